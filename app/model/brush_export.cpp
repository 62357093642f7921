#include "app/model/brush_export.h"

#include "app/model/model_loader.h"

#include "core/mesh/mesh_builder.h"
#include "core/operations/decimate.h"
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
    const std::size_t most = core::BrushModel::maxFaces;
    return copy.live().faces > most ? core::decimate(std::move(copy), most, control).mesh : core::extractMesh(copy);
}
} // namespace

QString BrushKeeper::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/brushes");
}

KeptBrush BrushKeeper::keep(const std::shared_ptr<core::Mesh>& copy, const QString& name,
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
        const QDir place(folder() + u'/' + QString::fromStdString(brush.what->fingerprint()));
        place.mkpath(QStringLiteral(".")); // without it there is no file, which is said
        const QString path = place.filePath(QFileInfo(name).completeBaseName() + QStringLiteral(".glb"));
        const QString problem = ModelLoader::save(path, mesh, {});
        return problem.isEmpty() ? KeptBrush{path, {}} : KeptBrush{{}, problem};
    } catch (const std::bad_alloc&) {
        return {{}, tr("There is not enough memory to make a brush of this model.")};
    }
}
} // namespace app
