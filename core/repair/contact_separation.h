#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>
#include <span>

namespace core::repair
{
struct SeparationResult
{
    std::size_t edges = 0, vertices = 0; ///< number of edges and vertices at which the solid touched itself
    /// Points that could not be separated, several at each position, and the ends of edges of four faces that are too
    /// short to be halved.
    std::vector<Slot> stuck;
};

/// Separates parts of a solid that touch only at edges or vertices, by a few lattice units. Precondition: the surface
/// bounds a solid except for these contacts.
SeparationResult separateContacts(TriangleSoup& surface, const JobControl& control = {});
} // namespace core::repair
