#pragma once

#include "core/geometry/triangle_mesh.h"

#include <functional>
#include <span>
#include <vector>

namespace core
{
class Mesh;

/// An exchange of faces: some are removed, others are added. Joining two surfaces, cutting a neck, removing a speck and
/// adding a shell are all surgeries. A surgery is a plain list, so that it can be checked before any half-edge changes.
struct Surgery
{
    struct Vertex
    {
        Vec3f point; ///< position, on the lattice
        Rgb color;
        Slot original = noSlot; ///< the live vertex that this vertex copies
        std::uint8_t mask = 0;
    };

    std::vector<Slot> removed;    ///< live faces to remove, each once
    std::vector<Vertex> vertices; ///< new vertices; vertices that lose all their faces are removed
    std::vector<Triangle> faces;  ///< new faces; a corner is the slot of a live vertex or newVertex(i)
    Slot nearby = 0;              ///< a live vertex; new elements get slots near it

    static constexpr Slot newVertex(std::size_t i) { return firstNew + static_cast<Slot>(i); }
    static constexpr bool isNew(Slot corner) { return corner >= firstNew; }
    static constexpr std::size_t newIndex(Slot corner) { return corner - firstNew; }

private:
    static constexpr Slot firstNew = Slot(1) << 31;
};

/// Returns the surgery that adds a shell. Precondition: the shell is closed, manifold and consistently oriented, and
/// its points are on the lattice.
Surgery additionOf(const TriangleMesh& shell, Slot nearby);

/// Returns the part of a surgery whose faces, removed and added, satisfy `isTaken`, with the new vertices that these
/// use. `isTaken`: called with the corners of each face, the removed ones first.
Surgery partOf(const Surgery& surgery, const Mesh& mesh, const std::function<bool(const Triangle&)>& isTaken);

/// Returns whether the mesh after the surgery is a closed 2-manifold, consistently oriented: each half-edge has its
/// opposite, no two faces share a half-edge, and the faces around each vertex form one umbrella. Cost: a sort of the
/// exchanged faces, and the stars of their corners.
bool isSurgeryOk(const Mesh& mesh, const Surgery& surgery);

/// Splits vertices whose faces would form several cycles after the surgery. Each cycle except the largest gets a copy
/// of the vertex, moved by the share `apart` (0 to 1) towards the mean of the cycle's ring. Skips a vertex around which
/// half-edges are unpaired; isSurgeryOk() then returns false.
void splitUmbrellas(const Mesh& mesh, Surgery& surgery, double apart);
} // namespace core
