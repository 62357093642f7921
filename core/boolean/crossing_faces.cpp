// 1. overlap  finds the faces in the boxes of other solids
// 2. search   builds a tree of these for each solid, which the faces of later solids query
// 3. test     tests each pair of faces whose boxes meet, exactly

#include "core/boolean/crossing_faces.h"

#include "core/analysis/self_intersection.h"
#include "core/geometry/triangle_intersection.h"
#include "core/util/parallel.h"

#include <limits>

namespace core::boolean
{
namespace
{
/// Returns a solid's faces whose boxes meet one of these boxes, ascending.
std::vector<Slot> facesIn(const SolidSoup& soup, std::size_t solid, std::span<const LatticeBox> boxes)
{
    const Slot first = soup.firstFaces[solid], end = soup.firstFaces[solid + 1];
    return joinChunks<std::vector<Slot>>(
        end - first, facesPerChunk, [&](std::size_t from, std::size_t to, std::vector<Slot>& faces) {
            for (auto f = static_cast<Slot>(first + from); f < first + to; ++f)
                if (const LatticeBox box = soup.boxOf(f);
                    std::ranges::any_of(boxes, [&](const LatticeBox& other) { return other.meets(box); }))
                    faces.push_back(f);
        });
}

CornerTriangle<LatticePredicates> cornerTriangle(const SolidSoup& soup, Slot face)
{
    return {soup.surface.triangles[face], soup.cornersOf(face)};
}

bool isDegenerate(const std::array<LatticePoint, 3>& c)
{
    return LatticePredicates::collinear(c[0], c[1], c[2]);
}

/// The faces of a solid that may meet others.
class SearchedFaces
{
public:
    SearchedFaces(const SolidSoup& soup, std::size_t solid, std::span<const LatticeBox> boxes)
        : m_faces(facesIn(soup, solid, boxes))
        , m_tree(boxesOf(soup, m_faces))
    {}

    bool empty() const { return m_faces.empty(); }
    std::span<const Slot> faces() const { return m_faces; }

    /// Calls visit(face) for each face whose box meets this one.
    template <typename Visit> void forEachNear(const LatticeBox& box, Visit visit) const
    {
        m_tree.forEachMeeting(floatBox(box), [&](Slot position) { visit(m_faces[m_tree.at(position)]); });
    }

private:
    static std::vector<FaceBox> boxesOf(const SolidSoup& soup, std::span<const Slot> faces)
    {
        std::vector<FaceBox> boxes(faces.size());
        forEachChunk(faces.size(), facesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                boxes[i] = floatBox(soup.boxOf(faces[i]));
        });
        return boxes;
    }

    std::vector<Slot> m_faces;
    BoxTree m_tree;
};

/// Adds the faces of both solids that meet each other; some of them several times.
void addMeeting(const SolidSoup& soup, const SearchedFaces& first, const SearchedFaces& second,
                const std::stop_token& stop, std::vector<Slot>& meeting)
{
    const std::vector<Slot> found = joinChunks<std::vector<Slot>>(
        second.faces().size(), facesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<Slot>& faces) {
            for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) {
                const Slot f = second.faces()[i];
                const CornerTriangle<LatticePredicates> t = cornerTriangle(soup, f);
                const std::size_t before = faces.size();
                first.forEachNear(soup.boxOf(f), [&](Slot other) {
                    const CornerTriangle<LatticePredicates> s = cornerTriangle(soup, other);
                    if (!isDegenerate(s.points) && !isDegenerate(t.points) && trianglesIntersect(s, t))
                        faces.push_back(other);
                });
                if (faces.size() > before)
                    faces.push_back(f);
            }
        });
    meeting.insert(meeting.end(), found.begin(), found.end());
}

std::vector<Slot> eachOnce(std::vector<Slot> faces)
{
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}
} // namespace

std::vector<Slot> crossingFaces(const SolidSoup& soup, const std::stop_token& stop)
{
    std::vector<SearchedFaces> searched;
    for (std::size_t s = 0; s < soup.solids(); ++s) {
        std::vector<LatticeBox> others;
        for (std::size_t other = 0; other < soup.solids(); ++other)
            if (other != s && soup.boxes[other].meets(soup.boxes[s]))
                others.push_back(soup.boxes[other]);
        searched.emplace_back(soup, s, others);
    }
    std::vector<Slot> meeting;
    for (std::size_t i = 0; i < searched.size(); ++i)
        for (std::size_t j = i + 1; j < searched.size(); ++j)
            if (!searched[i].empty() && !searched[j].empty() && soup.boxes[i].meets(soup.boxes[j]))
                addMeeting(soup, searched[i], searched[j], stop, meeting);
    return eachOnce(std::move(meeting));
}

std::vector<Slot> meetingFaces(const SolidSoup& soup, const std::stop_token& stop)
{
    constexpr std::size_t maxPairs = 10'000'000;
    const IntersectionReport met =
        selfIntersections<LatticePredicates>(soup.surface.points, soup.surface.triangles, maxPairs, stop);
    std::vector<Slot> meeting;
    for (const auto& [first, second] : met.pairs)
        meeting.insert(meeting.end(), {first, second});
    return eachOnce(std::move(meeting));
}
} // namespace core::boolean
