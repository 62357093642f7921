#pragma once

#include "core/mesh/mesh.h"
#include "core/operations/model_command.h"

namespace core
{
/// One part of a document as a mesh of its own, so that commands on a whole mesh can change it. Thread: one.
class DetachedPart
{
public:
    /// Precondition: the part has faces. Cost: O(mesh).
    DetachedPart(const Mesh& whole, PartId part);

    /// The part alone, as part 0, with the frame of the whole mesh. Vertices are in the order of their slots there.
    Mesh& mesh() { return *m_mesh; }

    /// Writes the changed part into the whole mesh, whose stroke is open. A part with the same faces as before keeps
    /// its slots. If the document needs another lattice now, all parts are moved to it. Sets change.refusal if parts do
    /// not fit on it. Cost: O(mesh).
    void putBack(Mesh& whole, ModelChange& change, const JobControl& control);

private:
    bool hasSameFaces() const;
    void writeVertices(Mesh& whole) const;
    void hideAgain(Mesh& whole, const std::vector<Vec3f>& points) const;

    PartId m_part;
    std::vector<Slot> m_vertices;  ///< slots of the part's vertices in the whole mesh
    std::vector<Triangle> m_faces; ///< faces before the change, with indices in m_vertices
    std::unique_ptr<Mesh> m_mesh;
};

/// Returns whether the part has faces; strokes can remove all of them. Cost: O(mesh).
bool hasFaces(const Mesh& mesh, PartId part);
/// Hides the vertices of the part that are at these places. Precondition: a stroke is open. Cost: O(mesh).
void hideAt(Mesh& mesh, PartId part, const std::vector<Vec3f>& places);
/// Returns the surface of a part without gaps, in the order of its slots, without part labels. Cost: O(mesh).
TriangleMesh surfaceOf(const Mesh& mesh, PartId part);
/// Replaces the faces of a part by a surface, which may be empty. If the part has no faces, adds it. Precondition: a
/// stroke is open; the surface is closed, manifold and oriented, and its points are on the mesh's lattice; the mesh
/// has a face of another part, or the surface is not empty. Cost: O(mesh).
void replacePart(Mesh& mesh, PartId part, const TriangleMesh& surface);
/// Moves all faces of the mesh, whose stroke is open, to another lattice. Sets change.refusal, and does nothing, if a
/// part would not be sound there. Cost: O(mesh).
void relocateParts(Mesh& mesh, const Lattice& lattice, ModelChange& change, const JobControl& control);
/// Returns the lattice for all faces if the part had this surface, which may be on another lattice.
Lattice latticeWith(const Mesh& mesh, PartId part, const TriangleMesh& surface);
/// Snaps a print-ready surface to the lattice. Returns false, and sets `change`, if it does not fit.
bool fitSurface(TriangleMesh& surface, const Lattice& lattice, ModelChange& change, const JobControl& control);
} // namespace core
