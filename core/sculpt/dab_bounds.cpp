#include "core/sculpt/dab_bounds.h"

#include <algorithm>

namespace core
{
namespace
{
/// d of a tool as a share of the brush's d. A crease is only as sharp as the mesh along it is fine; an alpha or a stamp
/// needs a mesh as fine as its details.
constexpr double lineDetail = 0.5, alphaDetail = 0.35, stampDetail = 0.28;
} // namespace

double detailShare(const StrokeSettings& settings)
{
    if (settings.topology == Topology::Uniform)
        return 1;
    if (settings.tool == Tool::Stamp)
        return stampDetail;
    if (settings.alpha && usesAlpha(settings.tool))
        return alphaDetail;
    return sharpens(settings.tool) ? lineDetail : 1;
}

EdgeBounds dabBounds(const StrokeSettings& settings, const Mesh& mesh, double radius)
{
    const double uniform = settings.detailLength > 0 ? settings.detailLength : mesh.uniformDetail();
    const EdgeBounds bounds = settings.topology == Topology::Uniform
                                  ? edgeBounds(uniform)
                                  : edgeBounds(radius, detailShare(settings) * settings.detail);
    return edgeBounds(std::max(bounds.detail, mesh.lattice().minDetail()));
}
} // namespace core
