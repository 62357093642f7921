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
/// The ground under the model: a grid in mm and a soft shade. Qt3D, sRGB colours, blended over what is there.
class Ground : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit Ground(Qt3DCore::QNode* parent = nullptr);

    /// Puts the ground at the bottom of the box; the lines' distance follows its size.
    void place(const core::Box& box);
    void setDark(bool dark);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_cell, *m_center, *m_under, *m_reach, *m_footprint, *m_lineColor, *m_lineAlpha, *m_shade;
};

/// The brush's ring in the tangent plane, with a tick along the normal. Where clay hides it, it is drawn faintly.
class BrushCursor : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit BrushCursor(Qt3DCore::QNode* parent = nullptr);

    void place(const core::Vec3& position, const core::Vec3& normal, double radius);
    void setColor(const QColor& color);
    /// Physical pixels of the target, and physical pixels to one logical pixel.
    void setPixels(QSize target, double ratio);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_viewport, *m_halfWidth, *m_color;
};

/// The plane of symmetry: a core::SymmetryPlane. Clay hides what lies within.
class SymmetryPlane : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit SymmetryPlane(Qt3DCore::QNode* parent = nullptr);

    /// There is a symmetry, and the box is not empty.
    void place(core::Symmetry symmetry, const core::Box& box);
    void setDark(bool dark);
    void setPixelRatio(double ratio);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_color, *m_border;
};
/// Where the sectors of radial symmetry meet: lines on the ground, from the upright axis outwards. With an upright
/// plane of symmetry as well they are their own image in it. Clay hides what lies under it.
class SectorBorders : public Qt3DCore::QEntity
{
    Q_OBJECT

public:
    explicit SectorBorders(Qt3DCore::QNode* parent = nullptr);

    /// There are two or more, and the box is not empty.
    void place(int sectors, core::Symmetry symmetry, const core::Box& box);
    void setDark(bool dark);
    void setPixelRatio(double ratio);

private:
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter *m_color, *m_border, *m_sectors;
};
} // namespace ui
