#include "app/commands/command_models.h"

#include "app/commands/standard_files.h"
#include "app/model/model_export.h"
#include "app/model/model_loader.h"

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

core::PartUnion unitePartsFor(const QString& out, core::TriangleMesh& mesh)
{
    return ModelExport::joinsPartsByDefault(out) ? core::uniteParts(mesh, {}) : core::PartUnion::NotNeeded;
}
} // namespace app
