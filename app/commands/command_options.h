#pragma once

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace app
{
/// The parsed options of a subcommand. Checks values with the same error messages for all subcommands. An option that
/// is unknown, wrong, or not allowed makes the constructor or the checking function throw CommandFailure.
class CommandOptions
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandOptions)

public:
    /// Parses the arguments. Precondition: `parser` has all its options and outlives this.
    CommandOptions(QCommandLineParser& parser, const QString& command, const QStringList& arguments);
    /// Returns whether --help was given; it has then been printed.
    bool isAnswered() const { return m_isAnswered; }

    const QString& command() const { return m_command; }
    QStringList files() const { return m_parser.positionalArguments(); }
    bool has(const QString& option) const { return m_parser.isSet(option); }
    QString text(const QString& option) const { return m_parser.value(option); }

    /// Returns the index in `words` of the option's value; 0 if the option is not set. Fails for any other word.
    qsizetype choice(const QString& option, const QStringList& words) const;
    /// Returns the option's value as a number. Fails if it is not a number from `min` to `max`, or is not set.
    double number(const QString& option, double min, double max) const;
    /// Returns the option's value as an integer; `min` if the option is not set. Fails for values below `min`.
    unsigned wholeNumber(const QString& option, unsigned min) const;

    /// Fails if both options are set.
    void requireOneOf(const QString& first, const QString& second) const;
    /// Fails if one of `options` is set, but not `needed`.
    void requireWith(const QStringList& options, const QString& needed) const;

    /// Adds --no-clobber.
    static void addNoClobber(QCommandLineParser& parser);
    /// Fails if --no-clobber is set and the file exists. An empty path and "-" are not files.
    void requireFree(const QString& path) const;
    /// Adds the option -o. `word`: name of the file in the help.
    static void addOutput(QCommandLineParser& parser, const QString& word);
    /// Returns the value of -o. Fails if it is not set.
    QString output() const;

private:
    [[noreturn]] void refuse(const QString& option, const QString& wanted) const;

    QCommandLineParser& m_parser;
    QString m_command;
    bool m_isAnswered = false;
};
} // namespace app
