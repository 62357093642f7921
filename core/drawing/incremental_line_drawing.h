#pragma once

#include "core/drawing/projected_views.h"

namespace core
{
/// Redraws a model after local changes. A drawing costs the changed parts and the drawn lines, not the whole model. The
/// result equals that of drawLines(), except that the pixel grid is larger than the model. Thread: one thread at a
/// time; draw() uses helper threads.
class IncrementalLineDrawing
{
public:
    /// `pixels` is the resolution along the longest side of the grid. If more than `maxEdges` edges may be outlines or
    /// creases, creases are omitted.
    IncrementalLineDrawing(int pixels, std::size_t maxEdges) : m_pixels(pixels), m_scan(maxEdges) {}

    /// Applies a patch. All patches must be from one mesh and in order; the first must be of the whole mesh.
    void apply(const MeshPatch& patch);

    /// Returns the model after all applied patches.
    const DrawArrays& model() const { return m_model; }

    /// Draws the model. Returns nothing if it was stopped; a later call can continue.
    std::optional<LineDrawing> draw(bool shaded, const std::stop_token& stop);

private:
    void expire(std::span<const Slot> faces);

    int m_pixels;
    DrawArrays m_model;
    FeatureScan m_scan;
    std::optional<DepthImages> m_images;
    Box m_room;          ///< the box that the grids of the images cover
    bool m_isNew = true; ///< the model must be scanned as a whole
};
} // namespace core
