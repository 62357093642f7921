#pragma once

#include "lattice.h"

namespace core
{
/// What a mesh keeps as a whole.
struct MeshFrame
{
    Lattice lattice = Lattice();
    double uniformDetail = 0; ///< d_detail of the uniform topology (DESIGN section 3), document's unit

    friend bool operator==(const MeshFrame&, const MeshFrame&) = default;
};
} // namespace core
