#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <vector>

namespace core
{
/// A point of the path of a tube.
struct TubePoint
{
    Vec3 position = Vec3::Zero(); ///< mm
    double radius = 0;            ///< of the tube there, mm

    friend bool operator==(const TubePoint&, const TubePoint&) = default;
};

/// A tube along a curve through the points of a path, with round ends. The curve is a centripetal Catmull-Rom spline
/// (Yuksel, Schaefer and Keyser 2011), which has no loops or cusps between points; the radius follows it without going
/// beyond those of two neighbours. Rings are turned along it as little as possible (Wang, Juettler, Zheng and Liu 2008,
/// "Computation of rotation minimizing frames"). All functions give the same bits on every machine. Thread: any.
class Tube
{
public:
    /// Precondition: at least two points, neighbours at different places, radii above 0. `edge`: length that edges have
    /// approximately, mm. Cost: O(rings).
    Tube(const std::vector<TubePoint>& path, double edge);

    /// Returns the surface of the whole tube. It crosses itself where the tube does, and where the curve bends more
    /// tightly than the tube is thick. Cost: O(vertices).
    TriangleMesh swept() const { return swept(0, m_rings.size() - 1); }

    /// Returns sound solids whose union is the tube: one if it does not cross itself. Returns none if they would have
    /// more than `maxFaces` triangles together, if a piece is too thin for float32, or if the job is cancelled. Cost:
    /// checkMesh() of the surface, about once for each halving.
    std::vector<TriangleMesh> solids(std::size_t maxFaces, const JobControl& control = {}) const;

private:
    /// A ring about the curve. A place (x, z) in it is at centre + x across + z (across x along).
    struct Ring
    {
        Vec3 centre;
        double radius;
        Vec3 along, across; ///< unit length, at a right angle
    };

    void turnRings();
    TriangleMesh swept(std::size_t first, std::size_t last) const;
    bool divide(std::size_t first, std::size_t last, std::vector<TriangleMesh>& solids, std::size_t& facesLeft,
                const JobControl& control) const;

    double m_edge;
    std::vector<Ring> m_rings;
};
} // namespace core
