#pragma once

#include "ui/scene/orbit_camera.h"

#include "core/primitives/tube.h"

#include <QPointF>

#include <optional>
#include <vector>

class QPainter;

namespace ui
{
/// Something of a tube's path that can be dragged in the view.
struct TubeHandle
{
    std::size_t point = 0;
    bool isRim = false; ///< the circle around the point, whose size is the radius; otherwise the point itself

    friend bool operator==(const TubeHandle&, const TubeHandle&) = default;
};

/// The path of a tube as handles in a view: a dot at each point, and a circle as large as the tube is there. Points
/// behind the eye have none. Positions are logical pixels. Thread: gui.
class TubeHandles
{
public:
    /// Camera and path must outlive the object.
    TubeHandles(const OrbitCamera& camera, const std::vector<core::TubePoint>& path) : m_camera(camera), m_path(path) {}

    /// Returns the handle at a position: the nearest dot, else the nearest circle.
    std::optional<TubeHandle> handleAt(const QPointF& at) const;
    /// Returns the point that a press on the straight line between two points would insert, and its index.
    std::optional<std::pair<std::size_t, core::TubePoint>> insertionAt(const QPointF& at) const;

    /// Returns the place at this position that is as deep as the point.
    core::Vec3 placeAt(const QPointF& at, std::size_t point) const;
    /// Returns the radius with which the circle of the point passes this position, mm.
    double radiusAt(const QPointF& at, std::size_t point) const;

    /// `chosen`: point drawn as the chosen one. `hot`: handle drawn as the one under the pointer.
    void paint(QPainter& painter, std::optional<std::size_t> chosen, const std::optional<TubeHandle>& hot) const;

private:
    bool isShown(std::size_t point) const;
    QPointF positionOf(std::size_t point) const;
    double radiusInPixels(std::size_t point) const;

    const OrbitCamera& m_camera;
    const std::vector<core::TubePoint>& m_path;
};
} // namespace ui
