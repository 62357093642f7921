#pragma once

#include "app/commands/command_options.h"

#include "ui/util/format_filters.h"

namespace app
{
/// Provides standard input and output, named "-", as temporary files: readers and writers need paths, and recognise the
/// format by the extension. All state is per process.
class StandardFiles
{
    Q_DECLARE_TR_FUNCTIONS(app::StandardFiles)

public:
    static bool isStandard(const QString& name) { return name == QLatin1String("-"); }

    /// Adds the options --from and --to: the format of standard input and output.
    static void addFrom(QCommandLineParser& parser);
    static void addTo(QCommandLineParser& parser, const QStringList& formats = ui::writtenEndings());

    /// Returns the path to read: `name`, or for "-" a file with the whole content of standard input, in the format of
    /// --from. Throws CommandFailure.
    static QString input(const CommandOptions& options, const QString& name);
    /// Returns the path to write: `name`, or for "-" a file that flush() sends to standard output. Its format is the
    /// only one in `formats`, or that of --to. Throws CommandFailure if there is no such format, or if it is binary and
    /// standard output is a terminal.
    static QString output(const CommandOptions& options, const QString& name,
                          const QStringList& formats = ui::writtenEndings());
    /// Returns whether standard output carries a file; nothing else may then be printed to it.
    static bool hasOutput();
    /// Copies the file of output(), if there is one, to standard output. Throws CommandFailure.
    static void flush();

    /// Replaces the paths of the temporary files in a sentence by "standard input" and "standard output".
    static QString named(QString sentence);
};
} // namespace app
