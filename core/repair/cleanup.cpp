#include "core/repair/cleanup.h"

#include "core/repair/edge_faces.h"

#include "core/analysis/equal_faces.h"
#include "core/geometry/predicates.h"

#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace core::repair
{
namespace
{
bool repeatsCorner(const Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::size_t dropRepeatedCorners(TriangleSoup& surface)
{
    return std::erase_if(surface.triangles, repeatsCorner);
}

/// Merges corners of one face that are at the same position. A face with two equal corners has no area, whichever
/// corner it loses. Equal points of different faces stay separate.
void joinEqualCorners(TriangleSoup& surface)
{
    std::vector<Slot> to;
    const auto rootOf = [&](Slot v) {
        while (to[v] != v)
            v = to[v] = to[to[v]];
        return v;
    };
    for (const Triangle& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Slot v = t[i], next = t[(i + 1) % 3];
            if (v == next || surface.points[v] != surface.points[next])
                continue;
            if (to.empty()) {
                to.resize(surface.points.size());
                std::iota(to.begin(), to.end(), Slot(0));
            }
            const auto [low, high] = std::minmax({rootOf(v), rootOf(next)});
            to[high] = low;
        }
    if (to.empty())
        return;
    for (Triangle& t : surface.triangles)
        for (Slot& v : t)
            v = rootOf(v);
}

/// Returns 1 if the face's corners are in the cyclic order of the sorted corners, otherwise -1.
int runOf(const Triangle& t)
{
    const Triangle s = sortedCorners(t);
    return (t[0] == s[0] && t[1] == s[1]) || (t[1] == s[0] && t[2] == s[1]) || (t[2] == s[0] && t[0] == s[1]) ? 1 : -1;
}

EqualFaces equalFacesOf(const std::vector<Triangle>& triangles)
{
    std::vector<Slot> all(triangles.size());
    std::iota(all.begin(), all.end(), Slot(0));
    return {triangles, all};
}

std::size_t dropDuplicates(TriangleSoup& surface, Duplicates duplicates)
{
    std::vector<Triangle>& triangles = surface.triangles;
    const EqualFaces equal = equalFacesOf(triangles);
    if (equal.groups() == triangles.size())
        return 0;
    std::vector<bool> goes(triangles.size(), false);
    for (std::size_t i = 0; i < equal.groups(); ++i) {
        const std::span<const Slot> group = equal.group(i);
        if (group.size() == 1)
            continue;
        int net = duplicates == Duplicates::KeepOne ? runOf(triangles[group[0]]) : 0;
        if (duplicates == Duplicates::Cancel)
            for (const Slot face : group)
                net += runOf(triangles[face]);
        for (const Slot face : group) {
            const bool stays = net * runOf(triangles[face]) > 0;
            net -= stays ? runOf(triangles[face]) : 0;
            goes[face] = !stays;
        }
    }
    std::size_t kept = 0;
    for (Slot f = 0; f < triangles.size(); ++f)
        if (!goes[f])
            triangles[kept++] = triangles[f];
    const std::size_t dropped = triangles.size() - kept;
    triangles.resize(kept);
    return dropped;
}

/// Returns the middle one of three collinear corners.
std::size_t middleCorner(const TriangleSoup& surface, const Triangle& t)
{
    std::array<std::int64_t, 3> acrossFrom; // squared length of the side across from each corner
    for (std::size_t i = 0; i < 3; ++i)
        acrossFrom[i] =
            (surface.points[t[(i + 1) % 3]] - surface.points[t[(i + 2) % 3]]).cast<std::int64_t>().squaredNorm();
    return static_cast<std::size_t>(std::ranges::max_element(acrossFrom) - acrossFrom.begin());
}

bool isCollinear(const TriangleSoup& surface, Slot face)
{
    const auto& [a, b, c] = surface.triangles[face];
    return LatticePredicates::collinear(surface.points[a], surface.points[b], surface.points[c]);
}

/// Returns whether the height of the face above its longest side is less than `tolerance`, lattice units.
bool isSliver(const TriangleSoup& surface, Slot face, double tolerance)
{
    const Triangle& t = surface.triangles[face];
    if (repeatsCorner(t))
        return false;
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    const Vec3 u = at(t[1]) - at(t[0]), v = at(t[2]) - at(t[0]);
    const double longest = std::sqrt(std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()}));
    return u.cross(v).norm() < tolerance * longest;
}

/// Merges points of these faces that are within the tolerance of each other into the first of them. Returns whether any
/// was merged.
bool mergeNearPoints(TriangleSoup& surface, std::span<const Slot> faces, double tolerance)
{
    std::vector<Slot> points;
    for (const Slot f : faces)
        points.insert(points.end(), surface.triangles[f].begin(), surface.triangles[f].end());
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Slot> to(surface.points.size());
    std::iota(to.begin(), to.end(), Slot(0));
    std::map<std::array<int, 3>, std::vector<Slot>> kept; ///< remaining points, by grid cell
    const int cell = static_cast<int>(std::ceil(tolerance));
    for (const Slot v : points) {
        const LatticePoint& p = surface.points[v];
        std::array<int, 3> home;
        for (int axis = 0; axis < 3; ++axis)
            home[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(p[axis] / static_cast<double>(cell)));
        for (int i = 0; i < 27 && to[v] == v; ++i) {
            const auto found = kept.find({home[0] + i % 3 - 1, home[1] + i / 3 % 3 - 1, home[2] + i / 9 - 1});
            if (found == kept.end())
                continue;
            for (const Slot other : found->second)
                if ((surface.points[other] - p).cast<double>().norm() <= tolerance)
                    to[v] = other;
        }
        if (to[v] == v)
            kept[home].push_back(v);
    }
    bool isAnyMerged = false;
    for (const Slot v : points)
        isAnyMerged |= to[v] != v;
    if (!isAnyMerged)
        return false;
    for (Triangle& t : surface.triangles)
        for (Slot& v : t)
            v = to[v];
    return true;
}

/// Returns the faces at each edge whose ends are both in `isMeant`, in the form of edgeFacesOf().
std::vector<EdgeFace> edgeFacesBetween(const std::vector<bool>& isMeant, std::span<const Triangle> triangles)
{
    std::vector<EdgeFace> edges;
    for (Slot f = 0; f < triangles.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
            const Slot from = triangles[f][i], to = triangles[f][(i + 1) % 3];
            if (isMeant[from] && isMeant[to])
                edges.push_back({std::min(from, to), std::max(from, to), f, from < to});
        }
    std::ranges::sort(edges, {}, [](const EdgeFace& e) { return std::tuple(e.low, e.high, e.face); });
    return edges;
}

/// Flips the longest edge of each flat face, each face at most once. Without a face across that edge the flat face is
/// removed. Returns the number of flat faces, including those that must wait for the next round.
std::size_t giveMiddlesAway(TriangleSoup& surface, const std::function<bool(Slot face)>& isFlat)
{
    std::vector<Triangle>& triangles = surface.triangles;
    std::vector<Slot> flat;
    for (Slot f = 0; f < triangles.size(); ++f)
        if (isFlat(f))
            flat.push_back(f);
    if (flat.empty())
        return 0;
    std::vector<bool> isCorner(surface.points.size(), false);
    for (const Slot f : flat)
        for (const Slot v : triangles[f])
            isCorner[v] = true;
    const std::vector<EdgeFace> edges = edgeFacesBetween(isCorner, triangles);
    std::vector<bool> isTouched(triangles.size(), false);
    for (const Slot f : flat) {
        const Triangle t = triangles[f];
        const std::size_t middle = middleCorner(surface, t);
        const Slot from = t[(middle + 1) % 3], b = t[middle], to = t[(middle + 2) % 3]; // the longest side, from -> to
        const auto [first, last] =
            std::ranges::equal_range(edges, std::pair(std::min(from, to), std::max(from, to)), {},
                                     [](const EdgeFace& e) { return std::pair(e.low, e.high); });
        if (isTouched[f])
            continue;
        const auto across = std::find_if(first, last, [&](const EdgeFace& e) {
            return e.face != f && e.forward != (from < to) && !isTouched[e.face] && !repeatsCorner(triangles[e.face]);
        });
        const bool mustWait = across == last && std::any_of(first, last, [&](const EdgeFace& e) {
                                  return e.face != f && isTouched[e.face];
                              });
        if (mustWait)
            continue;
        isTouched[f] = true;
        if (across == last) {
            triangles[f] = {b, b, b};
            continue;
        }
        isTouched[across->face] = true;
        const Slot apex = across->apex(triangles[across->face]); // the face across runs along this side as to -> from
        triangles[f] = {to, b, apex};
        triangles[across->face] = {b, from, apex};
    }
    return flat.size();
}

} // namespace

std::size_t weld(TriangleSoup& surface)
{
    std::vector<Slot> order(surface.points.size());
    std::iota(order.begin(), order.end(), Slot(0));
    const auto key = [&](Slot v) {
        const LatticePoint& p = surface.points[v];
        return std::tuple(p.x(), p.y(), p.z(), v);
    };
    std::ranges::sort(order, {}, key);
    std::vector<Slot> first(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool isSame = i > 0 && surface.points[order[i]] == surface.points[order[i - 1]];
        first[order[i]] = isSame ? first[order[i - 1]] : order[i];
    }
    std::vector<bool> isUsed(order.size(), false);
    std::vector<bool> isMerged(order.size(), false);
    for (Triangle& t : surface.triangles) {
        for (Slot& v : t) {
            isMerged[v] = first[v] != v;
            v = first[v];
            isUsed[v] = true;
        }
    }
    TriangleSoup result;
    std::vector<Slot> newSlot(order.size(), noSlot);
    for (Slot v = 0; v < order.size(); ++v) {
        if (!isUsed[v])
            continue;
        newSlot[v] = static_cast<Slot>(result.points.size());
        result.points.push_back(surface.points[v]);
        if (!surface.colors.empty())
            result.colors.push_back(surface.colors[v]);
    }
    for (Triangle& t : surface.triangles)
        for (Slot& v : t)
            v = newSlot[v];
    surface.points = std::move(result.points);
    surface.colors = std::move(result.colors);
    return static_cast<std::size_t>(std::ranges::count(isMerged, true));
}

CleanupResult cleanUp(TriangleSoup& surface, Duplicates duplicates)
{
    constexpr int maxRounds = 1000; // enough, because every round moves middle corners closer to faces with area
    CleanupResult cleaned;
    bool isFirst = true;
    for (int round = 0; round < maxRounds; ++round) {
        joinEqualCorners(surface);
        const std::size_t dropped = dropRepeatedCorners(surface);
        cleaned.degenerate += isFirst ? dropped : 0;
        cleaned.duplicates += dropDuplicates(surface, duplicates);
        const std::size_t flat = giveMiddlesAway(surface, [&](Slot f) { return isCollinear(surface, f); });
        cleaned.degenerate += isFirst ? flat : 0;
        isFirst = false;
        if (flat == 0)
            return cleaned;
    }
    std::erase_if(surface.triangles, [&](const Triangle& t) {
        return LatticePredicates::collinear(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
    });
    return cleaned;
}

bool hasDoubles(const TriangleSoup& surface)
{
    return equalFacesOf(surface.triangles).groups() < surface.triangles.size();
}

bool removeSlivers(TriangleSoup& surface, std::span<const Slot> faces, double tolerance)
{
    bool isChanged = mergeNearPoints(surface, faces, tolerance);
    std::vector<bool> isMeant(surface.triangles.size(), false);
    for (const Slot f : faces)
        isMeant[f] = true;
    const auto isMeantSliver = [&](Slot f) { return isMeant[f] && isSliver(surface, f, tolerance); };
    constexpr int maxRounds = 30; // enough, because every round shortens edges
    for (int round = 0; round < maxRounds && giveMiddlesAway(surface, isMeantSliver) > 0; ++round)
        isChanged = true;
    if (isChanged)
        cleanUp(surface, Duplicates::Cancel);
    return isChanged;
}
} // namespace core::repair
