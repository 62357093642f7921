#pragma once

#include <QList>
#include <QString>
#include <QStringList>

/// A table of a page. Cells are trimmed, and "\|" in them is read as "|".
struct ReferenceTable
{
    QStringList head;
    QList<QStringList> rows;

    /// Returns the words in backticks in the first column, row by row.
    QStringList keys() const;
};

/// A fenced block of a page, with its language and its text.
struct ReferenceExample
{
    QString language, text;
};

/// The parts of a page of resources/reference that tests compare with the program.
class ReferencePage
{
public:
    /// Reads a page. `name`: file name without its ending.
    explicit ReferencePage(const QString& name);

    /// Returns the first table whose first heading is `head`, or an empty table. `section`: title of the only section
    /// to be searched; empty: the whole page.
    ReferenceTable table(const QString& head, const QString& section = {}) const;
    /// Returns the examples in a language, in page order.
    QStringList examples(const QString& language) const;
    QStringList sections() const;
    /// Returns those lines of a section that are in no table and no example.
    QStringList text(const QString& section) const;

private:
    struct Section
    {
        QString title;
        QList<ReferenceTable> tables;
        QStringList text;
    };

    QList<Section> m_sections;
    QList<ReferenceExample> m_examples;
};

/// Returns the words in backticks.
QStringList codesIn(const QString& text);
