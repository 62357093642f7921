// check: tests whether models are sound. For one file it prints a few lines or a JSON object. For several files or a
// folder it prints a table, or a JSON object for each file on its own line.
#include "app/commands/command_models.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/commands/text_table.h"

#include "core/io/mesh_io.h"
#include "core/operations/part_union.h"
#include "core/parts/part_split.h"
#include "core/print/print_check.h"
#include "ui/util/error_messages.h"
#include "ui/util/path_display.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app
{
namespace
{
using core::PrintBed; // lupdate misparses functions whose return type is written core::PrintBed
using Json = nlohmann::ordered_json;

constexpr double minLength = 0.001, maxSide = 1e5; ///< smallest length in options and largest bed side, mm

class CheckMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::CheckCommand)
};

struct CheckOptions
{
    CommandModels models;
    bool json = false, csv = false;
    bool table = false;    ///< whether to print a table: for several files, or a folder
    bool hasWorks = false; ///< whether some models are pupils' works: results then include pupil and turn
    int nameColumns = 0;   ///< width of the table's first column, terminal columns
    double unit = 1;       ///< unit of the files' coordinates, mm
    std::optional<core::PrintLimits> print; ///< limits given by --print; nothing: printability is not checked
    bool hasBed = false;

    bool isPage() const { return !table && !json && !csv; }
};

/// Results of checking one file.
struct Checked
{
    core::MeshReport report;
    std::optional<core::PrintReport> print;
    std::optional<core::WorkDone> work; ///< strokes and time of work; nothing: not stored in the file
    core::ReadRemarks remarks;
};

template <class Value> Json orNull(const std::optional<Value>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

const char* nameOf(core::UnitDoubt doubt)
{
    return doubt == core::UnitDoubt::Inches ? "inches" : "metres";
}

Json doubtOf(const core::MeshReport& report)
{
    const core::UnitDoubt doubt = core::unitDoubtOf(report.volume.value_or(core::PrintLimits::inchVolume));
    return doubt == core::UnitDoubt::None ? Json(nullptr) : Json(nameOf(doubt));
}

/// Adds the results of the print check to the JSON object.
void addPrint(Json& json, const CheckOptions& options, const Checked& checked)
{
    const core::PrintReport& print = *checked.print;
    const auto share = [&](double area) { return print.area > 0 ? area / print.area : 0; };
    json["wall_limit_mm"] = options.print->minWall;
    json["min_wall_mm"] = orNull(print.thinnest);
    json["thin_share"] = print.thinnest ? Json(share(print.thin.area)) : Json(nullptr);
    json["overhang_share"] = share(print.overhangs.area);
    json["base_area_mm2"] = print.baseArea;
    json["fits_bed"] = options.hasBed ? Json(print.fit != core::BedFit::Not) : Json(nullptr);
    json["unit_doubt"] = doubtOf(checked.report);
}

Json toJson(const QString& file, const Checked& checked)
{
    const core::MeshReport& report = checked.report;
    return {{"file", file.toStdString()},
            {"vertices", report.vertices},
            {"faces", report.faces},
            {"closed", report.closed},
            {"manifold", report.manifold},
            {"oriented", report.oriented},
            {"bounds_solid", orNull(report.boundsSolid)},
            {"self_intersections", report.intersections.count},
            {"components", report.components},
            {"genus", orNull(report.genus)},
            {"volume_mm3", orNull(report.volume)},
            {"area_mm2", report.area},
            {"size_mm", {report.size.x(), report.size.y(), report.size.z()}},
            {"min_edge_mm", report.minEdge},
            {"max_edge_mm", report.maxEdge},
            {"degenerate_faces", report.degenerateFaces.count},
            {"lattice_ok", orNull(report.latticeOk)},
            {"print_ready", report.printReady()},
            {"strokes", checked.work ? Json(checked.work->strokes) : Json(nullptr)},
            {"time_spent_s", checked.work ? Json(std::llround(checked.work->seconds)) : Json(nullptr)}};
}

/// Adds the pupil and the turn to the JSON object; null if the model is not a work.
void addTurn(Json& json, const FoundModel& model)
{
    const auto text = [](const QString& value) { return value.isEmpty() ? Json(nullptr) : Json(value.toStdString()); };
    json["pupil"] = text(model.turn.pupil);
    json["turn_begun"] = text(model.turn.begun.toString(Qt::ISODate));
    json["turn_s"] = orNull(model.turn.seconds());
}

Json jsonOf(const CheckOptions& options, const QString& file, const FoundModel& model, const Checked& checked)
{
    Json json = toJson(file, checked);
    if (checked.print)
        addPrint(json, options, checked);
    if (options.hasWorks)
        addTurn(json, model);
    return json;
}

/// Returns the object for a file that cannot be read: all values are null, except the file's name and turn.
Json unknown(const CheckOptions& options, const QString& file, const FoundModel& model)
{
    Checked nothing;
    if (options.print)
        nothing.print.emplace();
    Json json = jsonOf(options, file, {}, nothing);
    for (auto& [key, value] : json.items())
        if (value.is_array())
            std::fill(value.begin(), value.end(), nullptr);
        else if (key != "file")
            value = nullptr;
    if (options.hasWorks)
        addTurn(json, model);
    return json;
}

/// Rounds to three decimals, or to three significant digits if the value is below 0.1.
QString rounded(double value)
{
    return std::abs(value) < 0.1 ? QString::number(value, 'g', 3)
                                 : QString::number(std::round(value * 1000) / 1000, 'g', 15);
}

QString word(const Json& value)
{
    if (value.is_null())
        return QStringLiteral("-");
    if (value.is_boolean())
        return value.get<bool>() ? CheckMessages::tr("yes") : CheckMessages::tr("no");
    if (value.is_number_float())
        return rounded(value.get<double>());
    if (value.is_array())
        return value[0].is_null() ? word(value[0])
                                  : QStringLiteral("%1 x %2 x %3").arg(word(value[0]), word(value[1]), word(value[2]));
    return QString::fromStdString(value.is_string() ? value.get<std::string>() : value.dump());
}

QString fieldOf(const Json& value)
{
    if (value.is_string())
        return csvField(QString::fromStdString(value.get<std::string>()));
    return value.is_null() ? QString() : QString::fromStdString(value.dump());
}

/// Returns a line of CSV. Numbers are written as in JSON; the three sides of the size are separate columns.
QString csvLine(const Json& report, bool isHeader)
{
    QStringList fields;
    for (const auto& [key, value] : report.items()) {
        if (!value.is_array())
            fields << (isHeader ? QString::fromStdString(key) : fieldOf(value));
        else
            for (std::size_t i = 0; i < value.size(); ++i)
                fields << (isHeader ? QStringLiteral("size_%1_mm").arg(QLatin1Char("xyz"[i])) : fieldOf(value[i]));
    }
    return fields.join(QLatin1Char(',')) + QLatin1Char('\n');
}

QString percent(double share)
{
    return QString::number(100 * share, 'f', 1) + QStringLiteral(" %");
}

/// Lists the reasons why a sound model does not print well.
QStringList obstacles(const CheckOptions& options, const core::PrintReport& print)
{
    QStringList found;
    if (options.hasBed && print.fit == core::BedFit::Not)
        found << CheckMessages::tr("it does not fit the bed");
    if (core::hasThinWalls(print, *options.print))
        found << CheckMessages::tr("%1 of its surface is thinner than %2 mm")
                     .arg(percent(print.thin.area / print.area), rounded(options.print->minWall));
    if (print.overhangs.count > 0)
        found << CheckMessages::tr("%1 of its surface overhangs by more than %2 degrees")
                     .arg(percent(print.overhangs.area / print.area), rounded(options.print->overhang));
    if (print.baseArea == 0)
        found << CheckMessages::tr("it stands on a point or an edge");
    return found;
}

QString verdict(const CheckOptions& options, const QString& file, const Checked& checked)
{
    if (!checked.report.printReady())
        return ui::ErrorMessages::refusal(file, checked.report);
    const QStringList found = checked.print ? obstacles(options, *checked.print) : QStringList();
    return found.isEmpty()
               ? CheckMessages::tr("%1 is watertight.").arg(file)
               : CheckMessages::tr("%1 is watertight, but: %2.").arg(file, found.join(QStringLiteral("; ")));
}

bool isShare(const std::string& key)
{
    return key.ends_with("_share");
}

/// Returns the translated label for a key of the JSON object.
QString labelOf(const std::string& key)
{
    static constexpr std::pair<std::string_view, const char*> labels[] = {
        {"file", QT_TRANSLATE_NOOP("app::CheckCommand", "file")},
        {"vertices", QT_TRANSLATE_NOOP("app::CheckCommand", "vertices")},
        {"faces", QT_TRANSLATE_NOOP("app::CheckCommand", "triangles")},
        {"closed", QT_TRANSLATE_NOOP("app::CheckCommand", "closed")},
        {"manifold", QT_TRANSLATE_NOOP("app::CheckCommand", "two faces at each edge")},
        {"oriented", QT_TRANSLATE_NOOP("app::CheckCommand", "consistently oriented faces")},
        {"bounds_solid", QT_TRANSLATE_NOOP("app::CheckCommand", "bounds a solid")},
        {"self_intersections", QT_TRANSLATE_NOOP("app::CheckCommand", "self-intersections")},
        {"components", QT_TRANSLATE_NOOP("app::CheckCommand", "parts")},
        {"genus", QT_TRANSLATE_NOOP("app::CheckCommand", "holes through it")},
        {"volume_mm3", QT_TRANSLATE_NOOP("app::CheckCommand", "volume, mm³")},
        {"area_mm2", QT_TRANSLATE_NOOP("app::CheckCommand", "surface, mm²")},
        {"size_mm", QT_TRANSLATE_NOOP("app::CheckCommand", "size, mm")},
        {"min_edge_mm", QT_TRANSLATE_NOOP("app::CheckCommand", "shortest edge, mm")},
        {"max_edge_mm", QT_TRANSLATE_NOOP("app::CheckCommand", "longest edge, mm")},
        {"degenerate_faces", QT_TRANSLATE_NOOP("app::CheckCommand", "triangles without area")},
        {"lattice_ok", QT_TRANSLATE_NOOP("app::CheckCommand", "still valid when opened")},
        {"print_ready", QT_TRANSLATE_NOOP("app::CheckCommand", "print-ready")},
        {"strokes", QT_TRANSLATE_NOOP("app::CheckCommand", "strokes")},
        {"time_spent_s", QT_TRANSLATE_NOOP("app::CheckCommand", "working time, s")},
        {"wall_limit_mm", QT_TRANSLATE_NOOP("app::CheckCommand", "thinnest wall allowed, mm")},
        {"min_wall_mm", QT_TRANSLATE_NOOP("app::CheckCommand", "thinnest wall, mm")},
        {"thin_share", QT_TRANSLATE_NOOP("app::CheckCommand", "surface that is too thin")},
        {"overhang_share", QT_TRANSLATE_NOOP("app::CheckCommand", "surface that overhangs")},
        {"base_area_mm2", QT_TRANSLATE_NOOP("app::CheckCommand", "base, mm²")},
        {"fits_bed", QT_TRANSLATE_NOOP("app::CheckCommand", "fits the bed")},
        {"unit_doubt", QT_TRANSLATE_NOOP("app::CheckCommand", "possible unit")},
        {"pupil", QT_TRANSLATE_NOOP("app::CheckCommand", "pupil")},
        {"turn_begun", QT_TRANSLATE_NOOP("app::CheckCommand", "turn begun")},
        {"turn_s", QT_TRANSLATE_NOOP("app::CheckCommand", "time of the turn, s")},
    };
    const auto* const found = std::ranges::find(labels, key, &std::pair<std::string_view, const char*>::first);
    return found == std::end(labels) ? QString::fromStdString(key) : CheckMessages::tr(found->second);
}

QString page(const CheckOptions& options, const QString& file, const Json& json, const Checked& checked)
{
    QString text;
    int width = 0;
    for (const auto& [key, value] : json.items())
        width = std::max(width, columnsOf(labelOf(key)));
    for (const auto& [key, value] : json.items())
        text += tableLine({labelOf(key), isShare(key) && !value.is_null() ? percent(value.get<double>()) : word(value)},
                          {-width, 0});
    text += verdict(options, file, checked);
    if (checked.report.volume)
        if (const QString doubt = ui::ErrorMessages::unitDoubt(*checked.report.volume); !doubt.isEmpty())
            text += QLatin1Char('\n') + doubt;
    return text + QLatin1Char('\n');
}

QString rowOf(const CheckOptions& options, const QStringList& fields)
{
    return tableLine(fields, {-options.nameColumns, 10, -32, -11, 8, 8, 9, 0});
}

QStringList tableHead(const CheckOptions& options)
{
    QStringList head = {CheckMessages::tr("file"), CheckMessages::tr("faces"), CheckMessages::tr("size, mm"),
                        CheckMessages::tr("print-ready")};
    if (options.print)
        head << CheckMessages::tr("wall, mm") << CheckMessages::tr("overhang") << CheckMessages::tr("base, mm²");
    if (options.print && options.hasBed)
        head << CheckMessages::tr("fits");
    return head;
}

QStringList tableFields(const CheckOptions& options, const QString& name, const Json& json)
{
    QStringList fields = {shortened(name, options.nameColumns), word(json["faces"]), word(json["size_mm"]),
                          word(json["print_ready"])};
    const auto toDecimals = [](const Json& value, int decimals) {
        return value.is_null() ? QStringLiteral("-") : QString::number(value.get<double>(), 'f', decimals);
    };
    if (options.print) {
        const Json& share = json["overhang_share"];
        fields << toDecimals(json["min_wall_mm"], 2)
               << (share.is_null() ? QStringLiteral("-") : percent(share.get<double>()))
               << toDecimals(json["base_area_mm2"], 1);
    }
    if (options.print && options.hasBed)
        fields << word(json["fits_bed"]);
    return fields;
}

QString jsonLine(const Json& report, const QString& problem)
{
    Json line{{"format", "fettle-check"}, {"version", 1}};
    line.update(report);
    line["error"] = problem.isEmpty() ? Json(nullptr) : Json(problem.toStdString());
    return QString::fromStdString(line.dump(-1, ' ', false, Json::error_handler_t::replace)) + QLatin1Char('\n');
}

/// Prints the result of one file; the first result is preceded by the table's head. `name`: shown in the table.
/// `problem`: why the file cannot be read; empty if it can.
void printReport(const CheckOptions& options, const QString& name, const Json& json, bool isFirst,
                 const QString& problem = {})
{
    if (options.json)
        CommandLine::print(jsonLine(json, problem));
    else if (options.csv)
        CommandLine::print((isFirst ? csvLine(json, true) : QString()) + csvLine(json, false));
    else
        CommandLine::print((isFirst ? rowOf(options, tableHead(options)) : QString()) +
                           rowOf(options, tableFields(options, name, json)));
}

/// Returns the surface that an export for print has: the union of the visible parts. Returns the parts themselves if
/// they are not sound, or no union is found; and all of them if all are hidden. `report`: of the mesh.
core::TriangleMesh printedSurface(core::TriangleMesh mesh, const core::PartList& parts, const core::MeshReport& report)
{
    if (core::TriangleMesh visible = core::visibleParts(mesh, parts); !visible.triangles.empty())
        mesh = std::move(visible);
    if (report.printReady())
        core::uniteParts(mesh, {});
    return mesh;
}

Checked check(const CheckOptions& options, const std::filesystem::path& file)
{
    auto [mesh, remarks, parts] = core::readModel(file);
    if (options.unit != 1)
        CommandUnit::scale(ui::displayName(file), mesh, options.unit);
    Checked checked{{}, {}, core::readMetadata(file).work, remarks};
    if (!options.print || !mesh.parts.empty())
        checked.report = core::checkMesh(mesh);
    if (!options.print)
        return checked;
    const bool hasParts = !mesh.parts.empty();
    if (hasParts)
        mesh = printedSurface(std::move(mesh), parts, checked.report);
    const core::PrintMeasures measures = core::measureForPrint(std::move(mesh));
    if (!hasParts)
        checked.report = measures.report;
    checked.print = core::checkForPrint(measures, *options.print);
    return checked;
}

PrintBed bedOf(const QString& text)
{
    const QStringList sides = text.split(u',');
    double lengths[3] = {};
    bool areLengths = sides.size() == std::ssize(lengths);
    for (qsizetype i = 0; areLengths && i < sides.size(); ++i) {
        lengths[i] = sides[i].toDouble(&areLengths);
        areLengths = areLengths && lengths[i] >= minLength && lengths[i] <= maxSide;
    }
    if (!areLengths)
        CommandLine::fail(
            CheckMessages::tr("check: --bed must be three lengths in mm, as in 250,210,220, not \"%1\".").arg(text));
    return {lengths[0], lengths[1], lengths[2]};
}

std::optional<core::PrintLimits> printLimits(const CommandOptions& options)
{
    constexpr double maxNozzle = core::PrintLimits::maxWall / core::PrintLimits::linesPerWall;
    const QString print = QStringLiteral("print"), nozzle = QStringLiteral("nozzle"), bed = QStringLiteral("bed"),
                  overhang = QStringLiteral("overhang");
    options.requireWith({nozzle, overhang, bed}, print);
    if (!options.has(print))
        return std::nullopt;
    core::PrintLimits limits;
    if (options.has(nozzle))
        limits.minWall = core::PrintLimits::linesPerWall * options.number(nozzle, minLength, maxNozzle);
    if (options.has(overhang))
        limits.overhang = options.number(overhang, 0, 90);
    if (options.has(bed))
        limits.bed = bedOf(options.text(bed));
    return limits;
}

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        CheckMessages::tr("Says whether models are closed, manifold, oriented, free of self-intersections, "
                          "and bound a solid. Status 0: all are, whatever --print finds; 1: not all."));
    parser.addPositionalArgument(QStringLiteral("FILE..."), CheckMessages::tr("Models, or folders of models; or -."));
    CommandUnit::addTo(parser);
    parser.addOptions(
        {{QStringLiteral("json"), CheckMessages::tr("One JSON object per file, each on its line.")},
         {QStringLiteral("csv"), CheckMessages::tr("CSV with a header row.")},
         {QStringLiteral("print"), CheckMessages::tr("Also measure wall thickness, overhangs and bed contact.")},
         {QStringLiteral("nozzle"),
          CheckMessages::tr("Nozzle width in mm; walls should be two lines thick (default: 0.4)."),
          QStringLiteral("MM")},
         {QStringLiteral("overhang"),
          CheckMessages::tr("Steepest overhang that prints without support, in degrees from "
                            "the vertical (default: 45)."),
          QStringLiteral("DEGREES")},
         {QStringLiteral("bed"),
          CheckMessages::tr("Width, depth and height of the printer's build volume, in mm (default: not checked)."),
          QStringLiteral("X,Y,Z")}});
    StandardFiles::addFrom(parser);
}

/// Returns the name of the model shown in the table.
QString shownName(const FoundModel& model)
{
    return model.work.isEmpty() ? StandardFiles::named(ui::displayName(model.file)) : model.pupil;
}

/// Returns the width of the name column: that of the longest name, within limits that leave room for the other columns.
int nameColumns(const QList<FoundModel>& models)
{
    constexpr int minColumns = 32, maxColumns = 64;
    int columns = minColumns;
    for (const FoundModel& model : models)
        columns = std::max(columns, columnsOf(shownName(model)));
    return std::min(columns, maxColumns);
}

std::optional<CheckOptions> parseCheckOptions(const QStringList& arguments)
{
    const QString json = QStringLiteral("json"), csv = QStringLiteral("csv");
    QCommandLineParser parser;
    addOptions(parser);
    const CommandOptions given(parser, QStringLiteral("check"), arguments);
    if (given.isAnswered())
        return std::nullopt;
    given.requireOneOf(json, csv);
    CheckOptions options;
    options.json = given.has(json);
    options.csv = given.has(csv);
    options.unit = CommandUnit::of(given);
    options.print = printLimits(given);
    options.hasBed = given.has(QStringLiteral("bed"));
    options.models = commandModels(given);
    options.table = options.models.hasFolder || options.models.files.size() > 1;
    options.hasWorks = std::ranges::any_of(options.models.files, [](const FoundModel& m) { return !m.work.isEmpty(); });
    options.nameColumns = nameColumns(options.models.files);
    return options;
}
} // namespace

ExitStatus checkCommand(const QStringList& arguments)
{
    const std::optional<CheckOptions> options = parseCheckOptions(arguments);
    if (!options)
        return Done;
    ExitStatus status = options->models.status;
    bool isFirst = true;
    for (const FoundModel& model : options->models.files) {
        const QString file = StandardFiles::named(ui::displayName(model.file)), name = shownName(model);
        try {
            const Checked checked = check(*options, model.file);
            const Json json = jsonOf(*options, file, model, checked);
            if (options->isPage())
                CommandLine::print(page(*options, file, json, checked));
            else
                printReport(*options, name, json, std::exchange(isFirst, false));
            if (const QString left = ui::ErrorMessages::remarks(file, checked.remarks); !left.isEmpty())
                CommandLine::printError(left);
            status = std::max(status, checked.report.printReady() ? Done : AnswerIsNo);
        } catch (const core::FileError& error) {
            const QString problem = StandardFiles::named(ui::ErrorMessages::sentence(error));
            CommandLine::printError(problem);
            if (options->table)
                printReport(*options, name, unknown(*options, file, model), std::exchange(isFirst, false), problem);
            status = BadInput;
        }
    }
    return status;
}
} // namespace app
