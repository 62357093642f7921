#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// Of a stroke that was done: what may be another afterwards.
struct BrushChange
{
    Tool tool = Tool::Pull;
    double radius = 0;   ///< in the document's unit
    double strength = 0; ///< 0 to 10

    friend bool operator==(const BrushChange&, const BrushChange&) = default;
};

BrushChange brushOf(const StrokeSettings& settings);

/// The same samples by another brush. Samples with a radius or a strength of their own keep their ratio to the
/// stroke's, within the ranges of the parameter table. A tool that cannot add solids adds none.
Stroke changed(Stroke stroke, const BrushChange& brush);
} // namespace core
