// boolean: reads and checks models, unites, subtracts or intersects them, and writes the result. Coordinates are those
// of the files.
#include "app/commands/command_line.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/commands/word_guess.h"
#include "app/model/model_loader.h"

#include "core/boolean/mesh_boolean.h"
#include "core/io/mesh_io.h"
#include "core/operations/part_union.h"
#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"

namespace app
{
namespace
{
// lupdate misparses functions whose return type is written with core::
using core::SetOperation, core::TriangleMesh, core::UpAxis;

class BooleanMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::BooleanCommand)
};

struct BooleanOptions
{
    SetOperation operation = SetOperation::Union;
    QStringList in; ///< two or more
    QString out;
    double unit = 1;          ///< unit of the coordinates that are read, mm
    std::optional<UpAxis> up; ///< up axis of the files that are read
};

QStringList upAxes()
{
    return {QStringLiteral("y"), QStringLiteral("z")};
}

/// Returns the operations in the order of core::SetOperation.
QStringList operationWords()
{
    return {QStringLiteral("union"), QStringLiteral("subtract"), QStringLiteral("intersect")};
}

void addBooleanOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(BooleanMessages::tr(
        "Unites models, subtracts all others from the first, or keeps what all have in common. The models must be "
        "watertight. OUT keeps their place and is in mm. Status 1: nothing is left, or there is no sound result."));
    parser.addPositionalArgument(
        QStringLiteral("OP"),
        BooleanMessages::tr("The operation: one of %1.").arg(operationWords().join(QStringLiteral(", "))));
    parser.addPositionalArgument(QStringLiteral("A"), BooleanMessages::tr("The first model; or -."));
    parser.addPositionalArgument(QStringLiteral("B..."), BooleanMessages::tr("The other models; or -."));
    CommandOptions::addOutput(parser, QStringLiteral("OUT"));
    CommandUnit::addTo(parser);
    parser.addOption(
        {QStringLiteral("up"),
         BooleanMessages::tr("Axis that points up in the files that are read (default: z for STL, 3MF and AMF, y for "
                             "others)."),
         upAxes().join(u'|')});
    StandardFiles::addFrom(parser);
    StandardFiles::addTo(parser);
    CommandOptions::addNoClobber(parser);
}

SetOperation operationNamed(const QString& word)
{
    const QStringList words = operationWords();
    if (const qsizetype place = words.indexOf(word); place >= 0)
        return static_cast<SetOperation>(place);
    const QString sentence = BooleanMessages::tr("boolean: \"%1\" is not an operation: the operations are %2.")
                                 .arg(word, words.join(QStringLiteral(", ")));
    const QString meant = meantWord(word, words);
    CommandLine::fail(meant.isEmpty() ? sentence : BooleanMessages::tr("%1 Did you mean %2?").arg(sentence, meant));
}

std::optional<BooleanOptions> parseBooleanOptions(const QStringList& arguments)
{
    const QString up = QStringLiteral("up");
    QCommandLineParser parser;
    addBooleanOptions(parser);
    const CommandOptions given(parser, QStringLiteral("boolean"), arguments);
    if (given.isAnswered())
        return std::nullopt;
    QStringList words = given.files();
    if (words.isEmpty())
        CommandLine::fail(BooleanMessages::tr("boolean: the operation is missing: one of %1.")
                              .arg(operationWords().join(QStringLiteral(", "))));
    BooleanOptions options;
    options.operation = operationNamed(words.takeFirst());
    if (words.size() < 2)
        CommandLine::fail(BooleanMessages::tr("boolean: needs two models or more; %n were given.", nullptr,
                                              static_cast<int>(words.size())));
    options.unit = CommandUnit::of(given);
    if (given.has(up))
        options.up = given.choice(up, upAxes()) == 0 ? UpAxis::Y : UpAxis::Z;
    options.out = given.output();
    given.requireFree(options.out);
    options.out = StandardFiles::output(given, options.out);
    CommandLine::requireMeshEnding(options.out);
    for (const QString& word : words)
        options.in << StandardFiles::input(given, word);
    return options;
}

/// Reads a model and scales it to mm. Throws CommandFailure if it is not sound.
TriangleMesh operand(const BooleanOptions& options, const QString& file)
{
    auto [mesh, remarks, parts] = core::readModel(toPath(file), {options.up});
    if (options.unit != 1)
        CommandUnit::scale(file, mesh, options.unit);
    if (core::checkMesh(mesh).printReady())
        core::uniteParts(mesh, {}); // if they overlap
    mesh.parts.clear();
    const core::MeshReport report = core::checkMesh(mesh);
    if (!report.printReady())
        CommandLine::fail(BooleanMessages::tr("%1 cannot be combined with others, because its surface does not bound a "
                                              "solid (%2). fettle convert --repair may make it watertight.")
                              .arg(file, ui::ErrorMessages::faults(report)));
    if (const QString left = ui::ErrorMessages::remarks(file, remarks); !left.isEmpty())
        CommandLine::printError(left);
    return std::move(mesh);
}

QString emptyText(const BooleanOptions& options)
{
    return options.operation == SetOperation::Intersection
               ? BooleanMessages::tr("The models have no space in common. Nothing was written.")
               : BooleanMessages::tr("Nothing is left of %1. Nothing was written.").arg(options.in.constFirst());
}

QString unresolvedText(const core::BooleanResult& result)
{
    const core::Vec3 place = result.place.value_or(core::Vec3::Zero());
    const auto rounded = [](double x) { return QString::number(x, 'g', 6); };
    return BooleanMessages::tr("The models cannot be combined soundly: near (%1, %2, %3) mm faces lie so close to each "
                               "other that they still meet after rounding. Move a model a little. Nothing was written.")
        .arg(rounded(place.x()), rounded(place.y()), rounded(place.z()));
}

/// Returns the line that is printed about the file that was written.
QString resultText(const QString& file, const core::MeshReport& report)
{
    return BooleanMessages::tr("%1: %2 x %3 x %4 mm, triangles: %5, volume: %6.")
        .arg(file, ui::millimetres(report.size.x()), ui::millimetres(report.size.y()), ui::millimetres(report.size.z()),
             ui::number(report.faces), ui::volumeText(report.volume.value_or(0)));
}
} // namespace

ExitStatus booleanCommand(const QStringList& arguments)
{
    const std::optional<BooleanOptions> options = parseBooleanOptions(arguments);
    if (!options)
        return Done;
    try {
        std::vector<TriangleMesh> solids;
        for (const QString& file : options->in)
            solids.push_back(operand(*options, file));
        core::BooleanResult result = core::combine(options->operation, solids);
        if (!result.mesh)
            throw CommandFailure{result.refusal == core::BooleanRefusal::LeavesNothing ? emptyText(*options)
                                                                                       : unresolvedText(result),
                                 AnswerIsNo};
        core::writeMesh(toPath(options->out), *result.mesh);
        StandardFiles::flush();
        CommandLine::printRemark(StandardFiles::named(resultText(options->out, result.report)) + u'\n');
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    return Done;
}
} // namespace app
