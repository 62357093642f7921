#pragma once

#include <QFont>
#include <QString>

#include <vector>

namespace vr
{
/// Heights are of the font's em, in whatever unit is painted in.
struct TextStyle
{
    double height = 40;
    double minHeight = 36;       ///< it shrinks so far before it is cut
    int lines = 1;               ///< at most
    double maxBlockHeight = 1e6; ///< the height that they may take
    Qt::TextElideMode cut = Qt::ElideRight;
    QFont::Weight weight = QFont::Normal;
};

struct FittedText
{
    QFont font;
    std::vector<QString> lines;
    double width = 0; ///< of the widest line

    double lineSpacing() const;
};

/// A text that stays in a width and its lines: smaller where needed, in more lines where it may, and cut with an
/// ellipsis where all that does not help. Any thread.
FittedText fitted(const QString& text, double width, const TextStyle& style);
} // namespace vr
