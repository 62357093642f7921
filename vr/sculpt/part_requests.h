#pragma once

#include "vr/input/model_placement.h"
#include "vr/panels/panel_content.h"
#include "vr/sculpt/brush_state.h"
#include "vr/sculpt/document_port.h"

namespace vr
{
/// Returns the request to the document for an action at the parts panel; none if the action needs none. Thread: any.
std::optional<DocumentRequest> requestOf(const PartsPanel& panel, const PanelAction& action);

/// A use of the wand's tip for a task of the hand.
struct TipUse
{
    Pose tip; ///< pose of the wand's tip, room space
    HandTask task = HandTask::ChoosePart;
    core::Box box; ///< bounding box of the model, mm
};
/// Returns the request for the hand's task at its tip. A part is chosen by a ray from the palm, so that a part which
/// the tip has entered is found, too. A cut removes what lies beyond the tip of the active part, or makes it a part,
/// and with symmetry also its mirror image. Precondition: the task is neither Sculpt nor DrawTube. Thread: any.
DocumentRequest requestAt(const TipUse& use, const PartsPanel& panel, const BrushState& brush,
                          const ModelPlacement& placement);
/// Returns the request that adds a tube where its path is, with the brush's symmetry. Thread: any.
DocumentRequest tubeRequest(const core::Primitive& tube, const PartsPanel& panel, const BrushState& brush);
/// Returns the plane of symmetry about which a cut at the tip is made again; None if it is made once. Thread: any.
core::Symmetry imageOfCut(const TipUse& use, const BrushState& brush, const ModelPlacement& placement);
} // namespace vr
