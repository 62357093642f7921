#pragma once

#include "vr/input/model_placement.h"
#include "vr/panels/panel_content.h"
#include "vr/sculpt/document_port.h"

namespace vr
{
/// Returns the request to the document for an action at the parts panel; none if the action needs none. Thread: any.
std::optional<DocumentRequest> requestOf(const PartsPanel& panel, const PanelAction& action);

/// Returns the request to make the part active at which the wand points. Its ray begins at the palm, so that a part
/// which the tip has entered is found, too. `tip`: room space. Thread: any.
PickPart pickAt(const Pose& tip, const ModelPlacement& placement);
} // namespace vr
