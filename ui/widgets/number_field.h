#pragma once

#include <QDoubleSpinBox>

namespace ui
{
/// A field for a number with decimals. Point and comma are both its decimal mark, whatever the user's language has;
/// neither separates thousands. Thread: gui.
class NumberField : public QDoubleSpinBox
{
    Q_OBJECT

public:
    using QDoubleSpinBox::QDoubleSpinBox;

    /// Replaces the other mark by that of the user's language while the user types.
    QValidator::State validate(QString& text, int& cursor) const override
    {
        QString number = text.chopped(text.endsWith(suffix()) ? suffix().size() : 0);
        for (const QChar mark : {u'.', u','})
            number.replace(mark, locale().decimalPoint());
        if (number.contains(locale().groupSeparator()))
            return QValidator::Invalid;
        text.replace(0, number.size(), number);
        return QDoubleSpinBox::validate(text, cursor);
    }
};
} // namespace ui
