#pragma once

#include "core/io/document_metadata.h"
#include "core/io/stroke/stroke_file.h"

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

/// Writes the model of a document, as everything requested before left it. Thread: gui; files are written on another.
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
        /// What was done to the model since it was opened; nothing: not known.
        std::optional<std::vector<core::FileEntry>> steps;
    };
    /// Saves somewhere else than to a file of the document. Returns whether the model is safe there; then it counts as
    /// saved. Thread: another.
    using Save = std::function<bool(const Present& present)>;
    /// Nobody sculpts from the copy on until `done`, which gets the answer of `save`, has returned. False: another job
    /// goes on, and nothing is done.
    bool saveExternally(const QString& what, Save save, std::function<void(bool isSaved)> done);

public Q_SLOTS:
    /// To a file that from now on is the model's own.
    void save(const QString& path);
    /// Beside that path, numbered after all that are there: a GLB, which from now on is the model's own, and an STL.
    /// Overwrites nothing.
    void saveNumbered(const QString& path);
    /// To another file, with at most `maxTriangles` (0: all). The file is read back and checked, with `slices` also by
    /// an installed slicer. Changes stay unsaved.
    void exportTo(const QString& path, quint64 maxTriangles = 0, bool slices = false);
    /// To a file that brushes are read from: brushExported(). The model and its own file stay as they are.
    void exportBrush();

Q_SIGNALS:
    void saved(const QString& path);
    /// The verdict: one line on the file as it was read back.
    void exported(const QString& path, const QString& verdict);
    void brushExported(const QString& path);
    /// The model could not be written there, as Document::refused() has said.
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
