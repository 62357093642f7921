#pragma once

#include "core/mesh/footprint.h"
#include "core/print/print_check.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace ui
{
/// Maps a measured value to a shade: 0 is far from a fault, 127 is at the limit, 128 to 255 are faults of increasing
/// severity.
struct PrintScale
{
    core::PrintPicture picture = core::PrintPicture::Thickness;
    double limit = 0.8; ///< mm of wall thickness, or degrees of overhang

    std::uint8_t shade(float value) const;
};

/// Returns the shades of vertices as a footprint, with the shades as its weights. `values`: one for each slot.
std::shared_ptr<const core::Footprint> shadesOf(std::vector<core::Slot> slots, const std::vector<float>& values,
                                                const PrintScale& scale);

/// The legend of the model's colours: a strip with the scale and labels below. Faults are hatched, as on the model.
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
        double place; ///< position along the strip, 0 to 1
        QString text;
    };
    std::vector<Mark> marks() const;

    PrintScale m_scale;
};
} // namespace ui
