#include "core/repair/hole_filling.h"

#include "core/repair/edge_faces.h"

#include "core/geometry/predicates.h"

#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace core::repair
{
namespace
{
/// Largest loop that is filled with the least area, in corners; the cost is cubic in it.
constexpr std::size_t maxCorners = 300;

/// Returns the directed edges of the faces to be added: one for each time that faces run along an edge more often in
/// the opposite direction.
std::unordered_multimap<Slot, Slot> openWays(const TriangleSoup& surface)
{
    std::unordered_multimap<Slot, Slot> ways;
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        int net = 0;
        for (const EdgeFace& e : around)
            net += e.forward ? 1 : -1;
        for (; net > 0; --net)
            ways.emplace(around[0].high, around[0].low);
        for (; net < 0; ++net)
            ways.emplace(around[0].low, around[0].high);
    });
    return ways;
}

/// Returns closed walks along the directed edges, each without repeated corners.
std::vector<std::vector<Slot>> loopsOf(std::unordered_multimap<Slot, Slot> ways, std::size_t points)
{
    std::vector<std::vector<Slot>> loops;
    std::vector<Slot> starts;
    for (const auto& [from, to] : ways)
        starts.push_back(from);
    std::ranges::sort(starts);
    std::vector<Slot> placeInWalk(points, noSlot);
    for (const Slot start : starts) {
        std::vector<Slot> walk;
        Slot at = start;
        while (true) {
            if (placeInWalk[at] != noSlot) { // a loop closes
                const auto first = walk.begin() + placeInWalk[at];
                loops.emplace_back(first, walk.end());
                for (auto v = first; v != walk.end(); ++v)
                    placeInWalk[*v] = noSlot;
                walk.erase(first, walk.end());
            }
            const auto way = ways.find(at);
            if (way == ways.end())
                break;
            placeInWalk[at] = static_cast<Slot>(walk.size());
            walk.push_back(at);
            at = way->second;
            ways.erase(way);
        }
        for (const Slot v : walk)
            placeInWalk[v] = noSlot;
    }
    return loops;
}

/// The surface's edges whose ends are both on hole loops.
class EdgeSet
{
public:
    EdgeSet(const TriangleSoup& surface, const std::vector<std::vector<Slot>>& loops)
    {
        std::vector<bool> isOnLoop(surface.points.size(), false);
        for (const std::vector<Slot>& loop : loops)
            for (const Slot v : loop)
                isOnLoop[v] = true;
        for (const Triangle& t : surface.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                if (const Slot a = t[i], b = t[i == 2 ? 0 : i + 1]; isOnLoop[a] && isOnLoop[b])
                    m_edges.insert(key(a, b));
    }

    bool has(Slot a, Slot b) const { return m_edges.contains(key(a, b)); }

private:
    static std::uint64_t key(Slot a, Slot b) { return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b); }
    std::unordered_set<std::uint64_t> m_edges;
};

class LoopFiller
{
public:
    LoopFiller(TriangleSoup& surface, const EdgeSet& present, std::vector<Slot> loop)
        : m_surface(surface)
        , m_present(present)
        , m_loop(std::move(loop))
    {}

    std::size_t fill()
    {
        const std::size_t before = m_surface.triangles.size();
        cutCorners();
        if (m_loop.size() >= 3)
            fillWithLeastArea();
        return m_surface.triangles.size() - before;
    }

private:
    Vec3 at(Slot v) const { return m_surface.points[v].cast<double>(); }

    /// Returns twice the area of a face, or a huge cost if the face would be degenerate.
    double cost(Slot a, Slot b, Slot c) const
    {
        const auto& p = m_surface.points;
        return LatticePredicates::collinear(p[a], p[b], p[c]) ? farMore : (at(b) - at(a)).cross(at(c) - at(a)).norm();
    }
    /// Returns a huge cost if the edge between two corners of the loop exists already, as it would then have four
    /// faces; otherwise 0.
    double costOfChord(std::size_t i, std::size_t k) const
    {
        const bool isBorder = k == i + 1 || (i == 0 && k + 1 == m_loop.size());
        return !isBorder && m_present.has(m_loop[i], m_loop[k]) ? farMore : 0;
    }
    static constexpr double farMore = 1e12 * Lattice::limit;

    void cutCorners()
    {
        while (m_loop.size() > maxCorners) {
            std::size_t best = 0;
            double minCost = std::numeric_limits<double>::infinity();
            const std::size_t n = m_loop.size();
            for (std::size_t i = 0; i < n; ++i) {
                const Slot a = m_loop[(i + n - 1) % n], b = m_loop[i], c = m_loop[(i + 1) % n];
                const Vec3 u = at(a) - at(b), v = at(c) - at(b);
                const double cosine = u.dot(v) / (u.norm() * v.norm());
                const bool isFlat =
                    LatticePredicates::collinear(m_surface.points[a], m_surface.points[b], m_surface.points[c]);
                if (!isFlat && -cosine < minCost) {
                    minCost = -cosine;
                    best = i;
                }
            }
            m_surface.triangles.push_back({m_loop[(best + n - 1) % n], m_loop[best], m_loop[(best + 1) % n]});
            m_loop.erase(m_loop.begin() + static_cast<std::ptrdiff_t>(best));
        }
    }

    void fillWithLeastArea()
    {
        const std::size_t n = m_loop.size();
        std::vector<double> minCost(n * n, 0);
        std::vector<std::size_t> apex(n * n, 0);
        for (std::size_t length = 2; length < n; ++length) {
            for (std::size_t i = 0; i + length < n; ++i) {
                const std::size_t k = i + length;
                double& best = minCost[i * n + k] = std::numeric_limits<double>::infinity();
                const double chord = costOfChord(i, k);
                for (std::size_t m = i + 1; m < k; ++m) {
                    const double sum =
                        minCost[i * n + m] + minCost[m * n + k] + chord + cost(m_loop[i], m_loop[m], m_loop[k]);
                    if (sum < best) {
                        best = sum;
                        apex[i * n + k] = m;
                    }
                }
            }
        }
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
        while (!open.empty()) {
            const auto [i, k] = open.back();
            open.pop_back();
            if (k - i < 2)
                continue;
            const std::size_t m = apex[i * n + k];
            m_surface.triangles.push_back({m_loop[i], m_loop[m], m_loop[k]});
            open.emplace_back(i, m);
            open.emplace_back(m, k);
        }
    }

    TriangleSoup& m_surface;
    const EdgeSet& m_present;
    std::vector<Slot> m_loop;
};

double areaOf(const TriangleSoup& surface, std::size_t fromFace)
{
    double area = 0;
    for (std::size_t f = fromFace; f < surface.triangles.size(); ++f) {
        const Triangle& t = surface.triangles[f];
        const Vec3 a = surface.points[t[0]].cast<double>();
        area += (surface.points[t[1]].cast<double>() - a).cross(surface.points[t[2]].cast<double>() - a).norm();
    }
    return area;
}

double extentOf(const LatticeBox& box)
{
    return (box.max - box.min).maxCoeff();
}

LatticeBox boxOf(const TriangleSoup& surface, const std::vector<Slot>& loop)
{
    LatticeBox box;
    for (const Slot v : loop)
        box.extend(surface.points[v]);
    return box;
}
} // namespace

HoleFillingResult fillHoles(TriangleSoup& surface, bool largeToo, const JobControl& control)
{
    HoleFillingResult filled;
    if (surface.triangles.empty())
        return filled;
    const double extent = extentOf(surface.box());
    std::vector<std::vector<Slot>> loops = loopsOf(openWays(surface), surface.points.size());
    const EdgeSet present(surface, loops);
    const std::size_t before = surface.triangles.size();
    const double area = areaOf(surface, 0);
    for (std::vector<Slot>& loop : loops) {
        if (control.isCancelled())
            break;
        const bool isLarge = extentOf(boxOf(surface, loop)) > largeHole * extent;
        filled.largeHoles += isLarge;
        if (isLarge && !largeToo)
            continue;
        filled.holes += 1;
        filled.faces += LoopFiller(surface, present, std::move(loop)).fill();
    }
    filled.share = areaOf(surface, before) / area;
    return filled;
}
} // namespace core::repair
