#pragma once

#include "core/analysis/print_check.h"
#include "core/mesh/footprint.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace ui
{
/// From what was measured to a shade: 0 is far from a fault, 128 all but one, and more is one, the worse the more
/// (255).
struct PrintScale
{
    core::PrintPicture picture = core::PrintPicture::Thickness;
    double limit = 0.8; ///< mm or degrees

    std::uint8_t shade(float value) const;
};

/// The shades on the model's vertices: a footprint's slots, with shades for weights. `values`: for each slot.
std::shared_ptr<const core::Footprint> shadesOf(std::vector<core::Slot> slots, const std::vector<float>& values,
                                                const PrintScale& scale);

/// What the colours on the model mean: the scale as a strip, with figures below it. Faults are hatched, there as here.
class PrintLegend : public QWidget
{
    Q_OBJECT

public:
    explicit PrintLegend(QWidget* parent = nullptr);

    void setScale(const PrintScale& scale);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Mark
    {
        double place; ///< 0 to 1 along the strip
        QString text;
    };
    std::vector<Mark> marks() const;

    PrintScale m_scale;
};
} // namespace ui
