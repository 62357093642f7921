#include "core/repair/doubled_parts.h"

#include "core/repair/edge_faces.h"

#include "core/analysis/surface_distance.h"
#include "core/geometry/box_tree.h"
#include "core/util/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <utility>

namespace core::repair
{
namespace
{
constexpr float nearby = 16; // lattice units; exceeds the rounding of the lattice and of files with six digits

/// A sorted list of edges of three or more faces.
using Border = std::vector<std::pair<Slot, Slot>>;

/// A part of the surface that is connected by edges of two faces.
struct Part
{
    std::vector<Slot> faces;
    Border border;
    bool isClosed = true; ///< each edge has an even number of the part's faces
};

std::vector<Part> partsOf(const TriangleSoup& surface)
{
    DisjointSets sets(surface.triangles.size());
    std::vector<std::vector<EdgeFace>> ends; // faces around each edge that does not have two
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        if (around.size() == 2)
            sets.unite(around[0].face, around[1].face);
        else
            ends.emplace_back(around.begin(), around.end());
    });
    std::vector<Part> parts;
    std::vector<Slot> ofFace;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Slot root = sets.root(f); // the first face of its part
        ofFace.push_back(root == f ? static_cast<Slot>(parts.size()) : ofFace[root]);
        if (root == f)
            parts.emplace_back();
        parts[ofFace[f]].faces.push_back(f);
    }
    std::map<Slot, std::size_t> count; // for each part, its number of faces at one edge
    for (const std::vector<EdgeFace>& around : ends) {
        count.clear();
        for (const EdgeFace& e : around)
            ++count[ofFace[e.face]];
        for (const auto& [part, faces] : count) {
            if (around.size() > 2)
                parts[part].border.emplace_back(around[0].low, around[0].high);
            parts[part].isClosed = parts[part].isClosed && faces % 2 == 0;
        }
    }
    return parts;
}

/// Returns whether two boxes are equal within `nearby`.
bool areAlike(const FaceBox& a, const FaceBox& b)
{
    return (a.min - b.min).abs().maxCoeff() <= nearby && (a.max - b.max).abs().maxCoeff() <= nearby;
}

/// A part as a mesh of its own, in lattice units, with samples: its vertices and the midpoints of its edges.
class PartSurface
{
public:
    PartSurface(const TriangleSoup& surface, const Part& part)
    {
        std::map<Slot, Slot> slots;
        for (const Slot f : part.faces) {
            Triangle t = surface.triangles[f];
            for (Slot& v : t) {
                const auto [entry, isNew] = slots.try_emplace(v, static_cast<Slot>(m_mesh.points.size()));
                if (isNew)
                    m_mesh.points.push_back(surface.points[v].cast<float>());
                v = entry->second;
            }
            m_mesh.triangles.push_back(t);
        }
        m_samples = m_mesh.points;
        for (const Triangle& t : m_mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                m_samples.push_back((m_mesh.points[t[i]] + m_mesh.points[t[(i + 1) % 3]]) / 2);
        for (const Vec3f& p : m_mesh.points)
            m_box.extend(p.array());
    }

    /// Returns six times the volume of a closed part; negative if it faces inwards.
    double sixVolumes() const
    {
        const auto at = [&](Slot v) { return Vec3((m_mesh.points[v] - m_mesh.points[0]).cast<double>()); };
        double sum = 0;
        for (const auto& [a, b, c] : m_mesh.triangles)
            sum += at(a).dot(at(b).cross(at(c)));
        return sum;
    }
    bool coincidesWith(const PartSurface& other) const
    {
        return areAlike(m_box, other.m_box) && liesUpon(other) && other.liesUpon(*this);
    }

private:
    bool liesUpon(const PartSurface& other) const
    {
        return std::ranges::max(distancesTo(other.m_mesh, m_samples)) <= nearby;
    }

    TriangleMesh m_mesh;
    std::vector<Vec3f> m_samples;
    FaceBox m_box;
};

std::vector<Triangle> dropParts(TriangleSoup& surface, const std::vector<Part>& parts, const std::vector<bool>& goes)
{
    std::vector<bool> faceGoes(surface.triangles.size(), false);
    for (std::size_t part = 0; part < parts.size(); ++part)
        for (const Slot f : parts[part].faces)
            faceGoes[f] = goes[part];
    std::vector<Triangle> dropped;
    std::size_t kept = 0;
    for (Slot f = 0; f < surface.triangles.size(); ++f)
        if (faceGoes[f])
            dropped.push_back(surface.triangles[f]);
        else
            surface.triangles[kept++] = surface.triangles[f];
    surface.triangles.resize(kept);
    return dropped;
}
} // namespace

std::vector<Triangle> dropDoubledPatches(TriangleSoup& surface)
{
    std::vector<Triangle> dropped;
    for (bool again = true; again;) { // removing a double may connect other parts
        const std::vector<Part> parts = partsOf(surface);
        std::map<Border, std::vector<std::size_t>> byBorder;
        for (std::size_t part = 0; part < parts.size(); ++part)
            if (!parts[part].isClosed && !parts[part].border.empty())
                byBorder[parts[part].border].push_back(part);
        std::vector<bool> goes(parts.size(), false);
        for (const auto& [border, alike] : byBorder) {
            std::vector<PartSurface> kept;
            for (std::size_t i = 0; alike.size() > 1 && i < alike.size(); ++i) {
                PartSurface part(surface, parts[alike[i]]);
                goes[alike[i]] = std::ranges::any_of(kept, [&](const PartSurface& k) { return part.coincidesWith(k); });
                if (!goes[alike[i]])
                    kept.push_back(std::move(part));
            }
        }
        const std::vector<Triangle> now = dropParts(surface, parts, goes);
        dropped.insert(dropped.end(), now.begin(), now.end());
        again = !now.empty();
    }
    return dropped;
}

std::vector<Triangle> dropDoubledShells(TriangleSoup& surface)
{
    const std::vector<Part> parts = partsOf(surface);
    std::vector<std::size_t> closed;
    std::vector<FaceBox> boxes, corners; // one entry for each closed part
    for (std::size_t part = 0; part < parts.size(); ++part) {
        if (!parts[part].isClosed)
            continue;
        FaceBox box;
        for (const Slot f : parts[part].faces)
            for (const Slot v : surface.triangles[f])
                box.extend(surface.points[v].array().cast<float>());
        closed.push_back(part);
        boxes.push_back(box);
        corners.push_back({box.min - nearby / 2, box.min + nearby / 2});
    }
    std::vector<bool> goes(parts.size(), false);
    if (closed.size() > 1) {
        const BoxTree tree(corners);
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
        for (Slot block = 0; block < tree.blocks(); ++block)
            tree.forEachMeetingPair(block, [&](Slot i, Slot j) {
                if (areAlike(boxes[tree.at(i)], boxes[tree.at(j)]))
                    pairs.push_back(std::minmax(closed[tree.at(i)], closed[tree.at(j)]));
            });
        std::ranges::sort(pairs);
        for (const auto& [first, second] : pairs) {
            if (goes[first] || goes[second])
                continue;
            const PartSurface a(surface, parts[first]), b(surface, parts[second]);
            goes[second] = a.sixVolumes() * b.sixVolumes() > 0 && a.coincidesWith(b);
        }
    }
    return dropParts(surface, parts, goes);
}
} // namespace core::repair
