#include "app/commands/command_line.h"

#include "app/commands/standard_files.h"
#include "app/commands/word_guess.h"
#include "app/model/model_loader.h"
#include "app/platform/terminal.h"

#include "core/mesh/openmesh_version.h"
#include "core/util/system_code.h"
#include "ui/util/format_filters.h"

#include <QFileInfo>

#include <algorithm>
#include <cstdio>
#include <new>

namespace app
{
namespace
{
struct CommandRow
{
    const char* name;
    ExitStatus (*run)(const QStringList&);
    const char *usage, *summary;
};
constexpr CommandRow commandTable[] = {
    {"new", newCommand, "new STARTER OUT",
     QT_TRANSLATE_NOOP("app::CommandLine", "write a starting shape: a ball, a cube, a vase and others")},
    {"check", checkCommand, "check FILE...",
     QT_TRANSLATE_NOOP("app::CommandLine",
                       "check whether models are watertight and will print; several files or a folder: a table")},
    {"convert", convertCommand, "convert IN OUT",
     QT_TRANSLATE_NOOP("app::CommandLine",
                       "write a model in another format or size, repaired, or with fewer triangles")},
    {"boolean", booleanCommand, "boolean OP A B -o OUT",
     QT_TRANSLATE_NOOP("app::CommandLine", "unite models, subtract them from the first, or keep what they share")},
    {"replay", replayCommand, "replay --strokes S.json",
     QT_TRANSLATE_NOOP("app::CommandLine", "play recorded strokes on a model")},
    {"report", reportCommand, "report FOLDER -o OUT",
     QT_TRANSLATE_NOOP("app::CommandLine", "write a class report: picture, size, print-ready or why not, strokes and "
                                           "time of each model")},
    {"sheet", sheetCommand, "sheet FILE... -o OUT",
     QT_TRANSLATE_NOOP("app::CommandLine", "draw models or folders of models to scale, a page each")},
    {"lesson", lessonCommand, "lesson [LESSON]",
     QT_TRANSLATE_NOOP("app::CommandLine",
                       "check a lesson by playing it to its end, or a pupil's model by one of its steps")},
    {"brush", brushCommand, "brush [PRESET]",
     QT_TRANSLATE_NOOP("app::CommandLine", "show what a brush preset contains, or why it is invalid")},
};

/// Returns the table row of a command; null if there is no such command.
const CommandRow* commandNamed(const QString& word)
{
    const auto* const found =
        std::ranges::find_if(commandTable, [&](const CommandRow& row) { return word == QLatin1String(row.name); });
    return found == std::end(commandTable) ? nullptr : found;
}

QStringList commandNames()
{
    QStringList names;
    for (const CommandRow& row : commandTable)
        names << QString::fromLatin1(row.name);
    return names;
}

QStringList windowOptions()
{
    return {QStringLiteral("--vr"), QString::fromLatin1(simulatorOption), QStringLiteral("--classroom"),
            QStringLiteral("--help"), QStringLiteral("--version")};
}

bool isHelp(const QString& word)
{
    return word == QLatin1String("--help") || word == QLatin1String("-h");
}

bool isVersion(const QString& word)
{
    return word == QLatin1String("--version") || word == QLatin1String("-v");
}

/// Returns whether `is` returns true for one of the arguments before "--"; arguments after "--" are file names.
bool hasOption(const QStringList& arguments, bool (*is)(const QString&))
{
    const auto end = std::ranges::find(arguments, QStringLiteral("--"));
    return std::any_of(arguments.begin(), end, is);
}

/// Returns whether the arguments name a command, or ask for help or the version. If so, run() handles them, valid or
/// not.
bool isCommand(const QStringList& arguments)
{
    if (arguments.isEmpty())
        return false;
    return commandNamed(arguments.first()) || arguments.first() == QLatin1String("help") ||
           hasOption(arguments, isHelp) || hasOption(arguments, isVersion);
}

/// Removes options that QApplication handles itself (listed in QGuiApplication's documentation).
QStringList withoutQtOptions(const QStringList& arguments)
{
    static const QStringList alone{QStringLiteral("reverse"), QStringLiteral("nograb"), QStringLiteral("dograb"),
                                   QStringLiteral("sync"), QStringLiteral("widgetcount")};
    static const QStringList withValue{QStringLiteral("platform"),        QStringLiteral("platformpluginpath"),
                                       QStringLiteral("platformtheme"),   QStringLiteral("plugin"),
                                       QStringLiteral("qwindowgeometry"), QStringLiteral("geometry"),
                                       QStringLiteral("qwindowicon"),     QStringLiteral("icon"),
                                       QStringLiteral("qwindowtitle"),    QStringLiteral("title"),
                                       QStringLiteral("session"),         QStringLiteral("display"),
                                       QStringLiteral("fontengine"),      QStringLiteral("style"),
                                       QStringLiteral("stylesheet"),      QStringLiteral("qmljsdebugger")};
    QStringList ours;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == QLatin1String("--"))
            return ours + arguments.sliced(i);
        const bool isOption = arguments[i].startsWith(u'-');
        const QString word = arguments[i].sliced(arguments[i].startsWith(QLatin1String("--")) ? 2 : isOption ? 1 : 0);
        if (isOption && withValue.contains(word))
            ++i;
        else if (!isOption || (!alone.contains(word) && !withValue.contains(word.section(u'=', 0, 0))))
            ours << arguments[i];
    }
    return ours;
}

bool write(std::FILE* stream, const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    const auto size = static_cast<std::size_t>(bytes.size());
    return std::fwrite(bytes.constData(), 1, size, stream) == size && std::fflush(stream) == 0;
}
} // namespace

bool CommandLine::opensWindow(const QStringList& arguments)
{
    try {
        if (isCommand(arguments))
            return false;
        windowStart(arguments);
        return true;
    } catch (const CommandFailure&) {
        return false; // run() reports the error in the system's language, without needing a display
    }
}

bool CommandLine::needsFonts(const QStringList& arguments)
{
    const CommandRow* const row = arguments.isEmpty() ? nullptr : commandNamed(arguments.first());
    const bool isHandout = std::ranges::any_of(
        arguments, [](const QString& argument) { return argument.startsWith(QLatin1String("--pdf")); });
    return row && (row->run == reportCommand || row->run == sheetCommand || (row->run == lessonCommand && isHandout));
}

ExitStatus CommandLine::run(const QStringList& arguments, const QString& openXr)
{
    try {
        return dispatch(arguments, openXr);
    } catch (const CommandFailure& failure) {
        printError(failure.sentence);
        return failure.status;
    } catch (const std::bad_alloc&) {
        printError(tr("There is not enough memory for this."));
        return BadInput;
    }
}

ExitStatus CommandLine::dispatch(const QStringList& arguments, const QString& openXr)
{
    if (!isCommand(arguments)) {
        windowStart(arguments);
        return Done;
    }
    const QString& word = arguments.first();
    if (const CommandRow* const row = commandNamed(word))
        return row->run(arguments.mid(1));
    if (word == QLatin1String("help") || isHelp(word))
        return helpOn(arguments.value(1));
    print(hasOption(arguments, isHelp) ? help() : versionText(openXr));
    return Done;
}

/// Prints the help on one command, or the general help if `word` is empty.
ExitStatus CommandLine::helpOn(const QString& word)
{
    if (word.isEmpty()) {
        print(help());
        return Done;
    }
    const CommandRow* const row = commandNamed(word);
    if (!row)
        fail(tr("There is no command \"%1\": the commands are %2.")
                 .arg(word, commandNames().join(QStringLiteral(", "))));
    return row->run({QStringLiteral("--help")});
}

/// Removes `--classroom FILE` from the arguments and returns the absolute path of the file; empty if the option is
/// missing. Throws CommandFailure if the file's name is missing.
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
    arguments = withoutQtOptions(arguments);
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
            failAt(tr("\"%1\" is not an option.").arg(argument), meantWord(argument, windowOptions()));
        else if (QFileInfo::exists(argument))
            files << argument;
        else
            failAt(
                tr("\"%1\" is neither a command nor a file.").arg(argument),
                meantWord(argument, commandNames() + QStringList{QStringLiteral("help"), QStringLiteral("--version")}));
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

/// Throws CommandFailure. `meant`: suggested correction; may be empty.
void CommandLine::failAt(const QString& sentence, const QString& meant)
{
    fail(meant.isEmpty() ? tr("%1 See fettle --help.").arg(sentence)
                         : tr("%1 Did you mean %2? See fettle --help.").arg(sentence, meant));
}

void CommandLine::fail(const QString& sentence)
{
    throw CommandFailure{sentence};
}

void CommandLine::requireMeshEnding(const QString& path)
{
    if (!ui::isWritten(path))
        fail(tr("%1: cannot tell the format: the ending must be one of %2.")
                 .arg(path, ui::writtenEndings().join(QStringLiteral(", "))));
}

void CommandLine::print(const QString& text)
{
    core::clearStreamCode();
    if (!write(stdout, text))
        fail(tr("The answer cannot be written to the standard output (%1).").arg(qt_error_string(core::streamCode())));
}

void CommandLine::printRemark(const QString& text)
{
    if (StandardFiles::hasOutput())
        write(stderr, text);
    else
        print(text);
}

/// Prints on a single line, even if a file name contains line breaks.
void CommandLine::printError(const QString& sentence)
{
    QString line;
    for (const QChar c : StandardFiles::named(sentence))
        line += c.isPrint() || c.isSurrogate() ? c : QLatin1Char(' ');
    write(stderr, QStringLiteral("fettle: %1\n").arg(line.trimmed()));
}

void CommandLine::printProgress(const QString& what)
{
    constexpr const char* line = "\r\033[K"; // returns to the beginning of the line and clears it
    if (isTerminal(stderr))
        write(stderr, QLatin1StringView(line) + what);
}

QString CommandLine::help()
{
    constexpr int usageColumns = 31;
    QString text =
        tr("Fettle sculpts closed models that stay ready to print.\n"
           "\n"
           "  fettle [--vr] [FILE]             open the window, with a model or with a ball of clay; --vr enters "
           "VR with it\n"
           "  fettle --vr-simulator [FILE]     the same without a headset: a window stands in for it; mouse "
           "and keyboard move head and controllers\n"
           "  fettle [--vr] --classroom CLASS.fettleclass\n"
           "                                   start a class session, as its teacher set it up (Edit > "
           "Classroom)\n");
    for (const CommandRow& row : commandTable)
        text += QStringLiteral("  fettle %1  %2\n")
                    .arg(QString::fromLatin1(row.usage), 7 - usageColumns)
                    .arg(tr(row.summary));
    return text + tr("  fettle help COMMAND              show the options of one of them\n"
                     "  fettle --version                 show the version, and those of the libraries\n"
                     "\n"
                     "Formats: %1. Lengths are in millimetres. The file - is the standard input or output.\n"
                     "Status: 0 done, 1 the answer is no, 2 bad input or usage (with a line on standard error).\n")
                      .arg(ui::modelFormats());
}

/// The application's version already contains the commit, if it is known.
QString CommandLine::versionText(const QString& openXr)
{
    return QStringLiteral("fettle %1\nQt %2, OpenXR %3, OpenMesh %4\n")
               .arg(QCoreApplication::applicationVersion(), QString::fromLatin1(qVersion()), openXr,
                    QString::fromStdString(core::openMeshVersion())) +
           tr("MIT License: free to use, change and pass on, without warranty") + u'\n';
}
} // namespace app
