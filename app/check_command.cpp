// check: is a model in order? One file: a few lines, or one JSON object. Several, or a folder: a table, or an object a line.
#include "command_line.h"
#include "model_loader.h"

#include "core/mesh_check.h"
#include "core/mesh_io.h"
#include "ui/messages.h"
#include "ui/model_formats.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace app
{
namespace
{
using Json = nlohmann::ordered_json;

class CheckWords
{
    Q_DECLARE_TR_FUNCTIONS(app::CheckCommand)
};

struct CheckOptions
{
    QStringList files;
    bool json = false, csv = false;
    bool table = false; ///< several files, or a folder
};

template <class Value> Json orNull(const std::optional<Value>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json toJson(const QString& file, const core::MeshReport& report)
{
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
            {"print_ready", report.printReady()}};
}

QString word(const Json& value)
{
    if (value.is_null())
        return QString();
    if (value.is_boolean())
        return value.get<bool>() ? QStringLiteral("yes") : QStringLiteral("no");
    if (value.is_number_float())
        return QString::number(value.get<double>(), 'g', 7);
    if (value.is_array())
        return QStringLiteral("%1 x %2 x %3").arg(word(value[0]), word(value[1]), word(value[2]));
    return QString::fromStdString(value.is_string() ? value.get<std::string>() : value.dump());
}

QString quoted(QString field)
{
    static const QRegularExpression special(QStringLiteral("[\",\\r\\n]"));
    if (!field.contains(special))
        return field;
    return QLatin1Char('"') + field.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

/// Numbers as in JSON; the three sides in a column each.
QString csvLine(const Json& report, bool isHeader)
{
    QStringList fields;
    for (const auto& [key, value] : report.items()) {
        const QString name = QString::fromStdString(key);
        if (value.is_array()) {
            for (std::size_t i = 0; i < value.size(); ++i)
                fields << (isHeader ? QStringLiteral("size_%1_mm").arg(QLatin1Char("xyz"[i]))
                                    : QString::fromStdString(value[i].dump()));
        } else if (isHeader) {
            fields << name;
        } else if (value.is_string()) {
            fields << quoted(QString::fromStdString(value.get<std::string>()));
        } else {
            fields << (value.is_null() ? QString() : QString::fromStdString(value.dump()));
        }
    }
    return fields.join(QLatin1Char(',')) + QLatin1Char('\n');
}

QString page(const QString& file, const Json& json, const core::MeshReport& report)
{
    QString text;
    for (const auto& [key, value] : json.items())
        text += QStringLiteral("%1 %2\n").arg(QString::fromStdString(key), -18).arg(value.is_null() ? QStringLiteral("-") : word(value));
    return text + (report.printReady() ? CheckWords::tr("%1 is in fine fettle.").arg(file) : ui::Messages::refusal(file, report))
           + QLatin1Char('\n');
}

QString tableLine(const QString& file, const QString& faces, const QString& size, const QString& verdict)
{
    return QStringLiteral("%1  %2  %3  %4\n").arg(file, -32).arg(faces, 10).arg(size, -32).arg(verdict);
}

/// Writes what was found of one file; the first is preceded by the table's head.
void printReport(const CheckOptions& options, const QString& file, const core::MeshReport& report, bool isFirst)
{
    const Json json = toJson(file, report);
    if (options.json)
        CommandLine::print(QString::fromStdString(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + QLatin1Char('\n'));
    else if (options.csv)
        CommandLine::print((isFirst ? csvLine(json, true) : QString()) + csvLine(json, false));
    else if (!options.table)
        CommandLine::print(page(file, json, report));
    else
        CommandLine::print((isFirst ? tableLine(CheckWords::tr("file"), CheckWords::tr("faces"), CheckWords::tr("size, mm"),
                                                CheckWords::tr("print-ready"))
                                    : QString())
                           + tableLine(file, word(json["faces"]), word(json["size_mm"]), word(json["print_ready"])));
}

/// A folder stands for the models in it, by name; those in folders further down are not looked at.
QStringList modelsIn(const QString& folder)
{
    QStringList patterns;
    for (const QString& ending : ui::modelEndings())
        patterns << QStringLiteral("*.") + ending;
    std::error_code problem;
    const std::filesystem::directory_iterator readable(toPath(folder), problem);
    if (problem)
        CommandLine::fail(CheckWords::tr("%1: this folder cannot be read (%2).").arg(folder, qt_error_string(problem.value())));
    QStringList files;
    for (const QString& name : QDir(folder).entryList(patterns, QDir::Files, QDir::Name))
        files << QDir(folder).filePath(name);
    if (files.isEmpty())
        CommandLine::fail(CheckWords::tr("%1: there is no model in this folder (%2).").arg(folder, ui::modelFormats()));
    return files;
}

std::optional<CheckOptions> parseOptions(const QStringList& arguments)
{
    const QString json = QStringLiteral("json"), csv = QStringLiteral("csv");
    QCommandLineParser parser;
    parser.setApplicationDescription(CheckWords::tr("Says whether models are closed, manifold, oriented, free of self-intersections, "
                                                    "and bound a solid. Status 0: all are; 1: not all."));
    parser.addPositionalArgument(QStringLiteral("FILE..."), CheckWords::tr("Models, or folders of models."));
    parser.addOptions({{json, CheckWords::tr("One JSON object per file, each on its line.")},
                       {csv, CheckWords::tr("Comma-separated values, with a head line.")}});
    if (!CommandLine::parse(parser, QStringLiteral("check"), arguments))
        return std::nullopt;
    CheckOptions options;
    options.json = parser.isSet(json);
    options.csv = parser.isSet(csv);
    if (options.json && options.csv)
        CommandLine::fail(CheckWords::tr("check: --json and --csv exclude each other."));
    for (const QString& name : parser.positionalArguments()) {
        const bool isFolder = QFileInfo(name).isDir();
        options.files += isFolder ? modelsIn(name) : QStringList(name);
        options.table = options.table || isFolder;
    }
    if (options.files.isEmpty())
        CommandLine::fail(CheckWords::tr("check: no file was given."));
    options.table = options.table || options.files.size() > 1;
    return options;
}
} // namespace

ExitStatus checkCommand(const QStringList& arguments)
{
    const std::optional<CheckOptions> options = parseOptions(arguments);
    if (!options)
        return Done;
    ExitStatus status = Done;
    bool isFirst = true;
    for (const QString& file : options->files) {
        try {
            const core::MeshReport report = core::checkMesh(core::readMesh(toPath(file)));
            printReport(*options, file, report, isFirst);
            isFirst = false;
            status = std::max(status, report.printReady() ? Done : AnswerIsNo);
        } catch (const core::FileError& error) {
            CommandLine::printError(ui::Messages::sentence(error));
            status = BadInput;
        }
    }
    return status;
}
} // namespace app
