#pragma once

#include "core/geometry/triangle_mesh.h"

#include <span>
#include <vector>

namespace core
{
class Mesh;

/// An exchange of faces: some go, others come in their place. All that changes topology is one: joining two sheets,
/// cutting a neck, removing a speck, adding a shell. A plain list, so that it can be checked before half-edges know of
/// it.
struct Surgery
{
    struct Vertex
    {
        Vec3f point; ///< on the lattice
        Rgb color;
        Slot original = noSlot; ///< the live vertex that it is a copy of
        std::uint8_t mask = 0;
    };

    std::vector<Slot> removed;    ///< live faces, each once
    std::vector<Vertex> vertices; ///< that come; those that lose all their faces go
    std::vector<Triangle> faces;  ///< that come; a corner is a live vertex's slot or newVertex(i)
    Slot near = 0;                ///< a live vertex: new elements take slots near it

    static constexpr Slot newVertex(std::size_t i) { return firstNew + static_cast<Slot>(i); }
    static constexpr bool isNew(Slot corner) { return corner >= firstNew; }
    static constexpr std::size_t newIndex(Slot corner) { return corner - firstNew; }

private:
    static constexpr Slot firstNew = Slot(1) << 31;
};

/// Adds a closed, manifold, consistently oriented shell whose points lie on the lattice.
Surgery additionOf(const TriangleMesh& shell, Slot near);

/// Whether the mesh is a closed 2-manifold, consistently oriented, after the surgery: each half-edge has its opposite,
/// no two faces use the same one, and the faces around each vertex make one umbrella. Cost: the faces and their
/// corners' stars.
bool isSurgeryOk(const Mesh& mesh, const Surgery& surgery);

/// Makes one umbrella of several: where the surgery leaves the faces around a vertex in more than one cycle, each cycle
/// but the largest gets a copy of the vertex, moved by `apart` of the way to the mean of that cycle's ring. Where
/// half-edges are not paired nothing is done; then isSurgeryOk says so.
void splitUmbrellas(const Mesh& mesh, Surgery& surgery, double apart);
} // namespace core
