#include "core/repair/orientation.h"

#include "core/repair/edge_faces.h"

#include "core/analysis/winding_number.h"
#include "core/geometry/face_geometry.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace core::repair
{
namespace
{
/// The parts of a surface, each connected by edges of two faces.
struct Parts
{
    std::vector<std::vector<Slot>> faces;
    std::vector<Slot> ofFace;
};

void turn(Triangle& t)
{
    std::swap(t[1], t[2]);
}

/// Visits each part from a seed face and reverses the faces that disagree with the seed, or the others if those are
/// fewer.
class Flood
{
public:
    /// `isSeen`: for each face, whether it is known to face outwards. Two such faces that disagree are not joined
    /// directly. Keeps a reference, and clears it for faces that are reversed.
    Flood(TriangleSoup& surface, std::vector<bool>& isSeen)
        : m_triangles(surface.triangles)
        , m_isSeen(isSeen)
        , m_across(3 * m_triangles.size(), noSlot)
    {
        forEachEdge(m_triangles, [&](std::span<const EdgeFace> around) {
            if (around.size() != 2)
                return;
            const bool agree = around[0].forward != around[1].forward;
            if (!agree && isSeen[around[0].face] && isSeen[around[1].face])
                return;
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
                    m_isSeen[f] = false;
                    ++turned;
                }
            }
            parts.faces.push_back(std::move(faces));
        }
        return parts;
    }

private:
    /// Stores a link as 2 x face + (1 if the orientations agree).
    void connect(Slot from, Slot to, bool agree)
    {
        Slot* link = &m_across[3 * from];
        while (*link != noSlot)
            ++link;
        *link = 2 * to + (agree ? 1 : 0);
    }

    std::vector<Triangle>& m_triangles;
    std::vector<bool>& m_isSeen;
    std::vector<Slot> m_across;
};

/// Tests from which sides faces are visible along the axes.
class VisibilityScan
{
public:
    explicit VisibilityScan(const TriangleSoup& surface)
        : m_surface(surface)
        , m_tree(faceBoxes(surface.points, surface.triangles))
    {}

    /// Counts the axis directions that lead out from the middle of the face: those in front of it minus those behind
    /// it. Adds the number of both to `seen`.
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

/// Returns for each part whether its faces run along each of its edges equally often in both directions.
std::vector<bool> closedParts(const TriangleSoup& surface, const Parts& parts)
{
    std::vector<bool> isClosed(parts.faces.size(), true);
    std::map<Slot, int> net; // for each part, the balance of directions along one edge
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        net.clear();
        for (const EdgeFace& e : around)
            net[parts.ofFace[e.face]] += e.forward ? 1 : -1;
        for (const auto& [part, sum] : net)
            isClosed[part] = isClosed[part] && sum == 0;
    });
    return isClosed;
}

/// Returns whether an open part separates space of different winding numbers, as a wall of a void does. A sheet in a
/// void or inside the matter has one winding number on both sides. Precondition: the rest of the surface is oriented.
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
                                         std::span(faces).subspan(i, 1)); // mean winding number of both sides
        sum += std::abs(around - std::round(around));
        ++count;
    }
    return sum > halfway * static_cast<double>(count);
}

/// Drops walls that would have open edges, repeatedly, as this may open edges of other walls.
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

/// Turns open parts that have edges of three or more faces towards the side from which they are visible, and marks
/// their faces in `isSeen` if hardly any is visible from the other side. Returns whether invisible parts were removed.
bool orientSheets(TriangleSoup& surface, const Parts& parts, OrientationResult& oriented, std::vector<bool>& isSeen)
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
        for (const Slot f : faces) {
            isSeen[f] = 2 * static_cast<std::size_t>(std::abs(balance)) > seen;
            if (balance < 0)
                turn(surface.triangles[f]);
        }
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
        if (!isKept[parts.ofFace[f]]) {
            oriented.membranes.push_back(surface.triangles[f]);
            continue;
        }
        isSeen[kept] = isSeen[f];
        surface.triangles[kept++] = surface.triangles[f];
    }
    surface.triangles.resize(kept);
    isSeen.resize(kept);
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

/// Makes sample points slightly inside or outside a closed part. Points on the part would be ambiguous: a cavity that
/// ends in the plane of an outer face has faces inside that face. Drops samples that are beyond an edge of the part's
/// faces or where these cross, unless all samples are.
class PartSamples
{
public:
    enum class Side { Inside, Outside };

    /// Keeps references to `points` and `faces`. `facesIn`: the part faces inwards.
    PartSamples(std::span<const Vec3> points, std::span<const Triangle> faces, bool facesIn)
        : m_points(points)
        , m_faces(faces)
        , m_facesIn(facesIn)
        , m_own(points, faces)
    {
        for (const auto& [a, b, c] : faces)
            m_ends.push_back(m_area += (points[b] - points[a]).cross(points[c] - points[a]).norm());
    }

    /// Returns points spread evenly over the area.
    std::vector<Vec3> overArea(std::size_t count, Side side = Side::Inside) const
    {
        constexpr double step = 0.61803399; // golden section
        constexpr double half = 0.5;
        std::vector<Vec3> samples;
        for (std::size_t i = 0; i < count; ++i) {
            const double at = (static_cast<double>(i) + half) / static_cast<double>(count) * m_area;
            const auto end = std::min(std::ranges::upper_bound(m_ends, at), m_ends.end() - 1);
            const auto& [a, b, c] = m_faces[static_cast<std::size_t>(end - m_ends.begin())];
            const Vec3 u = m_points[b] - m_points[a], v = m_points[c] - m_points[a];
            const double fromA = std::sqrt(std::clamp((*end - at) / u.cross(v).norm(), 0.0, 1.0));
            const double towardsC = std::fmod(static_cast<double>(i) * step, 1.0);
            samples.push_back(beside(u, v, fromA * ((1 - towardsC) * u + towardsC * v), side) + m_points[a]);
        }
        return cleared(std::move(samples), side);
    }

    /// Returns a point for each of at most `count` vertices. Vertices reach thin ends of the part, which samples by
    /// area would miss.
    std::vector<Vec3> atVertices(std::size_t count) const
    {
        std::vector<Slot> corners; // 3 x face + corner
        for (Slot f = 0; f < m_faces.size(); ++f)
            for (Slot k = 0; k < 3; ++k)
                corners.push_back(3 * f + k);
        const auto vertex = [&](Slot corner) { return m_faces[corner / 3][corner % 3]; };
        std::ranges::sort(corners, {}, vertex);
        corners.erase(std::ranges::unique(corners, {}, vertex).begin(), corners.end());
        const std::size_t stride = 1 + corners.size() / count;
        std::vector<Vec3> samples;
        for (std::size_t i = 0; i < corners.size(); i += stride) {
            const Triangle& t = m_faces[corners[i] / 3];
            const Slot k = corners[i] % 3;
            const Vec3 a = m_points[t[k]];
            samples.push_back(
                beside(m_points[t[(k + 1) % 3]] - a, m_points[t[(k + 2) % 3]] - a, Vec3::Zero(), Side::Inside) + a);
        }
        return cleared(std::move(samples), Side::Inside);
    }

private:
    static constexpr double depth = 16; ///< distance of samples from the surface, lattice units; exceeds the rounding

    /// Moves a point on a face off the face and away from its edges. `u`, `v`: two sides of the face.
    Vec3 beside(const Vec3& u, const Vec3& v, const Vec3& onFace, Side side) const
    {
        // Share of the way to the middle of the face; the move is at most twice the depth
        constexpr double fromEdges = 0.1;
        const Vec3 inwards = (u + v) / 3 - onFace;
        const bool isAlongNormal = m_facesIn == (side == Side::Inside);
        return onFace + std::min(fromEdges, 2 * depth / inwards.norm()) * inwards +
               (isAlongNormal ? depth : -depth) * u.cross(v).normalized();
    }

    std::vector<Vec3> cleared(std::vector<Vec3> all, Side side) const
    {
        constexpr double half = 0.5;
        const double right = side == Side::Outside ? 0 : m_facesIn ? -1 : 1;
        std::vector<Vec3> samples;
        std::ranges::copy_if(all, std::back_inserter(samples),
                             [&](const Vec3& p) { return std::abs(m_own.at(p) - right) < half; });
        return samples.empty() ? all : samples;
    }

    std::span<const Vec3> m_points;
    std::span<const Triangle> m_faces;
    bool m_facesIn;
    WindingNumber m_own;
    std::vector<double> m_ends; ///< running sums of the faces' areas, doubled
    double m_area = 0;          ///< area of the part, doubled
};

/// Winding numbers at sample points.
struct Windings : std::vector<double>
{
    /// Returns the least winding number, rounded; at least 0.
    double least() const { return std::max(0.0, std::round(std::ranges::min(*this))); }
    /// Returns the largest winding number, rounded; at least 0.
    double most() const { return std::max(0.0, std::round(std::ranges::max(*this))); }
    /// Returns the share of the points whose winding number exceeds `least`.
    double share(double least) const
    {
        constexpr double half = 0.5;
        const auto isMore = [&](double winding) { return winding - least > half; };
        return static_cast<double>(std::ranges::count_if(*this, isMore)) / static_cast<double>(size());
    }
};

/// All parts that face one way.
class PartsOfWay
{
public:
    /// `are`: for each part, whether it is one of them. `way`: 1 outward, -1 inward.
    PartsOfWay(const TriangleSoup& surface, std::span<const Vec3> points, const Parts& parts, std::vector<bool> are,
               int way)
        : m_are(std::move(are))
        , m_way(way)
        , m_winding(points, facesOf(surface, parts, m_are))
    {}

    /// Returns how often these parts wind around points inside or outside a part. The part itself does not count.
    Windings around(std::span<const Vec3> samples, std::size_t part,
                    PartSamples::Side side = PartSamples::Side::Inside) const
    {
        const double own = m_are[part] && side == PartSamples::Side::Inside ? 1 : 0;
        Windings windings;
        for (const Vec3& p : samples)
            windings.push_back(m_way * m_winding.at(p) - own);
        return windings;
    }

private:
    static std::vector<Triangle> facesOf(const TriangleSoup& surface, const Parts& parts, const std::vector<bool>& are)
    {
        std::vector<Triangle> triangles;
        for (Slot f = 0; f < surface.triangles.size(); ++f)
            if (are[parts.ofFace[f]])
                triangles.push_back(surface.triangles[f]);
        return triangles;
    }

    std::vector<bool> m_are;
    int m_way;
    WindingNumber m_winding;
};

/// Orientation and position of a part.
struct Facing
{
    bool isClosed = false;
    bool isInwards = false; ///< before turning; for closed parts only
    double volume = 0;      ///< negative if it faces inwards; for closed parts only
    bool isCavity = false;
    bool isInside = false; ///< inside other parts, as cavities are
    bool isGuess = false;  ///< partly inside parts of the other orientation, but no cavity
};

/// Distinguishes cavities from parts that are inside out.
class CavitySearch
{
public:
    CavitySearch(const TriangleSoup& surface, const Parts& parts)
        : m_surface(surface)
        , m_points(surface.places())
        , m_parts(parts)
        , m_facings(parts.faces.size())
    {
        const std::vector<bool> isClosed = closedParts(surface, parts);
        for (std::size_t part = 0; part < m_facings.size(); ++part) {
            m_facings[part].isClosed = isClosed[part];
            m_facings[part].volume = isClosed[part] ? volumeOf(surface, parts.faces[part]) : 0;
            m_facings[part].isInwards = m_facings[part].volume < 0;
            m_volume += std::abs(m_facings[part].volume);
        }
    }

    std::vector<Facing> run()
    {
        const std::vector<bool> meets = meetingParts();
        const auto those = [&](auto are) {
            std::vector<bool> result;
            for (std::size_t part = 0; part < m_facings.size(); ++part)
                result.push_back(meets[part] && are(m_facings[part]));
            return result;
        };
        const std::vector<bool> inwardOnes = those([](const Facing& f) { return f.isInwards; });
        const std::vector<bool> outwardOnes = those([](const Facing& f) { return !f.isInwards; });
        const PartsOfWay outward = ofWay(outwardOnes, 1), inward = ofWay(inwardOnes, -1);
        judge(inwardOnes, inward, outward, outward);
        // Cavities are excluded: a part in a cavity is no cavity of an inside-out model.
        const PartsOfWay inverted = ofWay(those([](const Facing& f) { return f.isInwards && !f.isCavity; }), -1);
        judge(outwardOnes, outward, inward, inverted);
        return std::move(m_facings);
    }

private:
    PartsOfWay ofWay(std::vector<bool> are, int way) const
    {
        return {m_surface, m_points, m_parts, std::move(are), way};
    }

    /// Returns for each part whether its box meets that of another part.
    std::vector<bool> meetingParts() const
    {
        std::vector<FaceBox> boxes(m_facings.size());
        for (Slot f = 0; f < m_surface.triangles.size(); ++f)
            for (const Slot v : m_surface.triangles[f])
                boxes[m_parts.ofFace[f]].extend(m_surface.points[v].array().cast<float>());
        const BoxTree tree(boxes);
        std::vector<bool> meets(boxes.size(), false);
        for (Slot block = 0; block < tree.blocks(); ++block)
            tree.forEachMeetingPair(block, [&](Slot i, Slot j) { meets[tree.at(i)] = meets[tree.at(j)] = true; });
        return meets;
    }

    /// Classifies the parts of one orientation. `alike`: these parts. `unlike`: parts of the other orientation.
    /// `around`: those of `unlike` in which a part may be a cavity.
    void judge(const std::vector<bool>& are, const PartsOfWay& alike, const PartsOfWay& unlike,
               const PartsOfWay& around)
    {
        constexpr double nearlyAll = 1 - 1e-9, most = 0.6, some = 0.001, muchOfBody = 0.2;
        constexpr double muchOfCutter = 0.02; // area share of one end of a 12 x 1 x 1 bar
        forEachChunk(are.size(), 1, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t part = begin; part < end; ++part) {
                Facing& facing = m_facings[part];
                if (!are[part] || !facing.isClosed)
                    continue;
                std::vector<Triangle> faces;
                for (const Slot f : m_parts.faces[part])
                    faces.push_back(m_surface.triangles[f]);
                const PartSamples of(m_points, faces, facing.isInwards);
                std::vector<Vec3> samples = of.overArea(few);
                Windings ofAlike = alike.around(samples, part), ofAround = around.around(samples, part);
                if (facing.isInwards && (ofAlike.least() > 0 || ofAround.share(0) < clearly)) {
                    samples = of.overArea(many);
                    ofAlike = alike.around(samples, part);
                    ofAround = around.around(samples, part);
                }
                const double hollows = facing.isInwards ? hollowsAround(alike, of, ofAlike, part) : ofAlike.least();
                const Windings ofUnlike = &around == &unlike ? ofAround : unlike.around(samples, part);
                facing.isCavity = ofAround.share(hollows) > (facing.isInwards ? most : nearlyAll);
                facing.isInside = facing.isCavity || ofAlike.share(ofUnlike.least()) > nearlyAll;
                const bool isBody = 2 * std::abs(facing.volume) > m_volume; // small parts may cross a part of this size
                const double share = !isBody ? some : facing.isInwards ? muchOfCutter : muchOfBody;
                facing.isGuess = ofAround.share(0) > share && !facing.isCavity;
            }
        });
    }

    /// Returns the number of parts of the same orientation whose hollow contains the part: they wind around all of it.
    /// Parts that cross it or coincide with it do not count. `windings`: winding numbers of those parts at points of
    /// it.
    static double hollowsAround(const PartsOfWay& alike, const PartSamples& of, const Windings& windings,
                                std::size_t part)
    {
        constexpr auto outside = PartSamples::Side::Outside;
        if (windings.least() == 0 || alike.around(of.overArea(few, outside), part, outside).most() == 0)
            return 0;
        return std::min(windings.least(), alike.around(of.atVertices(maxVertices), part).least());
    }

    static constexpr std::size_t few = 128, many = 2048, maxVertices = 16'384; ///< numbers of samples
    /// Few samples are enough if at least this share of them is inside parts of the other orientation.
    static constexpr double clearly = 0.75;

    const TriangleSoup& m_surface;
    std::vector<Vec3> m_points;
    const Parts& m_parts;
    std::vector<Facing> m_facings;
    double m_volume = 0; ///< sum of the volumes of all closed parts, as absolute values
};
} // namespace

OrientationResult orient(TriangleSoup& surface)
{
    OrientationResult oriented;
    std::vector<bool> isSeen(surface.triangles.size(), false);
    bool again = true;
    while (again) {
        const Parts parts = Flood(surface, isSeen).run(oriented.turned);
        again = orientSheets(surface, parts, oriented, isSeen);
    }
    return oriented;
}

OutwardResult orientOutwards(TriangleSoup& surface, bool innerAreCavities)
{
    OutwardResult faced;
    std::size_t turned = 0;
    std::vector<bool> isSeen(surface.triangles.size(), false);
    const Parts parts = Flood(surface, isSeen).run(turned);
    const std::vector<Facing> facings = CavitySearch(surface, parts).run();
    const auto facesIn = [&](const Facing& f) { return f.isCavity || (f.isInside && innerAreCavities); };
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Facing& facing = facings[parts.ofFace[f]];
        const bool shouldFaceIn = facesIn(facing);
        if (facing.isClosed && shouldFaceIn != facing.isInwards)
            turn(surface.triangles[f]);
        if (shouldFaceIn)
            faced.cavities.push_back(surface.triangles[f]);
        if (facing.isGuess)
            faced.guesses.push_back(f);
    }
    for (const Facing& facing : facings) {
        faced.inner += facing.isInside && !facing.isCavity;
        faced.turned += facing.isInwards && !facesIn(facing);
    }
    return faced;
}
} // namespace core::repair
