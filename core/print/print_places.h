#pragma once

#include "core/print/print_check.h"
#include "core/util/disjoint_sets.h"

#include <vector>

namespace core
{
/// Groups faulty faces, parts and ridges into places: whatever touches belongs to one place. Faces must be added in
/// ascending order, so that the order of the places is fixed.
class PrintPlaces
{
public:
    explicit PrintPlaces(const TriangleMesh& mesh) : m_mesh(mesh), m_vertices(mesh.points.size()) {}

    /// Adds a whole face. `badness`: lower is worse; the lowest of a place becomes PrintPlace::worst.
    void addFace(Slot face, double badness);
    /// Adds a thin part of a face; `area` is its thin area, mm^2.
    void addPart(const WallPart& part, double area);

    /// Adds a thin piece of a ridge.
    void addRidge(const WallRidge& ridge);

    /// Returns the places. Cost: a sort of the parts and of the whole faces around them.
    PrintFault take();

private:
    struct Bad
    {
        Slot face, member; ///< member: element of the disjoint sets
        double badness, area;
        const WallPart* part;   ///< null for a whole face or a ridge
        const WallRidge* ridge; ///< null for a whole face or a part
    };

    Vec3 normalOf(Slot face) const; ///< length of the normal: area of the face
    Slot memberAt(Slot face);
    std::array<Vec3, 3> cornersOf(const Bad& bad) const;
    Vec3 pointOf(const Bad& bad) const;
    bool isAtPart(const Bad& bad) const;
    void uniteTouching(DisjointSets& sets) const;

    const TriangleMesh& m_mesh;
    DisjointSets m_vertices;
    std::vector<Bad> m_bad;
    std::vector<bool> m_isAtPart; ///< for each vertex: a face around it has parts or ridges; empty if none has
    std::size_t m_parts = 0;
};
} // namespace core
