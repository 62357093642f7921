#pragma once

#include "ui/scene/headset_avatar.h"
#include "vr/sculpt/document_port.h"

namespace app
{
/// Returns the avatar of the user in the headset, in the document's space (mm). Thread: gui.
ui::HeadsetAvatar avatarOf(const vr::AvatarState& state);
} // namespace app
