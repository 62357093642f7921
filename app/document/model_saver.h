#pragma once

#include "core/io/document_metadata.h"
#include "core/io/stroke/stroke_file.h"
#include "ui/settings/export_settings.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace core
{
struct TriangleMesh;
}

namespace app
{
class Document;
struct ExportOutcome;
struct ExportedBrush;
struct SavedFile;

/// Saves and exports the model of a document, with the effect of all earlier requests. Thread: gui; files are written
/// on a background thread.
class ModelSaver : public QObject
{
    Q_OBJECT

public:
    explicit ModelSaver(Document* document) : m_document(document) {}

    struct Present
    {
        std::shared_ptr<const core::TriangleMesh> mesh;
        quint64 hash = 0;
        core::DocumentMetadata metadata;
        int step = 0;
        /// steps from the opened model to the present one; nothing: unknown
        std::optional<std::vector<core::FileEntry>> steps;
    };
    /// A callback that saves the model to a place that is not the document's file. Returns whether it succeeded; the
    /// model then counts as saved. Thread: background.
    using Save = std::function<bool(const Present& present)>;
    /// Runs `save` on a copy of the model, then calls `done` with its result. Sculpting is paused from the copy until
    /// `done` returns. Returns false and does nothing if another job is running.
    bool saveExternally(const QString& what, Save save, std::function<void(bool isSaved)> done);

public Q_SLOTS:
    /// Saves the model to a file, which becomes the document's file.
    void save(const QString& path);
    /// Saves a GLB, which becomes the document's file, and an STL beside `path`. Their number follows all numbers in
    /// use, so nothing is overwritten.
    void saveNumbered(const QString& path);
    /// Exports to another file. It is read back and verified, and tested by an installed slicer if `options` say so.
    /// Unsaved changes remain unsaved.
    void exportTo(const QString& path, const ui::ExportSettings& options = {});
    /// Exports the model as a brush file and emits brushExported(). The document and its file do not change.
    void exportBrush();

Q_SIGNALS:
    void saved(const QString& path);
    /// Emitted after an export. `verdict`: one line about the file as read back.
    void exported(const QString& path, const QString& verdict);
    void brushExported(const QString& path);
    /// Emitted if the model could not be saved, after Document::refused() with the reason.
    void saveFailed(const QString& path);
    void exportFailed(const QString& path);

private:
    using Write = std::function<SavedFile(const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata)>;
    void saveBy(const QString& name, const Write& write);
    void finishSaving(int index, const SavedFile& file);
    void finishExport(const QString& path, const ExportOutcome& outcome);
    void finishBrush(const ExportedBrush& brush);
    void startExternally(const Save& save, const std::function<void(bool isSaved)>& done);
    void finishExternally(int index, bool isSaved, const std::function<void(bool isSaved)>& done);
    std::optional<std::vector<core::FileEntry>> recordedSteps() const;

    Document* m_document;
};
} // namespace app
