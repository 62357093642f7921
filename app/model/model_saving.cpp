#include "app/model/model_saving.h"

#include "app/model/model_loader.h"

#include "ui/files/file_jobs.h"

#include <QDir>
#include <QFileInfo>

namespace app
{
namespace
{
/// Returns the path with its extension replaced by `ending`.
QString ended(const QString& path, const QString& ending)
{
    const QFileInfo file(path);
    return file.dir().filePath(QStringLiteral("%1.%2").arg(file.completeBaseName(), ending));
}
} // namespace

SavedFile ModelSaving::save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                            int backupCount)
{
    SavedFile saved{path, ModelLoader::save(path, mesh, metadata, backupCount), {}};
    if (saved.problem.isEmpty() &&
        ModelLoader::writtenSurface(path, mesh, metadata).triangles.size() < mesh.triangles.size())
        saved.notice = tr("Saved %1 without the hidden parts: its format cannot keep them hidden. GLB keeps them.")
                           .arg(QFileInfo(path).fileName());
    else if (saved.problem.isEmpty() && !mesh.colors.empty() && !ModelLoader::holdsColors(path))
        saved.notice =
            tr("Saved %1 without colours: its format has none. GLB keeps them.").arg(QFileInfo(path).fileName());
    return saved;
}

/// Chooses the number immediately before writing, because another program may be saving numbered files in the same
/// folder.
SavedFile ModelSaving::saveNumbered(const QString& path, const core::TriangleMesh& mesh,
                                    const core::DocumentMetadata& metadata)
{
    SavedFile saved = save(ui::FileJobs::numberedCopyOf(ended(path, QStringLiteral("glb"))), mesh, metadata);
    if (!saved.problem.isEmpty())
        return saved;
    const QString print = ended(saved.path, QStringLiteral("stl"));
    core::DocumentMetadata place;
    place.frame = metadata.frame;
    const QString problem = ModelLoader::save(print, mesh, place);
    const QString name = QFileInfo(saved.path).fileName();
    saved.notice = problem.isEmpty() ? tr("%1 and %2 were written.").arg(name, QFileInfo(print).fileName())
                                     : tr("Only %1 was written. %2").arg(name, problem);
    return saved;
}
} // namespace app
