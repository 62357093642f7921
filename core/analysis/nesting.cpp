// Computes, for each shell, the sign of its volume: in doubles or, if rounding could change the sign, in an exact sum.
// If there are other shells, counts how many of their faces are above the shell's highest vertex. An odd count means
// that the shell is inside an odd number of other shells.

#include "core/analysis/nesting.h"

#include "core/geometry/exact_sum.h"
#include "core/geometry/face_geometry.h"
#include "core/util/disjoint_sets.h"

#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace core
{
namespace
{
class Shells
{
public:
    Shells(std::span<const Vec3f> points, std::span<const Triangle> triangles)
        : m_points(points)
        , m_triangles(triangles)
        , m_components(componentsOf(points.size(), triangles))
    {
        collectFaces();
    }

    bool boundSolid() const
    {
        if (m_components.count == 1)
            return volumeSign(0) > 0;
        const BoxTree tree(faceBoxes(m_points, m_triangles));
        for (std::size_t shell = 0; shell < m_components.count; ++shell)
            if ((volumeSign(shell) > 0) == liesInOdd(shell, tree))
                return false;
        return true;
    }

    Components pieces() const
    {
        if (m_components.count == 1)
            return m_components;
        const BoxTree tree(faceBoxes(m_points, m_triangles));
        std::vector<std::size_t> outer(m_components.count);
        for (std::size_t shell = 0; shell < outer.size(); ++shell)
            outer[shell] = volumeSign(shell) > 0 ? shell : innermostAround(shell, tree);
        Components pieces;
        std::vector<Slot> number(outer.size(), noSlot);
        for (const Slot shell : m_components.ofFace) {
            Slot& piece = number[outer[shell]];
            if (piece == noSlot)
                piece = static_cast<Slot>(pieces.count++);
            pieces.ofFace.push_back(piece);
        }
        return pieces;
    }

private:
    std::span<const Slot> facesOf(std::size_t shell) const
    {
        return std::span(m_faces).subspan(m_firstFace[shell], m_firstFace[shell + 1] - m_firstFace[shell]);
    }

    /// Sorts the faces by shell.
    void collectFaces()
    {
        m_firstFace.assign(m_components.count + 1, 0);
        for (const Slot shell : m_components.ofFace)
            ++m_firstFace[shell + 1];
        std::partial_sum(m_firstFace.begin(), m_firstFace.end(), m_firstFace.begin());
        m_faces.resize(m_triangles.size());
        std::vector<std::size_t> next(m_firstFace.begin(), m_firstFace.end() - 1);
        for (Slot f = 0; f < m_triangles.size(); ++f)
            m_faces[next[m_components.ofFace[f]]++] = f;
    }

    /// Returns the sign of the shell's volume. The rounding error of a term is less than 8 roundings, as in orient3d;
    /// the sum of n terms adds n more.
    int volumeSign(std::size_t shell) const
    {
        const Vec3 origin = m_points[m_triangles[facesOf(shell)[0]][0]].cast<double>();
        double sum = 0, size = 0;
        for (const Slot f : facesOf(shell)) {
            const auto& [a, b, c] = m_triangles[f];
            const Vec3 u = m_points[a].cast<double>() - origin, v = m_points[b].cast<double>() - origin,
                       w = m_points[c].cast<double>() - origin;
            for (int i = 0; i < 3; ++i) {
                const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
                const double p = v[j] * w[k], q = v[k] * w[j];
                sum += u[i] * (p - q);
                size += std::abs(u[i]) * (std::abs(p) + std::abs(q));
            }
        }
        const double roundings = 2.0 * (3.0 * static_cast<double>(facesOf(shell).size()) + 16);
        return std::abs(sum) > roundings * 0x1p-53 * size ? signOf(sum) : exactVolumeSign(shell);
    }

    int exactVolumeSign(std::size_t shell) const
    {
        ExactSum sum;
        for (const Slot f : facesOf(shell)) {
            const auto& [a, b, c] = m_triangles[f];
            sum.addDeterminant(m_points[a], m_points[b], m_points[c]);
        }
        return sum.sign();
    }

    Vec3f highestPoint(std::size_t shell) const
    {
        Vec3f highest = m_points[m_triangles[facesOf(shell)[0]][0]];
        for (const Slot f : facesOf(shell))
            for (const Slot corner : m_triangles[f])
                if (m_points[corner].z() > highest.z())
                    highest = m_points[corner];
        return highest;
    }

    /// Calls visit(shell) for each face of another shell above the shell's highest point.
    template <class Visit> void forEachAbove(std::size_t shell, const BoxTree& tree, Visit visit) const
    {
        const Vec3f origin = highestPoint(shell);
        FaceBox ray;
        ray.extend(origin.array());
        ray.max.z() = std::numeric_limits<float>::infinity();
        tree.forEachMeeting(ray, [&](Slot position) {
            const Slot face = tree.at(position);
            if (m_components.ofFace[face] != shell && liesAbove(m_triangles[face], origin))
                visit(m_components.ofFace[face]);
        });
    }

    bool liesInOdd(std::size_t shell, const BoxTree& tree) const
    {
        bool odd = false;
        forEachAbove(shell, tree, [&](Slot) { odd = !odd; });
        return odd;
    }

    /// Returns the shell of the least volume around the shell. Precondition: there is one.
    std::size_t innermostAround(std::size_t shell, const BoxTree& tree) const
    {
        std::map<Slot, bool> isAround;
        forEachAbove(shell, tree, [&](Slot other) { isAround[other] = !isAround[other]; });
        std::size_t innermost = shell;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [other, odd] : isAround) {
            if (const double volume = odd ? std::abs(volumeOf(other)) : least; volume < least) {
                least = volume;
                innermost = other;
            }
        }
        return innermost;
    }

    double volumeOf(std::size_t shell) const
    {
        double sum = 0;
        for (const Slot f : facesOf(shell)) {
            const auto& [a, b, c] = m_triangles[f];
            sum += m_points[a].cast<double>().dot(m_points[b].cast<double>().cross(m_points[c].cast<double>())) / 6;
        }
        return sum;
    }

    /// Returns whether the ray upwards (+z) from the origin crosses the face. The origin is treated as if moved by (e,
    /// e^2, 0) for a tiny e > 0: then the ray meets no edge and no vertical face.
    bool liesAbove(const Triangle& face, const Vec3f& origin) const
    {
        constexpr int z = 2;
        const Vec3f &a = m_points[face[0]], &b = m_points[face[1]], &c = m_points[face[2]];
        const int facing = FloatPredicates::orient2d(a, b, c, z);
        if (facing == 0)
            return false;
        for (const auto& [p, q] : {std::tie(a, b), std::tie(b, c), std::tie(c, a)})
            if (sideOfMoved(p, q, origin) != facing)
                return false;
        return facing * FloatPredicates::orient3d(a, b, c, origin) < 0;
    }

    /// Returns orient2d(p, q, moved origin). If the sign is 0 for the unmoved origin, the derivatives by e and then e^2
    /// decide.
    static int sideOfMoved(const Vec3f& p, const Vec3f& q, const Vec3f& origin)
    {
        const int side = FloatPredicates::orient2d(p, q, origin, 2);
        if (side != 0)
            return side;
        return p.y() != q.y() ? (p.y() > q.y() ? 1 : -1) : (q.x() > p.x() ? 1 : -1);
    }

    std::span<const Vec3f> m_points;
    std::span<const Triangle> m_triangles;
    Components m_components;
    std::vector<Slot> m_faces;
    std::vector<std::size_t> m_firstFace; ///< first face of each shell, as an index into m_faces
};
} // namespace

Components componentsOf(std::size_t vertices, std::span<const Triangle> triangles)
{
    DisjointSets sets(vertices);
    for (const auto& [a, b, c] : triangles) {
        sets.unite(a, b);
        sets.unite(b, c);
    }
    Components result;
    result.ofFace.reserve(triangles.size());
    std::vector<Slot> number(vertices, noSlot);
    for (const Triangle& t : triangles) {
        Slot& component = number[sets.root(t[0])];
        if (component == noSlot)
            component = static_cast<Slot>(result.count++);
        result.ofFace.push_back(component);
    }
    return result;
}

std::size_t edgeComponents(std::span<const Triangle> triangles)
{
    std::vector<std::pair<std::uint64_t, Slot>> edges; // edge as both vertices, and a face at it
    edges.reserve(3 * triangles.size());
    for (Slot f = 0; f < triangles.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Slot a = triangles[f][i], b = triangles[f][(i + 1) % 3];
            edges.emplace_back(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), f);
        }
    }
    std::ranges::sort(edges);
    DisjointSets faces(triangles.size());
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        for (; end < edges.size() && edges[end].first == edges[begin].first; ++end)
            faces.unite(edges[begin].second, edges[end].second);
    }
    std::size_t count = 0;
    for (Slot f = 0; f < triangles.size(); ++f)
        count += faces.root(f) == f ? 1 : 0;
    return count;
}

bool boundsSolid(std::span<const Vec3f> points, std::span<const Triangle> triangles)
{
    return Shells(points, triangles).boundSolid();
}

Components solidPiecesOf(std::span<const Vec3f> points, std::span<const Triangle> triangles)
{
    return Shells(points, triangles).pieces();
}

bool boundsSolid(std::span<const LatticePoint> points, std::span<const Triangle> triangles)
{
    std::vector<Vec3f> same; // exact: a float32 holds each lattice coordinate
    same.reserve(points.size());
    for (const LatticePoint& p : points)
        same.push_back(p.cast<float>());
    return boundsSolid(same, triangles);
}
} // namespace core
