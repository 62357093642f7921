#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>
#include <span>

namespace core::repair
{
struct SeparationResult
{
    std::size_t edges = 0, vertices = 0; ///< where the solid touched itself
    /// Points, several at each place, where that did not help, and the ends of edges of four faces that are too short
    /// for it.
    std::vector<Slot> stuck;
};

/// Parts of the solid that touch at edges or vertices only draw back from each other there, by a few lattice units.
/// Where they cannot, the points are returned. The surface bounds a solid but for those touches.
SeparationResult separateContacts(TriangleSoup& surface, const JobControl& control = {});
} // namespace core::repair
