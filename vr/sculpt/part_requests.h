#pragma once

#include "vr/input/model_placement.h"
#include "vr/panels/panel_content.h"
#include "vr/sculpt/brush_state.h"
#include "vr/sculpt/document_port.h"

namespace vr
{
/// Returns the request to the document for an action at the parts panel; none if the action needs none. Thread: any.
std::optional<DocumentRequest> requestOf(const PartsPanel& panel, const PanelAction& action);

/// Returns the request for the hand's task at its tip, whose pose is in room space. A part is chosen by a ray from the
/// palm, so that a part which the tip has entered is found, too. Precondition: the task is not Sculpt. Thread: any.
DocumentRequest requestAt(const Pose& tip, HandTask task, const PartsPanel& panel, const BrushState& brush,
                          const ModelPlacement& placement);
} // namespace vr
