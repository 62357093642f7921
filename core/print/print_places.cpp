#include "core/print/print_places.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/triangle_distance.h"

#include <algorithm>
#include <functional>

namespace core
{
void PrintPlaces::addFace(Slot face, double badness)
{
    const auto& [a, b, c] = m_mesh.triangles[face];
    m_bad.push_back({face, a, badness, normalOf(face).norm(), nullptr, nullptr});
    m_vertices.unite(a, b);
    m_vertices.unite(a, c);
}

void PrintPlaces::addPart(const WallPart& part, double area)
{
    m_bad.push_back({part.face, memberAt(part.face), static_cast<double>(part.least), area, &part, nullptr});
}

void PrintPlaces::addRidge(const WallRidge& ridge)
{
    m_bad.push_back(
        {ridge.face, memberAt(ridge.face), static_cast<double>(ridge.least), ridge.area(), nullptr, &ridge});
}

/// Returns a new element of the disjoint sets, for a part or ridge in a face or at its border.
Slot PrintPlaces::memberAt(Slot face)
{
    m_isAtPart.resize(m_mesh.points.size());
    for (const Slot corner : m_mesh.triangles[face])
        m_isAtPart[corner] = true;
    return static_cast<Slot>(m_mesh.points.size() + m_parts++);
}

Vec3 PrintPlaces::normalOf(Slot face) const
{
    const auto [a, b, c] = core::cornersOf(m_mesh, face);
    return (b - a).cross(c - a) / 2;
}

std::array<Vec3, 3> PrintPlaces::cornersOf(const Bad& bad) const
{
    if (bad.ridge) {
        const auto& [from, to] = bad.ridge->ends;
        return {from.cast<double>(), to.cast<double>(), to.cast<double>()};
    }
    if (!bad.part)
        return core::cornersOf(m_mesh, bad.face);
    const auto& [a, b, c] = bad.part->corners;
    return {a.cast<double>(), b.cast<double>(), c.cast<double>()};
}

Vec3 PrintPlaces::pointOf(const Bad& bad) const
{
    if (bad.part || bad.ridge)
        return (bad.part ? bad.part->thinnest : bad.ridge->thinnest).cast<double>();
    const std::array<Vec3, 3> corners = cornersOf(bad);
    return (corners[0] + corners[1] + corners[2]) / 3;
}

bool PrintPlaces::isAtPart(const Bad& bad) const
{
    return bad.part || bad.ridge ||
           std::ranges::any_of(m_mesh.triangles[bad.face], [this](Slot corner) { return m_isAtPart[corner]; });
}

/// Unites parts, ridges and faces around them that touch. Parts do not share corners with their neighbours as faces do,
/// so they are tested by distance, within the float32 rounding of their corners.
void PrintPlaces::uniteTouching(DisjointSets& sets) const
{
    std::vector<const Bad*> bad;
    std::vector<FaceBox> boxes;
    float farthest = 0;
    for (const Bad& one : m_bad) {
        if (!isAtPart(one))
            continue;
        bad.push_back(&one);
        FaceBox& box = boxes.emplace_back();
        for (const Vec3& corner : cornersOf(one))
            box.extend(corner.cast<float>().array());
        farthest = std::max({farthest, -box.min.minCoeff(), box.max.maxCoeff()});
    }
    const float gap = 4 * std::numeric_limits<float>::epsilon() * farthest;
    for (FaceBox& box : boxes) {
        box.min -= gap;
        box.max += gap;
    }
    const BoxTree tree(boxes);
    for (Slot block = 0; block < tree.blocks(); ++block)
        tree.forEachMeetingPair(block, [&](Slot i, Slot j) {
            const Bad &one = *bad[tree.at(i)], &other = *bad[tree.at(j)];
            const double reach = static_cast<double>(gap);
            if (sets.root(one.member) != sets.root(other.member) &&
                nearestOfTriangles(cornersOf(one), cornersOf(other)).squaredDistance <= reach * reach)
                sets.unite(one.member, other.member);
        });
}

PrintFault PrintPlaces::take()
{
    DisjointSets sets(m_mesh.points.size() + m_parts);
    for (Slot v = 0; v < m_mesh.points.size(); ++v)
        sets.unite(v, m_vertices.root(v));
    if (m_parts > 0)
        uniteTouching(sets);
    PrintFault fault;
    std::vector<const Bad*> worst;
    std::vector<Slot> number(sets.size(), noSlot);
    for (const Bad& bad : m_bad) {
        Slot& place = number[sets.root(bad.member)];
        if (place == noSlot) {
            place = static_cast<Slot>(worst.size());
            worst.push_back(&bad);
            fault.places.emplace_back();
        }
        fault.places[place].area += bad.area;
        fault.area += bad.area;
        if (bad.badness < worst[place]->badness)
            worst[place] = &bad;
    }
    for (std::size_t i = 0; i < worst.size(); ++i) {
        PrintPlace& place = fault.places[i];
        place.face = worst[i]->face;
        place.worst = worst[i]->badness;
        place.point = pointOf(*worst[i]);
        const Vec3 normal = normalOf(place.face);
        place.normal = normal.isZero() ? Vec3::UnitY() : Vec3(normal.normalized());
    }
    fault.count = fault.places.size();
    std::ranges::stable_sort(fault.places, std::greater(), &PrintPlace::area);
    fault.places.resize(std::min(fault.places.size(), PrintFault::maxPlaces));
    return fault;
}
} // namespace core
