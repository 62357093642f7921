#pragma once

#include "core/sculpt/dab_pipeline.h"

namespace core
{
/// Applies a dab and its mirror image, if the stroke has a mirror plane (paper, section 3.5.2). Where the surface is
/// symmetric, bit for bit, both are done at once: the positive side is planned, and each operation is done together
/// with its mirror image. Elsewhere the dab and its image are applied one after the other.
class MirroredDab
{
public:
    MirroredDab(VerifiedMesh& surface, DabPipeline& pipeline)
        : m_surface(surface)
        , m_pipeline(pipeline)
        , m_mirror(surface.mesh())
    {}

    /// Applies the dab and its image. Precondition: a stroke is open.
    DabReport apply(DabRequest& request, const Dab& dab, GrabPair& grabs);

private:
    bool applyToHalf(DabContext& half);
    DabReport applyToImage(DabRequest& request, const Dab& image, GrabPair& grabs);
    DabReport applyAlone(DabRequest& request, const Dab& dab, Grab& grab, double selectMs = 0);

    VerifiedMesh& m_surface;
    DabPipeline& m_pipeline;
    MirrorMap m_mirror; ///< on only while a dab is done on both sides at once
};
} // namespace core
