// 1. join    open vertices near each other: the first of them keeps its position
// 2. split   open edges at the open vertices near them

#include "core/repair/crack_stitching.h"

#include "core/repair/edge_faces.h"

#include "core/geometry/box_tree.h"
#include "core/geometry/proximity_grid.h"
#include "core/util/disjoint_sets.h"

#include <cmath>
#include <unordered_map>

namespace core::repair
{
namespace
{
// 0.02 mm for a model of 100 mm: enough for files with few digits or with incomplete welding
constexpr double nearInSizes = 1.0 / 5000;
constexpr double nearInEdges = 1.0 / 4;

/// The open edges, which have one face, and their ends.
class Rim
{
public:
    explicit Rim(const TriangleSoup& surface) : m_surface(surface)
    {
        forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
            if (around.size() == 1)
                edges.push_back(around[0]);
        });
        for (const EdgeFace& e : edges) {
            vertices.push_back(e.low);
            vertices.push_back(e.high);
        }
        std::ranges::sort(vertices);
        vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
        measureReach();
    }

    Vec3 at(Slot v) const { return m_surface.points[v].cast<double>(); }
    /// Returns the distance from the vertex, in lattice units, within which another vertex is near.
    double reach(Slot v) const { return m_reach[v]; }
    double farthestReach() const { return m_farthestReach; }

    std::vector<EdgeFace> edges;
    std::vector<Slot> vertices; ///< open vertices, ascending

private:
    void measureReach()
    {
        m_reach.assign(m_surface.points.size(), 0);
        if (vertices.empty())
            return;
        const LatticeBox box = m_surface.box();
        for (const Slot v : vertices)
            m_reach[v] = nearInSizes * (box.max - box.min).maxCoeff();
        for (const Triangle& t : m_surface.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Slot a = t[i], b = t[i == 2 ? 0 : i + 1];
                if (m_reach[a] == 0 && m_reach[b] == 0)
                    continue;
                const double near = nearInEdges * (at(b) - at(a)).norm();
                m_reach[a] = std::min(m_reach[a], near);
                m_reach[b] = std::min(m_reach[b], near);
            }
        }
        for (const Slot v : vertices)
            m_farthestReach = std::max(m_farthestReach, m_reach[v]);
    }

    const TriangleSoup& m_surface;
    std::vector<double> m_reach; ///< for each vertex; 0 if it is not open
    double m_farthestReach = 0;
};

/// Merges open vertices, nearest pairs first. No vertex moves farther than its reach.
class Clusters
{
public:
    explicit Clusters(const Rim& rim) : m_rim(rim), m_sets(rim.vertices.size()), m_members(rim.vertices.size())
    {
        std::vector<Vec3> places;
        for (const Slot v : rim.vertices)
            places.push_back(rim.at(v));
        for (Slot i = 0; i < m_members.size(); ++i)
            m_members[i] = {i};
        for (const auto& [distance, i, j] : nearPairs(places))
            unite(i, j);
    }

    /// Calls visit(vertex, target) for each vertex that moves to the position of another one.
    template <typename Visit> void forEachMove(Visit visit)
    {
        for (Slot i = 0; i < m_rim.vertices.size(); ++i)
            if (const Slot to = m_sets.root(i); to != i)
                visit(m_rim.vertices[i], m_rim.vertices[to]);
    }

private:
    using Pair = std::tuple<double, Slot, Slot>; ///< distance, and two indices into Rim::vertices

    std::vector<Pair> nearPairs(const std::vector<Vec3>& places) const
    {
        const ProximityGrid grid(places, m_rim.farthestReach());
        std::vector<Pair> pairs;
        for (Slot i = 0; i < places.size(); ++i) {
            grid.forEachNear(places[i], [&](Slot j) {
                const double distance = (places[i] - places[j]).norm();
                if (i < j && distance <= reachOf(i) && distance <= reachOf(j))
                    pairs.emplace_back(distance, i, j);
            });
        }
        std::ranges::sort(pairs);
        return pairs;
    }

    double reachOf(Slot i) const { return m_rim.reach(m_rim.vertices[i]); }

    void unite(Slot i, Slot j)
    {
        const auto [to, from] = std::minmax({m_sets.root(i), m_sets.root(j)});
        if (to == from)
            return;
        const Vec3 place = m_rim.at(m_rim.vertices[to]);
        const bool allReachIt = std::ranges::all_of(m_members[from], [&](Slot member) {
            return (m_rim.at(m_rim.vertices[member]) - place).norm() <= reachOf(member);
        });
        if (!allReachIt)
            return;
        m_sets.unite(to, from);
        m_members[to].insert(m_members[to].end(), m_members[from].begin(), m_members[from].end());
        m_members[from].clear();
    }

    const Rim& m_rim;
    DisjointSets m_sets;                      ///< sets of indices into Rim::vertices
    std::vector<std::vector<Slot>> m_members; ///< members of each set, at its root
};

void joinVertices(TriangleSoup& surface, StitchResult& joined)
{
    const Rim rim(surface);
    if (rim.farthestReach() == 0)
        return;
    std::vector<Slot> becomes(surface.points.size());
    std::iota(becomes.begin(), becomes.end(), Slot(0));
    Clusters(rim).forEachMove([&](Slot v, Slot to) {
        becomes[v] = to;
        ++joined.vertices;
        joined.farthest = std::max(joined.farthest, (rim.at(v) - rim.at(to)).norm());
    });
    for (Triangle& t : surface.triangles)
        for (Slot& v : t)
            v = becomes[v];
}

/// The points at which open edges are split. Edges are identified by their ends, in the direction in which the face
/// runs along them.
class Splits
{
public:
    Splits(const TriangleSoup& surface, StitchResult& joined) : m_surface(surface), m_rim(surface)
    {
        if (m_rim.farthestReach() == 0)
            return;
        findPoints();
        while (dropLoose()) {
        }
        std::vector<Slot> vertices;
        for (const auto& [ends, points] : m_points) {
            for (const Point& point : points) {
                vertices.push_back(point.vertex);
                joined.farthest = std::max(joined.farthest, point.distance);
            }
        }
        std::ranges::sort(vertices);
        joined.vertices += vertices.size() - std::ranges::unique(vertices).size();
    }

    bool isEmpty() const { return m_points.empty(); }

    /// Appends to `result` the face, divided into a fan of triangles at each of its split edges.
    void cut(const Triangle& face, std::vector<Triangle>& result) const
    {
        std::vector<Part> open{{face, {true, true, true}}};
        while (!open.empty()) {
            const auto [t, isWhole] = open.back();
            open.pop_back();
            std::size_t i = 0;
            while (i < 3 && !(isWhole[i] && m_points.contains(key(t[i], t[(i + 1) % 3]))))
                ++i;
            if (i == 3) {
                result.push_back(t);
                continue;
            }
            const Slot to = t[(i + 1) % 3], apex = t[(i + 2) % 3];
            Slot from = t[i];
            bool isFirst = true;
            for (const auto& [share, v, distance] : m_points.at(key(from, to))) {
                open.push_back({{from, v, apex}, {false, false, isFirst && isWhole[(i + 2) % 3]}});
                from = v;
                isFirst = false;
            }
            open.push_back({{from, to, apex}, {false, isWhole[(i + 1) % 3], false}});
        }
    }

private:
    struct Part
    {
        Triangle corners;
        std::array<bool, 3> isWhole; ///< the side from corner i to the next corner is a whole edge of the original face
    };
    /// A vertex at which an edge is split.
    struct Point
    {
        double share; ///< position along the edge, 0 at its start, 1 at its end
        Slot vertex;
        double distance; ///< distance of the vertex from the edge, lattice units
        friend auto operator<=>(const Point&, const Point&) = default;
    };

    static std::uint64_t key(Slot from, Slot to) { return std::uint64_t(from) << 32 | to; }

    std::vector<FaceBox> boxesOfEdges() const
    {
        std::vector<FaceBox> boxes(m_rim.edges.size());
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (const Slot end : {m_rim.edges[i].low, m_rim.edges[i].high})
                boxes[i].extend(m_surface.points[end].array().cast<float>());
        return boxes;
    }

    void findPoints()
    {
        const BoxTree tree(boxesOfEdges());
        for (const Slot v : m_rim.vertices) {
            const LatticePoint reach = LatticePoint::Constant(static_cast<int>(std::ceil(m_rim.reach(v))));
            FaceBox around;
            around.extend((m_surface.points[v] - reach).array().cast<float>());
            around.extend((m_surface.points[v] + reach).array().cast<float>());
            tree.forEachMeeting(around, [&](Slot position) { add(v, m_rim.edges[tree.at(position)]); });
        }
        for (auto& [ends, points] : m_points)
            std::ranges::sort(points);
    }

    static std::pair<Slot, Slot> endsOf(const EdgeFace& edge)
    {
        return edge.forward ? std::pair(edge.low, edge.high) : std::pair(edge.high, edge.low);
    }

    void add(Slot v, const EdgeFace& edge)
    {
        const Slot apex = edge.apex(m_surface.triangles[edge.face]);
        if (v == edge.low || v == edge.high || v == apex)
            return;
        const auto [from, to] = endsOf(edge);
        const Vec3 along = m_rim.at(to) - m_rim.at(from), way = m_rim.at(v) - m_rim.at(from);
        const double length = along.norm(), share = way.dot(along) / along.squaredNorm();
        const double distance = way.cross(along).norm() / length;
        const double height = (m_rim.at(apex) - m_rim.at(from)).cross(along).norm() / length;
        if (share > 0 && share < 1 && distance <= m_rim.reach(v) && distance <= nearInEdges * height)
            m_points[key(from, to)].push_back({share, v, distance});
    }

    /// Calls visit(end, other end) for each part of the edge.
    template <typename Visit> void forEachPart(const EdgeFace& edge, Visit visit) const
    {
        auto [from, to] = endsOf(edge);
        if (const auto found = m_points.find(key(from, to)); found != m_points.end()) {
            for (const Point& point : found->second) {
                visit(from, point.vertex);
                from = point.vertex;
            }
        }
        visit(from, to);
    }

    /// Drops the splits of edges of which some part does not run along another edge: vertices near such an edge are no
    /// crack. Returns whether any was dropped.
    bool dropLoose()
    {
        std::unordered_map<std::uint64_t, int> times;
        for (const EdgeFace& edge : m_rim.edges)
            forEachPart(edge, [&](Slot a, Slot b) { ++times[key(std::min(a, b), std::max(a, b))]; });
        std::vector<std::uint64_t> loose;
        for (const EdgeFace& edge : m_rim.edges) {
            bool isLoose = false;
            forEachPart(edge,
                        [&](Slot a, Slot b) { isLoose = isLoose || times[key(std::min(a, b), std::max(a, b))] < 2; });
            const auto [from, to] = endsOf(edge);
            if (isLoose && m_points.contains(key(from, to)))
                loose.push_back(key(from, to));
        }
        for (const std::uint64_t edge : loose)
            m_points.erase(edge);
        return !loose.empty();
    }

    const TriangleSoup& m_surface;
    Rim m_rim;
    std::unordered_map<std::uint64_t, std::vector<Point>> m_points;
};

void splitEdges(TriangleSoup& surface, StitchResult& joined)
{
    const Splits splits(surface, joined);
    if (splits.isEmpty())
        return;
    std::vector<Triangle> result;
    result.reserve(surface.triangles.size());
    for (const Triangle& face : surface.triangles)
        splits.cut(face, result);
    surface.triangles = std::move(result);
}
} // namespace

StitchResult stitchCracks(TriangleSoup& surface)
{
    StitchResult joined;
    joinVertices(surface, joined);
    splitEdges(surface, joined);
    return joined;
}
} // namespace core::repair
