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
class RecoveryStore;
class PatchInbox;
class SculptWorker;

/// Connects window, document and worker. All must outlive the event loop; the window is destroyed before the document,
/// and that before the worker.
void connectAll(ui::MainWindow& window, Document& document, SculptWorker& worker,
                const std::shared_ptr<PatchInbox>& inbox);

/// Changes are recorded in the store, and what it has from before is offered in the window. The store must outlive the
/// document.
void connectRecovery(ui::MainWindow& window, Document& document, RecoveryStore& recoveryStore);

/// Autosaves unsaved lessons there, and offers those of earlier runs in the window. connectAll() comes
/// first.
void connectLessonAutosave(Document& document, const std::filesystem::path& root);

/// What a class says is read in the window and in the headset. connectAll() comes first.
void connectClassroom(ui::MainWindow& window, ClassroomMode& mode);
} // namespace app
