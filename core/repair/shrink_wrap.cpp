// Uses a grid of cubes, each divided into six tetrahedra around its diagonal, in the same way (Kuhn's), so that
// neighbours match.
//   1. begin    with the cubes that the surface passes through
//   2. ask      which of their corners are inside, and continue with the cubes to which the boundary leads
//   3. cut      each tetrahedron with corners inside and outside into one or two triangles, with a vertex on each edge
//               from inside to outside

#include "core/repair/shrink_wrap.h"

#include "core/analysis/winding_number.h"
#include "core/geometry/face_geometry.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace core::repair
{
namespace
{
using Node = Eigen::Vector3i; ///< a cube's lowest corner, or any grid point, in cells

constexpr int nodeBits = 21;

std::uint64_t keyOf(const Node& n)
{
    return (static_cast<std::uint64_t>(n.x()) << 2 * nodeBits) | (static_cast<std::uint64_t>(n.y()) << nodeBits) |
           static_cast<std::uint64_t>(n.z());
}

/// Returns corner i of a cube: bit 0 of i is x, bit 1 is y, bit 2 is z.
Node corner(const Node& cube, unsigned i)
{
    return cube + Node(static_cast<int>(i & 1), static_cast<int>(i >> 1 & 1), static_cast<int>(i >> 2 & 1));
}

/// Corners of the six tetrahedra, one for each path along edges from corner 0 to 7. In three of them the middle corners
/// are swapped, so that all have the same orientation.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class ShrinkWrap
{
public:
    ShrinkWrap(const TriangleSoup& surface, int cell, const JobControl& control)
        : m_original(surface)
        , m_cell(cell)
        , m_points(surface.places())
        , m_winding(m_points, surface.triangles)
        , m_tree(faceBoxes(surface.points, surface.triangles))
        , m_control(control)
        , m_origin(surface.box().min - LatticePoint::Constant(2 * cell))
    {}

    TriangleSoup run()
    {
        std::vector<Node> front = seeds();
        while (!front.empty() && !m_control.isCancelled()) {
            ask(front);
            front = next(front);
        }
        for (const Node& cube : m_crossed)
            for (const auto& tetrahedron : tetrahedra)
                cut(cube, tetrahedron);
        return std::move(m_result);
    }

private:
    LatticePoint place(const Node& n) const { return m_origin + m_cell * n; }

    /// Returns the cubes in each face's box that are near the face's plane.
    std::vector<Node> seeds()
    {
        std::vector<Node> cubes;
        for (const Triangle& t : m_original.triangles) {
            const Vec3 &a = m_points[t[0]], &b = m_points[t[1]], &c = m_points[t[2]];
            const Vec3 normal = (b - a).cross(c - a).normalized();
            const auto cellOf = [&](const Vec3& p) {
                return Node(((p - m_origin.cast<double>()) / m_cell).array().floor().cast<int>());
            };
            const Node low = cellOf(a.cwiseMin(b).cwiseMin(c)), high = cellOf(a.cwiseMax(b).cwiseMax(c));
            for (int x = low.x(); x <= high.x(); ++x) {
                for (int y = low.y(); y <= high.y(); ++y) {
                    for (int z = low.z(); z <= high.z(); ++z) {
                        const Node cube(x, y, z);
                        const Vec3 middle = place(cube).cast<double>() + Vec3::Constant(m_cell / 2.0);
                        if (std::abs(normal.dot(middle - a)) <= m_cell && m_seen.insert(keyOf(cube)).second)
                            cubes.push_back(cube);
                    }
                }
            }
        }
        return cubes;
    }

    void ask(const std::vector<Node>& cubes)
    {
        std::vector<std::pair<Node, bool*>> questions;
        for (const Node& cube : cubes) {
            for (unsigned i = 0; i < 8; ++i) {
                const auto [entry, isNew] = m_isInside.try_emplace(keyOf(corner(cube, i)), false);
                if (isNew)
                    questions.emplace_back(corner(cube, i), &entry->second);
            }
        }
        constexpr std::size_t nodesPerChunk = 64;
        forEachChunk(questions.size(), nodesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !m_control.isCancelled(); ++i)
                *questions[i].second = m_winding.at(place(questions[i].first).cast<double>()) > 0.5;
        });
    }

    bool isInside(const Node& n) const { return m_isInside.at(keyOf(n)); }

    std::vector<Node> next(const std::vector<Node>& cubes)
    {
        std::vector<Node> result;
        for (const Node& cube : cubes) {
            unsigned inside = 0;
            for (unsigned i = 0; i < 8; ++i)
                inside |= isInside(corner(cube, i)) ? 1u << i : 0;
            if (inside == 0 || inside == 0xff)
                continue;
            m_crossed.push_back(cube);
            for (int axis = 0; axis < 3; ++axis) {
                constexpr std::array<unsigned, 3> highSide{0xaa, 0xcc, 0xf0}; // corners on the high side of each axis
                for (const int way : {-1, 1}) {
                    const unsigned side = way > 0 ? highSide[static_cast<std::size_t>(axis)]
                                                  : 0xffu & ~highSide[static_cast<std::size_t>(axis)];
                    const unsigned there = inside & side;
                    if (there == 0 || there == side)
                        continue;
                    Node neighbour = cube;
                    neighbour[axis] += way;
                    if (m_seen.insert(keyOf(neighbour)).second)
                        result.push_back(neighbour);
                }
            }
        }
        return result;
    }

    void cut(const Node& cube, const std::array<unsigned, 4>& tetrahedron)
    {
        std::array<Node, 4> in, out;
        std::size_t ins = 0, outs = 0;
        bool isOdd = false; // the permutation that sorts inner corners first
        for (const unsigned i : tetrahedron) {
            const Node n = corner(cube, i);
            if (isInside(n)) {
                in[ins++] = n;
                isOdd ^= outs % 2 == 1;
            } else {
                out[outs++] = n;
            }
        }
        if (ins == 0 || outs == 0)
            return;
        if (ins == 1)
            add({vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2])}, isOdd);
        else if (ins == 3)
            add({vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0])}, isOdd);
        else {
            const Slot a = vertex(in[0], out[0]), b = vertex(in[0], out[1]), c = vertex(in[1], out[1]),
                       d = vertex(in[1], out[0]);
            add({a, b, c}, isOdd);
            add({a, c, d}, isOdd);
        }
    }

    void add(const Triangle& t, bool isTurned)
    {
        m_result.triangles.push_back(isTurned ? Triangle{t[0], t[2], t[1]} : t);
    }

    Slot vertex(const Node& in, const Node& out)
    {
        const Node low = in.cwiseMin(out), way = in.cwiseMax(out) - low;
        const auto direction = static_cast<std::size_t>(way.x() + 2 * way.y() + 4 * way.z());
        Slot& slot = m_vertices.try_emplace(keyOf(low), noVertices).first->second[direction];
        if (slot != noSlot)
            return slot;
        const Vec3 from = place(in).cast<double>(), to = place(out).cast<double>();
        Slot face = noSlot;
        const Vec3 p = from + crossing(from, to, face) * (to - from);
        slot = static_cast<Slot>(m_result.points.size());
        m_result.points.push_back(p.array().round().cast<int>());
        if (!m_original.colors.empty())
            m_result.colors.push_back(face == noSlot ? Rgb() : m_original.colors[m_original.triangles[face][0]]);
        return slot;
    }

    /// Returns where the edge passes through a face, as a share of the edge, or 0.5 if it passes through none. Prefers
    /// the crossing nearest to the middle. Avoids the ends, where triangles would have no area.
    double crossing(const Vec3& from, const Vec3& to, Slot& face) const
    {
        constexpr double nearEnd = 0.06;
        FaceBox box;
        box.extend(from.array().cast<float>());
        box.extend(to.array().cast<float>());
        double best = std::numeric_limits<double>::infinity();
        m_tree.forEachMeeting(box, [&](Slot position) {
            const Slot f = m_tree.at(position);
            const Triangle& t = m_original.triangles[f];
            const Vec3 a = m_points[t[0]], u = m_points[t[1]] - a, v = m_points[t[2]] - a, way = to - from;
            const Vec3 p = way.cross(v), q = (from - a).cross(u);
            const double det = u.dot(p);
            if (det == 0)
                return;
            const double x = (from - a).dot(p) / det, y = way.dot(q) / det, share = v.dot(q) / det;
            if (x < 0 || y < 0 || x + y > 1 || share < 0 || share > 1)
                return;
            const double distance = std::abs(share - 0.5), known = std::abs(best - 0.5);
            if (distance < known || (distance == known && f < face)) {
                best = share;
                face = f;
            }
        });
        return face == noSlot ? 0.5 : std::clamp(best, nearEnd, 1 - nearEnd);
    }

    const TriangleSoup& m_original;
    int m_cell;
    std::vector<Vec3> m_points;
    WindingNumber m_winding;
    BoxTree m_tree;
    const JobControl& m_control;
    LatticePoint m_origin;
    std::unordered_set<std::uint64_t> m_seen; ///< keys of visited cubes
    std::unordered_map<std::uint64_t, bool> m_isInside;
    std::vector<Node> m_crossed;
    using OnEdges = std::array<Slot, 8>; ///< indexed by the corner to which the edge leads from corner 0
    static constexpr OnEdges noVertices{noSlot, noSlot, noSlot, noSlot, noSlot, noSlot, noSlot, noSlot};
    std::unordered_map<std::uint64_t, OnEdges> m_vertices; ///< vertices on edges, by the edge's lower node
    TriangleSoup m_result;
};

} // namespace

TriangleSoup shrinkWrap(const TriangleSoup& surface, int cell, const JobControl& control)
{
    return ShrinkWrap(surface, cell, control).run();
}

int cellFor(const TriangleSoup& surface)
{
    double edges = 0;
    for (const Triangle& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            edges += (surface.points[t[i]] - surface.points[t[(i + 1) % 3]]).cast<double>().norm();
    const LatticeBox box = surface.box();
    const double side = (box.max - box.min).maxCoeff(),
                 mean = edges / (3.0 * static_cast<double>(surface.triangles.size()));
    constexpr double coarsest = 64, finest = 256;
    return static_cast<int>(std::clamp(mean / 2, side / finest, side / coarsest));
}
} // namespace core::repair
