#include "app/commands/command_line.h"

#include "app/model/model_loader.h"
#include "app/platform/terminal.h"

#include "ui/util/format_filters.h"

#include <QFileInfo>

#include <cerrno>
#include <cstdio>
#include <new>

namespace app
{
namespace
{
using Command = ExitStatus (*)(const QStringList&);

Command commandNamed(const QString& word)
{
    if (word == QLatin1String("brush"))
        return brushCommand;
    if (word == QLatin1String("check"))
        return checkCommand;
    if (word == QLatin1String("convert"))
        return convertCommand;
    if (word == QLatin1String("lesson"))
        return lessonCommand;
    if (word == QLatin1String("replay"))
        return replayCommand;
    if (word == QLatin1String("report"))
        return reportCommand;
    if (word == QLatin1String("sheet"))
        return sheetCommand;
    return nullptr;
}

bool isHelp(const QString& word)
{
    return word == QLatin1String("--help") || word == QLatin1String("-h") || word == QLatin1String("help");
}

bool isVersion(const QString& word)
{
    return word == QLatin1String("--version") || word == QLatin1String("-v");
}

bool write(std::FILE* stream, const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    const auto size = static_cast<std::size_t>(bytes.size());
    return std::fwrite(bytes.constData(), 1, size, stream) == size && std::fflush(stream) == 0;
}
} // namespace

bool CommandLine::isCommand(const QStringList& arguments)
{
    if (arguments.isEmpty())
        return false;
    return commandNamed(arguments.first()) || isHelp(arguments.first()) || isVersion(arguments.first());
}

bool CommandLine::needsFonts(const QStringList& arguments)
{
    const Command command = arguments.isEmpty() ? nullptr : commandNamed(arguments.first());
    return command == reportCommand || command == sheetCommand;
}

ExitStatus CommandLine::run(const QStringList& arguments)
{
    try {
        return dispatch(arguments);
    } catch (const CommandFailure& failure) {
        printError(failure.sentence);
        return failure.status;
    } catch (const std::bad_alloc&) {
        printError(tr("There is not enough memory for this."));
        return BadInput;
    }
}

ExitStatus CommandLine::dispatch(const QStringList& arguments)
{
    const QString& word = arguments.first();
    if (const Command command = commandNamed(word))
        return command(arguments.mid(1));
    if (isVersion(word)) {
        print(QStringLiteral("fettle " FETTLE_VERSION "\n"));
        return Done;
    }
    if (arguments.size() > 1) {
        if (const Command command = commandNamed(arguments.at(1)))
            return command({QStringLiteral("--help")});
        fail(tr("There is no help on %1: the commands are brush, check, convert, lesson, replay, report and sheet.")
                 .arg(arguments.at(1)));
    }
    print(help());
    return Done;
}

/// Takes `--classroom FILE` out of the arguments.
QString CommandLine::classFileIn(QStringList& arguments)
{
    const qsizetype at = arguments.indexOf(QStringLiteral("--classroom"));
    const qsizetype end = arguments.indexOf(QStringLiteral("--"));
    if (at < 0 || (end >= 0 && end < at))
        return {};
    if (at + 1 == arguments.size())
        fail(tr("--classroom needs the file of a class, which Edit › Classroom writes."));
    const QString path = QFileInfo(arguments.at(at + 1)).absoluteFilePath();
    arguments.remove(at, 2);
    return path;
}

WindowStart CommandLine::windowStart(QStringList arguments)
{
    WindowStart start;
    start.classFile = classFileIn(arguments);
    QStringList files;
    bool onlyFiles = false;
    for (const QString& argument : arguments) {
        if (!onlyFiles && argument == QLatin1String("--"))
            onlyFiles = true;
        else if (!onlyFiles && argument == QLatin1String("--vr"))
            start.entersVr = true;
        else if (!onlyFiles && argument == QLatin1String(simulatorOption))
            start.entersVr = start.simulatesVr = true;
        else if (!onlyFiles && argument.size() > 1 && argument.startsWith(QLatin1Char('-')))
            fail(tr("Unknown option %1; fettle --help lists them.").arg(argument));
        else
            files << argument;
    }
    if (files.size() > 1)
        fail(tr("One file at a time can be opened, but %n were given; fettle --help says more.", nullptr,
                static_cast<int>(files.size())));
    if (!files.isEmpty() && !start.classFile.isEmpty())
        fail(tr("%1 cannot be opened in a class, which begins with its own models.").arg(files.first()));
    if (!files.isEmpty())
        start.file = QFileInfo(files.first()).absoluteFilePath();
    return start;
}

bool CommandLine::parse(QCommandLineParser& parser, const QString& command, const QStringList& arguments)
{
    parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    parser.addOption({{QStringLiteral("h"), QStringLiteral("help")}, tr("Says this.")});
    if (!parser.parse(QStringList(QStringLiteral("fettle ") + command) + arguments))
        fail(QStringLiteral("%1: %2").arg(command, parser.errorText()));
    if (!parser.isSet(QStringLiteral("help")))
        return true;
    QString text = parser.helpText(); // its first line names the program as it was called, and no command
    const QString called = QCoreApplication::arguments().constFirst();
    if (const qsizetype at = text.indexOf(called); at >= 0)
        text.replace(at, called.size(), QStringLiteral("fettle ") + command);
    print(text);
    return false;
}

void CommandLine::addOutput(QCommandLineParser& parser, const QString& word)
{
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")}, tr("The file to write."), word});
}

QString CommandLine::output(const QCommandLineParser& parser, const QString& command)
{
    const QString path = parser.value(QStringLiteral("output"));
    if (path.isEmpty())
        fail(tr("%1: the file to write is missing; -o names it.").arg(command));
    return path;
}

void CommandLine::fail(const QString& sentence)
{
    throw CommandFailure{sentence};
}

void CommandLine::requireMeshEnding(const QString& path)
{
    if (!ui::isWritten(path))
        fail(tr("%1: its ending does not say a format that is written; %2 are.").arg(path, ui::writtenFormats()));
}

void CommandLine::print(const QString& text)
{
    errno = 0;
    if (!write(stdout, text))
        fail(tr("The answer cannot be written to the standard output (%1).").arg(qt_error_string(errno)));
}

/// One line, whatever a file's name holds.
void CommandLine::printError(const QString& sentence)
{
    QString line;
    for (const QChar c : sentence)
        line += c.isPrint() || c.isSurrogate() ? c : QLatin1Char(' ');
    write(stderr, QStringLiteral("fettle: %1\n").arg(line.trimmed()));
}

void CommandLine::printProgress(const QString& what)
{
    constexpr const char* line = "\r\033[K"; // from its beginning, and what it said goes
    if (isTerminal(stderr))
        write(stderr, QLatin1StringView(line) + what);
}

QString CommandLine::help()
{
    return tr("Fettle sculpts closed models that stay ready to print.\n"
              "\n"
              "  fettle [--vr] [FILE]             open the window, with a model or with a ball of clay; --vr enters VR "
              "with it\n"
              "  fettle --vr-simulator [FILE]     the same without a headset: a window shows what it would, mouse and "
              "keys are head and wands\n"
              "  fettle [--vr] --classroom CLASS.ini\n"
              "                                   begin a class in turns, as its teacher set it up (Edit > Classroom)\n"
              "  fettle check FILE... [--unit mm|cm|m|in] [--print] [--json] [--csv]\n"
              "                                   say whether models are in order; several files or a folder: a table\n"
              "  fettle convert IN OUT [--unit mm|cm|m|in] [--size MM] [--up y|z] [--legalise] [--triangles N]\n"
              "                                   write a model in another format or size, mended, or with fewer "
              "triangles\n"
              "  fettle replay --strokes S.json [--in FILE] [--out FILE] [--stats T.json] [--frames FOLDER] [--verify "
              "local|full|none]\n"
              "                                   play recorded strokes on a model\n"
              "  fettle report FOLDER -o OUT.html|OUT.pdf [--unit mm|cm|m|in]\n"
              "                                   a class report: picture, size, print-ready or why not, strokes and "
              "time of each model\n"
              "  fettle sheet FILE... -o OUT.pdf [--unit mm|cm|m|in] [--shaded]\n"
              "                                   drawings of models or folders to scale, a page each\n"
              "  fettle lesson [LESSON] [--model FILE] [--step N] [--pack OUT.zip] [--unpack FOLDER] [--pictures "
              "FOLDER] [--out FILE]\n"
              "                                   check a lesson by playing it to its end, or a pupil's model by one "
              "of its steps\n"
              "  fettle brush [PRESET] [--picture OUT.png]\n"
              "                                   say what a brush preset holds, or why it is none\n"
              "  fettle help COMMAND              the options of one of them\n"
              "  fettle --version\n"
              "\n"
              "Formats: %1. Lengths are in millimetres.\n"
              "Status: 0 done, 1 the answer is no, 2 bad input or usage (with a line on standard error).\n")
        .arg(ui::modelFormats());
}
} // namespace app
