#pragma once

#include "ui/wearer.h"
#include "vr/document_port.h"

namespace app
{
/// Who is in the headset, as those at the window see them: room space becomes the document's. Gui thread.
ui::Wearer wearerOf(const vr::Presence& presence);
} // namespace app
