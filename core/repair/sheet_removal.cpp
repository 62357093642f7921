#include "core/repair/sheet_removal.h"

#include "core/repair/edge_faces.h"
#include "core/repair/hole_filling.h"

#include "core/analysis/winding_number.h"
#include "core/geometry/rectangle_around.h"
#include "core/util/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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

/// Returns, averaged over the area of some of these faces, the distance of the other faces' winding number from a whole
/// number. It is a half if the others need these faces to be closed. It is 0 if these faces are entirely outside, in a
/// void or in the matter.
double closingShare(const TriangleSoup& surface, std::span<const Vec3> points, const WindingNumber& winding,
                    const Faces& faces)
{
    constexpr std::size_t samples = 64;
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < faces.size(); i += std::max<std::size_t>(1, faces.size() / samples)) {
        const Triangle& t = surface.triangles[faces[i]];
        const double share = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
        const Vec3 middle = (points[t[0]] + points[t[1]] + points[t[2]]) / 3;
        const double others = winding.at(middle, std::span(faces).subspan(i, 1));
        sum += share * std::abs(others - std::round(others));
        area += share;
    }
    return area > 0 ? sum / area : 0;
}

struct Candidate
{
    Faces faces;
    double volume; ///< volume that it would have if it were closed
};

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
} // namespace

SheetRemoval removeSheets(TriangleSoup& surface, const JobControl& control)
{
    constexpr double maxFilled = 0.75, minShare = 0.25;
    SheetRemoval removed;
    std::vector<Candidate> candidates;
    for (Faces& faces : openParts(surface)) {
        if (control.isCancelled())
            return removed;
        TriangleSoup part = partOf(surface, faces);
        const bool isOpen = fillHoles(part, true, control).share > maxFilled;
        if (const Extent extent = extentOf(part); isOpen && isFlat(extent))
            candidates.push_back({std::move(faces), extent.volume});
    }
    const double wholeArea = surface.triangles.empty() ? 0 : extentOf(surface).area;
    bool doAnyGo = true;
    // Repeated, because sheets change the winding numbers at other sheets
    while (doAnyGo && !candidates.empty() && !control.isCancelled()) {
        const std::vector<Vec3> points = surface.places();
        const WindingNumber winding(points, surface.triangles);
        const auto isNeeded = [&](const Candidate& candidate) {
            return closingShare(surface, points, winding, candidate.faces) > minShare;
        };
        const auto sheets = std::stable_partition(candidates.begin(), candidates.end(), isNeeded);
        for (auto sheet = sheets; sheet != candidates.end(); ++sheet)
            add(surface, *sheet, wholeArea, removed);
        drop(surface, {sheets, candidates.end()}, {candidates.begin(), sheets});
        doAnyGo = sheets != candidates.end();
        candidates.erase(sheets, candidates.end());
    }
    return removed;
}
} // namespace core::repair
