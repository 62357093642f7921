#pragma once

#include "app/commands/command_options.h"

#include "ui/util/format_filters.h"

namespace app
{
/// The standard input and output as files, where one is named "-": readers and writers have paths, and know the format
/// by the ending. There is one of each in a process.
class StandardFiles
{
    Q_DECLARE_TR_FUNCTIONS(app::StandardFiles)

public:
    static bool isStandard(const QString& name) { return name == QLatin1String("-"); }

    /// Adds --from and --to: the format of what comes or goes that way.
    static void addFrom(QCommandLineParser& parser);
    static void addTo(QCommandLineParser& parser, const QStringList& formats = ui::writtenEndings());

    /// Returns the path of what is to be read: `name`; of "-" that of a file that holds the standard input to its end,
    /// in the format of --from. Throws CommandFailure.
    static QString input(const CommandOptions& options, const QString& name);
    /// Returns the path of what is to be written: `name`; of "-" that of a file for flush(), in the only format, or in
    /// that of --to. Throws CommandFailure: no such format, or it is binary and a terminal would show it.
    static QString output(const CommandOptions& options, const QString& name,
                          const QStringList& formats = ui::writtenEndings());
    /// Returns whether the standard output carries a file, and nothing beside it.
    static bool hasOutput();
    /// Sends the file of output(), if there is one, to the standard output. Throws CommandFailure.
    static void flush();

    /// Names the standard input and output in a sentence about their files.
    static QString named(QString sentence);
};
} // namespace app
