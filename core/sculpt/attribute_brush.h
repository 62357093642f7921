#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Paints or masks the region (paper, section 3.5.3). Does not move vertices or remesh.
class AttributeBrush
{
public:
    /// Applies the dab. Precondition: the region is selected.
    void apply(DabContext& context);

private:
    Region m_whole; ///< with a mirror: the vertices that the dab alone selects, on both sides
};
} // namespace core
