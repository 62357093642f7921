#pragma once

#include <QCoreApplication>
#include <QStringList>

namespace app
{
/// The exit status of a subcommand (resources/reference/command-line.md, "Exit status").
enum ExitStatus { Done = 0, AnswerIsNo = 1, BadInput = 2 };

/// Thrown to end a subcommand with one sentence on standard error.
struct CommandFailure
{
    QString sentence;
    ExitStatus status = BadInput;
};

inline constexpr const char* simulatorOption = "--vr-simulator";

/// The content of the window when `fettle` is run without a subcommand.
struct WindowStart
{
    QString file; ///< absolute path; empty: open the ball
    bool entersVr = false;
    bool simulatesVr = false; ///< whether VR is the simulator instead of a headset
    QString classFile;        ///< absolute path; empty: no class
};

/// The command line. Works without a display. Standard output contains only results.
class CommandLine
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandLine)

public:
    /// Returns whether the arguments (without the program's name) open the window. Returns false if they begin with a
    /// subcommand (even if a file has that name), ask for help or the version, or are wrong.
    static bool opensWindow(const QStringList& arguments);
    /// Returns whether the subcommand draws text on pages: run() then needs a QGuiApplication, on any platform.
    static bool needsFonts(const QStringList& arguments);
    /// Runs a command that needs no window. Precondition: a QCoreApplication exists. `openXr`: version of the OpenXR
    /// loader that Fettle was built with.
    static ExitStatus run(const QStringList& arguments, const QString& openXr);
    /// Parses the arguments that open the window. Throws CommandFailure.
    static WindowStart windowStart(QStringList arguments);

    [[noreturn]] static void fail(const QString& sentence);
    /// Throws CommandFailure unless the file's extension is a format in which meshes can be written.
    static void requireMeshEnding(const QString& path);
    static void print(const QString& text);
    /// Prints a remark to standard output, or to standard error if standard output carries a file.
    static void printRemark(const QString& text);
    static void printError(const QString& sentence);
    /// Shows what is being done, in place of the previous text; an empty text clears the line. Does nothing unless
    /// standard error is a terminal.
    static void printProgress(const QString& what);

private:
    static QString classFileIn(QStringList& arguments);
    static ExitStatus dispatch(const QStringList& arguments, const QString& openXr);
    static ExitStatus helpOn(const QString& word);
    static QString help();
    static QString versionText(const QString& openXr);
    [[noreturn]] static void failAt(const QString& sentence, const QString& meant);
};

ExitStatus booleanCommand(const QStringList& arguments);
ExitStatus brushCommand(const QStringList& arguments);
ExitStatus checkCommand(const QStringList& arguments);
ExitStatus convertCommand(const QStringList& arguments);
ExitStatus lessonCommand(const QStringList& arguments);
ExitStatus newCommand(const QStringList& arguments);
ExitStatus replayCommand(const QStringList& arguments);
ExitStatus reportCommand(const QStringList& arguments);
ExitStatus sheetCommand(const QStringList& arguments);
} // namespace app
