#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// The settings of a recorded stroke that may be changed afterwards.
struct BrushChange
{
    Tool tool = Tool::Pull;
    double radius = 0;   ///< brush radius, mm
    double strength = 0; ///< brush strength, 0 to 10

    friend bool operator==(const BrushChange&, const BrushChange&) = default;
};

BrushChange brushOf(const StrokeSettings& settings);

/// Returns the stroke with its samples applied by another brush. A sample's own radius or strength keeps its ratio to
/// the stroke's, within the ranges of the parameter table. StrokeSettings::add is cleared for tools that cannot add
/// solids.
Stroke changed(Stroke stroke, const BrushChange& brush);
} // namespace core
