#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"

#include <span>

namespace core
{
/// Faces that lines of sight may meet. Thread: any; the object is immutable. Cost: a sort of the faces.
class Sightlines
{
public:
    /// Precondition: `points` outlives this.
    Sightlines(std::span<const Vec3f> points, std::vector<Triangle> faces);

    const Triangle& corners(Slot face) const { return m_faces[face]; }

    /// Calls visit(face) for faces that the line from p to p + reach * way meets, ends excluded, in no order, until it
    /// returns true. Lines that meet an edge may be given both its faces, never none of them. Returns whether a call
    /// returned true.
    template <class Visit> bool anyMet(const Vec3& p, const Vec3& way, double reach, Visit visit) const
    {
        bool isFound = false;
        if (m_faces.empty())
            return false;
        const auto reachOf = [&](const FaceBox& box) { return isMet(box, p, way, reach) ? 0.0 : endless; };
        m_tree.forEachNear(reachOf, endless, [&](Slot position) {
            const Slot face = m_tree.at(position);
            isFound = isFound || (isMet(face, p, way, reach) && visit(face));
            return isFound ? 0.0 : endless;
        });
        return isFound;
    }

private:
    static constexpr double endless = std::numeric_limits<double>::infinity();

    static bool isMet(const FaceBox& box, const Vec3& p, const Vec3& way, double reach);
    bool isMet(Slot face, const Vec3& p, const Vec3& way, double reach) const;

    std::span<const Vec3f> m_points;
    std::vector<Triangle> m_faces;
    BoxTree m_tree;
};
} // namespace core
