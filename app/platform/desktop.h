#pragma once

#include <QString>

namespace app
{
/// Returns whether there is a display to open a window on. Under X11 and Wayland it only looks whether one is
/// configured. Precondition: no Qt application exists yet.
bool hasDisplay();

/// Makes Qt use X11 instead of Wayland where both have a display: the headset simulator captures pictures by GLX, which
/// needs X11. Does nothing on Windows and macOS. Precondition: no Qt application exists yet.
void preferX11();

/// Returns the folder for what the program remembers by itself, such as journals. It need not exist. That is the state
/// directory of the XDG specification; on Windows and macOS, or where XDG_STATE_HOME does not tell, a folder in the
/// program's local data. Precondition: the application has its name.
QString stateFolder();
} // namespace app
