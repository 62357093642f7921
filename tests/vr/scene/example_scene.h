#pragma once

#include "vr/scene/scene_state.h"

#include <QImage>

/// A person at work: a model in front of them, a wand in each hand, and everything that a frame can show. For images
/// and measurements.
namespace example
{
vr::SceneState scene(const core::Box& box);
/// Returns an image that looks like a painted panel.
QImage panelPicture();
} // namespace example
