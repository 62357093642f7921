#pragma once

#include "core/geometry/geometry.h"

#include <span>
#include <vector>

namespace core
{
/// Faces put together by their corners: all faces of a group have three corners in common, however they run.
class EqualFaces
{
public:
    /// `faces`: some of them, ascending. Cost: a sort.
    EqualFaces(std::span<const Triangle> triangles, const std::vector<Slot>& faces);

    std::size_t groups() const { return m_begins.size() - 1; }
    /// Returns a group's faces, ascending, at least one.
    std::span<const Slot> group(std::size_t index) const
    {
        return std::span(m_faces).subspan(m_begins[index], m_begins[index + 1] - m_begins[index]);
    }

private:
    std::vector<Slot> m_faces;  ///< group by group
    std::vector<Slot> m_begins; ///< begins of the groups in `m_faces`, and the end
};
} // namespace core
