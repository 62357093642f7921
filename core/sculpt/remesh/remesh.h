#pragma once

#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/remesh/rest_lengths.h"
#include "core/sculpt/select/region.h"

#include <span>

namespace core
{
using VertexPair = std::array<Slot, 2>;

struct RemeshCounts
{
    std::uint64_t splits = 0, collapses = 0, flips = 0;
    bool capped = false; ///< the limit on operations was reached; the mesh is valid but not yet quasi-uniform

    std::vector<VertexPair> blocked; ///< edges shorter than d that no legal collapse removes

    bool any() const { return splits + collapses + flips > 0; }
    RemeshCounts& operator+=(const RemeshCounts& more);
};

/// Refines a mesh that is coarser than the brush. Splits the longest edge of each face that meets the ball, until no
/// such face has an edge longer than d_detail. New vertices in the ball are added to the region. `candidates`: must
/// include all faces that meet the ball. With a mirror, faces that cross its plane are split there first; then only
/// faces on the positive side are examined. `rest`: null, or the rest lengths of a stroke that keeps detail.
RemeshCounts refine(MeshEditor& edit, Region& region, std::span<const Slot> candidates, const Sphere& ball,
                    const EdgeBounds& bounds, RestLengths* rest = nullptr);

/// Splits the edges of these faces that cross the mirror's plane. Adds the new faces to `faces`, and the new vertices
/// in the ball to the region. Precondition: the editor has a mirror.
RemeshCounts splitFacesAcross(MeshEditor& edit, Region& region, std::vector<Slot>& faces, const Sphere& ball,
                              const EdgeBounds& bounds, RestLengths* rest = nullptr);

/// Makes the edges with both ends in the region quasi-uniform (paper, section 3.2). Splits edges longer than d_detail,
/// until none is left except for refused splits or a reached operation limit. Collapses edges shorter than d. Flips
/// edges whose opposite angles sum to more than 180 degrees. Relaxes vertices around the changes along the surface.
/// Each operation keeps the mesh closed and manifold and turns no face over or makes it degenerate. Intersections
/// between distant faces are not checked.
/// `rest`: null, or the rest lengths of a stroke that keeps detail. Then an edge that was shorter than 4 d collapses
/// only when it is shorter than a quarter of its length before the stroke. Vertices whose edges were shorter than
/// d_detail are not relaxed. Cost: O(region).
RemeshCounts optimise(MeshEditor& edit, Region& region, const EdgeBounds& bounds, RestLengths* rest = nullptr);
/// Optimises like optimise(), but keeps the shape of the surface. Creases and corners survive collapses, and a thin
/// wall keeps both sides of its rim, whose edges may then stay shorter than d. Relaxes vertices to `place(v)`.
RemeshCounts optimiseKeepingShape(MeshEditor& edit, Region& region, const EdgeBounds& bounds,
                                  const std::function<Vec3(Slot)>& place, RestLengths* rest = nullptr);

/// Moves the region's vertices to `place(v)`, in the order in which they were added, where their faces stay sound. Uses
/// the same test as the relaxation of optimise(). Cost: O(region).
void moveSoundly(MeshEditor& edit, Region& region, const EdgeBounds& bounds, const std::function<Vec3(Slot)>& place);
/// Returns the point halfway between v and the mean of its neighbours, projected onto v's tangent plane and at most d/2
/// away from v.
Vec3 relaxedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v);
/// Returns whether v has an edge whose two faces differ in direction by more than 40 degrees.
bool isSharp(const Mesh& mesh, Slot v);
/// Returns relaxedPlace(); if the surface is sharp at v, v's own point.
Vec3 relaxedAlongSharp(const Mesh& mesh, const EdgeBounds& bounds, Slot v);

/// Returns a point that evens out the spacing of vertices along a sharp line through v, whose edges are sharper than 60
/// degrees: halfway to the mean of v's neighbours on the line. Returns v's own point if there is no such line.
Vec3 evenedAlongLine(const Mesh& mesh, Slot v);

/// Only splits edges longer than d_detail: restores the d_detail-tight property after vertices have moved.
RemeshCounts splitLongEdges(MeshEditor& edit, Region& region, const EdgeBounds& bounds);
} // namespace core
