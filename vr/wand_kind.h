#pragma once

#include "wand_state.h"

#include <QString>

namespace vr
{
/// What is in one hand. The names are the runtime's own, in the language it speaks; empty: there is no such part, or it has no name.
struct WandKind
{
    QString profile; ///< OpenXR's path of the interaction profile; empty: nothing is in this hand, or nobody knows yet
    QString trigger, pad, side, menu;

    friend bool operator==(const WandKind&, const WandKind&) = default;
};

using WandKinds = std::array<WandKind, sideCount>; ///< by Side
} // namespace vr
