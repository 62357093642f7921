#pragma once

#include <filesystem>
#include <memory>

namespace ui
{
class MainWindow;
}

namespace app
{
class ClassroomMode;
class Document;
class JournalShelf;
class PatchInbox;
class SculptWorker;

/// The rooms' lines to each other. All must outlive the event loop; the window goes before the document, and that
/// before the worker.
void wire(ui::MainWindow& window, Document& document, SculptWorker& worker, const std::shared_ptr<PatchInbox>& inbox);

/// Changes are recorded on the shelf, and what it has from before is offered in the window. The shelf must outlive the
/// document.
void wireRecovery(ui::MainWindow& window, Document& document, JournalShelf& shelf);

/// A lesson that is not saved is kept there, and what is there from before is offered in the window. wire() comes
/// first.
void wireLessonKeeping(Document& document, const std::filesystem::path& root);

/// What a class says is read in the window and in the headset. wire() comes first.
void wireClassroom(ui::MainWindow& window, ClassroomMode& mode);
} // namespace app
