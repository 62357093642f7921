#include "ui/preferences/pressure_curve.h"

#include <algorithm>

namespace ui
{
namespace
{
constexpr double edge = 0.02; ///< positions (0 to 1) are kept this far from 0 and 1, where the exponent is undefined
constexpr double stepFactor = 1.1;
} // namespace

PressureCurve::PressureCurve(QWidget* parent) : CurveWidget(parent)
{
    setObjectName(QStringLiteral("penCurve"));
    setAccessibleName(tr("Pressure curve"));
    setToolTip(tr("Effect of pen pressure: above the diagonal a light touch does much, below it little. Drag to bend "
                  "the curve."));
}

void PressureCurve::setExponent(double exponent)
{
    m_exponent = std::clamp(exponent, minPenExponent, maxPenExponent);
    update();
}

void PressureCurve::bendTo(double x, double y)
{
    bend(std::log(std::clamp(y, edge, 1 - edge)) / std::log(std::clamp(x, edge, 1 - edge)));
}

void PressureCurve::step(int by)
{
    bend(by > 0 ? m_exponent / stepFactor : m_exponent * stepFactor);
}

void PressureCurve::bend(double exponent)
{
    setExponent(exponent);
    Q_EMIT bent(m_exponent);
}
} // namespace ui
