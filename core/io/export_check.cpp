#include "core/io/export_check.h"

#include "core/io/mesh_io.h"
#include "core/parts/part_split.h"

#include <algorithm>

namespace core
{
namespace
{
/// Returns whether the meshes have equally many triangles and same(corner of a, corner of b) is true for all corners.
template <class Same> bool alike(const TriangleMesh& a, const TriangleMesh& b, Same same)
{
    return std::ranges::equal(a.triangles, b.triangles, [&](const Triangle& s, const Triangle& t) {
        return same(s[0], t[0]) && same(s[1], t[1]) && same(s[2], t[2]);
    });
}
} // namespace

ExportVerdict checkExport(const std::filesystem::path& path, const TriangleMesh& mesh, const JobControl& control,
                          const PartList& parts)
{
    const TriangleMesh written = inListOrder(mesh, parts);
    const ReadResult result = readModel(path, {.stop = control.stop, .keepsObjects = !written.parts.empty()});
    const TriangleMesh& read = result.mesh;
    ExportVerdict verdict;
    verdict.sameCorners = !result.remarks.announcedTriangles &&
                          alike(read, written, [&](Slot a, Slot b) { return read.points[a] == written.points[b]; });
    const auto format = meshFormatOf(path);
    const bool hasColors = !written.colors.empty() && format && holdsColors(*format);
    verdict.sameColors = !hasColors || (!read.colors.empty() && alike(read, written, [&](Slot a, Slot b) {
        return read.colors[a] == written.colors[b];
    }));
    verdict.report = checkMesh(read, control);
    return verdict;
}
} // namespace core
