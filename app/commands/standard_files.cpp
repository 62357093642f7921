#include "app/commands/standard_files.h"

#include "app/commands/command_line.h"
#include "app/platform/terminal.h"

#include "core/io/mesh_io.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <cstdio>
#include <filesystem>
#include <optional>

namespace app
{
namespace
{
constexpr qint64 chunkSize = 1 << 20;

/// Paths of the temporary files for standard input and output, and their folder, which is removed by flush() or at the
/// end of the process. Empty: not used.
struct Files
{
    std::optional<QTemporaryDir> folder;
    QString input, output;

    QString pathOf(const QString& name)
    {
        if (!folder)
            folder.emplace(QDir::tempPath() + QStringLiteral("/fettle-XXXXXX"));
        return folder->filePath(name);
    }
};

Files& files()
{
    static Files files;
    return files;
}

QStringList readFormats()
{
    QStringList formats;
    for (const std::string_view ending : core::meshEndings())
        formats << QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
    return formats;
}

bool isText(const QString& ending)
{
    return ending == QLatin1String("obj") || ending == QLatin1String("off") || ending == QLatin1String("json") ||
           ending == QLatin1String("html");
}

[[noreturn]] void failToCopy(const QString& sentence, const QFile& from, const QFile& to)
{
    const QFile& faulty = from.error() != QFileDevice::NoError ? from : to;
    CommandLine::fail(sentence.arg(faulty.errorString()));
}

/// Copies the rest of one file to the other. Returns false if that fails; one of the files then has the reason.
bool copy(QFile& from, QFile& to)
{
    for (;;) {
        const QByteArray bytes = from.read(chunkSize);
        if (bytes.isEmpty())
            return from.error() == QFileDevice::NoError && to.flush();
        if (to.write(bytes) != bytes.size())
            return false;
    }
}
} // namespace

void StandardFiles::addFrom(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("from"), tr("Format of a model that is read from the standard input, -."),
                      readFormats().join(u'|')});
}

void StandardFiles::addTo(QCommandLineParser& parser, const QStringList& formats)
{
    parser.addOption({QStringLiteral("to"), tr("Format of the standard output, -."), formats.join(u'|')});
}

QString StandardFiles::input(const CommandOptions& options, const QString& name)
{
    const QString from = QStringLiteral("from");
    if (!isStandard(name))
        return name;
    if (!options.has(from))
        CommandLine::fail(tr("%1: --%2 must say the format of -: one of %3.")
                              .arg(options.command(), from, readFormats().join(QStringLiteral(", "))));
    const QString ending = readFormats()[options.choice(from, readFormats())];
    if (!files().input.isEmpty())
        return files().input;
    const QString problem = tr("The standard input cannot be read (%1).");
    files().input = files().pathOf(QStringLiteral("input.") + ending);
    QFile standard, file(files().input);
    if (!standard.open(stdin, QFile::ReadOnly) || !file.open(QFile::WriteOnly) || !copy(standard, file))
        failToCopy(problem, standard, file);
    return files().input;
}

QString StandardFiles::output(const CommandOptions& options, const QString& name, const QStringList& formats)
{
    const QString to = QStringLiteral("to");
    if (!isStandard(name))
        return name;
    if (formats.size() > 1 && !options.has(to))
        CommandLine::fail(tr("%1: --%2 must say the format of -: one of %3.")
                              .arg(options.command(), to, formats.join(QStringLiteral(", "))));
    const QString format = formats.size() == 1 ? formats.constFirst() : formats[options.choice(to, formats)];
    if (isTerminal(stdout) && !isText(format))
        CommandLine::fail(tr("%1: %2 is binary and is not printed to a terminal: redirect the standard output to a "
                             "file or a program.")
                              .arg(options.command(), format.toUpper()));
    files().output = files().pathOf(QStringLiteral("output.") + format);
    return files().output;
}

bool StandardFiles::hasOutput()
{
    return !files().output.isEmpty();
}

void StandardFiles::flush()
{
    if (!hasOutput())
        return;
    QFile file(files().output), standard;
    const bool isOpen = file.open(QFile::ReadOnly);
    // Removed first: SIGPIPE may end the process while writing, and the open file stays readable. Windows has no such
    // signal, and removes no file that is open.
    std::error_code ignored;
    std::filesystem::remove_all(QFileInfo(files().output).path().toStdU16String(), ignored);
    if (!isOpen || !standard.open(stdout, QFile::WriteOnly) || !copy(file, standard))
        failToCopy(tr("The standard output cannot be written (%1)."), file, standard);
    file.close();
    files().folder.reset();
}

QString StandardFiles::named(QString sentence)
{
    if (!files().input.isEmpty())
        sentence.replace(files().input, tr("(standard input)"));
    if (!files().output.isEmpty())
        sentence.replace(files().output, tr("(standard output)"));
    return sentence;
}
} // namespace app
