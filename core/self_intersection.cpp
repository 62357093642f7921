// All pairs of faces that meet: a tree of their boxes in Morton order; each node of eight faces asks the tree for the faces
// after it whose boxes meet its own; what remains after comparing single boxes is tested exactly.

#include "self_intersection.h"

#include "box_tree.h"
#include "first_few.h"
#include "parallel.h"
#include "triangle_pair.h"

namespace core
{
namespace
{
constexpr std::size_t facesPerChunk = 1 << 12;
constexpr std::size_t nodesPerChunk = 1 << 8;

template <typename Predicates> class PairSearch
{
public:
    using Point = typename Predicates::Point;
    using Pairs = FirstFew<FacePair>;

    PairSearch(std::span<const Point> points, std::span<const Triangle> triangles, std::vector<Slot> faces)
        : m_points(points)
        , m_triangles(triangles)
        , m_faces(std::move(faces))
        , m_tree(boxes())
    {}

    Pairs find(std::size_t keep, const std::stop_token& stop) const
    {
        std::vector<Pairs> found(chunksOf(m_tree.nodes(), nodesPerChunk), Pairs(keep));
        forEachChunk(m_tree.nodes(), nodesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t node = begin; node < end && !stop.stop_requested(); ++node)
                findFrom(static_cast<Slot>(node), found[chunk]);
        });
        Pairs all(keep);
        for (const Pairs& pairs : found)
            all.add(pairs);
        return all;
    }

private:
    std::vector<FaceBox> boxes() const
    {
        std::vector<FaceBox> result(m_faces.size());
        forEachChunk(m_faces.size(), facesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (const Slot corner : m_triangles[m_faces[i]])
                    result[i].extend(m_points[corner].array().template cast<float>());
        });
        return result;
    }

    Slot faceAt(Slot position) const { return m_faces[m_tree.at(position)]; }

    CornerTriangle<Predicates> triangleAt(Slot position) const
    {
        const Triangle& t = m_triangles[faceAt(position)];
        return {t, {m_points[t[0]], m_points[t[1]], m_points[t[2]]}};
    }

    /// Pairs of a face of the node and a face at a later position.
    void findFrom(Slot node, Pairs& found) const
    {
        const Slot first = node * BoxTree::nodeSize;
        const Slot last = std::min(first + BoxTree::nodeSize, m_tree.size());
        std::array<CornerTriangle<Predicates>, BoxTree::nodeSize> own;
        for (Slot i = first; i < last; ++i)
            own[i - first] = triangleAt(i);
        m_tree.forEachMeeting(m_tree.nodeBox(node), first, [&](Slot other) {
            const FaceBox& box = m_tree.box(other);
            const CornerTriangle<Predicates> triangle = triangleAt(other);
            for (Slot i = first; i < std::min(other, last); ++i)
                if (m_tree.box(i).meets(box) && trianglesMeet(own[i - first], triangle))
                    found.add(orderedPair(faceAt(i), faceAt(other)));
        });
    }

    static FacePair orderedPair(Slot a, Slot b) { return {std::min(a, b), std::max(a, b)}; }

    std::span<const Point> m_points;
    std::span<const Triangle> m_triangles;
    std::vector<Slot> m_faces; ///< those that take part, ascending
    BoxTree m_tree;
};

/// Faces that are degenerate, or those that are not, ascending.
template <typename Predicates>
std::vector<Slot> facesThatAre(bool degenerate, std::span<const typename Predicates::Point> points,
                               std::span<const Triangle> triangles)
{
    return joinChunks<std::vector<Slot>>(
        triangles.size(), facesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<Slot>& faces) {
            for (std::size_t f = begin; f < end; ++f) {
                const auto& [a, b, c] = triangles[f];
                if (Predicates::collinear(points[a], points[b], points[c]) == degenerate)
                    faces.push_back(static_cast<Slot>(f));
            }
        });
}
} // namespace

template <typename Predicates>
IntersectionReport selfIntersections(std::span<const typename Predicates::Point> points,
                                     std::span<const Triangle> triangles, std::size_t keep, const std::stop_token& stop)
{
    std::vector<Slot> faces = facesThatAre<Predicates>(false, points, triangles);
    auto found = PairSearch<Predicates>(points, triangles, std::move(faces)).find(keep, stop);
    return {found.count(), found.take()};
}

template <typename Predicates>
std::vector<Slot> degenerateFaces(std::span<const typename Predicates::Point> points,
                                  std::span<const Triangle> triangles)
{
    return facesThatAre<Predicates>(true, points, triangles);
}

template IntersectionReport selfIntersections<LatticePredicates>(std::span<const LatticePoint>,
                                                                 std::span<const Triangle>, std::size_t,
                                                                 const std::stop_token&);
template IntersectionReport selfIntersections<FloatPredicates>(std::span<const Vec3f>, std::span<const Triangle>,
                                                               std::size_t, const std::stop_token&);
template std::vector<Slot> degenerateFaces<LatticePredicates>(std::span<const LatticePoint>, std::span<const Triangle>);
template std::vector<Slot> degenerateFaces<FloatPredicates>(std::span<const Vec3f>, std::span<const Triangle>);
} // namespace core
