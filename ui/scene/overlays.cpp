#include "ui/scene/overlays.h"

#include "ui/scene/gl_convert.h"

#include "core/stroke/symmetry_plane.h"

#include <QQuaternion>

#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
constexpr double ringHalfWidth = 2.4;   ///< logical pixels, including the dark edges
constexpr double planeBorder = 1.2;     ///< width of the pane's border, logical pixels
constexpr double sectorHalfWidth = 0.7; ///< half of a line's width, logical pixels
/// length of the lines as a multiple of the model's largest distance from the vertical axis
constexpr double bordersReach = 1.5;

/// Appends two triangles for the segment a to b, in the format of cursor.vert; `afterB` gives the ribbon's direction at
/// b.
void appendSegment(std::vector<float>& out, const QVector3D& a, const QVector3D& b, const QVector3D& afterB)
{
    const auto corner = [&](const QVector3D& at, const QVector3D& next, float side) {
        out.insert(out.end(), {at.x(), at.y(), at.z(), next.x(), next.y(), next.z(), side});
    };
    corner(a, b, -1);
    corner(a, b, 1);
    corner(b, afterB, 1);
    corner(a, b, -1);
    corner(b, afterB, 1);
    corner(b, afterB, -1);
}

/// Returns a ring of radius 1 about Z, and a tick of length 0.3 along Z.
std::vector<float> ringAndTick()
{
    constexpr int segments = 96;
    const auto at = [](int i) {
        const double angle = 2 * std::numbers::pi * i / segments;
        return QVector3D(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0);
    };
    std::vector<float> out;
    for (int i = 0; i < segments; ++i)
        appendSegment(out, at(i), at(i + 1), at(i + 2));
    appendSegment(out, {0, 0, 0}, {0, 0, 0.3F}, {0, 0, 0.6F});
    return out;
}

/// Returns the colour of symmetry planes and sector borders on a dark or light background.
QVector3D symmetryColor(bool dark)
{
    return dark ? QVector3D(0.60F, 0.80F, 1.0F) : QVector3D(0.12F, 0.36F, 0.62F);
}

/// Returns the cell size of the grid, mm: 3 to 30 cells span a model of this size.
double gridCell(double size)
{
    return std::pow(10.0, std::floor(std::log10(size / 3)));
}

/// Returns a square in the plane z = 0, from -1 to 1, for this fragment shader.
Overlay::Shape square(const QString& fragmentShader)
{
    return {.vertexShader = QStringLiteral("plane"),
            .fragmentShader = fragmentShader,
            .vertices = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0},
            .attributes = {{"vertexPosition", 3}}};
}

QMatrix4x4 placed(const QVector3D& origin, const QQuaternion& rotation, const QVector3D& scale)
{
    QMatrix4x4 matrix;
    matrix.translate(origin);
    matrix.rotate(rotation);
    matrix.scale(scale);
    return matrix;
}

QVector3D onAllAxes(double scale)
{
    return QVector3D(1, 1, 1) * static_cast<float>(scale);
}
} // namespace

Ground::Ground()
    : Overlay({.vertexShader = QStringLiteral("ground"),
               .fragmentShader = QStringLiteral("ground"),
               .vertices = {-1, 0, -1, -1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0, -1},
               .attributes = {{"vertexPosition", 3}}})
{
    place(core::Box(core::Vec3::Constant(-50), core::Vec3::Constant(50)));
    setDark(false);
}

void Ground::place(const core::Box& box)
{
    constexpr double below =
        5e-4; // fraction of the box's diagonal: in the plane of a flat base, some pixels of the lines would be hidden
    const core::Vec3 center(box.center().x(), box.min().y() - below * box.diagonal().norm(), box.center().z());
    const double reach = 2.2 * box.diagonal().norm();
    const core::Vec3 half = 0.5 * box.sizes();
    setModelMatrix(placed(toQt(center), {}, onAllAxes(reach)));
    set("cell", static_cast<float>(gridCell(box.sizes().maxCoeff())));
    set("center", toQt(center));
    set("under", toQt(center));
    set("reach", static_cast<float>(reach));
    set("footprint", QVector2D(static_cast<float>(half.x()), static_cast<float>(half.z())));
}

void Ground::setDark(bool dark)
{
    set("lineColor", dark ? QVector3D(0.75F, 0.78F, 0.82F) : QVector3D(0.22F, 0.25F, 0.29F));
    set("lineAlpha", dark ? 0.22F : 0.30F);
    set("shade", dark ? 0.45F : 0.28F);
}

BrushCursor::BrushCursor()
    : Overlay({.vertexShader = QStringLiteral("cursor"),
               .fragmentShader = QStringLiteral("cursor"),
               .vertices = ringAndTick(),
               .attributes = {{"vertexPosition", 3}, {"vertexNext", 3}, {"vertexSide", 1}},
               .passes = {{Depth::Behind, {{"alpha", 0.22F}}}, {Depth::InFront, {{"alpha", 0.95F}}}}})
{
    setColor(Qt::white);
    setPixels({1, 1}, 1);
}

void BrushCursor::place(const core::Vec3& position, const core::Vec3& normal, double radius)
{
    setModelMatrix(placed(toQt(position), QQuaternion::rotationTo({0, 0, 1}, toQt(normal)), onAllAxes(radius)));
}

void BrushCursor::setColor(const QColor& color)
{
    set("color", toQt(color));
}

void BrushCursor::setPixels(QSize target, double ratio)
{
    set("viewport", QVector2D(static_cast<float>(target.width()), static_cast<float>(target.height())));
    set("halfWidth", static_cast<float>(ringHalfWidth * ratio));
}

SymmetryPlane::SymmetryPlane() : Overlay(square(QStringLiteral("plane")))
{
    setDark(false);
    setPixelRatio(1);
}

void SymmetryPlane::place(core::Symmetry symmetry, const core::Box& box)
{
    const core::SymmetryPlane pane = core::symmetryPlane(symmetry, box);
    const core::Vec3 x = pane.halfX.normalized(), y = pane.halfY.normalized();
    setModelMatrix(placed(toQt(pane.center), QQuaternion::fromAxes(toQt(x), toQt(y), toQt(core::planeNormal(symmetry))),
                          {static_cast<float>(pane.halfX.norm()), static_cast<float>(pane.halfY.norm()), 1}));
}

void SymmetryPlane::setDark(bool dark)
{
    set("color", symmetryColor(dark));
}

void SymmetryPlane::setPixelRatio(double ratio)
{
    set("border", static_cast<float>(planeBorder * ratio));
}

SectorBorders::SectorBorders() : Overlay(square(QStringLiteral("sectors")))
{
    set("sectors", 2.0F);
    setDark(false);
    setPixelRatio(1);
}

/// Places the lines. The first one extends from the vertical axis along +X if z = 0 is the plane of symmetry, else
/// along +Z.
void SectorBorders::place(int sectors, core::Symmetry symmetry, const core::Box& box)
{
    const core::Vec3 first = symmetry == core::Symmetry::Z ? core::Vec3::UnitX() : core::Vec3::UnitZ();
    const core::Vec3 farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
    setModelMatrix(placed({0, static_cast<float>(box.min().y()), 0},
                          QQuaternion::fromAxes(toQt(first), toQt(core::Vec3::UnitY().cross(first)), {0, 1, 0}),
                          onAllAxes(bordersReach * std::hypot(farthest.x(), farthest.z()))));
    set("sectors", static_cast<float>(sectors));
}

void SectorBorders::setDark(bool dark)
{
    set("color", symmetryColor(dark));
}

void SectorBorders::setPixelRatio(double ratio)
{
    set("border", static_cast<float>(sectorHalfWidth * ratio));
}
} // namespace ui
