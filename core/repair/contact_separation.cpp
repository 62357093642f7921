// 1. halve   each edge of four or more faces gets a vertex in its middle, so that every half has an end of its own
// 2. pair    faces at such an edge that have solid between them, by their exact order around it
// 3. split   each vertex into one copy for each fan of faces that are joined around it
// 4. part    the copies of each vertex: they move into their own cones, until an exact check of the neighbourhood
//            finds no intersection

#include "core/repair/contact_separation.h"

#include "core/repair/edge_faces.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/triangle_intersection.h"
#include "core/util/disjoint_sets.h"
#include "core/util/parallel.h"

#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace core::repair
{
namespace
{
/// Halves each edge of more than two faces. Edges too short to have a lattice point between their ends stay whole;
/// their ends are appended to `shortest`. Returns the number of halved edges.
std::size_t halveEdges(TriangleSoup& surface, std::vector<Slot>& shortest)
{
    std::vector<std::pair<std::pair<Slot, Slot>, Slot>> halved;
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        if (around.size() <= 2)
            return;
        const Slot low = around[0].low, high = around[0].high;
        if ((surface.points[high] - surface.points[low]).cwiseAbs().maxCoeff() > 1)
            halved.push_back({{low, high}, noSlot});
        else
            shortest.insert(shortest.end(), {low, high});
    });
    for (auto& [ends, middle] : halved) {
        const auto [a, b] = ends;
        const LatticePoint between = surface.points[a] + (surface.points[b] - surface.points[a]) / 2;
        middle = surface.addPoint(between, a, b);
    }
    const auto middleOf = [&](Slot a, Slot b) {
        const std::pair<Slot, Slot> ends = std::minmax(a, b);
        const auto found = std::ranges::lower_bound(halved, ends, {}, [](const auto& h) { return h.first; });
        return found != halved.end() && found->first == ends ? found->second : noSlot;
    };
    std::vector<Triangle> open;
    std::vector<Triangle> result;
    for (const Triangle& face : surface.triangles) {
        open.assign(1, face);
        while (!open.empty()) {
            const Triangle t = open.back();
            open.pop_back();
            std::size_t i = 0;
            Slot middle = noSlot;
            for (; i < 3 && middle == noSlot; ++i)
                middle = middleOf(t[i], t[(i + 1) % 3]);
            if (middle == noSlot) {
                result.push_back(t);
                continue;
            }
            --i;
            open.push_back({t[i], middle, t[(i + 2) % 3]});
            open.push_back({middle, t[(i + 1) % 3], t[(i + 2) % 3]});
        }
    }
    surface.triangles = std::move(result);
    return halved.size();
}

/// Orders faces around an edge: counter-clockwise as seen from its high end, beginning with the first face. Exact.
class Around
{
public:
    Around(const TriangleSoup& surface, const EdgeFace& first) : m_surface(surface), m_first(first) {}

    bool operator()(const EdgeFace& a, const EdgeFace& b) const
    {
        const int halfOfA = half(a), halfOfB = half(b);
        if (halfOfA != halfOfB)
            return halfOfA < halfOfB;
        return turn(apex(a), apex(b)) > 0;
    }

private:
    const LatticePoint& apex(const EdgeFace& e) const { return m_surface.points[e.apex(m_surface.triangles[e.face])]; }
    /// Returns the sign of the turn from a to b around the edge.
    int turn(const LatticePoint& a, const LatticePoint& b) const
    {
        return LatticePredicates::orient3d(m_surface.points[m_first.low], m_surface.points[m_first.high], a, b);
    }
    /// Returns 0 for the first face, and for others by the angle from it: 1 for less than half a turn, 2 for half a
    /// turn, 3 for more.
    int half(const EdgeFace& e) const
    {
        if (e.face == m_first.face)
            return 0;
        const int side = turn(apex(m_first), apex(e));
        return side > 0 ? 1 : side == 0 ? 2 : 3;
    }

    const TriangleSoup& m_surface;
    EdgeFace m_first;
};

/// Sets of face corners (3 x face + corner) that will share one vertex.
class Fans
{
public:
    explicit Fans(const TriangleSoup& surface) : m_surface(surface), m_sets(3 * surface.triangles.size())
    {
        forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
            if (around.size() == 2)
                join(around[0], around[1]);
            else if (around.size() > 2)
                pair({around.begin(), around.end()});
        });
    }

    Slot root(Slot corner) { return m_sets.root(corner); }

private:
    /// Joins neighbouring faces around an edge that have solid between them. A face that runs along the edge from low
    /// to high has the solid on one side of it, as seen along the edge; a face of the other direction has it on the
    /// other side.
    void pair(std::vector<EdgeFace> around)
    {
        std::sort(around.begin(), around.end(), Around(m_surface, around[0]));
        const std::size_t n = around.size();
        for (std::size_t i = 0; i < n; ++i) {
            const EdgeFace &face = around[i], &next = around[(i + 1) % n];
            if (!face.forward && next.forward)
                join(face, next);
        }
    }

    void join(const EdgeFace& a, const EdgeFace& b)
    {
        for (const Slot v : {a.low, a.high})
            m_sets.unite(cornerAt(a.face, v), cornerAt(b.face, v));
    }
    Slot cornerAt(Slot face, Slot v) const
    {
        const Triangle& t = m_surface.triangles[face];
        return 3 * face + (t[0] == v ? 0 : t[1] == v ? 1 : 2);
    }

    const TriangleSoup& m_surface;
    DisjointSets m_sets;
};

/// Indices of the copies of one vertex.
using Copies = std::vector<Slot>;

std::vector<Copies> splitVertices(TriangleSoup& surface)
{
    Fans fans(surface);
    std::map<Slot, std::vector<Slot>> fansOf; // for each vertex, the roots of its fans, except the first fan
    std::vector<Slot> firstFan(surface.points.size(), noSlot);
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        for (Slot i = 0; i < 3; ++i) {
            const Slot v = surface.triangles[f][i], fan = fans.root(3 * f + i);
            if (firstFan[v] == noSlot)
                firstFan[v] = fan;
            else if (firstFan[v] != fan)
                fansOf[v].push_back(fan);
        }
    }
    std::map<Slot, Slot> vertexOfFan;
    std::vector<Copies> split;
    for (auto& [v, others] : fansOf) {
        std::ranges::sort(others);
        others.erase(std::ranges::unique(others).begin(), others.end());
        split.push_back({v});
        for (const Slot fan : others)
            split.back().push_back(vertexOfFan[fan] = surface.addPoint(LatticePoint(surface.points[v]), v, v));
    }
    for (Slot f = 0; f < surface.triangles.size() && !split.empty(); ++f) {
        for (Slot i = 0; i < 3; ++i) {
            const auto found = vertexOfFan.find(fans.root(3 * f + i));
            if (found != vertexOfFan.end())
                surface.triangles[f][i] = found->second;
        }
    }
    return split;
}

/// Returns a unit vector with a positive component along all of these unit vectors, found with the perceptron rule;
/// nothing if none is found.
std::optional<Vec3> directionAlong(const std::vector<Vec3>& vectors, Vec3 start)
{
    constexpr int steps = 1000;
    constexpr double clearly = 1e-3; // least sine of the angle between the result and each face
    for (int i = 0; i < steps; ++i) {
        const double length = start.norm();
        const auto worst = std::ranges::min_element(vectors, {}, [&](const Vec3& v) { return v.dot(start); });
        if (length > 0 && worst->dot(start) > clearly * length)
            return Vec3(start / length);
        start += *worst;
    }
    return std::nullopt;
}

/// The faces around one copy of a vertex.
struct Fan
{
    std::vector<Vec3> inwards;  ///< reversed normals of the faces
    Vec3 middle = Vec3::Zero(); ///< sum of the unit vectors along the faces' edges
    double shortestEdge = std::numeric_limits<double>::infinity();
};

/// Returns a unit vector into the cone that the fan forms, whether it encloses solid or empty space. It never points
/// out of the cone, where other fans may be. Returns zero if the fan is no cone all of whose faces are visible from
/// inside.
Vec3 wayInto(const Fan& fan)
{
    for (const double side : {1.0, -1.0}) {
        std::vector<Vec3> ways;
        for (const Vec3& inwards : fan.inwards)
            ways.push_back(side * inwards);
        const std::optional<Vec3> way = directionAlong(ways, fan.middle);
        if (way && way->dot(fan.middle) > 0)
            return *way;
    }
    return Vec3::Zero();
}

/// Finds the faces near moved faces, of a surface whose points stay near their first places.
class Vicinity
{
public:
    /// `reach`: for each point, how far it may move along each axis, lattice units.
    Vicinity(const TriangleSoup& surface, std::span<const float> reach)
        : m_surface(surface)
        , m_begins(surface.points.size() + 1, 0)
        , m_faces(3 * surface.triangles.size())
        , m_boxes(faceBoxes(surface.points, std::span<const Triangle>(surface.triangles)))
        , m_tree(roomsOf(surface, reach))
    {
        for (const Triangle& t : surface.triangles)
            for (const Slot v : t)
                ++m_begins[v];
        std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
        for (Slot f = 0; f < surface.triangles.size(); ++f)
            for (const Slot v : surface.triangles[f])
                m_faces[--m_begins[v]] = f;
    }

    /// Returns the faces with one of these corners, which have moved, each once.
    std::vector<Slot> update(std::span<const Slot> moved)
    {
        std::vector<Slot> faces;
        for (const Slot v : moved)
            faces.insert(faces.end(), m_faces.begin() + m_begins[v], m_faces.begin() + m_begins[v + 1]);
        std::ranges::sort(faces);
        faces.erase(std::ranges::unique(faces).begin(), faces.end());
        for (const Slot f : faces)
            m_boxes[f] = boxOf(f);
        return faces;
    }

    /// Calls visit(other) for each face whose box meets that of the face, and for the face itself.
    template <typename Visit> void forEachNear(Slot face, Visit visit) const
    {
        constexpr float margin = 1;
        FaceBox box = m_boxes[face];
        box.min -= margin;
        box.max += margin;
        m_tree.forEachMeeting(box, [&](Slot position) {
            if (const Slot other = m_tree.at(position); m_boxes[other].meets(box))
                visit(other);
        });
    }

private:
    /// Returns the boxes that the faces never leave.
    static std::vector<FaceBox> roomsOf(const TriangleSoup& surface, std::span<const float> reach)
    {
        std::vector<FaceBox> rooms(surface.triangles.size());
        for (Slot f = 0; f < rooms.size(); ++f)
            for (const Slot v : surface.triangles[f]) {
                const Eigen::Array3f p = surface.points[v].array().cast<float>();
                rooms[f].extend(p - reach[v]);
                rooms[f].extend(p + reach[v]);
            }
        return rooms;
    }

    FaceBox boxOf(Slot face) const
    {
        FaceBox box;
        for (const Slot v : m_surface.triangles[face])
            box.extend(m_surface.points[v].array().cast<float>());
        return box;
    }

    const TriangleSoup& m_surface;
    std::vector<Slot> m_begins, m_faces; ///< the faces at each point, and where they begin
    std::vector<FaceBox> m_boxes;        ///< of the faces as they are
    BoxTree m_tree;                      ///< boxes that they never leave
};

/// Moves the copies of each vertex apart.
class Parting
{
public:
    Parting(TriangleSoup& surface, const std::vector<Copies>& split) : m_surface(surface), m_start(surface.points)
    {
        m_groupOf.assign(surface.points.size(), noSlot);
        for (Slot g = 0; g < split.size(); ++g) {
            m_groups.push_back({split[g], std::vector<Fan>(split[g].size()), {}});
            for (const Slot v : split[g])
                m_groupOf[v] = g;
        }
        for (const Triangle& t : surface.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                if (m_groupOf[t[i]] != noSlot)
                    addFace(m_groups[m_groupOf[t[i]]], t, i);
        for (Group& group : m_groups)
            for (const Fan& fan : group.fans)
                group.ways.push_back(wayInto(fan));
    }

    /// Moves all groups of copies; groups that no distance separates return to their start.
    void run(const JobControl& control)
    {
        Vicinity vicinity(m_surface, reaches());
        std::vector<Slot> moved;
        for (const Group& group : m_groups)
            move(group, moved);
        while (!control.isCancelled() && !moved.empty())
            moved = moveOtherwise(unsoundCorners(moved, vicinity, control.stop));
    }

    /// Returns the copies that could not be separated.
    std::vector<Slot> stuck() const
    {
        std::vector<Slot> points;
        for (const Group& group : m_groups)
            if (group.choice == distances.size())
                points.insert(points.end(), group.copies.begin(), group.copies.end());
        return points;
    }

private:
    struct Group
    {
        Copies copies;
        std::vector<Fan> fans;  ///< fan of each copy
        std::vector<Vec3> ways; ///< direction in which each copy moves
        std::size_t choice = 0; ///< index into `distances`
    };

    /// Distances by which copies are moved, lattice units, in the order in which they are tried.
    static constexpr std::array<double, 7> distances{16, 64, 4, 256, 1, 1024, 4096};

    void addFace(Group& group, const Triangle& t, std::size_t corner)
    {
        const auto at = [&](std::size_t k) { return Vec3(m_start[t[k % 3]].cast<double>()); };
        const Vec3 u = at(corner + 1) - at(corner), w = at(corner + 2) - at(corner);
        const auto copy = static_cast<std::size_t>(std::ranges::find(group.copies, t[corner]) - group.copies.begin());
        Fan& fan = group.fans[copy];
        fan.inwards.push_back(-u.cross(w).normalized());
        fan.middle += u.normalized() + w.normalized();
        fan.shortestEdge = std::min({fan.shortestEdge, u.norm(), w.norm()});
    }

    /// Returns how far a copy with this fan may move, lattice units.
    static double longestStep(const Fan& fan) { return std::max(1.0, fan.shortestEdge / 4); }

    /// Returns how far each point may move along each axis, lattice units.
    std::vector<float> reaches() const
    {
        constexpr double rounding = 1;
        std::vector<float> reach(m_surface.points.size(), 0);
        for (const Group& group : m_groups)
            for (std::size_t i = 0; i < group.copies.size(); ++i)
                reach[group.copies[i]] =
                    static_cast<float>(rounding + std::min(std::ranges::max(distances), longestStep(group.fans[i])));
        return reach;
    }

    /// Moves the copies of a group by its chosen distance, and appends the copies to `moved`.
    void move(const Group& group, std::vector<Slot>& moved)
    {
        for (std::size_t i = 0; i < group.copies.size(); ++i) {
            const double wanted = group.choice < distances.size() ? distances[group.choice] : 0;
            const double step = std::min(wanted, longestStep(group.fans[i]));
            const LatticePoint by = (step * group.ways[i]).array().round().cast<int>();
            m_surface.points[group.copies[i]] = m_start[group.copies[i]] + by;
        }
        moved.insert(moved.end(), group.copies.begin(), group.copies.end());
    }

    /// Returns the corners of faces that are degenerate or meet other faces. Tests the faces with moved corners against
    /// all faces near them.
    std::vector<Slot> unsoundCorners(std::span<const Slot> moved, Vicinity& vicinity, const std::stop_token& stop) const
    {
        constexpr std::size_t facesPerChunk = 1 << 6;
        const std::vector<Slot> faces = vicinity.update(moved);
        std::vector<bool> hasMoved(m_surface.triangles.size(), false);
        for (const Slot f : faces)
            hasMoved[f] = true;
        std::vector<std::atomic<bool>> isUnsound(m_surface.triangles.size());
        forEachChunk(faces.size(), facesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) {
                const Slot face = faces[i];
                const auto triangle = triangleOf(face);
                const bool isSolid = !isDegenerate(triangle);
                vicinity.forEachNear(face, [&](Slot other) {
                    if (isUnsound[face] && isUnsound[other])
                        return;
                    const auto near = triangleOf(other);
                    if (isDegenerate(near))
                        isUnsound[other] = true;
                    else if (isSolid && (face < other || !hasMoved[other]) && trianglesIntersect(triangle, near))
                        isUnsound[face] = isUnsound[other] = true;
                });
            }
        });
        std::vector<Slot> corners;
        for (Slot f = 0; f < isUnsound.size(); ++f)
            if (isUnsound[f])
                corners.insert(corners.end(), m_surface.triangles[f].begin(), m_surface.triangles[f].end());
        return corners;
    }

    CornerTriangle<LatticePredicates> triangleOf(Slot face) const
    {
        const Triangle& t = m_surface.triangles[face];
        return {t, {m_surface.points[t[0]], m_surface.points[t[1]], m_surface.points[t[2]]}};
    }

    static bool isDegenerate(const CornerTriangle<LatticePredicates>& triangle)
    {
        const auto& [a, b, c] = triangle.points;
        return LatticePredicates::collinear(a, b, c);
    }

    /// Moves the groups at these corners by their next distance, if they have one left. Returns the copies that moved.
    std::vector<Slot> moveOtherwise(const std::vector<Slot>& corners)
    {
        std::set<Slot> groups;
        for (const Slot v : corners)
            if (m_groupOf[v] != noSlot && m_groups[m_groupOf[v]].choice < distances.size())
                groups.insert(m_groupOf[v]);
        std::vector<Slot> moved;
        for (const Slot g : groups) {
            ++m_groups[g].choice;
            move(m_groups[g], moved);
        }
        return moved;
    }

    TriangleSoup& m_surface;
    std::vector<LatticePoint> m_start;
    std::vector<Slot> m_groupOf; ///< group of each vertex; noSlot for most
    std::vector<Group> m_groups;
};

} // namespace

SeparationResult separateContacts(TriangleSoup& surface, const JobControl& control)
{
    SeparationResult separated;
    std::vector<Slot> shortest;
    separated.edges = halveEdges(surface, shortest);
    const std::vector<Copies> split = splitVertices(surface);
    // The midpoints of halved edges do not count
    separated.vertices = split.size() - std::min(split.size(), separated.edges);
    Parting parting(surface, split);
    parting.run(control);
    separated.stuck = parting.stuck();
    separated.stuck.insert(separated.stuck.end(), shortest.begin(), shortest.end());
    return separated;
}
} // namespace core::repair
