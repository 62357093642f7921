#include "core/repair/orientation.h"

#include "core/repair/edge_faces.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/winding_number.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace core::repair
{
namespace
{
/// The parts of a surface that hang together by edges of two.
struct Parts
{
    std::vector<std::vector<Slot>> faces;
    std::vector<Slot> ofFace;
};

void turn(Triangle& t)
{
    std::swap(t[1], t[2]);
}

/// Runs through each part and turns what runs against where it began, or the others if those are fewer.
class Flood
{
public:
    explicit Flood(TriangleSoup& surface) : m_triangles(surface.triangles), m_across(3 * m_triangles.size(), noSlot)
    {
        forEachEdge(m_triangles, [&](std::span<const EdgeFace> around) {
            if (around.size() != 2)
                return;
            const bool agree = around[0].forward != around[1].forward;
            connect(around[0].face, around[1].face, agree);
            connect(around[1].face, around[0].face, agree);
        });
    }

    Parts run(std::size_t& turned)
    {
        Parts parts;
        parts.ofFace.assign(m_triangles.size(), noSlot);
        std::vector<bool> isAgainst(m_triangles.size(), false);
        for (Slot seed = 0; seed < m_triangles.size(); ++seed) {
            if (parts.ofFace[seed] != noSlot)
                continue;
            const auto part = static_cast<Slot>(parts.faces.size());
            std::vector<Slot> faces{seed};
            parts.ofFace[seed] = part;
            std::size_t against = 0;
            for (std::size_t i = 0; i < faces.size(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const Slot link = m_across[3 * faces[i] + k];
                    if (link == noSlot || parts.ofFace[link / 2] != noSlot)
                        continue;
                    const Slot next = link / 2;
                    parts.ofFace[next] = part;
                    isAgainst[next] = isAgainst[faces[i]] == (link % 2 == 1);
                    against += isAgainst[next];
                    faces.push_back(next);
                }
            }
            const bool fewerAgainst = 2 * against <= faces.size();
            for (const Slot f : faces) {
                if (isAgainst[f] == fewerAgainst) {
                    turn(m_triangles[f]);
                    ++turned;
                }
            }
            parts.faces.push_back(std::move(faces));
        }
        return parts;
    }

private:
    /// Kept as 2 x face + whether they agree.
    void connect(Slot from, Slot to, bool agree)
    {
        Slot* link = &m_across[3 * from];
        while (*link != noSlot)
            ++link;
        *link = 2 * to + (agree ? 1 : 0);
    }

    std::vector<Triangle>& m_triangles;
    std::vector<Slot> m_across;
};

/// Looks along the axes.
class VisibilityScan
{
public:
    explicit VisibilityScan(const TriangleSoup& surface)
        : m_surface(surface)
        , m_tree(faceBoxes(surface.points, surface.triangles))
    {}

    /// From the middle of the face: how many of the axes' ways lead out before it, less how many behind. Both are added
    /// to `seen`.
    int balance(Slot face, std::size_t& seen) const
    {
        const Triangle& t = m_surface.triangles[face];
        const Vec3 a = at(t[0]), b = at(t[1]), c = at(t[2]);
        const Vec3 middle = (a + b + c) / 3, normal = (b - a).cross(c - a);
        int result = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int way : {-1, 1}) {
                if (normal[axis] == 0 || !leadsOut(face, middle, axis, way))
                    continue;
                ++seen;
                result += normal[axis] * way > 0 ? 1 : -1;
            }
        }
        return result;
    }

private:
    Vec3 at(Slot v) const { return m_surface.points[v].cast<double>(); }

    bool leadsOut(Slot face, const Vec3& from, int axis, int way) const
    {
        FaceBox line;
        line.extend(from.array().cast<float>());
        Eigen::Array3f end = from.array().cast<float>();
        end[axis] = static_cast<float>(2 * way * Lattice::limit);
        line.extend(end);
        bool isBlocked = false;
        m_tree.forEachMeeting(line, [&](Slot position) {
            const Slot other = m_tree.at(position);
            isBlocked = isBlocked || (other != face && blocks(other, from, axis, way));
        });
        return !isBlocked;
    }

    bool blocks(Slot face, const Vec3& from, int axis, int way) const
    {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const Triangle& t = m_surface.triangles[face];
        const std::array<Vec3, 3> p{at(t[0]) - from, at(t[1]) - from, at(t[2]) - from};
        std::array<double, 3> weight;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &u = p[(k + 1) % 3], &v = p[(k + 2) % 3];
            weight[k] = u[i] * v[j] - u[j] * v[i];
        }
        const double sum = weight[0] + weight[1] + weight[2];
        if (sum == 0 || weight[0] * sum < 0 || weight[1] * sum < 0 || weight[2] * sum < 0)
            return false;
        return way * (weight[0] * p[0][axis] + weight[1] * p[1][axis] + weight[2] * p[2][axis]) / sum > 0;
    }

    const TriangleSoup& m_surface;
    BoxTree m_tree;
};

/// Returns, by part, whether its faces run each of its edges as often one way as the other.
std::vector<bool> closedParts(const TriangleSoup& surface, const Parts& parts)
{
    std::vector<bool> isClosed(parts.faces.size(), true);
    std::map<Slot, int> net; // of an edge, by part
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        net.clear();
        for (const EdgeFace& e : around)
            net[parts.ofFace[e.face]] += e.forward ? 1 : -1;
        for (const auto& [part, sum] : net)
            isClosed[part] = isClosed[part] && sum == 0;
    });
    return isClosed;
}

/// Returns whether a part that is open parts space of different winding numbers, as a wall of a void does, rather than
/// lie in the midst of space of one, as a sheet within a void or within the matter does. The rest of the surface runs
/// the right way.
bool isWall(const TriangleSoup& surface, std::span<const Vec3> points, const WindingNumber& winding,
            const std::vector<Slot>& faces)
{
    constexpr std::size_t samples = 16;
    constexpr double halfway = 0.25;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < faces.size(); i += std::max<std::size_t>(1, faces.size() / samples)) {
        const auto& [a, b, c] = surface.triangles[faces[i]];
        const double around = winding.at((points[a] + points[b] + points[c]) / 3,
                                         std::span(faces).subspan(i, 1)); // the mean of both sides
        sum += std::abs(around - std::round(around));
        ++count;
    }
    return sum > halfway * static_cast<double>(count);
}

/// Drops walls that would have open edges, and then those that these leave open.
void keepClosedWalls(const TriangleSoup& surface, const Parts& parts, std::span<const std::size_t> walls,
                     std::vector<bool>& isKept)
{
    bool isAnyDropped = std::ranges::any_of(walls, [&](std::size_t part) { return isKept[part]; });
    while (isAnyDropped) {
        std::vector<bool> isOpen(parts.faces.size(), false);
        forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
            int net = 0;
            for (const EdgeFace& e : around)
                net += !isKept[parts.ofFace[e.face]] ? 0 : e.forward ? 1 : -1;
            for (const EdgeFace& e : around)
                isOpen[parts.ofFace[e.face]] = isOpen[parts.ofFace[e.face]] || net != 0;
        });
        isAnyDropped = false;
        for (const std::size_t part : walls)
            if (isKept[part] && isOpen[part]) {
                isKept[part] = false;
                isAnyDropped = true;
            }
    }
}

/// Turns the parts that hang on edges of three or more to where they are seen from. True: some were not seen, and went.
bool orientSheets(TriangleSoup& surface, const Parts& parts, OrientationResult& oriented)
{
    std::vector<bool> hangs(parts.faces.size(), false);
    bool doAny = false;
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        if (around.size() < 3)
            return;
        doAny = true;
        for (const EdgeFace& e : around)
            hangs[parts.ofFace[e.face]] = true;
    });
    if (!doAny)
        return false;
    const std::vector<bool> isClosed = closedParts(surface, parts);
    const VisibilityScan scan(surface);
    std::vector<std::size_t> unseen;
    for (std::size_t part = 0; part < parts.faces.size(); ++part) {
        if (!hangs[part] || isClosed[part])
            continue;
        constexpr std::size_t samples = 64;
        const std::vector<Slot>& faces = parts.faces[part];
        const std::size_t step = std::max<std::size_t>(1, faces.size() / samples);
        std::size_t seen = 0;
        int balance = 0;
        for (std::size_t i = 0; i < faces.size(); i += step)
            balance += scan.balance(faces[i], seen);
        if (seen == 0)
            unseen.push_back(part);
        for (const Slot f : faces)
            if (balance < 0)
                turn(surface.triangles[f]);
        oriented.turned += balance < 0 ? faces.size() : 0;
    }
    if (unseen.empty())
        return false;
    const std::vector<Vec3> points = surface.places();
    const WindingNumber winding(points, surface.triangles);
    std::vector<bool> isKept(parts.faces.size(), true);
    for (const std::size_t part : unseen)
        isKept[part] = isWall(surface, points, winding, parts.faces[part]);
    keepClosedWalls(surface, parts, unseen, isKept);
    const std::size_t membranes = oriented.membranes.size();
    std::size_t kept = 0;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        if (isKept[parts.ofFace[f]])
            surface.triangles[kept++] = surface.triangles[f];
        else
            oriented.membranes.push_back(surface.triangles[f]);
    }
    surface.triangles.resize(kept);
    return oriented.membranes.size() > membranes;
}

double volumeOf(const TriangleSoup& surface, const std::vector<Slot>& faces)
{
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    const Vec3 origin = at(surface.triangles[faces[0]][0]);
    double volume = 0;
    for (const Slot f : faces) {
        const auto& [a, b, c] = surface.triangles[f];
        volume += (at(a) - origin).dot((at(b) - origin).cross(at(c) - origin)) / 6;
    }
    return volume;
}

/// Calls visit(share of the first side, of the second) for the middles of the equal triangles that a triangle falls
/// into when each side is cut into `perSide`.
template <typename Visit> void forEachSample(int perSide, Visit visit)
{
    for (int i = 0; i < perSide; ++i)
        for (int j = 0; i + j < perSide; ++j) {
            visit((i + 1.0 / 3) / perSide, (j + 1.0 / 3) / perSide);
            if (i + j + 1 < perSide)
                visit((i + 2.0 / 3) / perSide, (j + 2.0 / 3) / perSide);
        }
}

/// Winding of other parts at points of a closed part.
struct Surroundings
{
    struct Sample
    {
        double area;
        double outward, inward; ///< winding numbers of parts that face outwards and of those that face inwards
    };

    std::vector<Sample> samples;
    double area = 0; ///< of all samples

    /// Returns how often parts of one way wind around all of it, `way`: 1 outward, -1 inward.
    double aroundAll(int way) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [part, outward, inward] : samples)
            least = std::min(least, std::round(way > 0 ? outward : -inward));
        return std::max(0.0, least); // below 0 where a sample lies beyond an edge of its own part
    }

    /// Returns the share of the area that parts of one way wind around more often than `least`.
    double share(int way, double least) const
    {
        constexpr double half = 0.5;
        double sum = 0;
        for (const auto& [part, outward, inward] : samples)
            sum += (way > 0 ? outward : -inward) - least > half ? part : 0;
        return sum / area;
    }
};

/// Winding numbers of the parts that face outwards, and of those that face inwards.
class WindingByWay
{
public:
    /// `facesIn`: by part.
    WindingByWay(const TriangleSoup& surface, const Parts& parts, const std::vector<bool>& facesIn)
        : m_surface(surface)
        , m_points(surface.places())
        , m_outward(windingOf(parts, facesIn, false))
        , m_inward(windingOf(parts, facesIn, true))
    {}

    /// Looks a little inside of the faces: those of a cavity that ends in the plane of an outer face lie in others,
    /// too.
    Surroundings around(const std::vector<Slot>& faces, bool facesIn) const
    {
        constexpr std::size_t samples = 64;
        constexpr double depth = 16; // lattice units: more than what rounding moves
        const double own = facesIn ? -1 : 1;
        const std::size_t step = std::max<std::size_t>(1, faces.size() / samples);
        const auto perSide = static_cast<int>(std::ceil(std::sqrt(samples / static_cast<double>(faces.size()))));
        Surroundings around;
        for (std::size_t i = 0; i < faces.size(); i += step) {
            const auto& [a, b, c] = m_surface.triangles[faces[i]];
            const Vec3 u = m_points[b] - m_points[a], v = m_points[c] - m_points[a];
            const Vec3 inside = m_points[a] - depth * own * u.cross(v).normalized();
            const double area = u.cross(v).norm() / (perSide * perSide);
            forEachSample(perSide, [&](double alongU, double alongV) {
                const Vec3 p = inside + alongU * u + alongV * v;
                around.samples.push_back(
                    {area, m_outward.at(p) - (facesIn ? 0 : own), m_inward.at(p) - (facesIn ? own : 0)});
                around.area += area;
            });
        }
        return around;
    }

private:
    WindingNumber windingOf(const Parts& parts, const std::vector<bool>& facesIn, bool way) const
    {
        std::vector<Triangle> triangles;
        for (std::size_t part = 0; part < parts.faces.size(); ++part)
            if (facesIn[part] == way)
                for (const Slot f : parts.faces[part])
                    triangles.push_back(m_surface.triangles[f]);
        return {m_points, triangles};
    }

    const TriangleSoup& m_surface;
    std::vector<Vec3> m_points;
    WindingNumber m_outward, m_inward;
};
} // namespace

OrientationResult orient(TriangleSoup& surface)
{
    OrientationResult oriented;
    bool again = true;
    while (again) {
        const Parts parts = Flood(surface).run(oriented.turned);
        again = orientSheets(surface, parts, oriented);
    }
    return oriented;
}

OutwardResult orientOutwards(TriangleSoup& surface, bool innerAreCavities)
{
    constexpr double nearlyAll = 1 - 1e-9, most = 0.6, much = 0.4;
    OutwardResult faced;
    std::size_t turned = 0;
    const Parts parts = Flood(surface).run(turned);
    const std::vector<bool> isClosed = closedParts(surface, parts);
    std::vector<double> volumes;
    std::vector<bool> facesIn;
    for (const std::vector<Slot>& faces : parts.faces) {
        volumes.push_back(volumeOf(surface, faces));
        facesIn.push_back(isClosed[facesIn.size()] && volumes.back() < 0);
    }
    std::optional<WindingByWay> winding;
    if (parts.faces.size() > 1)
        winding.emplace(surface, parts, facesIn);
    for (std::size_t part = 0; part < parts.faces.size(); ++part) {
        if (!isClosed[part])
            continue;
        const std::vector<Slot>& faces = parts.faces[part];
        const Surroundings around = winding ? winding->around(faces, facesIn[part]) : Surroundings{{{1, 0, 0}}, 1};
        const int way = facesIn[part] ? -1 : 1;
        // Parts of its way that are around all of it make a hollow of what it lies in; those that cross it do not.
        const double within = around.share(-way, around.aroundAll(way));
        const double withinAlike = around.share(way, around.aroundAll(-way));
        const bool isCavity = within > (facesIn[part] ? most : nearlyAll);
        const bool isInside = isCavity || withinAlike > nearlyAll;
        const bool shouldFaceIn = isCavity || (isInside && innerAreCavities);
        faced.inner += isInside && !isCavity;
        faced.turned += facesIn[part] && !isInside;
        faced.isGuess = faced.isGuess || (within > much && !isCavity);
        if (isCavity)
            faced.cavitiesOutside += std::abs(volumes[part]) * (1 - within + around.share(way, around.aroundAll(way)));
        if (shouldFaceIn != facesIn[part])
            for (const Slot f : faces)
                turn(surface.triangles[f]);
    }
    return faced;
}
} // namespace core::repair
