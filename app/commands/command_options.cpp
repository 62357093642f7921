#include "app/commands/command_options.h"

#include "app/commands/command_line.h"

#include <QFileInfo>
#include <QLocale>

namespace app
{
namespace
{
QString inWords(double number)
{
    return QString::number(number, 'g', 8);
}

QString dashed(const QStringList& options)
{
    return QStringLiteral("--") + options.join(QStringLiteral(", --"));
}
} // namespace

CommandOptions::CommandOptions(QCommandLineParser& parser, const QString& command, const QStringList& arguments)
    : m_parser(parser)
    , m_command(command)
{
    parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    parser.addOption({{QStringLiteral("h"), QStringLiteral("help")}, tr("Show this help.")});
    if (!parser.parse(QStringList(QStringLiteral("fettle ") + command) + arguments))
        CommandLine::fail(QStringLiteral("%1: %2").arg(command, parser.errorText()));
    if (!parser.isSet(QStringLiteral("help")))
        return;
    QString text = parser.helpText(); // its first line contains the program's name as called, without the subcommand
    const QString called = QCoreApplication::arguments().constFirst();
    if (const qsizetype at = text.indexOf(called); at >= 0)
        text.replace(at, called.size(), QStringLiteral("fettle ") + command);
    CommandLine::print(text);
    m_isAnswered = true;
}

void CommandOptions::refuse(const QString& option, const QString& wanted) const
{
    CommandLine::fail(tr("%1: --%2 must be %3, not \"%4\".").arg(m_command, option, wanted, text(option)));
}

qsizetype CommandOptions::choice(const QString& option, const QStringList& words) const
{
    if (!has(option))
        return 0;
    const qsizetype place = words.indexOf(text(option));
    if (place < 0)
        refuse(option, tr("one of %1").arg(words.join(QStringLiteral(", "))));
    return place;
}

double CommandOptions::number(const QString& option, double min, double max) const
{
    bool isNumber = false;
    const double number = QLocale::c().toDouble(text(option), &isNumber);
    if (!isNumber || !(number >= min && number <= max))
        refuse(option, tr("a number from %1 to %2").arg(inWords(min), inWords(max)));
    return number;
}

unsigned CommandOptions::wholeNumber(const QString& option, unsigned min) const
{
    if (!has(option))
        return min;
    bool isNumber = false;
    const unsigned number = QLocale::c().toUInt(text(option), &isNumber);
    if (!isNumber || number < min)
        refuse(option, tr("a whole number, %1 or more").arg(min));
    return number;
}

void CommandOptions::requireOneOf(const QString& first, const QString& second) const
{
    if (has(first) && has(second))
        CommandLine::fail(tr("%1: --%2 and --%3 cannot be used together.").arg(m_command, first, second));
}

void CommandOptions::requireWith(const QStringList& options, const QString& needed) const
{
    for (const QString& option : options)
        if (has(option) && !has(needed))
            CommandLine::fail(tr("%1: %2 can only be used with --%3.").arg(m_command, dashed({option}), needed));
}

void CommandOptions::addNoClobber(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("no-clobber"), tr("Overwrite no existing file; end with status 2 instead.")});
}

void CommandOptions::requireFree(const QString& path) const
{
    const QFileInfo file(path);
    if (has(QStringLiteral("no-clobber")) && !path.isEmpty() && path != QLatin1String("-") &&
        (file.exists() || file.isSymLink()))
        CommandLine::fail(
            tr("%1: %2 already exists and is not overwritten, because of --no-clobber.").arg(m_command, path));
}

void CommandOptions::addOutput(QCommandLineParser& parser, const QString& word)
{
    parser.addOption({{QStringLiteral("o"), QStringLiteral("out"), QStringLiteral("output")},
                      tr("The file to write, in the format of its ending; or -."),
                      word});
}

QString CommandOptions::output() const
{
    const QString path = text(QStringLiteral("output"));
    if (path.isEmpty())
        CommandLine::fail(tr("%1: the output file is missing; name it with -o.").arg(m_command));
    return path;
}
} // namespace app
