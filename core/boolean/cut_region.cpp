// 1. choose  takes the faces that are cut, and those near their boxes and planes
// 2. cut     cuts these; the other faces only add to the winding numbers
// 3. merge   joins both by the points that they share on the lattice

#include "core/boolean/cut_region.h"

#include "core/util/parallel.h"

#include <limits>
#include <unordered_map>

namespace core::boolean
{
namespace
{
/// Distance from faces that are cut, lattice units. Rounding, and cutting again after it, do not reach beyond.
constexpr int margin = 512;

struct LatticeHash
{
    std::size_t operator()(const LatticePoint& p) const
    {
        std::uint64_t hash = 0;
        for (const int x : p)
            hash = (hash ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
        return hash ^ (hash >> 32);
    }
};

/// Numbers points in the order in which faces use them.
class PointNumbers
{
public:
    explicit PointNumbers(std::size_t count) : m_numbers(count, noSlot) {}

    /// Returns the number of a point; adds it to points() if it is new.
    Slot of(Slot point)
    {
        Slot& number = m_numbers[point];
        if (number == noSlot) {
            number = static_cast<Slot>(m_points.size());
            m_points.push_back(point);
        }
        return number;
    }
    const std::vector<Slot>& points() const { return m_points; }

private:
    std::vector<Slot> m_numbers, m_points;
};

/// The space between two planes, at the margin on either side of a face.
class Slab
{
public:
    explicit Slab(const std::array<LatticePoint, 3>& face) : m_origin(face[0].cast<double>())
    {
        const Vec3 u = (face[1] - face[0]).cast<double>(), v = (face[2] - face[0]).cast<double>();
        m_normal = u.cross(v).normalized();
    }

    /// Returns whether a part of the triangle is inside.
    bool meets(const std::array<LatticePoint, 3>& triangle) const
    {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const LatticePoint& p : triangle) {
            const double height = m_normal.dot(p.cast<double>() - m_origin);
            least = std::min(least, height);
            most = std::max(most, height);
        }
        return least <= margin && most >= -margin;
    }

private:
    Vec3 m_origin, m_normal;
};

/// Appends points of a surface, with their colours, to another.
void copyPoints(const repair::TriangleSoup& from, std::span<const Slot> points, repair::TriangleSoup& to)
{
    for (const Slot v : points) {
        to.points.push_back(from.points[v]);
        if (!from.colors.empty())
            to.colors.push_back(from.colors[v]);
    }
}
} // namespace

CutRegion::CutRegion(const SolidSoup& soup, const std::vector<Fate>& fates)
    : m_soup(soup)
    , m_fates(fates)
    , m_isNear(facesNearCuts())
{
    PointNumbers numbers(soup.surface.points.size());
    std::vector<bool> isCut(soup.surface.points.size(), false);
    for (Slot f = 0; f < m_isNear.size(); ++f) {
        if (!m_isNear[f])
            continue;
        Triangle t = soup.surface.triangles[f];
        for (Slot& v : t) {
            isCut[v] = isCut[v] || fates[f] == Fate::Cut;
            v = numbers.of(v);
        }
        m_surface.triangles.push_back(t);
    }
    copyPoints(soup.surface, numbers.points(), m_surface);
    std::ranges::copy_if(numbers.points(), std::back_inserter(m_unmoved), [&](Slot v) { return !isCut[v]; });
}

std::vector<bool> CutRegion::facesNearCuts() const
{
    std::vector<FaceBox> cuts;
    std::vector<Slab> slabs;
    LatticeBox all;
    for (Slot f = 0; f < m_fates.size(); ++f)
        if (m_fates[f] == Fate::Cut) {
            const LatticeBox box = m_soup.boxOf(f);
            cuts.push_back(floatBox(box, margin));
            slabs.emplace_back(m_soup.cornersOf(f));
            all.extend(box);
        }
    std::vector<bool> isNear(m_fates.size(), false);
    if (cuts.empty())
        return isNear;
    all.min.array() -= margin;
    all.max.array() += margin;
    const BoxTree tree(cuts);
    const std::vector<Slot> near = joinChunks<std::vector<Slot>>(
        m_fates.size(), facesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<Slot>& faces) {
            for (auto f = static_cast<Slot>(begin); f < end; ++f) {
                const LatticeBox box = m_soup.boxOf(f);
                const auto corners = m_soup.cornersOf(f);
                bool isHere = false;
                if (all.meets(box))
                    tree.forEachMeeting(floatBox(box), [&](Slot position) {
                        isHere = isHere || slabs[tree.at(position)].meets(corners);
                    });
                if (isHere)
                    faces.push_back(f);
            }
        });
    for (const Slot f : near)
        isNear[f] = true;
    return isNear;
}

repair::LeftOut CutRegion::leftOut() const
{
    std::vector<Triangle> kept, dropped;
    for (Slot f = 0; f < m_fates.size(); ++f)
        if (!m_isNear[f])
            (m_fates[f] == Fate::Kept ? kept : dropped).push_back(m_soup.surface.triangles[f]);
    const std::vector<Vec3> places = m_soup.surface.places();
    return {WindingNumber(places, kept), WindingNumber(places, dropped)};
}

repair::Resolution CutRegion::cut(double tolerance, const JobControl& control)
{
    constexpr std::uint64_t maxCutAgain = 5'000; // pairs of faces: about a second
    std::uint64_t budget = maxCutAgain;
    const repair::Resolution resolution =
        repair::cutIntersections(m_surface, {m_soup.least, false}, leftOut(), tolerance, budget, control);
    m_exactVolume = resolution.volume;
    return resolution;
}

PlacedSurface CutRegion::merged(std::span<const TriangleMesh> solids) const
{
    const repair::TriangleSoup& soup = m_soup.surface;
    PlacedSurface result;
    result.exactVolume = m_exactVolume;
    PointNumbers numbers(soup.points.size());
    for (Slot f = 0; f < m_fates.size(); ++f) {
        if (m_isNear[f] || m_fates[f] != Fate::Kept)
            continue;
        const Triangle& t = soup.triangles[f];
        result.surface.triangles.push_back({numbers.of(t[0]), numbers.of(t[1]), numbers.of(t[2])});
        const auto at = [&](std::size_t corner) { return Vec3(soup.points[t[corner]].cast<double>()); };
        result.exactVolume += at(0).dot(at(1).cross(at(2))) / 6;
    }
    std::unordered_map<LatticePoint, Slot, LatticeHash> unmoved; // by place
    for (const Slot v : m_unmoved)
        unmoved.emplace(soup.points[v], v);
    std::vector<Slot> cornerOf(m_surface.points.size(), noSlot); // for each point of the region, its new index
    for (Slot v = 0; v < m_surface.points.size(); ++v)
        if (const auto found = unmoved.find(m_surface.points[v]); found != unmoved.end())
            cornerOf[v] = numbers.of(found->second);
    copyPoints(soup, numbers.points(), result.surface);
    for (const Slot v : numbers.points()) {
        const auto solid =
            static_cast<std::size_t>(std::ranges::upper_bound(m_soup.firstPoints, v) - m_soup.firstPoints.begin()) - 1;
        result.points.push_back(solids[solid].points[v - m_soup.firstPoints[solid]]);
    }
    for (const Triangle& t : m_surface.triangles) {
        Triangle corners = t;
        for (Slot& v : corners) {
            if (cornerOf[v] == noSlot) {
                cornerOf[v] = static_cast<Slot>(result.points.size());
                copyPoints(m_surface, std::span(&v, 1), result.surface);
                result.points.push_back(m_soup.pointAt(m_surface.points[v]));
            }
            v = cornerOf[v];
        }
        result.surface.triangles.push_back(corners);
    }
    return result;
}
} // namespace core::boolean
