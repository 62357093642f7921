#pragma once

#include "ui/settings/preferences.h"
#include "ui/widgets/curve_widget.h"

namespace ui
{
/// A plot of the effective pressure against the pen's pressure (penPressure). Dragging bends the curve; Up makes the
/// pen softer, Down firmer. Thread: gui.
class PressureCurve : public CurveWidget
{
    Q_OBJECT

public:
    explicit PressureCurve(QWidget* parent = nullptr);

    double exponent() const { return m_exponent; }
    /// Sets the exponent, clamped to the range of the preferences.
    void setExponent(double exponent);

Q_SIGNALS:
    /// The user has bent the curve.
    void bent(double exponent);

protected:
    double valueAt(double x) const override { return penPressure(x, m_exponent); }
    void bendTo(double x, double y) override;
    void step(int by) override;

private:
    void bend(double exponent);

    double m_exponent = 1;
};
} // namespace ui
