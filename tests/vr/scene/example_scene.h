#pragma once

#include "vr/scene/scene_state.h"

#include <QImage>

/// A person at work: a model before them, a wand in each hand, whatever a frame can show. For pictures and
/// measurements.
namespace example
{
vr::SceneState scene(const core::Box& box);
/// As a panel might be painted.
QImage panelPicture();
} // namespace example
