#pragma once

#include "brush_settings.h"

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace ui
{
/// One row of the parameter table as a slider with a number box. A view of BrushSettings, which must outlive it.
class ParameterControl : public QWidget
{
    Q_OBJECT

public:
    /// Logarithmic for lengths: each step is the same factor.
    ParameterControl(BrushSettings* brush, core::Parameter parameter, QWidget* parent = nullptr);

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
    QDoubleSpinBox* m_box;
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
