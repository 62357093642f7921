// All pairs of faces that meet: those whose boxes meet in a tree of boxes are tested exactly.

#include "core/analysis/self_intersection.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/triangle_intersection.h"
#include "core/util/parallel.h"
#include "core/util/smallest_k.h"

#include <atomic>
#include <numeric>

namespace core
{
namespace
{
constexpr std::size_t facesPerPairChunk = 1 << 12;
constexpr std::size_t blocksPerChunk = 4;

class PairSearch
{
public:
    /// Of some faces, ascending.
    template <typename Points>
    PairSearch(const Points& points, std::span<const Triangle> triangles, std::vector<Slot> faces)
        : m_triangles(triangles)
        , m_faces(std::move(faces))
        , m_tree(faceBoxes(points, m_faces.size(),
                           [this](std::size_t i) -> const Triangle& { return m_triangles[m_faces[i]]; }))
    {}

    /// meet(i, j) for the faces at two positions whose boxes meet.
    template <typename Meet> IntersectionReport find(std::size_t keep, const std::stop_token& stop, Meet meet) const
    {
        using Pairs = SmallestK<FacePair>;
        std::vector<Pairs> found(chunksOf(m_tree.blocks(), blocksPerChunk), Pairs(keep));
        forEachChunk(m_tree.blocks(), blocksPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t block = begin; block < end && !stop.stop_requested(); ++block)
                m_tree.forEachMeetingPair(static_cast<Slot>(block), [&](Slot i, Slot j) {
                    if (meet(i, j))
                        found[chunk].add(orderedPair(faceAt(i), faceAt(j)));
                });
        });
        Pairs all(keep);
        for (const Pairs& pairs : found)
            all.add(pairs);
        return {all.count(), all.take()};
    }

    /// By position, in memory: neighbours are met with again and again.
    template <typename Predicates>
    std::vector<CornerTriangle<Predicates>> inOrder(std::span<const typename Predicates::Point> points) const
    {
        std::vector<CornerTriangle<Predicates>> result(m_faces.size());
        forEachChunk(m_faces.size(), facesPerPairChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Triangle& t = m_triangles[faceAt(static_cast<Slot>(i))];
                result[i] = {t, {points[t[0]], points[t[1]], points[t[2]]}};
            }
        });
        return result;
    }

private:
    Slot faceAt(Slot position) const { return m_faces[m_tree.at(position)]; }

    static FacePair orderedPair(Slot a, Slot b) { return {std::min(a, b), std::max(a, b)}; }

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
        triangles.size(), facesPerPairChunk, [&](std::size_t begin, std::size_t end, std::vector<Slot>& faces) {
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
    const PairSearch search(points, triangles, facesThatAre<Predicates>(false, points, triangles));
    const auto ordered = search.inOrder<Predicates>(points);
    return search.find(keep, stop, [&](Slot i, Slot j) { return trianglesIntersect(ordered[i], ordered[j]); });
}

SurfaceAndImage selfIntersections(std::span<const Vec3f> points, std::span<const LatticePoint> image,
                                  std::span<const Triangle> triangles, std::size_t keep, const std::stop_token& stop)
{
    std::vector<Slot> all(triangles.size());
    std::iota(all.begin(), all.end(), Slot(0));
    const PairSearch search(image, triangles, std::move(all));
    const auto ordered = search.inOrder<FloatPredicates>(points);
    const auto orderedImage = search.inOrder<LatticePredicates>(image);
    std::atomic<bool> imageMeets = false;
    IntersectionReport report = search.find(keep, stop, [&](Slot i, Slot j) {
        if (!imageMeets.load(std::memory_order_relaxed) && trianglesIntersect(orderedImage[i], orderedImage[j]))
            imageMeets = true;
        return trianglesIntersect(ordered[i], ordered[j]);
    });
    return {std::move(report), imageMeets};
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
