#pragma once

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QStringList>

namespace app
{
/// The exit status of a subcommand (README.md, "Two commands").
enum ExitStatus { Done = 0, AnswerIsNo = 1, BadInput = 2 };

/// Ends a subcommand: one sentence for stderr.
struct CommandFailure
{
    QString sentence;
    ExitStatus status = BadInput;
};

inline constexpr const char* simulatorOption = "--vr-simulator";

/// What `fettle` without a subcommand begins with.
struct WindowStart
{
    QString file; ///< absolute; empty: the ball
    bool entersVr = false;
    bool simulatesVr = false; ///< it enters the simulator
    QString classFile;        ///< absolute; empty: it is no class
};

/// The command line. Works without a display; standard output carries only answers.
class CommandLine
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandLine)

public:
    /// Whether the arguments (without the program's name) name a subcommand, --help or --version. These words win over
    /// file names.
    static bool isCommand(const QStringList& arguments);
    /// Whether it draws letters on pages: run() needs a QGuiApplication then, on whatever platform.
    static bool needsFonts(const QStringList& arguments);
    /// Runs it. Needs a QCoreApplication.
    static ExitStatus run(const QStringList& arguments);
    /// For `fettle` without a subcommand. Throws CommandFailure.
    static WindowStart windowStart(QStringList arguments);

    /// Throws CommandFailure with usage when the arguments do not fit. --help is answered.
    static bool parse(QCommandLineParser& parser, const QString& command, const QStringList& arguments);
    /// -o, and what was given there. output() throws CommandFailure if nothing was. `word`: how usage calls it.
    static void addOutput(QCommandLineParser& parser, const QString& word);
    static QString output(const QCommandLineParser& parser, const QString& command);
    [[noreturn]] static void fail(const QString& sentence);
    /// Throws CommandFailure unless a mesh can be written under that name, by its ending.
    static void requireMeshEnding(const QString& path);
    static void print(const QString& text);
    static void printError(const QString& sentence);
    /// Shows what goes on, in place of what was shown before; only at a terminal. Empty: clears the line.
    static void printProgress(const QString& what);

private:
    static QString classFileIn(QStringList& arguments);
    static ExitStatus dispatch(const QStringList& arguments);
    static QString help();
};

ExitStatus brushCommand(const QStringList& arguments);
ExitStatus checkCommand(const QStringList& arguments);
ExitStatus convertCommand(const QStringList& arguments);
ExitStatus lessonCommand(const QStringList& arguments);
ExitStatus replayCommand(const QStringList& arguments);
ExitStatus reportCommand(const QStringList& arguments);
ExitStatus sheetCommand(const QStringList& arguments);
} // namespace app
