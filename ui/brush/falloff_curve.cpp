#include "ui/brush/falloff_curve.h"

#include "ui/util/error_messages.h"

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
const int maxFalloff = static_cast<int>(core::info(core::Parameter::Falloff).max);
} // namespace

FalloffCurve::FalloffCurve(BrushSettings* brush, QWidget* parent) : CurveWidget(parent), m_brush(brush)
{
    setObjectName(QStringLiteral("falloffCurve"));
    setAccessibleName(ErrorMessages::name(core::Parameter::Falloff));
    setToolTip(tr("How the brush fades from its centre to its rim. Drag to change the curve."));
    connect(brush, &BrushSettings::changed, this, qOverload<>(&QWidget::update));
}

void FalloffCurve::bendTo(double x, double y)
{
    int nearest = 0;
    for (int n = core::minFalloff; n <= maxFalloff; ++n) {
        if (std::abs(core::falloff(x, n) - y) < std::abs(core::falloff(x, nearest) - y))
            nearest = n;
    }
    m_brush->setValue(core::Parameter::Falloff, nearest);
}

/// Steps the falloff exponent n and skips the invalid values between 0 (no weighting) and the smallest valid n.
void FalloffCurve::step(int by)
{
    int n = falloff() + by;
    while (n > 0 && n < maxFalloff && !core::isFalloff(n))
        n += by;
    m_brush->setValue(core::Parameter::Falloff, std::clamp(n, 0, maxFalloff));
}
} // namespace ui
