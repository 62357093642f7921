#include "tests/app/commands/reference_page.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>

namespace
{
QStringList linesOf(const QString& path)
{
    QFile file(path);
    return file.open(QFile::ReadOnly) ? QString::fromUtf8(file.readAll()).split(u'\n') : QStringList();
}

QStringList cellsOf(const QString& line)
{
    static const QRegularExpression separator(QStringLiteral("(?<!\\\\)\\|"));
    QStringList cells = line.split(separator);
    cells.removeFirst(); // the parts before the first and after the last separator
    cells.removeLast();
    for (QString& cell : cells)
        cell = cell.trimmed().replace(QStringLiteral("\\|"), QStringLiteral("|"));
    return cells;
}
} // namespace

QStringList codesIn(const QString& text)
{
    QStringList codes;
    const QStringList parts = text.split(u'`');
    for (qsizetype i = 1; i < parts.size(); i += 2)
        codes << parts[i];
    return codes;
}

QStringList ReferenceTable::keys() const
{
    QStringList keys;
    for (const QStringList& row : rows)
        keys << codesIn(row.value(0));
    return keys;
}

ReferencePage::ReferencePage(const QString& name)
{
    static const QRegularExpression heading(QStringLiteral("^#+ (.*)$")), rule(QStringLiteral("^\\|[-|]+$"));
    bool isExample = false, isTable = false;
    for (const QString& line : linesOf(QStringLiteral(FETTLE_SOURCE_DIR "/resources/reference/%1.md").arg(name))) {
        if (line.startsWith(QLatin1String("```"))) {
            isExample = !isExample;
            if (isExample)
                m_examples << ReferenceExample{line.mid(3), {}};
        } else if (isExample) {
            m_examples.last().text += line + u'\n';
        } else if (const auto match = heading.match(line); match.hasMatch()) {
            m_sections << Section{match.captured(1), {}, {}};
        } else if (line.startsWith(u'|') && !m_sections.isEmpty()) {
            QList<ReferenceTable>& tables = m_sections.last().tables;
            if (!isTable)
                tables << ReferenceTable{cellsOf(line), {}};
            else if (!rule.match(line).hasMatch())
                tables.last().rows << cellsOf(line);
        } else if (!m_sections.isEmpty()) {
            m_sections.last().text << line;
        }
        isTable = !isExample && line.startsWith(u'|');
    }
}

ReferenceTable ReferencePage::table(const QString& head, const QString& section) const
{
    for (const Section& part : m_sections)
        for (const ReferenceTable& table : part.tables)
            if (table.head.value(0) == head && (section.isEmpty() || part.title == section))
                return table;
    return {};
}

QStringList ReferencePage::examples(const QString& language) const
{
    QStringList texts;
    for (const ReferenceExample& example : m_examples)
        if (example.language == language)
            texts << example.text;
    return texts;
}

QStringList ReferencePage::sections() const
{
    QStringList titles;
    for (const Section& section : m_sections)
        titles << section.title;
    return titles;
}

QStringList ReferencePage::text(const QString& section) const
{
    const auto found = std::ranges::find(m_sections, section, &Section::title);
    return found == m_sections.end() ? QStringList() : found->text;
}
