#pragma once

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace app
{
/// The options of a subcommand: parsed, and their values checked and refused in the same words by all. Throws
/// CommandFailure, with usage.
class CommandOptions
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandOptions)

public:
    /// Parses the arguments; `parser` has the options by then, and outlives this.
    CommandOptions(QCommandLineParser& parser, const QString& command, const QStringList& arguments);
    /// Returns whether --help was asked for, and was answered.
    bool isAnswered() const { return m_isAnswered; }

    const QString& command() const { return m_command; }
    QStringList files() const { return m_parser.positionalArguments(); }
    bool has(const QString& option) const { return m_parser.isSet(option); }
    QString text(const QString& option) const { return m_parser.value(option); }

    /// Returns the place of the option's word among `words`; 0 if the option is not set.
    qsizetype choice(const QString& option, const QStringList& words) const;
    /// Returns a number from `min` to `max`.
    double number(const QString& option, double min, double max) const;
    /// Returns a whole number, `min` or more; `min` if the option is not set.
    unsigned wholeNumber(const QString& option, unsigned min) const;

    /// Refuses two options that are both set.
    void requireOneOf(const QString& first, const QString& second) const;
    /// Refuses options that are set without the one that they need.
    void requireWith(const QStringList& options, const QString& needed) const;

    /// Adds --no-clobber.
    static void addNoClobber(QCommandLineParser& parser);
    /// Refuses a file that is there, if --no-clobber is set. An empty path and "-" are no file.
    void requireFree(const QString& path) const;
    /// Adds -o. `word`: how usage calls its file.
    static void addOutput(QCommandLineParser& parser, const QString& word);
    /// Returns the file of -o, which must be there.
    QString output() const;

private:
    [[noreturn]] void refuse(const QString& option, const QString& wanted) const;

    QCommandLineParser& m_parser;
    QString m_command;
    bool m_isAnswered = false;
};
} // namespace app
