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

/// Connects window, document and worker. All three must outlive the event loop. The window must be destroyed before the
/// document, and the document before the worker.
void connectAll(ui::MainWindow& window, Document& document, SculptWorker& worker,
                const std::shared_ptr<PatchInbox>& inbox);

/// Records the document's changes in the store, and offers documents of earlier runs for recovery in the window. The
/// store must outlive the document.
void connectRecovery(ui::MainWindow& window, Document& document, RecoveryStore& recoveryStore);

/// Autosaves unsaved lessons to `root`, and offers lessons autosaved by earlier runs in the window. Precondition:
/// connectAll() was called.
void connectLessonAutosave(Document& document, const std::filesystem::path& root);

/// Shows the messages of a class in the window and in the headset. Precondition: connectAll() was called.
void connectClassroom(ui::MainWindow& window, ClassroomMode& mode);
} // namespace app
