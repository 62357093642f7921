#pragma once

#include "core/mesh/mesh.h"
#include "core/stroke/tool.h"

#include <array>
#include <span>

namespace core
{
/// Finds vertices by their places and faces by their corners. Cost: a sort of the mesh.
class SurfaceIndex
{
public:
    using Place = std::array<int, 3>; ///< lattice units

    explicit SurfaceIndex(const Mesh& mesh);

    static Place placeOf(const LatticePoint& p) { return {p.x(), p.y(), p.z()}; }
    Slot vertexAt(const Place& place) const { return found(m_vertices, place); }
    /// Returns the nearest vertex whose coordinates differ by at most `within` units, or noSlot.
    Slot vertexNear(const Place& place, int within) const;
    /// Returns the face with these corners in this cyclic order, or noSlot.
    Slot faceOf(const Triangle& corners) const { return found(m_faces, turned(corners)); }

private:
    template <class Key> using Table = std::vector<std::pair<Key, Slot>>;

    template <class Key> static Slot found(const Table<Key>& table, const Key& key)
    {
        const auto at = std::ranges::lower_bound(table, key, {}, &std::pair<Key, Slot>::first);
        return at != table.end() && at->first == key ? at->second : noSlot;
    }
    static Triangle turned(Triangle corners)
    {
        std::ranges::rotate(corners, std::ranges::min_element(corners));
        return corners;
    }

    Table<Place> m_vertices;
    Table<Triangle> m_faces;
};

/// Returns the exchange of faces that turns the mesh into `after`, whose points are at `places`: faces that both have
/// stay. New vertices have the mask of the vertex that they replace, if there is one within a few units, else none.
Surgery exchangeWith(const TriangleMesh& after, std::span<const LatticePoint> places, const Mesh& mesh);

/// Returns whether each face has a mirror image, bit for bit. Cost: a sort of the mesh.
bool isSymmetric(const Mesh& mesh, Symmetry plane);
} // namespace core
