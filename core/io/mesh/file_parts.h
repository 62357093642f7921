#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/parts/part_list.h"
#include "core/parts/part_split.h"

#include <algorithm>
#include <string>
#include <vector>

namespace core::io
{
/// A part of a mesh that is written as an object of a file.
struct FilePart
{
    const TriangleMesh& mesh;
    std::string name; ///< the part's name, or "Part N"; empty: a mesh without parts, whose object has no name
};

/// The parts of a mesh as objects of a file, in the order of their list.
class FileParts
{
public:
    /// `mesh`: not owned. `parts`: listedParts() of the mesh. Cost: a copy of the mesh if it has several parts.
    FileParts(const TriangleMesh& mesh, const PartList& parts)
    {
        if (parts.size() == 1) {
            m_all.push_back({mesh, parts == PartList() ? std::string() : nameOf(parts.all().front())});
            return;
        }
        m_pieces = splitByPart(mesh);
        std::ranges::sort(m_pieces, {}, [&parts](const PartPiece& piece) { return parts.find(piece.part); });
        for (const PartPiece& piece : m_pieces)
            m_all.push_back({piece.mesh, nameOf(*parts.find(piece.part))});
    }
    FileParts(const FileParts&) = delete;
    FileParts& operator=(const FileParts&) = delete;

    const std::vector<FilePart>& all() const { return m_all; }

private:
    static std::string nameOf(const Part& part)
    {
        return part.name.empty() ? "Part " + std::to_string(part.id + 1) : part.name;
    }

    std::vector<PartPiece> m_pieces;
    std::vector<FilePart> m_all;
};
} // namespace core::io
