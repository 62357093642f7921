#pragma once

#include "core/boolean/solid_soup.h"

#include <stop_token>

namespace core::boolean
{
/// Returns the faces that meet or touch a face of another solid, ascending. Exact; uses all cores. Cost: a sort of the
/// faces where boxes of solids overlap, and a test of each pair of faces whose boxes meet there.
std::vector<Slot> crossingFaces(const SolidSoup& soup, const std::stop_token& stop = {});

/// Returns the faces that meet any other face, ascending. Faces of one solid count, too, because rounding to the
/// lattice may make them meet. Cost: selfIntersections() of all faces.
std::vector<Slot> meetingFaces(const SolidSoup& soup, const std::stop_token& stop = {});
} // namespace core::boolean
