#pragma once

#include <QList>
#include <QString>
#include <QStringList>

/// A table of a page: cells are trimmed, and "\|" in them is "|".
struct ReferenceTable
{
    QStringList head;
    QList<QStringList> rows;

    /// Returns the words in backticks of the first column, row by row.
    QStringList keys() const;
};

/// A fenced block of a page: its language and its text.
struct ReferenceExample
{
    QString language, text;
};

/// A page of resources/reference, as far as tests compare it with the program.
class ReferencePage
{
public:
    /// `name`: of the file, without its ending.
    explicit ReferencePage(const QString& name);

    /// Returns the table whose first head is `head`, from the section on if one is named; an empty one if there is
    /// none.
    ReferenceTable table(const QString& head, const QString& section = {}) const;
    /// Returns the examples in a language, in the order of the page.
    QStringList examples(const QString& language) const;
    QStringList sections() const;
    /// Returns the lines of a section that are in no table and no example.
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
