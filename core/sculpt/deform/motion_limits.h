#pragma once

#include "core/sculpt/select/region.h"

#include <cassert>

namespace core
{
/// Limits the motion of a region's vertices. A limit is the share of its planned displacement that a vertex may move
/// before it would touch something. Limits persist across the sub-steps of a dab.
class MotionLimits
{
public:
    void clear() { m_share.clear(); }
    /// Returns whether any limits have been set.
    bool inUse() const { return !m_share.empty(); }

    /// Returns the limit of v, 0 to 1. Precondition: if limits are in use, extend() was called after v was added to the
    /// region.
    double share(const Region& region, Slot v) const
    {
        assert(m_share.empty() || region.position(v) < m_share.size());
        return m_share.empty() ? 1 : m_share[region.position(v)];
    }

    /// Gives each vertex added to the region since the last call the tightest limit of its neighbours.
    void extend(const Region& region, const Mesh& mesh);
    /// Tightens the limits of the region's vertices at the bad faces and in `rings` > 0 rings around them, from 1 to
    /// 1/4 or from 1/4 to 0. Returns the vertices whose limit changed.
    std::vector<Slot> tighten(Region& region, const Mesh& mesh, const std::vector<Slot>& badFaces, int rings);

private:
    std::vector<double> m_share; ///< shares, by position in the region; empty: no limits
};
} // namespace core
