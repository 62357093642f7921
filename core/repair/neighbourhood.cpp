#include "core/repair/neighbourhood.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/predicates.h"
#include "core/util/parallel.h"

namespace core::repair
{
std::vector<FaceBox> boxesAround(const TriangleSoup& surface, std::span<const Slot> points, float margin)
{
    std::vector<bool> isMeant(surface.points.size(), false);
    for (const Slot v : points)
        isMeant[v] = true;
    std::vector<Triangle> around;
    for (const Triangle& t : surface.triangles)
        if (isMeant[t[0]] || isMeant[t[1]] || isMeant[t[2]])
            around.push_back(t);
    std::vector<FaceBox> boxes = faceBoxes(surface.points, std::span<const Triangle>(around));
    for (FaceBox& box : boxes) {
        box.min -= margin;
        box.max += margin;
    }
    return boxes;
}

std::vector<Slot> facesNear(const TriangleSoup& surface, const std::vector<FaceBox>& boxes)
{
    constexpr std::size_t facesPerChunk = 1 << 12;
    if (boxes.empty())
        return {};
    const BoxTree tree(boxes);
    return joinChunks<std::vector<Slot>>(surface.triangles.size(), facesPerChunk,
                                         [&](std::size_t begin, std::size_t end, std::vector<Slot>& near) {
                                             for (std::size_t f = begin; f < end; ++f) {
                                                 FaceBox face;
                                                 for (const Slot v : surface.triangles[f])
                                                     face.extend(surface.points[v].array().cast<float>());
                                                 bool isNear = false;
                                                 tree.forEachMeeting(face, [&](Slot) { isNear = true; });
                                                 if (isNear)
                                                     near.push_back(static_cast<Slot>(f));
                                             }
                                         });
}

IntersectionReport intersectionsAmong(const TriangleSoup& surface, std::span<const Slot> faces, std::size_t maxPairs,
                                      const std::stop_token& stop)
{
    std::vector<Triangle> triangles;
    triangles.reserve(faces.size());
    for (const Slot f : faces)
        triangles.push_back(surface.triangles[f]);
    IntersectionReport met = selfIntersections<LatticePredicates>(surface.points, triangles, maxPairs, stop);
    for (auto& [first, second] : met.pairs) {
        first = faces[first];
        second = faces[second];
    }
    return met;
}
} // namespace core::repair
