#include "core/analysis/part_overlap.h"

#include "core/analysis/mesh_check.h"

#include <algorithm>
#include <map>
#include <ranges>

namespace core
{
namespace
{
/// Returns whether two of the boxes share a point. Cost: quadratic in their number if all are side by side.
bool doAnyMeet(std::vector<Box> boxes)
{
    std::ranges::sort(boxes, {}, [](const Box& box) { return box.min().x(); });
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = i + 1; k < boxes.size() && boxes[k].min().x() <= boxes[i].max().x(); ++k)
            if (boxes[i].intersects(boxes[k]))
                return true;
    return false;
}
} // namespace

bool doPartsOverlap(const TriangleMesh& mesh, const JobControl& control)
{
    if (mesh.parts.empty())
        return false;
    std::map<PartId, Box> boxes;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        boxes[mesh.parts[v]].extend(mesh.points[v].cast<double>());
    const auto values = boxes | std::views::values;
    if (!doAnyMeet({values.begin(), values.end()}))
        return false;
    TriangleMesh whole = mesh;
    whole.parts.clear();
    return !checkMesh(whole, control).printReady();
}
} // namespace core
