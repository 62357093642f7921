#include "core/parts/part_split.h"

#include <algorithm>
#include <map>
#include <set>

namespace core
{
namespace
{
/// Appends the values of one attribute; `present`: whether the joined mesh has it. A piece without values gets
/// defaults.
template <class Value>
void append(std::vector<Value>& all, const std::vector<Value>& values, std::size_t count, bool isPresent)
{
    if (!isPresent)
        return;
    if (values.empty())
        all.resize(all.size() + count);
    else
        all.insert(all.end(), values.begin(), values.end());
}
} // namespace

std::vector<PartPiece> splitByPart(const TriangleMesh& mesh)
{
    std::map<PartId, PartPiece> pieces;
    const auto partOf = [&](Slot v) { return mesh.parts.empty() ? PartId(0) : mesh.parts[v]; };
    std::vector<Slot> newIndex(mesh.points.size(), noSlot);
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        PartPiece& piece = pieces[partOf(t[0])];
        piece.faces.push_back(f);
        for (const Slot v : t)
            newIndex[v] = 0;
    }
    for (Slot v = 0; v < mesh.points.size(); ++v) {
        if (newIndex[v] == noSlot)
            continue;
        PartPiece& piece = pieces[partOf(v)];
        newIndex[v] = static_cast<Slot>(piece.points.size());
        piece.points.push_back(v);
        piece.mesh.points.push_back(mesh.points[v]);
        if (!mesh.colors.empty())
            piece.mesh.colors.push_back(mesh.colors[v]);
        if (!mesh.masks.empty())
            piece.mesh.masks.push_back(mesh.masks[v]);
    }
    std::vector<PartPiece> result;
    for (auto& [part, piece] : pieces) {
        piece.part = part;
        for (const Slot f : piece.faces) {
            const auto& [a, b, c] = mesh.triangles[f];
            piece.mesh.triangles.push_back({newIndex[a], newIndex[b], newIndex[c]});
        }
        result.push_back(std::move(piece));
    }
    return result;
}

TriangleMesh joined(const std::vector<PartPiece>& pieces)
{
    const bool hasColors = std::ranges::any_of(pieces, [](const PartPiece& p) { return !p.mesh.colors.empty(); });
    const bool hasMasks = std::ranges::any_of(pieces, [](const PartPiece& p) { return !p.mesh.masks.empty(); });
    const bool hasLabels = std::ranges::any_of(pieces, [](const PartPiece& p) { return p.part != 0; });
    TriangleMesh all;
    for (const PartPiece& piece : pieces) {
        const Slot first = static_cast<Slot>(all.points.size());
        const std::size_t count = piece.mesh.points.size();
        all.points.insert(all.points.end(), piece.mesh.points.begin(), piece.mesh.points.end());
        append(all.colors, piece.mesh.colors, count, hasColors);
        append(all.masks, piece.mesh.masks, count, hasMasks);
        if (hasLabels)
            all.parts.insert(all.parts.end(), count, piece.part);
        for (const auto& [a, b, c] : piece.mesh.triangles)
            all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

PartList listedParts(const TriangleMesh& mesh, const PartList& known)
{
    std::set<PartId> ids(mesh.parts.begin(), mesh.parts.end());
    if (ids.empty())
        ids.insert(0);
    std::vector<Part> parts;
    for (const Part& part : known.all()) {
        if (ids.erase(part.id) > 0)
            parts.push_back(part);
    }
    for (const PartId id : ids)
        parts.emplace_back().id = id;
    return PartList(std::move(parts));
}

TriangleMesh visibleParts(const TriangleMesh& mesh, const PartList& list)
{
    if (std::ranges::all_of(list.all(), &Part::isVisible))
        return mesh;
    std::vector<PartPiece> pieces = splitByPart(mesh);
    std::erase_if(pieces, [&list](const PartPiece& piece) {
        const Part* const part = list.find(piece.part);
        return part && !part->isVisible;
    });
    return joined(pieces);
}

TriangleMesh inListOrder(const TriangleMesh& mesh, const PartList& known)
{
    if (mesh.parts.empty())
        return mesh;
    const PartList list = listedParts(mesh, known);
    const auto placeOf = [&list](const PartPiece& piece) { return list.find(piece.part); };
    std::vector<PartPiece> pieces = splitByPart(mesh);
    std::ranges::sort(pieces, {}, placeOf);
    return joined(pieces);
}
} // namespace core
