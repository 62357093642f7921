#pragma once

#include "core/primitives/tube.h"

namespace core
{
/// Returns the points of a path drawn by hand that a tube needs: those without which it would leave the drawn path by
/// more than `tolerance`, mm (drawn_path.h). Of points that are nearer to each other than the tube is thick
/// there only one is left: a hand that shakes would fold it. The first and the last remain. Precondition: at least two
/// points. Thread: any. Cost: quadratic at worst.
std::vector<TubePoint> thinnedPath(const std::vector<TubePoint>& drawn, double tolerance);
} // namespace core
