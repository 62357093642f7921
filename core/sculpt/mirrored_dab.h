#pragma once

#include "core/sculpt/dab_pipeline.h"

namespace core
{
/// A dab and its image in the stroke's mirror, if it has one (paper, section 3.5.2). Where the surface is symmetric,
/// bit for bit, the two are done at once: one half is planned, and each operation is done with its mirror image.
/// Elsewhere they are two dabs, one after the other.
class MirroredDab
{
public:
    MirroredDab(VerifiedMesh& surface, DabPipeline& pipeline)
        : m_surface(surface)
        , m_pipeline(pipeline)
        , m_mirror(surface.mesh())
    {}

    /// Precondition: a stroke is open.
    DabReport apply(DabRequest& request, const Dab& dab, GrabPair& grabs);

private:
    bool applyToHalf(DabContext& half);
    DabReport applyToImage(DabRequest& request, const Dab& image, GrabPair& grabs);
    DabReport applyAlone(DabRequest& request, const Dab& dab, Grab& grab, double selectMs = 0);

    VerifiedMesh& m_surface;
    DabPipeline& m_pipeline;
    MirrorMap m_mirror; ///< on while a dab is done on both sides at once
};
} // namespace core
