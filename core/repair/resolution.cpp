#include "core/repair/resolution.h"

#include "core/repair/cleanup.h"
#include "core/repair/contact_separation.h"
#include "core/repair/knot_covering.h"
#include "core/repair/neighbourhood.h"
#include "core/repair/outward_offset.h"

#include "core/analysis/mesh_topology.h"
#include "core/analysis/nesting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core::repair
{
namespace
{
constexpr std::size_t maxPairs = 1'000'000;

/// Returns the faces of the pairs, each once, ascending.
std::vector<Slot> facesOf(std::span<const FacePair> pairs)
{
    std::vector<Slot> faces;
    for (const auto& [first, second] : pairs) {
        faces.push_back(first);
        faces.push_back(second);
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

/// Returns the number of triples of faces that meet each other, up to roughly `limit`. In each triple two cuts cross in
/// a face.
std::uint64_t triplesOf(std::size_t faces, std::span<const FacePair> pairs, std::uint64_t limit)
{
    if (pairs.empty())
        return 0;
    std::vector<std::vector<Slot>> after(faces); // for each face, the faces after it that it meets
    for (const auto& [first, second] : pairs)
        after[first].push_back(second);
    for (std::vector<Slot>& others : after)
        std::ranges::sort(others);
    std::uint64_t triples = 0;
    for (const auto& [first, second] : pairs) {
        const auto [fewer, more] =
            std::minmax(after[first], after[second], [](const auto& a, const auto& b) { return a.size() < b.size(); });
        for (const Slot third : fewer)
            triples += std::ranges::binary_search(more, third) ? 1 : 0;
        if (triples > limit)
            break;
    }
    return triples;
}

std::vector<Slot> cornersOf(const TriangleSoup& surface, std::span<const Slot> faces)
{
    std::vector<Slot> corners;
    for (const Slot f : faces)
        corners.insert(corners.end(), surface.triangles[f].begin(), surface.triangles[f].end());
    return corners;
}

/// Returns the longest side of the surface's box.
double sizeOf(const TriangleSoup& surface)
{
    const LatticeBox box = surface.box();
    return (box.max - box.min).cast<double>().maxCoeff();
}

/// Returns the faces that have one of these points.
std::vector<Slot> facesWith(const TriangleSoup& surface, std::span<const Slot> points)
{
    std::vector<bool> isMeant(surface.points.size(), false);
    for (const Slot v : points)
        isMeant[v] = true;
    std::vector<Slot> faces;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Triangle& t = surface.triangles[f];
        if (isMeant[t[0]] || isMeant[t[1]] || isMeant[t[2]])
            faces.push_back(f);
    }
    return faces;
}

/// Cuts a surface until no two faces meet.
class Cutting
{
public:
    /// `tolerance`: accuracy of the file's points, lattice units. `budget`: pairs of faces that may be cut after the
    /// first time.
    Cutting(TriangleSoup& surface, Inside inside, Beside beside, double tolerance, Resolution& resolution,
            std::uint64_t& budget, const JobControl& control)
        : m_surface(surface)
        , m_inside(inside)
        , m_beside(std::move(beside))
        , m_ofFile(tolerance)
        , m_resolution(resolution)
        , m_budget(budget)
        , m_control(control)
    {}

    /// Only cuts and rounds, without merging or moving points, and gives up after this number of rounds.
    void setExact(std::size_t rounds) { m_exactRounds = rounds; }

    /// `pairLimit`: if more pairs of faces meet at first, nothing is cut.
    void run(std::uint64_t pairLimit)
    {
        constexpr std::size_t maxRounds = 24, firstOfCovering = 4, lastOfGrowth = 10; // rounds; few surfaces need all
        constexpr double ofRounding = 8;                                              // tolerance in lattice units
        constexpr std::uint64_t maxTriples = 1'000'000; // cutting them takes about a minute
        m_resolution.isDone = false;
        m_met = selfIntersections<LatticePredicates>(m_surface.points, m_surface.triangles, maxPairs, m_control.stop);
        m_resolution.intersections = m_met.count;
        if (m_ofFile > 0 && canGoOn())
            removeSlivers(m_ofFile);
        if (m_met.count > 0)
            m_resolution.unresolved = placeOf(m_met.pairs[0]);
        if (m_met.count > std::min(pairLimit, manyMoreThan(m_resolution.intersections)) ||
            triplesOf(m_surface.triangles.size(), m_met.pairs, maxTriples) > maxTriples)
            return;
        cut(m_control.part(0, 0.5));
        std::uint64_t fewest = m_met.count;
        double tolerance = std::max(ofRounding, m_ofFile), reached = 0.5;
        const bool isExact = m_exactRounds > 0;
        const std::size_t rounds = isExact ? m_exactRounds : maxRounds;
        for (std::size_t round = 1; round < rounds && !m_control.isCancelled(); ++round) {
            m_met = intersectionsAmong(m_surface, facesNear(m_surface, m_changed), maxPairs, m_control.stop);
            if (!isExact && m_met.count > 0 && canGoOn())
                removeSlivers(tolerance / 2);
            if (!isExact && m_met.count > 0 && canGoOn())
                round < firstOfCovering ? offset(tolerance) : cover();
            m_resolution.isDone = m_met.count == 0;
            m_resolution.unresolved.reset();
            if (m_met.count > 0)
                m_resolution.unresolved = placeOf(m_met.pairs[0]);
            if (m_resolution.isDone)
                return cut(m_control.part(reached, 1)); // removes what rounding has turned inside out
            if (m_met.count > std::min(m_budget, manyMoreThan(fewest)))
                return;
            m_budget -= m_met.count;
            fewest = std::min(fewest, m_met.count);
            tolerance *= round < lastOfGrowth ? 1.5 : 1;
            cut(m_control.part(reached, (1 + reached) / 2));
            reached = (1 + reached) / 2;
        }
    }

private:
    static constexpr float reach = 2; ///< distance within which a rounded point may make faces meet, lattice units

    /// Returns the number of pairs above which the surface is given up as a tangle.
    static std::uint64_t manyMoreThan(std::uint64_t pairs)
    {
        constexpr std::uint64_t growth = 3, fewEnough = 1000;
        return growth * pairs + fewEnough;
    }

    bool canGoOn() const { return m_met.count <= maxPairs; }
    LatticePoint placeOf(const FacePair& pair) const { return m_surface.points[m_surface.triangles[pair.first][0]]; }

    void removeSlivers(double tolerance)
    {
        const std::vector<Slot> faces = facesOf(m_met.pairs), corners = cornersOf(m_surface, faces);
        if (repair::removeSlivers(m_surface, faces, tolerance))
            searchAround(corners);
    }

    void offset(double distance)
    {
        const std::vector<Slot> corners = cornersOf(m_surface, facesOf(m_met.pairs));
        offsetOutwards(m_surface, corners, distance);
        cleanUp(m_surface, Duplicates::Cancel);
        searchAround(corners);
    }

    void cover()
    {
        constexpr double widest = 1.0 / 500; // share of the size
        std::vector<Slot> corners = cornersOf(m_surface, facesOf(m_met.pairs));
        const std::size_t points = m_surface.points.size();
        const CoveredKnots covered = coverKnots(m_surface, m_met.pairs, widest * sizeOf(m_surface));
        m_resolution.knots += covered.count;
        m_resolution.widestKnot = std::max(m_resolution.widestKnot, covered.largest);
        for (std::size_t v = points; v < m_surface.points.size(); ++v)
            corners.push_back(static_cast<Slot>(v));
        searchAround(corners);
    }

    void searchAround(std::span<const Slot> points)
    {
        m_met = intersectionsAmong(m_surface, facesNear(m_surface, boxesAround(m_surface, points, reach)), maxPairs,
                                   m_control.stop);
    }

    void cut(const JobControl& control)
    {
        constexpr double afterCutting = 0.5;
        if (!canGoOn() || m_control.isCancelled())
            return;
        m_resolution.rounds += m_met.count > 0;
        m_changed = boxesAround(m_surface, cornersOf(m_surface, facesOf(m_met.pairs)), reach);
        WindingSolid solid = windingSolidOf(m_surface, arrange(m_surface, m_met.pairs, control.part(0, afterCutting)),
                                            m_inside, m_beside, control.part(afterCutting, 1));
        m_surface = std::move(solid.surface);
        // The surface now bounds the requested space; what rounding turns inside out is removed.
        m_inside = Inside::Positive;
        m_beside.beyond.resize(std::min<std::size_t>(m_beside.beyond.size(), 1)); // keeps only the kept faces
        if (m_resolution.volume + m_resolution.insideOutVolume == 0) {
            m_resolution.volume = solid.volume;
            m_resolution.insideOutVolume = solid.insideOutVolume;
        }
        cleanUp(m_surface, Duplicates::Cancel);
        control.reportProgress(1);
    }

    TriangleSoup& m_surface;
    Inside m_inside;
    Beside m_beside; ///< beyond: the kept faces come first
    double m_ofFile;
    Resolution& m_resolution;
    std::uint64_t& m_budget;
    const JobControl& m_control;
    std::size_t m_exactRounds = 0; ///< 0: points may be merged and moved
    IntersectionReport m_met;
    std::vector<FaceBox> m_changed; ///< boxes where faces changed in the last cut: no faces meet elsewhere
};

/// Drops components that are thin and small. Returns their number.
std::size_t dropCrumbs(TriangleSoup& surface)
{
    constexpr double thin = 64;                  // lattice units; thickness is the volume divided by half the area
    constexpr double small = 1e-4;               // share of the whole area
    constexpr double rounding = 2.5, few = 0.02; // likewise, for all that are as thin as rounding errors together
    const Components components = componentsOf(surface.points.size(), surface.triangles);
    std::vector<double> volume(components.count, 0), area(components.count, 0);
    std::vector<Slot> origin(components.count, noSlot);
    double whole = 0;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Triangle& t = surface.triangles[f];
        const Slot component = components.ofFace[f];
        if (origin[component] == noSlot)
            origin[component] = t[0];
        const auto at = [&](Slot v) {
            return Vec3((surface.points[v] - surface.points[origin[component]]).cast<double>());
        };
        const double faceArea = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm() / 2;
        volume[component] += at(t[0]).dot(at(t[1]).cross(at(t[2]))) / 6;
        area[component] += faceArea;
        whole += faceArea;
    }
    const auto thickness = [&](std::size_t c) { return area[c] > 0 ? 2 * std::abs(volume[c]) / area[c] : 0; };
    double areaOfThinnest = 0;
    for (std::size_t c = 0; c < components.count; ++c)
        areaOfThinnest += thickness(c) <= rounding ? area[c] : 0;
    const bool areFew = areaOfThinnest <= few * whole;
    std::vector<bool> isCrumb(components.count, false);
    for (std::size_t c = 0; c < components.count; ++c)
        isCrumb[c] = (area[c] <= small * whole && thickness(c) <= thin) || (areFew && thickness(c) <= rounding);
    std::size_t kept = 0;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Slot c = components.ofFace[f];
        if (!isCrumb[c])
            surface.triangles[kept++] = surface.triangles[f];
    }
    surface.triangles.resize(kept);
    return static_cast<std::size_t>(std::ranges::count(isCrumb, true));
}
} // namespace

Resolution resolveIntersections(TriangleSoup& surface, Inside inside, const TriangleSoup& cavities, double tolerance,
                                std::uint64_t& budget, const JobControl& control)
{
    constexpr int maxTimes = 16;
    constexpr int firstReach = 16, lastReach = 2048; // lattice units; doubled each time
    constexpr std::size_t manyTimes = 4, fewStuck = 500;
    constexpr std::uint64_t maxMet = 100'000; // pairs of faces; with more, cutting rarely converges
    Resolution resolution;
    std::size_t maxStuck = std::numeric_limits<std::size_t>::max();
    Cutting(surface, inside, {cavities, {}}, tolerance, resolution, budget, control).run(maxPairs);
    for (int time = 0; time < maxTimes && resolution.isDone && !control.isCancelled(); ++time) {
        const MeshTopology topology = topologyOf(surface.points.size(), surface.triangles);
        if (topology.nonManifoldEdges.count + topology.nonManifoldVertices.count == 0)
            break;
        const SeparationResult separated = separateContacts(surface, control);
        resolution.touchingEdges += separated.edges;
        resolution.touchingVertices += separated.vertices;
        if (separated.stuck.empty())
            break;
        const bool areMore = separated.stuck.size() > maxStuck; // it does not converge
        maxStuck = manyTimes * separated.stuck.size() + fewStuck;
        if (time + 1 == maxTimes || areMore) {
            resolution.isDone = false;
            resolution.unresolved = surface.points[separated.stuck[0]];
            break;
        }
        const int reach = std::min(lastReach, firstReach << time);
        removeSlivers(surface, facesWith(surface, separated.stuck), reach / 2);
        if (time % 2 == 0)
            offsetOutwards(surface, separated.stuck, reach);
        else
            coverPoints(surface, separated.stuck, reach);
        weld(surface);
        Resolution unread;
        Cutting(surface, Inside::Positive, {cavities, {}}, tolerance, unread, budget, {control.stop, {}})
            .run(std::min(budget, maxMet));
        resolution.isDone = unread.isDone;
        resolution.knots += unread.knots;
        resolution.widestKnot = std::max(resolution.widestKnot, unread.widestKnot);
        resolution.unresolved = unread.unresolved;
    }
    if (resolution.rounds > 0)
        resolution.crumbs = dropCrumbs(surface);
    return resolution;
}

Resolution cutIntersections(TriangleSoup& part, Inside inside, const LeftOut& leftOut, double tolerance,
                            std::uint64_t& budget, const JobControl& control)
{
    constexpr std::size_t exactRounds = 6; // most surfaces need one or two; more rarely help
    Resolution resolution;
    Cutting cutting(part, inside, {{}, {&leftOut.kept, &leftOut.dropped}}, tolerance, resolution, budget, control);
    cutting.setExact(tolerance == 0 ? exactRounds : 0);
    cutting.run(maxPairs);
    return resolution;
}
} // namespace core::repair
