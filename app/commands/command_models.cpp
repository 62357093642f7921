#include "app/commands/command_models.h"

#include "app/commands/standard_files.h"
#include "app/model/model_export.h"
#include "app/model/model_loader.h"

#include "core/analysis/part_overlap.h"
#include "core/boolean/mesh_boolean.h"
#include "core/parts/part_split.h"
#include "ui/util/error_messages.h"

#include <QFileInfo>

namespace app
{
namespace
{
class CommandModelsMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandModels)
};
} // namespace

CommandModels commandModels(const CommandOptions& options)
{
    if (options.files().isEmpty())
        CommandLine::fail(CommandModelsMessages::tr("%1: no file was given.").arg(options.command()));
    CommandModels models;
    for (const QString& name : options.files()) {
        if (!QFileInfo(name).isDir()) {
            models.files << FoundModel{toPath(StandardFiles::input(options, name))};
            continue;
        }
        models.hasFolder = true;
        try {
            models.files << modelsAndWorks(toPath(name));
        } catch (const core::FileError& error) {
            CommandLine::printError(ui::ErrorMessages::sentence(error));
            models.status = BadInput;
        }
    }
    return models;
}

PartUnion unitePartsFor(const QString& out, core::TriangleMesh& mesh)
{
    if (!ModelExport::joinsPartsByDefault(out) || !core::doPartsOverlap(mesh))
        return PartUnion::NotNeeded;
    std::vector<core::TriangleMesh> solids;
    for (core::PartPiece& piece : core::splitByPart(mesh))
        solids.push_back(std::move(piece.mesh));
    core::BooleanResult all = core::combine(core::SetOperation::Union, solids);
    if (!all.mesh)
        return PartUnion::Failed;
    mesh = std::move(*all.mesh);
    return PartUnion::Done;
}
} // namespace app
