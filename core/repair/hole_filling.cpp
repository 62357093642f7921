#include "core/repair/hole_filling.h"

#include "core/repair/edge_faces.h"

#include "core/geometry/point_triangle.h"
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
    /// Returns false if the edge is already there.
    bool add(Slot a, Slot b) { return m_edges.insert(key(a, b)).second; }
    void remove(Slot a, Slot b) { m_edges.erase(key(a, b)); }

private:
    static std::uint64_t key(Slot a, Slot b) { return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b); }
    std::unordered_set<std::uint64_t> m_edges;
};

class LoopFiller
{
public:
    LoopFiller(const TriangleSoup& surface, const EdgeSet& present, std::vector<Slot> loop)
        : m_surface(surface)
        , m_present(present)
        , m_loop(std::move(loop))
    {}

    std::vector<Triangle> fill(std::size_t most = maxCorners)
    {
        cutCorners(most);
        if (m_loop.size() >= 3)
            fillWithLeastArea();
        return std::move(m_faces);
    }
    /// Returns whether no face is degenerate and no edge was there before.
    bool isClean() const { return m_cost < farMore; }

private:
    Vec3 at(Slot v) const { return m_surface.points[v].cast<double>(); }

    /// Returns twice the area of a face, or a huge cost if the face would be degenerate: the normal is exact.
    double cost(Slot a, Slot b, Slot c) const
    {
        const double area = (at(b) - at(a)).cross(at(c) - at(a)).norm();
        return area == 0 ? farMore : area;
    }
    /// Returns a huge cost if the edge between two corners of the loop exists already, as it would then have four
    /// faces; otherwise 0.
    double costOfChord(std::size_t i, std::size_t k) const
    {
        const bool isBorder = k == i + 1 || (i == 0 && k + 1 == m_loop.size());
        return !isBorder && m_present.has(m_loop[i], m_loop[k]) ? farMore : 0;
    }
    static constexpr double farMore = 1e12 * Lattice::limit;

    void cutCorners(std::size_t most)
    {
        while (m_loop.size() > most) {
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
            m_faces.push_back({m_loop[(best + n - 1) % n], m_loop[best], m_loop[(best + 1) % n]});
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
        m_cost = minCost[n - 1];
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
        while (!open.empty()) {
            const auto [i, k] = open.back();
            open.pop_back();
            if (k - i < 2)
                continue;
            const std::size_t m = apex[i * n + k];
            m_faces.push_back({m_loop[i], m_loop[m], m_loop[k]});
            open.emplace_back(i, m);
            open.emplace_back(m, k);
        }
    }

    const TriangleSoup& m_surface;
    const EdgeSet& m_present;
    std::vector<Slot> m_loop;
    std::vector<Triangle> m_faces;
    double m_cost = 0;
};

/// Returns the normal of a face, as long as twice its area.
Vec3 normalOf(const TriangleSoup& surface, const Triangle& t)
{
    const Vec3 a = surface.points[t[0]].cast<double>();
    return (surface.points[t[1]].cast<double>() - a).cross(surface.points[t[2]].cast<double>() - a);
}

double doubleAreaOf(const TriangleSoup& surface, std::span<const Triangle> faces)
{
    double area = 0;
    for (const Triangle& t : faces)
        area += normalOf(surface, t).norm();
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

/// A loop and the faces that fill it.
struct Patch
{
    std::vector<Slot> loop = {};
    std::vector<Triangle> faces = {};
    double doubleArea = 0;
    LatticeBox box = {};
    Vec3 normal = Vec3::Zero(); ///< sum of the faces' normals, made of unit length
};

Patch patchOver(const TriangleSoup& surface, std::vector<Slot> loop, std::vector<Triangle> faces)
{
    Patch patch{.loop = std::move(loop), .faces = std::move(faces)};
    patch.doubleArea = doubleAreaOf(surface, patch.faces);
    patch.box = boxOf(surface, patch.loop);
    for (const Triangle& t : patch.faces)
        patch.normal += normalOf(surface, t);
    patch.normal.normalize();
    return patch;
}

/// Fills loops that bound one opening together, as both rims at the end of a pipe do, with faces between them.
class LoopJoiner
{
public:
    LoopJoiner(const TriangleSoup& surface, EdgeSet& present) : m_surface(surface), m_present(present) {}

    /// Joins patches, beginning with the largest. Joined patches are empty.
    void run(std::vector<Patch>& patches, const JobControl& control)
    {
        std::vector<Patch*> rims = rimsAmong(patches);
        std::ranges::stable_sort(rims, std::ranges::greater(), [](const Patch* patch) { return patch->doubleArea; });
        for (auto outer = rims.begin(); outer != rims.end(); ++outer)
            for (auto inner = outer + 1; inner != rims.end() && !control.isCancelled(); ++inner)
                if (!(*outer)->loop.empty() && !(*inner)->loop.empty() && join(**outer, **inner))
                    **inner = {};
    }

private:
    /// Returns the patches to whose border the surface comes from below or above. A hole in a sheet is none.
    std::vector<Patch*> rimsAmong(std::vector<Patch>& patches) const
    {
        constexpr double steep = 0.9; // cosine of the angle between the normals of the patch and of the surface
        const auto key = [](Slot from, Slot to) { return std::uint64_t(from) << 32 | to; };
        std::unordered_map<std::uint64_t, std::pair<Patch*, double>> edges;
        std::unordered_map<Patch*, std::pair<double, double>> lengths; // of the border, and of it times the cosine
        for (Patch& patch : patches)
            for (std::size_t i = 0; i < patch.loop.size(); ++i) {
                const Slot from = patch.loop[i], to = patch.loop[(i + 1) % patch.loop.size()];
                const double length = (m_surface.points[to] - m_surface.points[from]).cast<double>().norm();
                edges.emplace(key(to, from), std::pair(&patch, length)); // the surface's face runs the other way
                lengths[&patch].first += length;
            }
        for (const Triangle& t : m_surface.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                if (const auto edge = edges.find(key(t[i], t[i == 2 ? 0 : i + 1])); edge != edges.end()) {
                    const auto [patch, length] = edge->second;
                    lengths[patch].second += length * std::abs(patch->normal.dot(normalOf(m_surface, t).normalized()));
                }
        std::vector<Patch*> rims;
        for (Patch& patch : patches)
            if (lengths[&patch].second < steep * lengths[&patch].first)
                rims.push_back(&patch);
        return rims;
    }

    /// Replaces the outer patch by one over both loops, and returns true, if that has clearly less area.
    bool join(Patch& outer, const Patch& inner)
    {
        constexpr std::size_t most = 2 * maxCorners;
        constexpr double leastGain = 1.5; // of the smaller patch's area; that of a hole in a flat face is 2
        if (outer.loop.size() + inner.loop.size() + 2 > most || !isNear(inner, outer))
            return false;
        const std::vector<Slot> loop = joined(outer.loop, inner.loop);
        const Slot from = loop[0], to = loop.back();
        // A bridge that leads away from the patch is no part of a rim: it lies on the wall between the ends of a tube.
        const Vec3 bridge = (m_surface.points[to] - m_surface.points[from]).cast<double>();
        const double along = bridge.dot(outer.normal);
        if (2 * along * along > bridge.squaredNorm() || !m_present.add(from, to))
            return false;
        LoopFiller filler(m_surface, m_present, loop);
        Patch both = patchOver(m_surface, loop, filler.fill(most));
        const double gain = outer.doubleArea + inner.doubleArea - both.doubleArea;
        if (!filler.isClean() || gain < leastGain * std::min(outer.doubleArea, inner.doubleArea)) {
            m_present.remove(from, to);
            return false;
        }
        both.box = outer.box;
        outer = std::move(both);
        return true;
    }

    /// Returns whether the first corner of a loop lies on or near the faces of another patch, measured by the loop's
    /// size, and the loop's box in that of the other.
    bool isNear(const Patch& inner, const Patch& outer) const
    {
        const double slack = extentOf(inner.box) / 2;
        const Vec3 p = m_surface.points[inner.loop[0]].cast<double>();
        if (((inner.box.min - outer.box.min).cast<double>().array() < -slack).any() ||
            ((outer.box.max - inner.box.max).cast<double>().array() < -slack).any())
            return false;
        return std::ranges::any_of(outer.faces, [&](const Triangle& t) {
            const auto at = [&](Slot v) { return Vec3(m_surface.points[v].cast<double>()); };
            return (nearestInTriangle(p, {at(t[0]), at(t[1]), at(t[2])}) - p).norm() <= slack;
        });
    }

    /// Returns one loop over two, with a bridge there and back between their nearest corners, which are its first and
    /// its last.
    std::vector<Slot> joined(std::vector<Slot> a, std::vector<Slot> b) const
    {
        double least = std::numeric_limits<double>::infinity();
        std::size_t ofA = 0, ofB = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t k = 0; k < b.size(); ++k) {
                const double distance = (m_surface.points[a[i]] - m_surface.points[b[k]]).cast<double>().squaredNorm();
                if (distance < least) {
                    least = distance;
                    ofA = i;
                    ofB = k;
                }
            }
        std::ranges::rotate(a, a.begin() + static_cast<std::ptrdiff_t>(ofA));
        std::ranges::rotate(b, b.begin() + static_cast<std::ptrdiff_t>(ofB));
        std::vector<Slot> loop = a;
        loop.push_back(a[0]);
        loop.insert(loop.end(), b.begin(), b.end());
        loop.push_back(b[0]);
        return loop;
    }

    const TriangleSoup& m_surface;
    EdgeSet& m_present;
};
} // namespace

HoleFillingResult fillHoles(TriangleSoup& surface, bool largeToo, const JobControl& control)
{
    HoleFillingResult filled;
    if (surface.triangles.empty())
        return filled;
    const double extent = extentOf(surface.box());
    std::vector<std::vector<Slot>> loops = loopsOf(openWays(surface), surface.points.size());
    EdgeSet present(surface, loops);
    const double area = doubleAreaOf(surface, surface.triangles);
    std::vector<Patch> patches;
    for (std::vector<Slot>& loop : loops) {
        if (control.isCancelled())
            break;
        const bool isLarge = extentOf(boxOf(surface, loop)) > largeHole * extent;
        filled.largeHoles += isLarge;
        if (isLarge && !largeToo)
            continue;
        filled.holes += 1;
        std::vector<Triangle> faces = LoopFiller(surface, present, loop).fill();
        patches.push_back(patchOver(surface, std::move(loop), std::move(faces)));
    }
    LoopJoiner(surface, present).run(patches, control);
    double added = 0;
    for (const Patch& patch : patches) {
        surface.triangles.insert(surface.triangles.end(), patch.faces.begin(), patch.faces.end());
        filled.faces += patch.faces.size();
        added += patch.doubleArea;
    }
    filled.share = added / area;
    return filled;
}
} // namespace core::repair
