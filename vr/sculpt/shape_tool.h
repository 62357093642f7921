#pragma once

#include "vr/input/model_placement.h"
#include "vr/scene/scene_state.h"
#include "vr/sculpt/brush_state.h"

#include "core/operations/model_command.h"

namespace vr
{
/// Returns the shape as large as the brush: its greatest measure is the brush's diameter. Space: document, mm.
core::Primitive shapeOfSize(core::Primitive::Kind kind, double diameter);

/// Returns the command that adds a shape as large as the brush with its centre at the tip. Its axis is the upright of
/// the wand, or the document's axis within 8 degrees of it. With symmetry it is mirrored; a shape near the plane is put
/// on it. `tip`: room space.
core::Insert shapeAt(core::Primitive::Kind kind, const Pose& tip, const BrushState& brush,
                     const ModelPlacement& placement);

/// Returns a point of a tube as thick as the brush; near the plane of symmetry, a point on it. `tip`: room space.
core::TubePoint tubePointAt(const Pose& tip, const BrushState& brush, const ModelPlacement& placement);

/// Adds the mirror image of each line about the document's plane. Lines: room space.
void addMirrorImage(std::vector<Segment>& outline, core::Symmetry plane, const ModelPlacement& placement);

/// Replaces `outline` by the edges of the shape that the command adds, in room space: rings and lines that show its
/// form. Thread: any.
void outlineOf(const core::Insert& shape, const ModelPlacement& placement, std::vector<Segment>& outline);
} // namespace vr
