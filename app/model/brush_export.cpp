#include "app/model/brush_export.h"

#include "app/model/model_loader.h"

#include "core/decimation/decimate.h"
#include "core/mesh/mesh_builder.h"
#include "ui/brush/brush_files.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <new>

namespace app
{
namespace
{
core::TriangleMesh fewEnough(core::Mesh& copy, const core::JobControl& control)
{
    const std::size_t maxFaces = core::BrushModel::maxFaces;
    return copy.live().faces > maxFaces ? core::decimate(std::move(copy), maxFaces, control).mesh
                                        : core::extractMesh(copy);
}
} // namespace

QString BrushExport::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/brushes");
}

ExportedBrush BrushExport::run(const std::shared_ptr<core::Mesh>& copy, const QString& name,
                               const core::JobControl& control)
{
    try {
        if (!copy)
            throw std::bad_alloc();
        const core::TriangleMesh mesh = fewEnough(*copy, control);
        if (control.isCancelled())
            return {};
        const auto brush = ui::brushModelOf(mesh, name);
        if (!brush.what)
            return {{}, brush.problem};
        const QDir folderOfBrush(folder() + u'/' + QString::fromStdString(brush.what->fingerprint()));
        folderOfBrush.mkpath(QStringLiteral(".")); // if this fails, save() below reports the missing folder
        const QString path = folderOfBrush.filePath(QFileInfo(name).completeBaseName() + QStringLiteral(".glb"));
        const QString problem = ModelLoader::save(path, mesh, {});
        return problem.isEmpty() ? ExportedBrush{path, {}} : ExportedBrush{{}, problem};
    } catch (const std::bad_alloc&) {
        return {{}, tr("There is not enough memory to make a brush of this model.")};
    }
}
} // namespace app
