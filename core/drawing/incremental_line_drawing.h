#pragma once

#include "core/drawing/projected_views.h"

namespace core
{
/// Draws a model again and again while it changes here and there: a drawing then costs what changed and the lines that
/// are drawn, not the model. Its drawings are those of drawLines(), but for their grid, which has room around the
/// model. One thread; drawing takes others to help.
class IncrementalLineDrawing
{
public:
    /// `pixels` along the longest side of what the grid has room for; beyond `maxEdges` edges in question creases are
    /// left out.
    IncrementalLineDrawing(int pixels, std::size_t maxEdges) : m_pixels(pixels), m_scan(maxEdges) {}

    /// Patches of one mesh in order, a whole one first.
    void apply(const MeshPatch& patch);

    /// As the patches have left it.
    const DrawArrays& model() const { return m_model; }

    /// Nothing if it was stopped; nothing is lost then.
    std::optional<LineDrawing> draw(bool shaded, const std::stop_token& stop);

private:
    void expire(std::span<const Slot> faces);

    int m_pixels;
    DrawArrays m_model;
    FeatureScan m_scan;
    std::optional<DepthImages> m_images;
    Box m_room;          ///< that the images hold
    bool m_isNew = true; ///< nothing is known of the model
};
} // namespace core
