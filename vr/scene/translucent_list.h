#pragma once

#include "vr/scene/label_textures.h"
#include "vr/scene/scene_state.h"
#include "vr/scene/translucent_shapes.h"

#include <vector>

namespace vr
{
/// All translucent shapes of a frame, the farthest first.
struct TranslucentList
{
    std::vector<TranslucentShape> panels; ///< pictures; they hide what is behind them
    std::vector<TranslucentShape> others;
};

/// In place of what the lists held. No allocation once they have been as long.
void buildTranslucentList(const SceneState& state, LabelTextures& labels, TranslucentList& into);
} // namespace vr
