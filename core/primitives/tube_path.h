#pragma once

#include "core/primitives/tube.h"

namespace core
{
/// Returns the points of a path drawn by hand that a tube needs: those without which it would leave the drawn path by
/// more than `tolerance`, mm (drawn_path.h). Of points that are nearer to each other than the tube's
/// radius there only one is left: a hand that shakes would fold it. The first and the last remain, unless they are the
/// same and all are near. Precondition: at least two
/// points. Thread: any. Cost: quadratic at worst.
std::vector<TubePoint> thinnedPath(const std::vector<TubePoint>& drawn, double tolerance);
} // namespace core
