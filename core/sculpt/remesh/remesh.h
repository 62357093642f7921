#pragma once

#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/remesh/rest_lengths.h"
#include "core/sculpt/select/region.h"

#include <span>

namespace core
{
/// The ends of an edge.
using VertexPair = std::array<Slot, 2>;

struct RemeshCounts
{
    std::uint64_t splits = 0, collapses = 0, flips = 0;
    bool capped = false; ///< the cap on operations was reached; the mesh is legal but not yet quasi-uniform

    std::vector<VertexPair> blocked; ///< edges shorter than d that no legal collapse removes

    bool any() const { return splits + collapses + flips > 0; }
    RemeshCounts& operator+=(const RemeshCounts& more);
};

/// Refines a mesh that is coarser than the brush: splits the longest edge of each face that meets the ball, until none
/// there is longer than d_detail. New vertices within the ball join the region. `candidates`: at least the faces that
/// meet the ball. With a mirror, faces that reach across its plane are first split there; then only those of the half
/// are looked at. `rest`: null, or of a stroke that keeps detail.
RemeshCounts refine(MeshEditor& edit, Region& region, std::span<const Slot> candidates, const Sphere& ball,
                    const EdgeBounds& bounds, RestLengths* rest = nullptr);

/// Makes the edges with both ends in the region quasi-uniform (paper, section 3.2): splits those longer than d_detail,
/// until none is (except for refused splits, and the cap), collapses those shorter than d, flips those whose opposite
/// angles exceed 180 degrees together, and relaxes vertices around the changes along the surface. Each operation is
/// legal by itself: closed and manifold, no face turned over or made degenerate. It does not ask whether distant
/// faces meet. With `rest`, of a stroke that keeps detail, an edge that was shorter than 4 d collapses only when it is
/// shorter than a quarter of what it was, and vertices whose edges were shorter than d_detail are not relaxed. Cost:
/// O(region).
RemeshCounts optimise(MeshEditor& edit, Region& region, const EdgeBounds& bounds, RestLengths* rest = nullptr);
/// As optimise(), for a surface that is to keep its shape: creases and corners outlive collapses, and a thin wall keeps
/// both sides of its rim, whose edges may then stay shorter than d. Relaxes vertices to `place(v)`.
RemeshCounts optimiseKeepingShape(MeshEditor& edit, Region& region, const EdgeBounds& bounds,
                                  const std::function<Vec3(Slot)>& place, RestLengths* rest = nullptr);

/// Moves the region's vertices, in the order in which they joined, to `place(v)` where their faces stay sound by that:
/// as optimise() relaxes those around its changes. O(region).
void moveSoundly(MeshEditor& edit, Region& region, const EdgeBounds& bounds, const std::function<Vec3(Slot)>& place);
/// Returns a place half way towards the mean of the neighbours, along the surface, at most d/2 away.
Vec3 relaxedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v);
/// Whether an edge at v is sharper than 40 degrees.
bool isSharp(const Mesh& mesh, Slot v);
/// Returns relaxedPlace(), or its own place for a vertex where the surface is sharp.
Vec3 relaxedAlongSharp(const Mesh& mesh, const EdgeBounds& bounds, Slot v);

/// Returns a place that makes the line even along which the surface is sharper than 60 degrees at v: half way to the
/// mean of v's neighbours on it. Where no such line runs through v, returns its own place.
Vec3 evenedAlongLine(const Mesh& mesh, Slot v);

/// Only splits: restores the d_detail tight property after vertices moved.
RemeshCounts splitLongEdges(MeshEditor& edit, Region& region, const EdgeBounds& bounds);
} // namespace core
