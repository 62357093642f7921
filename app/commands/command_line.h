#pragma once

#include <QCoreApplication>
#include <QStringList>

namespace app
{
/// The exit status of a subcommand (resources/reference/command-line.md, "Exit status").
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
    /// Returns whether the arguments (without the program's name) open the window: they neither name a subcommand,
    /// which wins over file names, nor ask for help or the version, nor are wrong.
    static bool opensWindow(const QStringList& arguments);
    /// Whether it draws letters on pages: run() needs a QGuiApplication then, on whatever platform.
    static bool needsFonts(const QStringList& arguments);
    /// Does what needs no window. Needs a QCoreApplication. `openXr`: version of the loader that it was built with.
    static ExitStatus run(const QStringList& arguments, const QString& openXr);
    /// Reads arguments that are no subcommand. Throws CommandFailure.
    static WindowStart windowStart(QStringList arguments);

    [[noreturn]] static void fail(const QString& sentence);
    /// Throws CommandFailure unless a mesh can be written under that name, by its ending.
    static void requireMeshEnding(const QString& path);
    static void print(const QString& text);
    /// Prints what is no answer of its own where the standard output carries a file: to standard error then.
    static void printRemark(const QString& text);
    static void printError(const QString& sentence);
    /// Shows what goes on, in place of what was shown before; only at a terminal. Empty: clears the line.
    static void printProgress(const QString& what);

private:
    static QString classFileIn(QStringList& arguments);
    static ExitStatus dispatch(const QStringList& arguments, const QString& openXr);
    static ExitStatus helpOn(const QString& word);
    static QString help();
    static QString versionText(const QString& openXr);
    [[noreturn]] static void failAt(const QString& sentence, const QString& meant);
};

ExitStatus brushCommand(const QStringList& arguments);
ExitStatus checkCommand(const QStringList& arguments);
ExitStatus convertCommand(const QStringList& arguments);
ExitStatus lessonCommand(const QStringList& arguments);
ExitStatus newCommand(const QStringList& arguments);
ExitStatus replayCommand(const QStringList& arguments);
ExitStatus reportCommand(const QStringList& arguments);
ExitStatus sheetCommand(const QStringList& arguments);
} // namespace app
