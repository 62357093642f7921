#include "core/operations/cut_pieces.h"

#include "core/analysis/solid_angles.h"
#include "core/area/area_test.h"
#include "core/area/sightlines.h"
#include "core/util/parallel.h"

#include <atomic>
#include <cmath>
#include <numeric>

namespace core
{
namespace
{
constexpr std::size_t facesPerChunk = 1 << 9;

/// Disjoint sets of slots.
class Sets
{
public:
    explicit Sets(std::size_t slots) : m_parents(slots) { std::iota(m_parents.begin(), m_parents.end(), Slot(0)); }

    Slot find(Slot slot)
    {
        while (m_parents[slot] != slot)
            slot = m_parents[slot] = m_parents[m_parents[slot]];
        return slot;
    }
    void join(Slot a, Slot b) { m_parents[find(a)] = find(b); }

private:
    std::vector<Slot> m_parents;
};

/// The pieces as seen: which of them are covered by others.
class Cover
{
public:
    Cover(const ViewArea& area, std::span<const Vec3f> points, const std::vector<Triangle>& faces,
          const std::vector<Slot>& pieces, std::size_t count)
        : m_area(area)
        , m_test(area)
        , m_points(points)
        , m_pieces(pieces)
        , m_lines(points, faces)
        , m_isCovered(count)
        , m_nearest(count, std::numeric_limits<double>::infinity())
    {}

    /// Looks from the faces. Pieces whose faces have no point in the area are judged from points on the cut.
    std::vector<bool> seenFirst(std::span<const std::pair<Vec3, Slot>> onCut);

private:
    void look(const Vec3& p, Slot piece, Symmetry mirror, std::vector<double>& nearest);
    void look(Slot face, std::vector<double>& nearest);

    const ViewArea& m_area;
    AreaTest m_test;
    std::span<const Vec3f> m_points;
    const std::vector<Slot>& m_pieces; ///< piece of each face
    Sightlines m_lines;
    std::vector<std::atomic<bool>> m_isCovered;
    std::vector<double> m_nearest; ///< depth of each piece's nearest point
};

/// Looks from a point of a piece to the eye and away from it. `mirror`: the plane about which the view is mirrored.
void Cover::look(const Vec3& p, Slot piece, Symmetry mirror, std::vector<double>& nearest)
{
    const bool isMirrored = mirror != Symmetry::None;
    const Vec3 image = isMirrored ? mirrored(p, mirror) : p;
    Vec3 way = m_test.sight().towardEye(image);
    if (isMirrored)
        way = mirrored(way, mirror);
    constexpr double endless = std::numeric_limits<double>::infinity();
    nearest[piece] = std::min(nearest[piece], m_test.sight().seen(image).z());
    const bool isBehind = m_lines.anyMet(p, way, m_test.sight().isPerspective() ? 1 : endless,
                                         [&](Slot face) { return m_pieces[face] != piece; });
    if (isBehind)
        m_isCovered[piece] = true;
    m_lines.anyMet(p, -way, endless, [&](Slot face) {
        if (m_pieces[face] != piece)
            m_isCovered[m_pieces[face]] = true;
        return false;
    });
}

void Cover::look(Slot face, std::vector<double>& nearest)
{
    const Triangle& corners = m_lines.corners(face);
    const auto at = [&](std::size_t i) -> Vec3 { return m_points[corners[i]].cast<double>(); };
    const bool isSymmetric = m_area.symmetry != Symmetry::None;
    for (const Vec3& p : {at(0), Vec3((at(0) + at(1) + at(2)) / 3)}) {
        const bool isWithin = m_test.isWithin(p);
        const bool isImageWithin = isSymmetric && m_test.isWithin(mirrored(p, m_area.symmetry));
        const bool isOutside = m_area.side == ViewArea::Side::Outside && !isWithin && !isImageWithin;
        const bool isInside = m_area.side == ViewArea::Side::Inside;
        if ((isInside && isWithin) || isOutside)
            look(p, m_pieces[face], Symmetry::None, nearest);
        if ((isInside && isImageWithin) || (isOutside && isSymmetric))
            look(p, m_pieces[face], m_area.symmetry, nearest);
    }
}

std::vector<bool> Cover::seenFirst(std::span<const std::pair<Vec3, Slot>> onCut)
{
    std::vector<std::vector<double>> nearest(chunksOf(m_pieces.size(), facesPerChunk), m_nearest);
    forEachChunk(m_pieces.size(), facesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (auto face = static_cast<Slot>(begin); face < end; ++face)
            look(face, nearest[chunk]);
    });
    for (const auto& depths : nearest)
        for (std::size_t piece = 0; piece < depths.size(); ++piece)
            m_nearest[piece] = std::min(m_nearest[piece], depths[piece]);
    std::vector<double> nearestOnCut = m_nearest;
    for (const auto& [p, piece] : onCut) {
        if (!std::isinf(m_nearest[piece]))
            continue;
        look(p, piece, Symmetry::None, nearestOnCut);
        if (m_area.symmetry != Symmetry::None)
            look(p, piece, m_area.symmetry, nearestOnCut);
    }
    m_nearest = nearestOnCut;
    std::vector<bool> isFirst(m_isCovered.size()); // numbers that joinVoids() has freed have no nearest point
    for (std::size_t piece = 0; piece < isFirst.size(); ++piece)
        isFirst[piece] = !m_isCovered[piece] && !std::isinf(m_nearest[piece]);
    if (std::ranges::find(isFirst, true) == isFirst.end()) {
        const double least = *std::ranges::min_element(m_nearest);
        for (std::size_t piece = 0; piece < isFirst.size(); ++piece)
            isFirst[piece] = m_nearest[piece] == least;
    }
    return isFirst;
}
std::vector<Vec3> middlesOf(const TriangleMesh& mesh)
{
    std::vector<Vec3> middles;
    for (const auto& [a, b, c] : mesh.triangles)
        middles.emplace_back(
            (mesh.points[a].cast<double>() + mesh.points[b].cast<double>() + mesh.points[c].cast<double>()) / 3);
    return middles;
}

/// Returns whether a closed boundary goes around a surface, given by points of it. Some of them may be on the boundary.
bool isAround(const TriangleMesh& boundary, const std::vector<Vec3>& surface)
{
    constexpr double inside = 0.75; // seen from a point on it, the boundary fills about half of the sphere
    std::vector<Vec3> points;
    for (const Vec3f& p : boundary.points)
        points.push_back(p.cast<double>());
    const SolidAngles angles(points, boundary.triangles);
    return std::ranges::any_of(surface, [&](const Vec3& p) { return angles.at(p) > inside; });
}
} // namespace

CutPieces::CutPieces(const Mesh& mesh, const Surgery& whole) : m_mesh(mesh), m_whole(whole)
{
    join();
    joinVoids();
}

Slot CutPieces::keyOf(Slot corner) const
{
    return Surgery::isNew(corner) ? static_cast<Slot>(m_mesh.slots().vertices + Surgery::newIndex(corner)) : corner;
}

/// Numbers the sets of exchanged faces that are connected by vertices.
void CutPieces::join()
{
    const std::size_t keys = m_mesh.slots().vertices + m_whole.vertices.size();
    Sets sets(keys);
    std::vector<Slot> exchanged;
    const auto add = [&](const Triangle& t) {
        sets.join(keyOf(t[0]), keyOf(t[1]));
        sets.join(keyOf(t[0]), keyOf(t[2]));
        for (const Slot corner : t)
            exchanged.push_back(keyOf(corner));
    };
    for (const Slot f : m_whole.removed)
        add(m_mesh.corners(f));
    for (const Triangle& t : m_whole.faces)
        add(t);
    std::vector<Slot> number(keys, noSlot);
    m_pieceOf.assign(keys, noSlot);
    for (const Slot key : exchanged) {
        Slot& piece = number[sets.find(key)];
        if (piece == noSlot)
            piece = static_cast<Slot>(m_count++);
        m_pieceOf[key] = piece;
    }
}

/// Returns the closed boundary of a piece: its removed faces, and its new ones turned over.
TriangleMesh CutPieces::boundaryOf(Slot piece) const
{
    TriangleMesh boundary;
    std::vector<Slot> index(m_pieceOf.size(), noSlot);
    const auto cornerOf = [&](Slot corner) {
        Slot& at = index[keyOf(corner)];
        if (at == noSlot) {
            at = static_cast<Slot>(boundary.points.size());
            boundary.points.push_back(Surgery::isNew(corner) ? m_whole.vertices[Surgery::newIndex(corner)].point
                                                             : m_mesh.point(corner));
        }
        return at;
    };
    const auto add = [&](Slot a, Slot b, Slot c) {
        if (m_pieceOf[keyOf(a)] == piece)
            boundary.triangles.push_back({cornerOf(a), cornerOf(b), cornerOf(c)});
    };
    for (const Slot f : m_whole.removed)
        add(m_mesh.corners(f)[0], m_mesh.corners(f)[1], m_mesh.corners(f)[2]);
    for (const auto& [a, b, c] : m_whole.faces)
        add(a, c, b);
    return boundary;
}

/// Joins each void with the smallest piece around it. The boundary of a void has a negative volume. What a hole of the
/// area leaves of the piece is such a void, too; its ends are on the piece's boundary.
void CutPieces::joinVoids()
{
    std::vector<double> volumes(m_count); // 6 times
    const Vec3 from = m_mesh.point(m_whole.nearby).cast<double>();
    const auto at = [&](Slot corner) -> Vec3 {
        const Vec3f& p =
            Surgery::isNew(corner) ? m_whole.vertices[Surgery::newIndex(corner)].point : m_mesh.point(corner);
        return p.cast<double>() - from;
    };
    const auto add = [&](const Triangle& t, double sign) {
        volumes[m_pieceOf[keyOf(t[0])]] += sign * at(t[0]).cross(at(t[1])).dot(at(t[2]));
    };
    for (const Slot f : m_whole.removed)
        add(m_mesh.corners(f), 1);
    for (const Triangle& t : m_whole.faces)
        add(t, -1);
    std::vector<Slot> joined(m_count);
    std::iota(joined.begin(), joined.end(), Slot(0));
    for (Slot hollow = 0; hollow < m_count; ++hollow) {
        if (volumes[hollow] >= 0)
            continue;
        const std::vector<Vec3> middles = middlesOf(boundaryOf(hollow));
        for (Slot piece = 0; piece < m_count; ++piece) {
            const bool isSmaller = joined[hollow] == hollow || volumes[piece] < volumes[joined[hollow]];
            if (volumes[piece] < -volumes[hollow] || !isSmaller)
                continue;
            if (isAround(boundaryOf(piece), middles))
                joined[hollow] = piece;
        }
    }
    for (Slot& piece : m_pieceOf)
        piece = piece == noSlot ? noSlot : joined[piece];
}

std::vector<bool> CutPieces::seenFirst(const ViewArea& area) const
{
    std::vector<Vec3f> points(m_mesh.slots().vertices, Vec3f::Zero());
    std::vector<Triangle> faces;
    std::vector<Slot> pieces;
    for (const Slot f : m_whole.removed) {
        faces.push_back(m_mesh.corners(f));
        pieces.push_back(m_pieceOf[faces.back()[0]]);
        for (const Slot v : faces.back())
            points[v] = m_mesh.point(v);
    }
    std::vector<std::pair<Vec3, Slot>> onCut;
    for (std::size_t i = 0; i < m_whole.vertices.size(); ++i)
        if (const Slot piece = m_pieceOf[keyOf(Surgery::newVertex(i))]; piece != noSlot)
            onCut.emplace_back(m_whole.vertices[i].point.cast<double>(), piece);
    return Cover(area, points, faces, pieces, m_count).seenFirst(onCut);
}

Surgery CutPieces::taking(const std::vector<bool>& pieces) const
{
    return partOf(m_whole, m_mesh, [&](const Triangle& face) { return pieces[m_pieceOf[keyOf(face[0])]]; });
}
} // namespace core
