#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/widgets/number_field.h"

#include <optional>

class QSlider;

namespace ui
{
/// A number box into which any number can be typed. A number out of its range is reported by asked(), and the box shows
/// the nearest possible number.
class NumberBox : public NumberField
{
    Q_OBJECT

public:
    using NumberField::NumberField;

    QValidator::State validate(QString& text, int& cursor) const override;
    void fixup(QString& text) const override;
    /// Returns a size that does not depend on the number, so that neighbours do not move while digits are typed.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void asked(double value) const;

private:
    std::optional<double> numberIn(const QString& text) const;
};

/// A slider and a number box for one row of the parameter table. A view of BrushSettings, which must outlive it.
class ParameterControl : public QWidget
{
    Q_OBJECT

public:
    enum class Label { Before, Without };
    /// The slider is logarithmic if the parameter's minimum is above 0.
    ParameterControl(BrushSettings* brush, core::Parameter parameter, Label label = Label::Before);

Q_SIGNALS:
    /// A number was typed and confirmed with Return.
    void entered();

private:
    void showValue();
    int position(double value) const;
    double valueAt(int position) const;

    BrushSettings* m_brush;
    core::Parameter m_parameter;
    QSlider* m_slider;
    NumberBox* m_box;
    bool m_isShowing = false; ///< the brush is changing the slider, not the user
};

/// Controls for radius and strength in one row.
class BrushBar : public QWidget
{
    Q_OBJECT

public:
    explicit BrushBar(BrushSettings* brush, QWidget* parent = nullptr);

Q_SIGNALS:
    /// A number was typed and confirmed; the window should return the keyboard focus to the view.
    void entered();
};
} // namespace ui
