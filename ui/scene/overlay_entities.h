#pragma once

#include "core/geometry/geometry.h"
#include "core/stroke/tool.h"

#include <QColor>
#include <Qt3DCore/QEntity>

namespace Qt3DCore
{
class QTransform;
}
namespace Qt3DRender
{
class QParameter;
}

namespace ui
{
/// The ground under the model: a grid in mm and a soft shadow. A Qt3D entity, sRGB colours, blended over the frame.
class Ground : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit Ground(Qt3DCore::QNode* parent = nullptr);

    /// Puts the ground at the bottom of the box; the spacing of the lines depends on the box's size.
    void place(const core::Box& box);
    void setDark(bool dark);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_cell, *m_center, *m_under, *m_reach, *m_footprint, *m_lineColor, *m_lineAlpha, *m_shade;
};

/// The brush's ring in the tangent plane, with a tick along the normal. Drawn faintly where the clay hides it.
class BrushCursor : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit BrushCursor(Qt3DCore::QNode* parent = nullptr);

    void place(const core::Vec3& position, const core::Vec3& normal, double radius);
    void setColor(const QColor& color);
    /// Sets the size of the target in physical pixels, and the physical pixels per logical pixel.
    void setPixels(QSize target, double ratio);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_viewport, *m_halfWidth, *m_color;
};

/// A pane that shows the plane of symmetry (see core::SymmetryPlane). The clay hides its inner part.
class SymmetryPlane : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit SymmetryPlane(Qt3DCore::QNode* parent = nullptr);

    /// Precondition: `symmetry` is not None and the box is not empty.
    void place(core::Symmetry symmetry, const core::Box& box);
    void setDark(bool dark);
    void setPixelRatio(double ratio);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_color, *m_border;
};
/// Borders of the sectors of radial symmetry: lines on the ground, from the vertical axis outwards. With a vertical
/// plane of symmetry, the lines are symmetric to it. The clay hides lines under it.
class SectorBorders : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit SectorBorders(Qt3DCore::QNode* parent = nullptr);

    /// Precondition: at least two sectors, and the box is not empty.
    void place(int sectors, core::Symmetry symmetry, const core::Box& box);
    void setDark(bool dark);
    void setPixelRatio(double ratio);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_color, *m_border, *m_sectors;
};
} // namespace ui
