#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/widgets/curve_widget.h"

namespace ui
{
/// A plot of the brush's falloff b(x) (paper, section 3.3) from centre to rim. Dragging chooses the exponent n whose
/// curve passes nearest to the pointer; the arrow keys step n. Precondition: the brush outlives the plot. Thread: gui.
class FalloffCurve : public CurveWidget
{
    Q_OBJECT

public:
    explicit FalloffCurve(BrushSettings* brush, QWidget* parent = nullptr);

    /// Small height, because the panel has many rows.
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
