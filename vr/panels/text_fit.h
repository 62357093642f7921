#pragma once

#include <QFont>
#include <QString>

#include <vector>

namespace vr
{
/// Style of a text. Heights are those of the font's em, in the painter's unit.
struct TextStyle
{
    double height = 40;
    double minHeight = 36;       ///< smallest height to which the text shrinks before it is cut
    int lines = 1;               ///< largest number of lines
    double maxBlockHeight = 1e6; ///< largest height of all lines together
    Qt::TextElideMode cut = Qt::ElideRight;
    QFont::Weight weight = QFont::Normal;
};

struct FittedText
{
    QFont font;
    std::vector<QString> lines;
    double width = 0; ///< width of the widest line

    double lineSpacing() const;
};

/// Returns the text so that it fits into a width and a number of lines. It shrinks if necessary, wraps if it may have
/// several lines, and is cut with an ellipsis if all that is not enough. Thread: any.
FittedText fitted(const QString& text, double width, const TextStyle& style);
} // namespace vr
