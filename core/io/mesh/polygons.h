#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"

#include <span>

namespace core::io
{
/// Largest number of corners of a face. Outlines of scans and of lettering have tens of thousands.
inline constexpr std::size_t maxCorners = std::size_t(1) << 20;

/// Appends the triangles of one face with at least three corners, in the polygon's orientation; adds no vertices. A
/// quad is cut at its reflex corner or along the shorter diagonal, a larger polygon by ear clipping (ear_clipping.h). A
/// polygon that crosses itself or has no area also gives triangles, but they may be useless.
void appendPolygon(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
                   StopCheck& stopCheck);

/// Stores the polygons of a file until all points are known.
class Polygons
{
public:
    void reserve(std::size_t faces, std::size_t cornersEach)
    {
        m_corners.reserve(faces * cornersEach);
        m_ends.reserve(faces);
    }
    void addCorner(Slot corner) { m_corners.push_back(corner); }
    /// Ends the face that consists of the corners added since the last endFace().
    void endFace() { m_ends.push_back(static_cast<Slot>(m_corners.size())); }

    void clear()
    {
        m_corners.clear();
        m_ends.clear();
    }
    /// Removes the corners of the open face.
    void dropOpenFace() { m_corners.resize(m_ends.empty() ? 0 : m_ends.back()); }

    std::size_t cornersOfOpenFace() const { return m_corners.size() - (m_ends.empty() ? 0 : m_ends.back()); }
    std::size_t faces() const { return m_ends.size(); }
    std::size_t corners() const { return m_corners.size(); }

    /// Returns the triangles of all faces. From polygons of more than three corners it removes corners that equal the
    /// preceding one, and slits: paths that lead to a point and straight back. Leaves out polygons with fewer than
    /// three corners left. Counts removed corners and omitted polygons in the remarks. Throws ReadingCancelled.
    std::vector<Triangle> triangles(const std::vector<Vec3f>& points, StopCheck stopCheck, ReadRemarks& remarks) const;

private:
    std::vector<Slot> m_corners;
    std::vector<Slot> m_ends;
};
} // namespace core::io
