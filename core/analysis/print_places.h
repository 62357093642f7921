#pragma once

#include "core/analysis/print_check.h"
#include "core/util/disjoint_sets.h"

#include <vector>

namespace core
{
/// Gathers what has a fault into places: what touches hangs together. Faces are added in ascending order, so that the
/// places have one order.
class PrintPlaces
{
public:
    explicit PrintPlaces(const TriangleMesh& mesh) : m_mesh(mesh), m_vertices(mesh.points.size()) {}

    /// A whole face. The place's worst is the least badness.
    void addFace(Slot face, double badness);
    /// A part that is thin on an area.
    void addPart(const WallPart& part, double area);

    /// A piece of a ridge that is thin.
    void addRidge(const WallRidge& ridge);

    /// Cost: a sort of the parts, and of the whole faces around them.
    PrintFault take();

private:
    struct Bad
    {
        Slot face, member; ///< of the sets
        double badness, area;
        const WallPart* part;   ///< null, and
        const WallRidge* ridge; ///< null: the whole face
    };

    Vec3 normalOf(Slot face) const; ///< as long as the face has area
    Slot memberAt(Slot face);
    std::array<Vec3, 3> cornersOf(const Bad& bad) const;
    Vec3 pointOf(const Bad& bad) const;
    bool isAtPart(const Bad& bad) const;
    void uniteTouching(DisjointSets& sets) const;

    const TriangleMesh& m_mesh;
    DisjointSets m_vertices;
    std::vector<Bad> m_bad;
    std::vector<bool> m_isAtPart; ///< by vertex: of a face that has parts or ridges; empty without any
    std::size_t m_parts = 0;
};
} // namespace core
