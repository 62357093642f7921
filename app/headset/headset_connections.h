#pragma once

namespace ui
{
class MainWindow;
}

namespace app
{
class Document;
class Headset;
class SculptWorker;

/// The lines between the window and who is in the headset. The window's own, so that it ends before the document. Gui
/// thread.
Headset* wireHeadset(ui::MainWindow& window, Document& document, SculptWorker& worker);
} // namespace app
