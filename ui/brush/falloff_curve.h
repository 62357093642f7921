#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/widgets/curve_widget.h"

namespace ui
{
/// b(x) of the brush (paper, section 3.3) drawn from the centre to the rim; dragging bends it to the n that passes
/// nearest to the hand, the arrow keys step n. The brush must outlive it. Thread: gui.
class FalloffCurve : public CurveWidget
{
    Q_OBJECT

public:
    explicit FalloffCurve(BrushSettings* brush, QWidget* parent = nullptr);

    /// Low: the panel has many rows.
    QSize sizeHint() const override { return {200, 72}; }

protected:
    double valueAt(double x) const override { return core::falloff(x, falloff()); }
    void bendTo(double x, double y) override;
    void step(int by) override;

private:
    int falloff() const { return m_brush->stroke().falloff; }

    BrushSettings* m_brush;
};
} // namespace ui
