// Finds all pairs of faces that meet: a tree of boxes gives the pairs whose boxes meet, which are tested exactly. One
// face represents all faces with the same corners.

#include "core/analysis/self_intersection.h"

#include "core/analysis/equal_faces.h"
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

/// Counts pairs of faces, and keeps the first pairs in ascending order.
class Pairs
{
public:
    explicit Pairs(std::size_t keep) : m_pairs(keep) {}

    /// Adds all pairs of a face of group a and a face of group b. Precondition: both groups are ascending.
    void add(std::span<const Slot> a, std::span<const Slot> b)
    {
        m_pairs.count(a.size() * b.size());
        std::size_t i = 0, j = 0;
        for (std::size_t left = m_pairs.capacity(); left > 0 && i < a.size() && j < b.size();) {
            const bool isFirstOfA = a[i] < b[j];
            const Slot first = isFirstOfA ? a[i++] : b[j++];
            left -= addBehind(first, isFirstOfA ? b.subspan(j) : a.subspan(i), left);
        }
    }
    /// Adds all pairs of faces within one group. Precondition: the group is ascending.
    void add(std::span<const Slot> group)
    {
        m_pairs.count(group.size() * (group.size() - 1) / 2);
        std::size_t left = m_pairs.capacity();
        for (std::size_t i = 0; left > 0 && i + 1 < group.size(); ++i)
            left -= addBehind(group[i], group.subspan(i + 1), left);
    }
    void add(const Pairs& other) { m_pairs.add(other.m_pairs); }

    IntersectionReport report() { return {m_pairs.count(), m_pairs.take()}; }

private:
    /// Keeps the first pairs of a face with the faces after it, at most `most`. Returns the number of these pairs.
    std::size_t addBehind(Slot first, std::span<const Slot> behind, std::size_t most)
    {
        const std::span<const Slot> taken = behind.first(std::min(behind.size(), most));
        for (const Slot second : taken)
            m_pairs.keep({first, second});
        return taken.size();
    }

    SmallestK<FacePair> m_pairs;
};

class PairSearch
{
public:
    /// `faces`: the faces to search, ascending.
    template <typename Points>
    PairSearch(const Points& points, std::span<const Triangle> triangles, const std::vector<Slot>& faces)
        : m_triangles(triangles)
        , m_faces(triangles, faces)
        , m_tree(faceBoxes(points, m_faces.groups(),
                           [this](std::size_t i) -> const Triangle& { return m_triangles[m_faces.group(i).front()]; }))
    {}

    /// Returns the pairs for which meet(i, j) is true. Calls meet(i, j) for positions whose boxes meet, and meet(i, i)
    /// for a position with several equal faces.
    template <typename Meet> IntersectionReport find(std::size_t keep, const std::stop_token& stop, Meet meet) const
    {
        std::vector<Pairs> found(m_tree.blocks(), Pairs(keep));
        forEachChunk(m_tree.blocks(), 1, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t block = begin; block < end && !stop.stop_requested(); ++block)
                m_tree.forEachMeetingPair(static_cast<Slot>(block), [&](Slot i, Slot j) {
                    if (meet(i, j))
                        found[chunk].add(facesAt(i), facesAt(j));
                });
        });
        Pairs all(keep);
        for (const Pairs& pairs : found)
            all.add(pairs);
        for (Slot i = 0; i < m_tree.size(); ++i)
            if (facesAt(i).size() > 1 && meet(i, i))
                all.add(facesAt(i));
        return all.report();
    }

    /// Returns the faces by position, so that faces tested together are near in memory.
    template <typename Predicates>
    std::vector<CornerTriangle<Predicates>> inOrder(std::span<const typename Predicates::Point> points) const
    {
        std::vector<CornerTriangle<Predicates>> result(m_faces.groups());
        forEachChunk(m_faces.groups(), facesPerPairChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Triangle& t = m_triangles[facesAt(static_cast<Slot>(i)).front()];
                result[i] = {t, {points[t[0]], points[t[1]], points[t[2]]}};
            }
        });
        return result;
    }

private:
    std::span<const Slot> facesAt(Slot position) const { return m_faces.group(m_tree.at(position)); }

    std::span<const Triangle> m_triangles;
    EqualFaces m_faces; ///< the searched faces, grouped by equal corners
    BoxTree m_tree;     ///< boxes of one face of each group
};

/// Returns, ascending, the faces that are degenerate if `degenerate`, otherwise the faces that are not.
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
    const PairSearch search(image, triangles, all);
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
