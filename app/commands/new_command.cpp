// new: writes a starter model, or a primitive of given measures, to a file.
#include "app/commands/command_line.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/model/command_names.h"
#include "app/model/model_loader.h"

#include "core/io/mesh_io.h"
#include "core/operations/model_command.h"
#include "core/primitives/primitives.h"
#include "core/primitives/starter_models.h"
#include "ui/util/error_messages.h"

#include <QLocale>

#include <algorithm>

namespace app
{
namespace
{
using core::TriangleMesh; // lupdate takes a function that returns core::TriangleMesh for a member of core

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

QString primitiveNames()
{
    QStringList names;
    for (std::size_t i = 0; i < core::Primitive::kinds; ++i)
        names << QString::fromUtf8(core::name(static_cast<core::Primitive::Kind>(i)));
    return names.join(QStringLiteral(", "));
}

QString optionOf(core::Primitive::Measure measure)
{
    return QString::fromUtf8(core::name(measure)).replace(u'_', u'-');
}

/// The options of primitives, besides those of their measures.
const QString profileOption = QStringLiteral("profile"), pathOption = QStringLiteral("path"),
              edgeOption = QStringLiteral("edge-length");

/// Returns the options of primitives.
QStringList primitiveOptions()
{
    QStringList options = {profileOption, pathOption, edgeOption};
    for (std::size_t i = 0; i < core::Primitive::measures; ++i)
        options << optionOf(static_cast<core::Primitive::Measure>(i));
    return options;
}

void addPrimitiveOptions(QCommandLineParser& parser)
{
    const QString descriptions[] = {NewMessages::tr("Width of a box, along x, in mm."),
                                    NewMessages::tr("Height along y in mm; a capsule's with its round ends."),
                                    NewMessages::tr("Depth of a box, along z, in mm."),
                                    NewMessages::tr("Radius in mm; a cone's at the bottom, a torus's to the middle of "
                                                    "its tube."),
                                    NewMessages::tr("Radius of a cone at the top, in mm (default: 0)."),
                                    NewMessages::tr("Radius of a torus's tube, in mm.")};
    static_assert(std::size(descriptions) == core::Primitive::measures);
    for (std::size_t i = 0; i < core::Primitive::measures; ++i)
        parser.addOption({optionOf(static_cast<core::Primitive::Measure>(i)), descriptions[i], QStringLiteral("MM")});
    parser.addOption({profileOption, NewMessages::tr("Profile of a lathe: points of radius and height in mm."),
                      QStringLiteral("POINTS")});
    parser.addOption(
        {pathOption, NewMessages::tr("Path of a tube: points of x, y, z and radius in mm."), QStringLiteral("POINTS")});
    parser.addOption({edgeOption, NewMessages::tr("Length of a primitive's edges in mm (default: automatic)."),
                      QStringLiteral("MM")});
}

/// Reads points of `Size` numbers, as in "10,0 8,20". `refusal`: the sentence for other texts; %1 is the text.
template <std::size_t Size> std::vector<std::array<double, Size>> pointsIn(const QString& text, const QString& refusal)
{
    std::vector<std::array<double, Size>> points;
    for (const QString& point : text.simplified().split(u' ', Qt::SkipEmptyParts)) {
        const QStringList words = point.split(u',');
        bool isRead = words.size() == qsizetype(Size);
        std::array<double, Size>& numbers = points.emplace_back();
        for (std::size_t i = 0; i < Size && isRead; ++i)
            numbers[i] = QLocale::c().toDouble(words[qsizetype(i)], &isRead);
        if (!isRead)
            CommandLine::fail(refusal.arg(text));
    }
    return points;
}

TriangleMesh primitiveOf(core::Primitive::Kind kind, const CommandOptions& options)
{
    core::Primitive primitive;
    primitive.kind = kind;
    QStringList known = {edgeOption};
    for (const core::Primitive::Measure measure : core::measuresOf(kind)) {
        const QString option = optionOf(measure);
        known << option;
        if (measure == core::Primitive::Measure::TopRadius && !options.has(option))
            continue; // a pointed cone
        if (!options.has(option))
            CommandLine::fail(NewMessages::tr("new: %1 needs --%2.").arg(QString::fromUtf8(core::name(kind)), option));
        primitive.length(measure) =
            options.number(option, measure == core::Primitive::Measure::TopRadius ? 0 : core::ModelLimits::minExtent,
                           core::ModelLimits::maxExtent);
    }
    if (kind == core::Primitive::Kind::Lathe || kind == core::Primitive::Kind::Tube) {
        known << (kind == core::Primitive::Kind::Lathe ? profileOption : pathOption);
        if (!options.has(known.last()))
            CommandLine::fail(
                NewMessages::tr("new: %1 needs --%2.").arg(QString::fromUtf8(core::name(kind)), known.last()));
    }
    if (kind == core::Primitive::Kind::Lathe) {
        const QString refusal = NewMessages::tr("new: --profile must be points of radius and height, as in "
                                                "\"10,0 8,20\", not \"%1\".");
        for (const auto& [radius, height] : pointsIn<2>(options.text(profileOption), refusal))
            primitive.profile.push_back({radius, height});
    }
    if (kind == core::Primitive::Kind::Tube) {
        const QString refusal = NewMessages::tr("new: --path must be points of x, y, z and radius, as in "
                                                "\"0,0,0,2 9,5,0,1\", not \"%1\".");
        for (const auto& [x, y, z, radius] : pointsIn<4>(options.text(pathOption), refusal))
            primitive.path.push_back({{x, y, z}, radius});
    }
    if (options.has(edgeOption))
        primitive.edge = options.number(edgeOption, core::ModelLimits::minExtent, core::ModelLimits::maxExtent);
    for (const QString& option : primitiveOptions())
        if (options.has(option) && !known.contains(option))
            CommandLine::fail(NewMessages::tr("new: %1 has no --%2.").arg(QString::fromUtf8(core::name(kind)), option));
    core::PrimitiveResult made = core::makePrimitive(primitive);
    if (!made.mesh)
        CommandLine::fail(QStringLiteral("new: ") + CommandNames::problem(made));
    return std::move(*made.mesh);
}

/// Returns the shape that the arguments name. A name that is both a starter's and a primitive's is the primitive's if a
/// measure is given.
TriangleMesh shapeOf(const QString& word, const CommandOptions& options, const QString& size)
{
    const std::optional<core::Starter> starter = core::starterNamed(word.toStdString());
    const std::optional<core::Primitive::Kind> primitive = core::primitiveNamed(word.toStdString());
    const QStringList measures = primitiveOptions();
    const bool isMeasured = std::ranges::any_of(measures, [&](const QString& name) { return options.has(name); });
    if (primitive && (isMeasured || !starter)) {
        if (options.has(size))
            CommandLine::fail(NewMessages::tr("new: %1 with measures has no --%2.").arg(word, size));
        return primitiveOf(*primitive, options);
    }
    if (!starter)
        CommandLine::fail(NewMessages::tr("new: the shape must be one of %1, or with measures %2, not \"%3\".")
                              .arg(starterNames(), primitiveNames(), word));
    if (isMeasured)
        CommandLine::fail(NewMessages::tr("new: %1 has no measures but --%2.").arg(word, size));
    core::TriangleMesh mesh = core::starterModel(*starter);
    if (const double factor =
            options.has(size) ? options.number(size, minStarterSize, maxStarterSize) / starterSize : 1;
        factor != 1)
        CommandUnit::scale(word, mesh, factor);
    return mesh;
}
} // namespace

ExitStatus newCommand(const QStringList& arguments)
{
    const QString size = QStringLiteral("size");
    QCommandLineParser parser;
    parser.setApplicationDescription(
        NewMessages::tr("Writes one of the program's starting shapes: %1. Or a solid of the given measures: %2.")
            .arg(starterNames(), primitiveNames()));
    parser.addPositionalArgument(QStringLiteral("STARTER"), NewMessages::tr("The shape."));
    parser.addPositionalArgument(QStringLiteral("OUT"),
                                 NewMessages::tr("The file to write, in the format of its ending; or -."));
    parser.addOption({size, NewMessages::tr("Length of its longest side in mm (default: 100)."), QStringLiteral("MM")});
    addPrimitiveOptions(parser);
    StandardFiles::addTo(parser);
    CommandOptions::addNoClobber(parser);
    const CommandOptions options(parser, QStringLiteral("new"), arguments);
    if (options.isAnswered())
        return Done;
    if (options.files().size() != 2)
        CommandLine::fail(NewMessages::tr("new: needs a shape and a file, as in new ball ball.glb; the shapes are %1.")
                              .arg(starterNames()));
    const QString word = options.files()[0], out = options.files()[1];
    const core::TriangleMesh mesh = shapeOf(word, options, size);
    options.requireFree(out);
    const QString path = StandardFiles::output(options, out);
    CommandLine::requireMeshEnding(path);
    try {
        core::writeMesh(toPath(path), mesh);
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    StandardFiles::flush();
    return Done;
}
} // namespace app
