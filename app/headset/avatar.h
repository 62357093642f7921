#pragma once

#include "ui/scene/headset_avatar.h"
#include "vr/sculpt/document_port.h"

namespace app
{
/// Who is in the headset, as those at the window see them: room space becomes the document's. Gui thread.
ui::HeadsetAvatar wearerOf(const vr::AvatarState& presence);
} // namespace app
