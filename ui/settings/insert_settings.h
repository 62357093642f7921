#pragma once

#include "ui/settings/view_appearance.h"

namespace ui
{
/// Ways of combining an inserted model or primitive with the present one, in the order of the list.
enum class InsertUse { Part, Join, Subtract, Intersect, Apart };

inline constexpr std::array<Named<InsertUse>, 5> insertUses{{{InsertUse::Part, "part"},
                                                             {InsertUse::Join, "join"},
                                                             {InsertUse::Subtract, "subtract"},
                                                             {InsertUse::Intersect, "intersect"},
                                                             {InsertUse::Apart, "apart"}}};
} // namespace ui
