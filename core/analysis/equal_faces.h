#pragma once

#include "core/geometry/geometry.h"

#include <span>
#include <vector>

namespace core
{
/// Groups of faces with equal corners: all faces of a group have the same three corners, in any order and orientation.
class EqualFaces
{
public:
    /// `faces`: the faces to group, ascending. Cost: one sort.
    EqualFaces(std::span<const Triangle> triangles, const std::vector<Slot>& faces);

    std::size_t groups() const { return m_begins.size() - 1; }
    /// Returns the faces of a group, ascending; at least one.
    std::span<const Slot> group(std::size_t index) const
    {
        return std::span(m_faces).subspan(m_begins[index], m_begins[index + 1] - m_begins[index]);
    }

private:
    std::vector<Slot> m_faces;  ///< faces, grouped
    std::vector<Slot> m_begins; ///< start of each group in `m_faces`, and the end of the last group
};
} // namespace core
