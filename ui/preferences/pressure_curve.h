#pragma once

#include "ui/settings/preferences.h"
#include "ui/widgets/curve_widget.h"

namespace ui
{
/// What counts as pressure over what the pen says (penPressure): dragging bends it, the arrow keys make it softer (up)
/// or firmer. Thread: gui.
class PressureCurve : public CurveWidget
{
    Q_OBJECT

public:
    explicit PressureCurve(QWidget* parent = nullptr);

    double exponent() const { return m_exponent; }
    /// In the range of the preferences.
    void setExponent(double exponent);

Q_SIGNALS:
    /// By hand.
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
