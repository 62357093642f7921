#pragma once

#include "core/sculpt/select/region.h"

#include <cassert>

namespace core
{
/// Limits on the motion of a region's vertices: the share of its plan that a vertex may do before it would touch
/// something. Limits persist across the sub-steps of a dab.
class MotionLimits
{
public:
    void clear() { m_share.clear(); }
    /// Whether there are limits.
    bool inUse() const { return !m_share.empty(); }

    /// Precondition: extend() since v joined the region, if in use.
    double share(const Region& region, Slot v) const
    {
        assert(m_share.empty() || region.position(v) < m_share.size());
        return m_share.empty() ? 1 : m_share[region.position(v)];
    }

    /// Limits vertices that have joined the region since as their neighbours are limited.
    void extend(const Region& region, const Mesh& mesh);
    /// Tightens the limits of the region's vertices at the bad faces and in `rings` > 0 rings around them: 1 -> 1/4 ->
    /// 0. Returns those whose limit changed.
    std::vector<Slot> tighten(Region& region, const Mesh& mesh, const std::vector<Slot>& badFaces, int rings);

private:
    std::vector<double> m_share; ///< by position in the region; empty: no limits
};
} // namespace core
