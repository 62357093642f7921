#pragma once

#include <QString>

#include <functional>

class QMainWindow;

namespace ui
{
class Actions;
class ModelFiles;
class Settings;
class SideColumn;
class Viewport;

struct ReferenceContext
{
    QMainWindow* window;
    SideColumn* column;
    Viewport* viewport;
    ModelFiles* files; ///< reports images dropped on the window
};

/// Adds the reference images behind the model: their actions, and a panel that is hidden until an image is chosen.
/// Reads the settings now. The arguments are not owned. `notice` shows a short message.
void addReferences(const ReferenceContext& context, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice);
} // namespace ui
