#include "core/sculpt/mirrored_dab.h"

#include "core/sculpt/dab_selection.h"
#include "core/util/phase_timer.h"

namespace core
{
DabReport MirroredDab::apply(DabRequest& request, const Dab& dab, GrabPair& grabs)
{
    if (request.settings.symmetry == Symmetry::None)
        return applyAlone(request, dab, grabs.own);
    m_mirror.setPlane(request.settings.symmetry);
    const Dab folded = m_mirror.folded(dab.position) == dab.position ? dab : m_mirror.imageOf(dab);
    const Dab first = grabs.own.state.isHalf ? folded : dab, image = m_mirror.imageOf(first);
    DabContext half(m_surface, request, folded, grabs.own);
    half.mirror = &m_mirror;
    const bool isSymmetric = applyToHalf(half);
    m_mirror.setPlane(Symmetry::None);
    if (isSymmetric)
        return half.report;
    DabReport report = applyAlone(request, first, grabs.own, half.report.selectMs);
    if (image.position != first.position)
        report += applyToImage(request, image, grabs);
    report.asymmetric = true;
    return report;
}

/// Applies the dab to both sides at once. Returns false, with nothing changed, if the surface is not symmetric here.
bool MirroredDab::applyToHalf(DabContext& half)
{
    {
        const PhaseTimer timer(half.report.selectMs);
        if (!selectMirroredRegion(half))
            return false;
    }
    m_pipeline.applyToRegion(half);
    return true;
}

/// Applies one dab without a mirror. `selectMs`: milliseconds already spent on selecting for this dab.
DabReport MirroredDab::applyAlone(DabRequest& request, const Dab& dab, Grab& grab, double selectMs)
{
    DabContext context(m_surface, request, dab, grab);
    context.report.selectMs = selectMs;
    m_pipeline.apply(context);
    return context.report;
}

/// Applies the dab's mirror image after the dab itself. A tool that keeps its selection uses a separate grab for the
/// image.
DabReport MirroredDab::applyToImage(DabRequest& request, const Dab& image, GrabPair& grabs)
{
    if (!keepsSelection(request.settings.tool))
        return applyAlone(request, image, grabs.own);
    grabs.image.dropRemoved(m_surface.mesh());
    const DabReport report = applyAlone(request, image, grabs.image);
    grabs.own.dropRemoved(m_surface.mesh());
    return report;
}
} // namespace core
