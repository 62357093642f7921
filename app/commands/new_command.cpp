// new: writes a starter model to a file, to sculpt or to replay strokes on.
#include "app/commands/command_line.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/model/model_loader.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "ui/util/error_messages.h"

namespace app
{
namespace
{
/// length of the longest side, mm: default, and limits of the option
constexpr double starterSize = 100, minStarterSize = 0.001, maxStarterSize = 1e6;

class NewMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::NewCommand)
};

QString starterNames()
{
    QStringList names;
    for (const core::Starter starter : core::starters)
        names << QString::fromUtf8(core::name(starter));
    return names.join(QStringLiteral(", "));
}
} // namespace

ExitStatus newCommand(const QStringList& arguments)
{
    const QString size = QStringLiteral("size");
    QCommandLineParser parser;
    parser.setApplicationDescription(
        NewMessages::tr("Writes one of the program's starting shapes: %1.").arg(starterNames()));
    parser.addPositionalArgument(QStringLiteral("STARTER"), NewMessages::tr("The shape."));
    parser.addPositionalArgument(QStringLiteral("OUT"),
                                 NewMessages::tr("The file to write, in the format of its ending; or -."));
    parser.addOption({size, NewMessages::tr("Length of its longest side in mm (default: 100)."), QStringLiteral("MM")});
    StandardFiles::addTo(parser);
    CommandOptions::addNoClobber(parser);
    const CommandOptions options(parser, QStringLiteral("new"), arguments);
    if (options.isAnswered())
        return Done;
    if (options.files().size() != 2)
        CommandLine::fail(NewMessages::tr("new: needs a shape and a file, as in new ball ball.glb; the shapes are %1.")
                              .arg(starterNames()));
    const QString word = options.files()[0], out = options.files()[1];
    const std::optional<core::Starter> starter = core::starterNamed(word.toStdString());
    if (!starter)
        CommandLine::fail(NewMessages::tr("new: the shape must be one of %1, not \"%2\".").arg(starterNames(), word));
    const double factor = options.has(size) ? options.number(size, minStarterSize, maxStarterSize) / starterSize : 1;
    options.requireFree(out);
    const QString path = StandardFiles::output(options, out);
    CommandLine::requireMeshEnding(path);
    core::TriangleMesh mesh = core::starterModel(*starter);
    if (factor != 1)
        CommandUnit::scale(word, mesh, factor);
    try {
        core::writeMesh(toPath(path), mesh);
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    StandardFiles::flush();
    return Done;
}
} // namespace app
