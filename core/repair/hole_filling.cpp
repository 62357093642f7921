#include "core/repair/hole_filling.h"

#include "core/repair/edge_faces.h"

#include "core/geometry/box_tree.h"
#include "core/geometry/point_triangle.h"
#include "core/geometry/predicates.h"
#include "core/util/disjoint_sets.h"

#include <cmath>
#include <optional>
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

/// Returns the normal of a face, as long as twice its area.
Vec3 normalOf(const TriangleSoup& surface, const Triangle& t)
{
    const Vec3 a = surface.points[t[0]].cast<double>();
    return (surface.points[t[1]].cast<double>() - a).cross(surface.points[t[2]].cast<double>() - a);
}

std::array<Vec3, 3> cornersOf(const TriangleSoup& surface, const Triangle& t)
{
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    return {at(t[0]), at(t[1]), at(t[2])};
}

double doubleAreaOf(const TriangleSoup& surface, std::span<const Triangle> faces)
{
    double area = 0;
    for (const Triangle& t : faces)
        area += normalOf(surface, t).norm();
    return area;
}

LatticeBox boxOf(const TriangleSoup& surface, std::span<const Slot> corners)
{
    LatticeBox box;
    for (const Slot v : corners)
        box.extend(surface.points[v]);
    return box;
}

double extentOf(const LatticeBox& box)
{
    return (box.max - box.min).maxCoeff();
}

std::uint64_t key(Slot from, Slot to)
{
    return std::uint64_t(from) << 32 | to;
}

/// Finds the face at an edge of a hole loop. The face runs along the edge in the other direction.
class RimFaces
{
public:
    RimFaces(const TriangleSoup& surface, const std::vector<std::vector<Slot>>& loops)
    {
        for (const std::vector<Slot>& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i)
                m_faces.emplace(key(loop[i], loop[(i + 1) % loop.size()]), noSlot);
        for (Slot f = 0; f < surface.triangles.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i) {
                const Triangle& t = surface.triangles[f];
                if (const auto way = m_faces.find(key(t[i == 2 ? 0 : i + 1], t[i])); way != m_faces.end())
                    way->second = f;
            }
    }

    /// Returns the face, or noSlot if no loop runs from one corner to the other. Of several faces, it is the last.
    Slot at(Slot from, Slot to) const
    {
        const auto way = m_faces.find(key(from, to));
        return way != m_faces.end() ? way->second : noSlot;
    }

private:
    std::unordered_map<std::uint64_t, Slot> m_faces;
};

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
                    add(a, b);
    }

    bool has(Slot a, Slot b) const { return m_edges.contains(keyOf(a, b)); }
    /// Returns false if the edge is already there.
    bool add(Slot a, Slot b) { return m_edges.insert(keyOf(a, b)).second; }
    void remove(Slot a, Slot b) { m_edges.erase(keyOf(a, b)); }

private:
    static std::uint64_t keyOf(Slot a, Slot b) { return key(std::min(a, b), std::max(a, b)); }
    std::unordered_set<std::uint64_t> m_edges;
};

constexpr double parallel = 0.99; ///< cosine of the angle between the normals of faces in one plane

/// Finds faces that lie on the surface.
class CoverSearch
{
public:
    /// Keeps a reference.
    explicit CoverSearch(const TriangleSoup& surface) : m_surface(surface), m_tree(boxesOf(surface)) {}

    /// Returns whether the middle of a face lies on a face of the surface, within a hundredth of the new face's extent,
    /// and both are in one plane.
    bool covers(const Triangle& t) const
    {
        const auto [a, b, c] = cornersOf(m_surface, t);
        const Vec3 middle = (a + b + c) / 3, normal = (b - a).cross(c - a);
        const double slack = 0.01 * std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        FaceBox near;
        near.extend((middle.array() - slack).cast<float>());
        near.extend((middle.array() + slack).cast<float>());
        bool isCovered = false;
        m_tree.forEachMeeting(near, [&](Slot position) {
            const Triangle& face = m_surface.triangles[m_tree.at(position)];
            const Vec3 other = normalOf(m_surface, face);
            if (!isCovered && std::abs(normal.dot(other)) >= parallel * normal.norm() * other.norm())
                isCovered = (nearestInTriangle(middle, cornersOf(m_surface, face)) - middle).norm() <= slack;
        });
        return isCovered;
    }

private:
    static std::vector<FaceBox> boxesOf(const TriangleSoup& surface)
    {
        std::vector<FaceBox> boxes(surface.triangles.size());
        for (std::size_t f = 0; f < boxes.size(); ++f)
            for (const Slot v : surface.triangles[f])
                boxes[f].extend(surface.points[v].cast<float>().array());
        return boxes;
    }

    const TriangleSoup& m_surface;
    BoxTree m_tree;
};

/// The signed volumes between the faces of each component and the mean of their corners. Components share points.
class ComponentVolumes
{
public:
    /// Keeps a reference.
    explicit ComponentVolumes(const TriangleSoup& surface) : m_surface(surface), m_sets(surface.points.size())
    {
        for (const auto& [a, b, c] : surface.triangles) {
            m_sets.unite(a, b);
            m_sets.unite(b, c);
        }
        std::unordered_map<Slot, double> corners;
        for (const Triangle& t : surface.triangles)
            for (const Slot v : t) {
                m_components[m_sets.root(v)].middle += surface.points[v].cast<double>();
                ++corners[m_sets.root(v)];
            }
        for (auto& [root, component] : m_components)
            component.middle /= corners[root];
        for (const Triangle& t : surface.triangles) {
            Component& component = m_components[m_sets.root(t[0])];
            component.volume += volumeBelow({&t, 1}, component.middle);
        }
    }

    /// Returns the volume, without its sign, of the component of these faces' corners together with them.
    double with(std::span<const Triangle> faces)
    {
        const Component& component = m_components[m_sets.root(faces[0][0])];
        return std::abs(component.volume + volumeBelow(faces, component.middle));
    }

private:
    struct Component
    {
        Vec3 middle = Vec3::Zero();
        double volume = 0; ///< lattice units^3, times 6
    };

    double volumeBelow(std::span<const Triangle> faces, const Vec3& apex) const
    {
        double volume = 0;
        for (const Triangle& t : faces)
            volume += (m_surface.points[t[0]].cast<double>() - apex).dot(normalOf(m_surface, t));
        return volume;
    }

    const TriangleSoup& m_surface;
    DisjointSets m_sets;
    std::unordered_map<Slot, Component> m_components; ///< by the root of their points
};

/// A cost so large that a face is only taken where there is no other.
constexpr double farMore = 1e12 * Lattice::limit;

/// Weighs the faces over an opening that goes over edges of a model with flat sides: the missing sides are in planes of
/// the rim.
class FaceWeights
{
public:
    /// Keeps references.
    FaceWeights(const TriangleSoup& surface, const std::vector<Slot>& loop, const CoverSearch& search)
        : m_loop(loop)
        , m_search(search)
    {
        constexpr double flat = 5e-3;   // distance from a plane, as a share of the loop's extent
        constexpr std::size_t part = 4; // a plane has one in so many corners, and four or more
        constexpr std::size_t steps = 16;
        const std::size_t n = loop.size(), fewest = std::max<std::size_t>(4, n / part);
        const std::size_t step = std::max<std::size_t>(1, n / steps); // rims of scans are uneven
        const double slack = flat * extentOf(boxOf(surface, loop));
        const auto at = [&](std::size_t i) { return Vec3(surface.points[loop[i % n]].cast<double>()); };
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 normal = (at(i) - at(i + n - step)).cross(at(i + step) - at(i)).normalized();
            std::vector<bool> isIn(n);
            for (std::size_t k = 0; k < n; ++k)
                isIn[k] = std::abs(normal.dot(at(k) - at(i))) <= slack;
            if (!normal.isZero() && static_cast<std::size_t>(std::ranges::count(isIn, true)) >= fewest &&
                std::ranges::find(m_planes, isIn) == m_planes.end())
                m_planes.push_back(std::move(isIn));
        }
    }

    /// Returns whether the face between three corners of the loop, by their index, lies on the surface.
    bool isCovered(std::size_t i, std::size_t m, std::size_t k) const
    {
        return m_search.covers({m_loop[i], m_loop[m], m_loop[k]});
    }
    /// Returns the factor by which the area of such a face counts.
    double at(std::size_t i, std::size_t m, std::size_t k) const
    {
        constexpr double offPlanes = 2;
        const auto hasAll = [&](const std::vector<bool>& isIn) { return isIn[i] && isIn[m] && isIn[k]; };
        return std::ranges::any_of(m_planes, hasAll) ? 1 : offPlanes;
    }

private:
    const std::vector<Slot>& m_loop;
    const CoverSearch& m_search;
    std::vector<std::vector<bool>> m_planes; ///< for each plane of the rim, which corners are in it
};

class LoopFiller
{
public:
    /// Keeps references. `weights`: null for plain areas.
    LoopFiller(const TriangleSoup& surface, const EdgeSet& present, std::vector<Slot> loop,
               const FaceWeights* weights = nullptr)
        : m_surface(surface)
        , m_present(present)
        , m_weights(weights)
        , m_loop(std::move(loop))
    {}

    std::vector<Triangle> fill(std::size_t most = maxCorners)
    {
        cutCorners(most);
        if (m_loop.size() >= 3)
            fillWithLeastArea();
        return std::move(m_faces);
    }
    /// Returns whether no face is degenerate or covered by the surface, and no edge was there before.
    bool isClean() const { return m_cost < farMore; }

private:
    Vec3 at(Slot v) const { return m_surface.points[v].cast<double>(); }

    /// Returns twice the weighted area of a face between corners of the loop, by their index, or a huge cost if the
    /// face would be degenerate or covered by the surface: the normal is exact.
    double cost(std::size_t i, std::size_t m, std::size_t k) const
    {
        const Vec3 a = at(m_loop[i]);
        const double area = (at(m_loop[m]) - a).cross(at(m_loop[k]) - a).norm();
        if (area == 0 || (m_weights && m_weights->isCovered(i, m, k)))
            return farMore;
        return m_weights ? area * m_weights->at(i, m, k) : area;
    }
    /// Returns a huge cost if the edge between two corners of the loop exists already, as it would then have four
    /// faces; otherwise 0.
    double costOfChord(std::size_t i, std::size_t k) const
    {
        const bool isBorder = k == i + 1 || (i == 0 && k + 1 == m_loop.size());
        return !isBorder && m_present.has(m_loop[i], m_loop[k]) ? farMore : 0;
    }

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
                    const double sum = minCost[i * n + m] + minCost[m * n + k] + chord + cost(i, m, k);
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
    const FaceWeights* m_weights;
    std::vector<Slot> m_loop;
    std::vector<Triangle> m_faces;
    double m_cost = 0;
};

/// Fills loops as Covering::Avoided says.
class OpeningFiller
{
public:
    /// Keeps references.
    OpeningFiller(const TriangleSoup& surface, const EdgeSet& present, const RimFaces& rim)
        : m_surface(surface)
        , m_present(present)
        , m_rim(rim)
    {}

    /// Where an opening goes over an edge of the model, the least area cuts that edge off, with faces that lie on the
    /// surface. On a sheet most faces do, and the least area is kept.
    std::vector<Triangle> fill(const std::vector<Slot>& loop)
    {
        std::vector<Triangle> faces = LoopFiller(m_surface, m_present, loop).fill();
        if (loop.size() > maxCorners || !isFoldedBack(faces))
            return faces;
        if (!m_search) {
            m_search.emplace(m_surface);
            m_volumes.emplace(m_surface);
        }
        std::vector<Triangle> covered;
        std::ranges::copy_if(faces, std::back_inserter(covered),
                             [&](const Triangle& t) { return m_search->covers(t); });
        if (2 * doubleAreaOf(m_surface, covered) > doubleAreaOf(m_surface, faces))
            return faces;
        const FaceWeights weights(m_surface, loop, *m_search);
        LoopFiller beside(m_surface, m_present, loop, &weights);
        std::vector<Triangle> others = beside.fill();
        return beside.isClean() && m_volumes->with(others) > m_volumes->with(faces) ? others : faces;
    }

private:
    /// Returns whether one of the faces lies on the face beyond the loop: their normals are opposite.
    bool isFoldedBack(std::span<const Triangle> faces) const
    {
        return std::ranges::any_of(faces, [&](const Triangle& t) {
            const Vec3 normal = normalOf(m_surface, t);
            for (std::size_t i = 0; i < 3; ++i)
                if (const Slot beyond = m_rim.at(t[i], t[i == 2 ? 0 : i + 1]); beyond != noSlot) {
                    const Vec3 other = normalOf(m_surface, m_surface.triangles[beyond]);
                    if (normal.dot(other) <= -parallel * normal.norm() * other.norm())
                        return true;
                }
            return false;
        });
    }

    const TriangleSoup& m_surface;
    const EdgeSet& m_present;
    const RimFaces& m_rim;
    std::optional<CoverSearch> m_search; ///< made when it is first needed, as are the volumes
    std::optional<ComponentVolumes> m_volumes;
};

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
    LoopJoiner(const TriangleSoup& surface, EdgeSet& present, const RimFaces& rim)
        : m_surface(surface)
        , m_present(present)
        , m_rim(rim)
    {}

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
        std::vector<Patch*> rims;
        for (Patch& patch : patches) {
            double whole = 0, weighted = 0; // length of the border, and of it times the cosine
            for (std::size_t i = 0; i < patch.loop.size(); ++i) {
                const Slot from = patch.loop[i], to = patch.loop[(i + 1) % patch.loop.size()];
                const double length = (m_surface.points[to] - m_surface.points[from]).cast<double>().norm();
                const Vec3 normal = normalOf(m_surface, m_surface.triangles[m_rim.at(from, to)]);
                whole += length;
                weighted += length * std::abs(patch.normal.dot(normal.normalized()));
            }
            if (weighted < steep * whole)
                rims.push_back(&patch);
        }
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
            return (nearestInTriangle(p, cornersOf(m_surface, t)) - p).norm() <= slack;
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
    const RimFaces& m_rim;
};
} // namespace

HoleFillingResult fillHoles(TriangleSoup& surface, bool largeToo, Covering covering, const JobControl& control)
{
    HoleFillingResult filled;
    if (surface.triangles.empty())
        return filled;
    const double extent = extentOf(surface.box());
    std::vector<std::vector<Slot>> loops = loopsOf(openWays(surface), surface.points.size());
    EdgeSet present(surface, loops);
    const RimFaces rim(surface, loops);
    const double area = doubleAreaOf(surface, surface.triangles);
    OpeningFiller filler(surface, present, rim);
    std::vector<Patch> patches;
    double largest = 0;
    for (std::vector<Slot>& loop : loops) {
        if (control.isCancelled())
            break;
        const LatticeBox box = boxOf(surface, loop);
        if (extentOf(box) > largest) {
            largest = extentOf(box);
            filled.largest = (box.min + box.max).cast<double>() / 2;
        }
        const bool isLarge = extentOf(box) > largeHole * extent;
        filled.largeHoles += isLarge;
        if (isLarge && !largeToo)
            continue;
        filled.holes += 1;
        std::vector<Triangle> faces =
            covering == Covering::Allowed ? LoopFiller(surface, present, loop).fill() : filler.fill(loop);
        patches.push_back(patchOver(surface, std::move(loop), std::move(faces)));
    }
    LoopJoiner(surface, present, rim).run(patches, control);
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
