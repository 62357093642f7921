#pragma once

#include "ui/settings/brush_settings.h"

#include <QDoubleSpinBox>

#include <optional>

class QSlider;

namespace ui
{
/// A number box into which every number can be typed: what it cannot show is asked for by a signal, and shown as the
/// nearest that it can.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QValidator::State validate(QString& text, int& cursor) const override;
    void fixup(QString& text) const override;
    /// Returns the same size for all numbers, so that nothing beside it moves when a digit comes.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void asked(double value) const;

private:
    std::optional<double> numberIn(const QString& text) const;
};

/// One row of the parameter table as a slider with a number box. A view of BrushSettings, which must outlive it.
class ParameterControl : public QWidget
{
    Q_OBJECT

public:
    enum class Label { Before, Without };
    /// Logarithmic where nothing is no value: each step is the same factor.
    ParameterControl(BrushSettings* brush, core::Parameter parameter, Label label = Label::Before);

Q_SIGNALS:
    /// A number was typed, and Return.
    void entered();

private:
    void showValue();
    int position(double value) const;
    double valueAt(int position) const;

    BrushSettings* m_brush;
    core::Parameter m_parameter;
    QSlider* m_slider;
    NumberBox* m_box;
    bool m_isShowing = false; ///< the change comes from the brush, not from a hand
};

/// Radius and strength in one line.
class BrushBar : public QWidget
{
    Q_OBJECT

public:
    explicit BrushBar(BrushSettings* brush, QWidget* parent = nullptr);

Q_SIGNALS:
    /// A number was typed, and Return: the keys belong to the model again.
    void entered();
};
} // namespace ui
