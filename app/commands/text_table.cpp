#include "app/commands/text_table.h"

#include <QRegularExpression>

#include <algorithm>
#include <cstdlib>

namespace app
{
namespace
{
bool isWide(char32_t sign)
{
    switch (QChar::script(sign)) {
    case QChar::Script_Han:
    case QChar::Script_Hangul:
    case QChar::Script_Hiragana:
    case QChar::Script_Katakana:
    case QChar::Script_Bopomofo:
        return true;
    default: // CJK punctuation, full-width letters, emoji
        return (sign >= 0x3000 && sign <= 0x303f) || (sign >= 0xff01 && sign <= 0xff60) ||
               (sign >= 0x1f300 && sign <= 0x1faff);
    }
}

int columnsOf(char32_t sign)
{
    const QChar::Category kind = QChar::category(sign);
    if (kind == QChar::Mark_NonSpacing || kind == QChar::Mark_Enclosing || kind == QChar::Other_Format)
        return 0;
    return isWide(sign) ? 2 : 1;
}

/// Returns as many characters as fit into `columns`, from the left or right end.
QString part(const QList<uint>& signs, int columns, bool fromLeft)
{
    qsizetype count = 0;
    for (int used = 0; count < signs.size(); ++count) {
        used += columnsOf(char32_t(signs[fromLeft ? count : signs.size() - 1 - count]));
        if (used > columns)
            break;
    }
    const QList<uint> kept = fromLeft ? signs.first(count) : signs.last(count);
    return QString::fromUcs4(reinterpret_cast<const char32_t*>(kept.constData()), kept.size());
}
} // namespace

int columnsOf(const QString& text)
{
    int columns = 0;
    for (const uint sign : text.toUcs4())
        columns += columnsOf(char32_t(sign));
    return columns;
}

QString shortened(const QString& text, int columns)
{
    QString line = text;
    for (QChar& c : line)
        c = c.isPrint() || c.isSurrogate() ? c : QLatin1Char(' ');
    if (columnsOf(line) <= columns)
        return line;
    const QList<uint> signs = line.toUcs4();
    const int right = (columns - 1) / 2; // columns for the end of the text
    return part(signs, columns - 1 - right, true) + QChar(0x2026) + part(signs, right, false);
}

QString tableLine(const QStringList& fields, const std::vector<int>& widths)
{
    QStringList line;
    for (qsizetype i = 0; i < fields.size(); ++i) {
        const int width = widths[static_cast<std::size_t>(i)];
        const QString space(std::max(0, std::abs(width) - columnsOf(fields[i])), QLatin1Char(' '));
        line << (width < 0 ? fields[i] + space : space + fields[i]);
    }
    QString text = line.join(QStringLiteral("  "));
    while (text.endsWith(QLatin1Char(' ')))
        text.chop(1);
    return text + QLatin1Char('\n');
}

QString csvField(QString text)
{
    static const QRegularExpression special(QStringLiteral("[\",\\r\\n]"));
    if (!text.contains(special))
        return text;
    return QLatin1Char('"') + text.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}
} // namespace app
