#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Paints the region (paper, section 3.5.3), or masks it. Moves nothing and remeshes nothing.
class AttributeBrush
{
public:
    /// Precondition: the region is selected.
    void apply(DabContext& context);

private:
    Region m_whole; ///< with a mirror: what the dab alone selects, on both sides
};
} // namespace core
