#pragma once

#include "vr/scene/translucent_shapes.h"
#include "vr/scene/label_textures.h"
#include "vr/scene/scene_state.h"

#include <vector>

namespace vr
{
/// All that a frame shows that is seen through, the farthest first.
struct GlassLists
{
    std::vector<Glass> panels; ///< pictures; they hide what is behind them
    std::vector<Glass> others;
};

/// In place of what the lists held. No allocation once they have been as long.
void listGlass(const SceneState& state, LabelPictures& labels, GlassLists& into);
} // namespace vr
