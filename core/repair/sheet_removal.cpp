#include "core/repair/sheet_removal.h"

#include "core/repair/edge_faces.h"
#include "core/repair/hole_filling.h"

#include "core/analysis/surface_distance.h"
#include "core/analysis/winding_number.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/rectangle_around.h"
#include "core/util/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace core::repair
{
namespace
{
using Faces = std::vector<Slot>;

/// Returns the parts connected by edges of two faces that have an open edge, in the order of their first faces.
std::vector<Faces> openParts(const TriangleSoup& surface)
{
    DisjointSets sets(surface.triangles.size());
    std::vector<Slot> open;
    forEachEdge(surface.triangles, [&](std::span<const EdgeFace> around) {
        if (around.size() == 2)
            sets.unite(around[0].face, around[1].face);
        if (around.size() == 1)
            open.push_back(around[0].face);
    });
    std::map<Slot, Faces> parts;
    for (const Slot f : open)
        parts[sets.root(f)];
    for (Slot f = 0; f < surface.triangles.size(); ++f)
        if (const auto part = parts.find(sets.root(f)); part != parts.end())
            part->second.push_back(f);
    std::vector<Faces> result;
    for (auto& [root, faces] : parts)
        result.push_back(std::move(faces));
    std::ranges::sort(result, {}, [](const Faces& faces) { return faces[0]; });
    return result;
}

TriangleSoup partOf(const TriangleSoup& surface, const Faces& faces)
{
    TriangleSoup part;
    std::map<Slot, Slot> slots;
    for (const Slot f : faces) {
        Triangle t = surface.triangles[f];
        for (Slot& v : t) {
            const auto [entry, isNew] = slots.try_emplace(v, static_cast<Slot>(part.points.size()));
            if (isNew)
                part.points.push_back(surface.points[v]);
            v = entry->second;
        }
        part.triangles.push_back(t);
    }
    return part;
}

struct Extent
{
    double area = 0, volume = 0;
};

Extent extentOf(const TriangleSoup& part)
{
    const Vec3 origin = part.points[part.triangles[0][0]].cast<double>();
    double twiceArea = 0, sixVolumes = 0;
    for (const Triangle& t : part.triangles) {
        const auto at = [&](std::size_t i) { return Vec3(part.points[t[i]].cast<double>() - origin); };
        twiceArea += (at(1) - at(0)).cross(at(2) - at(0)).norm();
        sixVolumes += at(0).dot(at(1).cross(at(2)));
    }
    return {twiceArea / 2, std::abs(sixVolumes / 6)};
}

/// Returns whether the volume is less than a tenth of that of the ball with the same area.
bool isFlat(const Extent& extent)
{
    constexpr double ofBall = 0.1;
    const double ballVolume = extent.area * std::sqrt(extent.area) / (6 * std::sqrt(std::numbers::pi));
    return extent.volume < ofBall * ballVolume;
}

constexpr double minShare = 0.25; ///< part of a whole winding number by which others need a part

/// Returns the mean, by area, of measure(middle, face) at about 64 of these faces. `face`: a span of one.
template <typename Measure>
double meanOver(std::span<const Triangle> triangles, std::span<const Vec3> points, std::span<const Slot> faces,
                Measure measure)
{
    constexpr std::size_t samples = 64;
    const std::size_t step = faces.size() / samples | 1; // odd, because rows of grids often have a power of two
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < faces.size(); i += step) {
        const auto& [a, b, c] = triangles[faces[i]];
        const double share = (points[b] - points[a]).cross(points[c] - points[a]).norm();
        sum += share * measure((points[a] + points[b] + points[c]) / 3, faces.subspan(i, 1));
        area += share;
    }
    return area > 0 ? sum / area : 0;
}

double fromWhole(double winding)
{
    return std::abs(winding - std::round(winding));
}

/// Returns the mean distance of the other faces' winding number at a part from a whole number. It is a half if the
/// others need the part to be closed. It is 0 if the part is entirely outside, in a void or in the matter.
double closingShare(const TriangleSoup& surface, std::span<const Vec3> points, const WindingNumber& winding,
                    const Faces& part)
{
    return meanOver(surface.triangles, points, part,
                    [&](const Vec3& p, std::span<const Slot> face) { return fromWhole(winding.at(p, face)); });
}

struct Candidate
{
    Faces faces;
    double volume; ///< volume that it would have if it were closed
};
using Candidates = std::vector<Candidate>;

/// Adds to `removed` a sheet of a surface with the area `wholeArea`.
void add(const TriangleSoup& surface, const Candidate& sheet, double wholeArea, SheetRemoval& removed)
{
    constexpr double large = 0.01; // share of the whole area
    const TriangleSoup part = partOf(surface, sheet.faces);
    ++removed.sheets;
    removed.volume += sheet.volume;
    if (extentOf(part).area >= large * wholeArea)
        for (const Slot f : sheet.faces)
            removed.largeOnes.push_back(surface.triangles[f]);
    const Rectangle rectangle = rectangleAround(part.places());
    if (rectangle.length * rectangle.width >= removed.length * removed.width) {
        removed.length = rectangle.length;
        removed.width = rectangle.width;
    }
}

/// Removes `parts` from the surface, and renumbers the faces of `others`.
void drop(TriangleSoup& surface, std::span<const Candidate> parts, std::span<Candidate> others)
{
    std::vector<bool> goes(surface.triangles.size(), false);
    for (const Candidate& part : parts)
        for (const Slot f : part.faces)
            goes[f] = true;
    std::vector<Slot> newSlot(surface.triangles.size(), noSlot);
    Slot kept = 0;
    for (Slot f = 0; f < surface.triangles.size(); ++f)
        if (!goes[f]) {
            newSlot[f] = kept;
            surface.triangles[kept++] = surface.triangles[f];
        }
    surface.triangles.resize(kept);
    for (Candidate& part : others)
        for (Slot& f : part.faces)
            f = newSlot[f];
}

/// Returns groups of parts, by their index, that are linked by nearness: boxes of parts, each enlarged on all sides by
/// a third of its longest side, meet. Cost: O(pairs of boxes that meet).
std::vector<std::vector<Slot>> groupsOf(const TriangleSoup& surface, std::span<const Faces> parts)
{
    constexpr float reach = 1.0F / 3;
    std::vector<FaceBox> boxes(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const Slot f : parts[i])
            for (const Slot v : surface.triangles[f])
                boxes[i].extend(surface.points[v].cast<float>().array());
        const float margin = reach * (boxes[i].max - boxes[i].min).maxCoeff();
        boxes[i].min -= margin;
        boxes[i].max += margin;
    }
    const BoxTree tree(boxes);
    DisjointSets sets(parts.size());
    for (Slot i = 0; i < parts.size(); ++i)
        tree.forEachMeeting(boxes[i], [&](Slot position) { sets.unite(i, tree.at(position)); });
    std::map<Slot, std::vector<Slot>> groups;
    for (Slot i = 0; i < parts.size(); ++i)
        groups[sets.root(i)].push_back(i);
    std::vector<std::vector<Slot>> result;
    for (auto& [root, group] : groups)
        result.push_back(std::move(group));
    return result;
}

/// Returns for each of these parts the sum of the absolute values of the others' mean winding numbers at it. Where
/// sheets cross, each winds around half of the other from its front and half from behind, so the mean is about 0. Cost:
/// O(square of the parts).
std::vector<double> sumsOfMeans(const TriangleSoup& surface, std::span<const Vec3> points, std::span<const Faces> parts,
                                const JobControl& control)
{
    std::vector<double> sums(parts.size(), 0);
    for (std::size_t i = 0; i < parts.size() && !control.isCancelled(); ++i) {
        const TriangleSoup alone = partOf(surface, parts[i]);
        const WindingNumber winding(alone.places(), alone.triangles);
        for (std::size_t k = 0; k < parts.size(); ++k)
            if (k != i)
                sums[k] += std::abs(meanOver(surface.triangles, points, parts[k],
                                             [&](const Vec3& p, std::span<const Slot>) { return winding.at(p); }));
    }
    return sums;
}

/// The parts of a surface that have an open edge.
class OpenParts
{
public:
    /// `points`: those of the surface. `winding`: its winding number. Keeps references.
    OpenParts(const TriangleSoup& surface, std::span<const Vec3> points, const WindingNumber& winding)
        : m_surface(surface)
        , m_points(points)
        , m_winding(winding)
        , m_parts(openParts(surface))
    {
        std::vector<bool> isOpen(surface.triangles.size(), false);
        for (const Faces& part : m_parts)
            for (const Slot f : part)
                isOpen[f] = true;
        std::vector<Triangle> rest;
        for (Slot f = 0; f < surface.triangles.size(); ++f)
            if (!isOpen[f])
                rest.push_back(surface.triangles[f]);
        if (!rest.empty())
            m_rest.emplace(points, rest);
    }

    /// Moves to the end the candidates that only seem to be needed, as sheets that cross do, and returns the first of
    /// them: all open parts near such a part are candidates, their winding numbers at it are 0 on average, so is that
    /// of all open parts together, and the faces in no open part are closed there.
    Candidates::iterator moveFreeToEnd(Candidates& candidates, const JobControl& control) const
    {
        constexpr std::size_t most = 100; // parts of a group
        if (m_parts.empty())              // sheets that went may have left others closed
            return candidates.end();
        std::vector<std::size_t> sizes(m_surface.triangles.size(), 0); // of candidates, by the first face
        std::vector<bool> isFree(m_surface.triangles.size(), false);   // by the first face
        for (const Candidate& candidate : candidates)
            sizes[candidate.faces[0]] = candidate.faces.size();
        const auto isCandidate = [&](Slot part) { return sizes[m_parts[part][0]] == m_parts[part].size(); };
        for (const std::vector<Slot>& group : groupsOf(m_surface, m_parts)) {
            if (control.isCancelled())
                return candidates.end();
            if (group.size() > most || !std::ranges::all_of(group, isCandidate))
                continue;
            std::vector<Faces> members;
            for (const Slot i : group)
                members.push_back(m_parts[i]);
            const std::vector<double> sums = sumsOfMeans(m_surface, m_points, members, control);
            if (control.isCancelled())
                return candidates.end();
            for (std::size_t i = 0; i < members.size(); ++i)
                isFree[members[i][0]] = sums[i] <= minShare && std::abs(meanOfOpenAt(members[i])) <= minShare &&
                                        restFromWholeAt(members[i]) <= minShare;
        }
        return std::stable_partition(candidates.begin(), candidates.end(),
                                     [&](const Candidate& candidate) { return !isFree[candidate.faces[0]]; });
    }

private:
    /// Returns the mean winding number of the other open parts at one of them.
    double meanOfOpenAt(const Faces& part) const
    {
        return meanOver(m_surface.triangles, m_points, part, [&](const Vec3& p, std::span<const Slot> face) {
            return m_winding.at(p, face) - (m_rest ? m_rest->at(p) : 0);
        });
    }

    /// Returns the mean distance from a whole number of the winding number of the faces in no open part.
    double restFromWholeAt(const Faces& part) const
    {
        return meanOver(m_surface.triangles, m_points, part,
                        [&](const Vec3& p, std::span<const Slot>) { return m_rest ? fromWhole(m_rest->at(p)) : 0; });
    }

    const TriangleSoup& m_surface;
    std::span<const Vec3> m_points;
    const WindingNumber& m_winding;
    std::vector<Faces> m_parts;
    std::optional<WindingNumber> m_rest; ///< of the faces in no open part, which need not be closed
};

/// Returns whether a part is in one plane within this distance.
bool isPlane(const TriangleSoup& part, double within)
{
    const std::vector<Vec3> points = part.places();
    Vec3 normal = Vec3::Zero();
    for (const auto& [a, b, c] : part.triangles)
        normal += (points[b] - points[a]).cross(points[c] - points[a]);
    normal.normalize();
    return std::ranges::all_of(points, [&](const Vec3& p) { return std::abs(normal.dot(p - points[0])) <= within; });
}

/// Returns about 250 points of a part, spread by area.
std::vector<Vec3> pointsOf(const TriangleSoup& part)
{
    constexpr double count = 250;
    const std::vector<Vec3> corners = part.places();
    const double ofArea = count / extentOf(part).area;
    std::vector<Vec3> points;
    double due = 0; // points that the faces so far have too few
    for (const auto& [a, b, c] : part.triangles) {
        const Vec3 ab = corners[b] - corners[a], ac = corners[c] - corners[a];
        due += ofArea * ab.cross(ac).norm() / 2;
        const auto rows = static_cast<int>((std::sqrt(8 * due + 1) - 1) / 2);
        for (int i = 0; i < rows; ++i)
            for (int k = 0; i + k < rows; ++k)
                points.push_back(corners[a] + (i + 1.0 / 3) / rows * ab + (k + 1.0 / 3) / rows * ac);
        due -= rows * (rows + 1) / 2;
    }
    return points;
}

/// Plane sheets on openings. The filled openings are in the same place, so a solid needs them only once.
class OpeningSheets
{
public:
    /// Keeps references.
    OpeningSheets(const TriangleSoup& surface, const WindingNumber& winding, const JobControl& control)
        : m_surface(surface)
        , m_winding(winding)
        , m_control(control)
    {}

    /// Moves plane sheets to the end that lie on the other faces once their holes are filled, and returns the first of
    /// them. They may stick out where the winding number of the other faces is nearly a whole number.
    Candidates::iterator moveToEnd(Candidates& candidates) const
    {
        constexpr int attempts = 5; // each leaves out fewer sheets; two or three suffice
        auto first = std::stable_partition(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
            const TriangleSoup sheet = partOf(m_surface, candidate.faces);
            return !isPlane(sheet, reachOf(sheet));
        });
        for (int i = 0; i < attempts && first != candidates.end() && !m_control.isCancelled(); ++i) {
            const std::set<Slot> onOthers = sheetsOnOthers({first, candidates.end()});
            const auto next = std::stable_partition(first, candidates.end(), [&](const Candidate& candidate) {
                return !onOthers.contains(candidate.faces[0]);
            });
            if (next == first)
                return first;
            first = next;
        }
        return candidates.end();
    }

private:
    /// Returns the distance within which a sheet is taken for plane, and for lying on others.
    static double reachOf(const TriangleSoup& sheet)
    {
        constexpr double ofWidth = 1e-3;
        return ofWidth * rectangleAround(sheet.places()).width;
    }

    /// Returns the first faces of those sheets that lie on the surface without all of them, once its holes are filled.
    std::set<Slot> sheetsOnOthers(std::span<const Candidate> sheets) const
    {
        constexpr double maxBeside = 0.02; // share of a sheet's points
        std::set<Slot> result;
        const TriangleMesh others = filledWithout(sheets);
        if (others.triangles.empty())
            return result;
        std::vector<Vec3f> points;
        std::vector<std::size_t> ends; // of each sheet's points
        for (const Candidate& sheet : sheets) {
            for (const Vec3& p : pointsOf(partOf(m_surface, sheet.faces)))
                points.push_back(p.cast<float>());
            ends.push_back(points.size());
        }
        const std::vector<float> distances = distancesTo(others, points, {m_control.stop, {}});
        for (std::size_t i = 0, at = 0; i < sheets.size() && !m_control.isCancelled(); ++i) {
            const std::size_t first = at;
            const auto reach = static_cast<float>(reachOf(partOf(m_surface, sheets[i].faces)));
            std::size_t beside = 0;
            for (; at < ends[i]; ++at)
                if (distances[at] > reach &&
                    fromWhole(m_winding.at(points[at].cast<double>(), sheets[i].faces)) > minShare)
                    ++beside;
            if (static_cast<double>(beside) <= maxBeside * static_cast<double>(at - first))
                result.insert(sheets[i].faces[0]);
        }
        return result;
    }

    /// Returns the surface without these parts once its holes are filled, in lattice units.
    TriangleMesh filledWithout(std::span<const Candidate> parts) const
    {
        TriangleSoup others = m_surface;
        drop(others, parts, {});
        fillHoles(others, true, Covering::Avoided, m_control);
        TriangleMesh mesh;
        for (const LatticePoint& p : others.points)
            mesh.points.push_back(p.cast<float>());
        mesh.triangles = std::move(others.triangles);
        return mesh;
    }

    const TriangleSoup& m_surface;
    const WindingNumber& m_winding;
    const JobControl& m_control;
};
} // namespace

SheetRemoval removeSheets(TriangleSoup& surface, const JobControl& control)
{
    constexpr double maxFilled = 0.75;
    SheetRemoval removed;
    Candidates candidates;
    for (Faces& faces : openParts(surface)) {
        if (control.isCancelled())
            return removed;
        TriangleSoup part = partOf(surface, faces);
        const bool isOpen = fillHoles(part, true, Covering::Allowed, control).share > maxFilled;
        if (const Extent extent = extentOf(part); isOpen && isFlat(extent))
            candidates.push_back({std::move(faces), extent.volume});
    }
    const double wholeArea = surface.triangles.empty() ? 0 : extentOf(surface).area;
    // Repeated, because sheets change the winding numbers at other sheets
    while (!candidates.empty() && !control.isCancelled()) {
        const std::vector<Vec3> points = surface.places();
        const WindingNumber winding(points, surface.triangles);
        const auto isNeeded = [&](const Candidate& candidate) {
            return closingShare(surface, points, winding, candidate.faces) > minShare;
        };
        auto sheets = std::stable_partition(candidates.begin(), candidates.end(), isNeeded);
        if (sheets == candidates.end())
            sheets = OpenParts(surface, points, winding).moveFreeToEnd(candidates, control);
        if (sheets == candidates.end())
            sheets = OpeningSheets(surface, winding, control).moveToEnd(candidates);
        if (sheets == candidates.end())
            break;
        for (auto sheet = sheets; sheet != candidates.end(); ++sheet)
            add(surface, *sheet, wholeArea, removed);
        drop(surface, {sheets, candidates.end()}, {candidates.begin(), sheets});
        candidates.erase(sheets, candidates.end());
    }
    return removed;
}
} // namespace core::repair
