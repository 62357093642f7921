#pragma once

#include "vr/scene/label_textures.h"
#include "vr/scene/scene_state.h"
#include "vr/scene/translucent_shapes.h"

#include <vector>

namespace vr
{
/// All translucent shapes of a frame. Each list is sorted from far to near.
struct TranslucentList
{
    std::vector<TranslucentShape> panels; ///< pictures, which hide what is behind them
    std::vector<TranslucentShape> others;
};

/// Replaces the contents of `into`. Allocates nothing if the lists have been as long before.
void buildTranslucentList(const SceneState& state, LabelTextures& labels, TranslucentList& into);
} // namespace vr
