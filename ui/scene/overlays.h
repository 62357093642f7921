#pragma once

#include "ui/scene/overlay.h"

#include "core/geometry/geometry.h"
#include "core/stroke/tool.h"

#include <QColor>

namespace ui
{
/// The ground under the model: a grid in mm and a soft shadow.
class Ground : public Overlay
{
public:
    Ground();

    /// Puts the ground at the bottom of the box; the spacing of the lines depends on the box's size.
    void place(const core::Box& box);
    void setDark(bool dark);
};

/// The brush's ring in the tangent plane, with a tick along the normal. Drawn faintly where the clay hides it.
class BrushCursor : public Overlay
{
public:
    BrushCursor();

    void place(const core::Vec3& position, const core::Vec3& normal, double radius);
    void setColor(const QColor& color);
    /// Sets the size of the target in physical pixels, and the physical pixels per logical pixel.
    void setPixels(QSize target, double ratio);
};

/// A pane that shows the plane of symmetry (see core::SymmetryPlane). The clay hides its inner part.
class SymmetryPlane : public Overlay
{
public:
    SymmetryPlane();

    /// Precondition: `symmetry` is not None and the box is not empty.
    void place(core::Symmetry symmetry, const core::Box& box);
    void setDark(bool dark);
    void setPixelRatio(double ratio);
};

/// Borders of the sectors of radial symmetry: lines on the ground, from the vertical axis outwards. With a vertical
/// plane of symmetry, the lines are symmetric to it. The clay hides lines under it.
class SectorBorders : public Overlay
{
public:
    SectorBorders();

    /// Precondition: at least two sectors, and the box is not empty.
    void place(int sectors, core::Symmetry symmetry, const core::Box& box);
    void setDark(bool dark);
    void setPixelRatio(double ratio);
};
} // namespace ui
