#include "core/sculpt/solid_boolean.h"

#include "core/analysis/shell_orientation.h"
#include "core/analysis/winding_number.h"
#include "core/mesh/surface_query.h"
#include "core/repair/arrangement.h"
#include "core/repair/edge_faces.h"
#include "core/util/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>

namespace core
{
namespace
{
/// Largest number of model points compared when looking up the colour of a point of the solid.
constexpr std::size_t maxColorSample = 2048;

Vec3 middleOf(const repair::Arrangement& arrangement, Slot face)
{
    const auto& [a, b, c] = arrangement.faces[face].corners;
    return (arrangement.points[a] + arrangement.points[b] + arrangement.points[c]) / 3;
}

double areaOf(const repair::Arrangement& arrangement, Slot face)
{
    const auto& [a, b, c] = arrangement.faces[face].corners;
    const Vec3& p = arrangement.points[a];
    return (arrangement.points[b] - p).cross(arrangement.points[c] - p).norm();
}

/// Returns whether the point is inside the model. Counts the faces above it; exact.
bool isInside(const VerifiedMesh& surface, const LatticePoint& point)
{
    const Mesh& mesh = surface.mesh();
    ShellOrientation probe(point);
    surface.octree().query(probe.column(), [&](Slot f) {
        const auto [a, b, c] = mesh.corners(f);
        probe.castAt({mesh.latticePoint(a), mesh.latticePoint(b), mesh.latticePoint(c)});
    });
    return probe.isInside();
}
} // namespace

/// The faces after cutting them along the intersection curves. A patch is a set of pieces connected without crossing
/// such a curve, so all of it is on one side of the other surface.
struct SolidBoolean::Pieces
{
    explicit Pieces(repair::Arrangement arranged)
        : arrangement(std::move(arranged))
        , patches(arrangement.faces.size())
        , largest(arrangement.faces.size(), noSlot)
    {
        std::vector<Triangle> triangles;
        for (const repair::ArrangedFace& face : arrangement.faces) {
            triangles.push_back(face.corners);
            isGeneral = isGeneral && face.jump == 1 && arrangement.upon[face.original].empty();
        }
        repair::forEachEdge(triangles, [&](std::span<const repair::EdgeFace> around) {
            if (around.size() == 2)
                patches.unite(around[0].face, around[1].face);
            isGeneral = isGeneral && (around.size() <= 2 || around.size() == 4);
        });
        for (Slot f = 0; f < largest.size(); ++f) {
            Slot& best = largest[patches.root(f)];
            if (best == noSlot || areaOf(arrangement, f) > areaOf(arrangement, best))
                best = f;
        }
    }

    repair::Arrangement arrangement;
    mutable DisjointSets patches;
    std::vector<Slot> largest; ///< largest face of each patch, stored at the patch's root
    bool isGeneral = true;     ///< no two faces are coplanar, and the surfaces cross wherever they meet
};

SolidBoolean::SolidBoolean(const VerifiedMesh& surface, const TriangleMesh& solid) : m_surface(surface)
{
    const Mesh& mesh = surface.mesh();
    LatticeBox box;
    for (const Vec3f& p : solid.points)
        box.extend(mesh.lattice().toLattice(p));
    surface.octree().query(box, [&](Slot f) {
        if (boxOf(mesh, f).meets(box))
            m_candidates.push_back(f);
    });
    std::ranges::sort(m_candidates);
    std::unordered_map<Slot, Slot> indices;
    for (Slot f : m_candidates) {
        Triangle corners = mesh.corners(f);
        for (Slot& v : corners) {
            const auto [at, isNew] = indices.try_emplace(v, static_cast<Slot>(m_vertices.size()));
            if (isNew) {
                m_vertices.push_back(v);
                m_soup.points.push_back(mesh.latticePoint(v));
                m_soup.colors.push_back(mesh.color(v));
            }
            v = at->second;
        }
        m_soup.triangles.push_back(corners);
    }
    const auto first = static_cast<Slot>(m_soup.points.size());
    const bool isOneColor = std::ranges::adjacent_find(m_soup.colors, std::not_equal_to()) == m_soup.colors.end();
    for (const Vec3f& p : solid.points) {
        m_soup.points.push_back(mesh.lattice().toLattice(p));
        const Rgb color = first == 0 ? Rgb() : isOneColor ? m_soup.colors[0] : colorNear(m_soup.points.back(), first);
        m_soup.colors.push_back(color);
    }
    for (const auto& [a, b, c] : solid.triangles)
        m_soup.triangles.push_back({first + a, first + b, first + c});
    m_pairs =
        selfIntersections<LatticePredicates>(m_soup.points, m_soup.triangles, std::numeric_limits<std::size_t>::max())
            .pairs;
}

bool SolidBoolean::areCrossing() const
{
    return std::ranges::any_of(
        m_pairs, [&](const FacePair& pair) { return isSolidFace(pair.first) != isSolidFace(pair.second); });
}

/// Returns the colour of the point nearest to p among the first `count` points of m_soup, or among a sample of these if
/// there are many.
Rgb SolidBoolean::colorNear(const LatticePoint& p, std::size_t count) const
{
    const std::size_t step = 1 + count / maxColorSample;
    std::size_t nearest = 0;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < count; i += step) {
        const auto way = (m_soup.points[i] - p).cast<std::int64_t>();
        if (const std::int64_t squared = way.squaredNorm(); squared < least) {
            least = squared;
            nearest = i;
        }
    }
    return m_soup.colors[nearest];
}

std::optional<Surgery> SolidBoolean::surgery(BooleanOperation operation) const
{
    const Pieces pieces(repair::arrange(m_soup, m_pairs));
    if (!pieces.isGeneral)
        return std::nullopt;
    const std::vector<Vec3> places = m_soup.places();
    const WindingNumber winding(places, std::span(m_soup.triangles).subspan(m_candidates.size()));
    std::vector<bool> isKept(pieces.largest.size());
    for (Slot f = 0; f < isKept.size(); ++f) {
        const Slot root = pieces.patches.root(f);
        if (root != f) { // a root is the lowest face of its patch, so its result is known already
            isKept[f] = isKept[root];
            continue;
        }
        const Vec3 middle = middleOf(pieces.arrangement, pieces.largest[root]);
        const Slot original = pieces.arrangement.faces[pieces.largest[root]].original;
        if (!isSolidFace(original)) {
            isKept[f] = winding.at(middle) < 0.5;
            continue;
        }
        const std::array<Slot, 1> own = {original - static_cast<Slot>(m_candidates.size())};
        const bool isInModel = isInside(m_surface, middle.array().round().cast<int>());
        const bool isInOtherShell = winding.at(middle, own) > 1; // the face's own shell counts 1/2
        isKept[f] = !isInOtherShell && isInModel == (operation == BooleanOperation::Subtract);
    }
    return surgeryOf(pieces, isKept, operation);
}

Surgery SolidBoolean::surgeryOf(const Pieces& pieces, const std::vector<bool>& isKept, BooleanOperation operation) const
{
    const repair::Arrangement& arrangement = pieces.arrangement;
    const Lattice& lattice = m_surface.mesh().lattice();
    Surgery surgery;
    surgery.nearby = m_vertices.front();
    // new points that round to the same lattice point become one vertex
    std::map<std::tuple<int, int, int>, Slot> corners;
    const auto cornerAt = [&](Slot point) {
        if (point < m_vertices.size())
            return m_vertices[point];
        const LatticePoint p = arrangement.points[point].array().round().cast<int>();
        const auto [at, isNew] =
            corners.try_emplace({p.x(), p.y(), p.z()}, Surgery::newVertex(surgery.vertices.size()));
        if (isNew)
            surgery.vertices.push_back({lattice.toPoint(p), arrangement.colors[point], noSlot, 0});
        return at->second;
    };
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        const LatticePoint& p = m_soup.points[i];
        corners.emplace(std::tuple(p.x(), p.y(), p.z()), m_vertices[i]);
    }
    std::vector<bool> isWhole(m_candidates.size(), true);
    for (const auto& [first, second] : m_pairs) {
        for (Slot f : {first, second}) {
            if (!isSolidFace(f))
                isWhole[f] = false;
        }
    }
    for (Slot f = 0; f < isKept.size(); ++f) {
        const auto& [triangle, original, jump] = arrangement.faces[f];
        const bool isModel = !isSolidFace(original);
        if (isModel && isWhole[original] && !isKept[f])
            surgery.removed.push_back(m_candidates[original]);
        if (!isKept[f] || (isModel && isWhole[original]))
            continue;
        Triangle face = {cornerAt(triangle[0]), cornerAt(triangle[1]), cornerAt(triangle[2])};
        if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
            continue;
        if (!isModel && operation == BooleanOperation::Subtract)
            std::swap(face[1], face[2]);
        surgery.faces.push_back(face);
    }
    for (std::size_t i = 0; i < isWhole.size(); ++i) {
        if (!isWhole[i])
            surgery.removed.push_back(m_candidates[i]);
    }
    return surgery;
}
} // namespace core
