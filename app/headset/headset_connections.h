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

/// Makes the headset and connects it to the window. The window owns it, so it is destroyed before the document. Thread:
/// gui.
Headset* connectHeadset(ui::MainWindow& window, Document& document, SculptWorker& worker);
} // namespace app
