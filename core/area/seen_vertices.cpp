#include "core/area/seen_vertices.h"

#include "core/area/area_test.h"
#include "core/area/sightlines.h"
#include "core/mesh/normals.h"
#include "core/util/parallel.h"

namespace core
{
namespace
{
constexpr std::size_t verticesPerChunk = 1 << 12;

std::vector<Vec3f> pointsOf(const Mesh& mesh)
{
    std::vector<Vec3f> places(mesh.slots().vertices, Vec3f::Zero());
    for (const Slot v : mesh.vertices())
        places[v] = mesh.point(v);
    return places;
}

std::vector<Triangle> shownFaces(const Mesh& mesh)
{
    std::vector<Triangle> faces;
    for (const Slot f : mesh.faces()) {
        if (!mesh.isFaceHidden(f) && mesh.frame().parts.isVisible(mesh.partOfFace(f)))
            faces.push_back(mesh.corners(f));
    }
    return faces;
}

/// Tells which vertices of a mesh are seen from an eye, or from far away against the view.
class SeenVertices
{
public:
    explicit SeenVertices(const Mesh& mesh)
        : m_mesh(mesh)
        , m_points(pointsOf(mesh))
        , m_lines(m_points, shownFaces(mesh))
    {}

    /// `at`: the vertex's place, or its mirror image about the plane, which `mirror` gives.
    bool isSeen(Slot v, const Sight& sight, Symmetry mirror) const
    {
        const Vec3 p = m_mesh.point(v).cast<double>();
        Vec3 way = sight.towardEye(mirror == Symmetry::None ? p : mirrored(p, mirror));
        if (mirror != Symmetry::None)
            way = mirrored(way, mirror);
        if (!(vertexNormal(m_mesh, v).dot(way) > 0))
            return false;
        const double reach = sight.isPerspective() ? 1 : std::numeric_limits<double>::infinity();
        return !m_lines.anyMet(p, way, reach, [&](Slot f) {
            const Triangle& corners = m_lines.corners(f);
            return corners[0] != v && corners[1] != v && corners[2] != v;
        });
    }

private:
    const Mesh& m_mesh;
    std::vector<Vec3f> m_points;
    Sightlines m_lines;
};
} // namespace

std::optional<std::vector<bool>> verticesIn(const ViewArea& area, const Mesh& mesh, std::optional<PartId> part)
{
    const AreaTest test(area);
    if (!test.hasArea())
        return std::nullopt;
    std::optional<SeenVertices> seen;
    if (area.isFrontOnly)
        seen.emplace(mesh);
    const auto isIn = [&](Slot v) {
        const Vec3 p = mesh.point(v).cast<double>();
        const auto isSeen = [&](Symmetry mirror) { return !seen || seen->isSeen(v, test.sight(), mirror); };
        const bool isMirrored = area.symmetry != Symmetry::None;
        const bool isWithin = test.isWithin(p);
        const bool isImageWithin = isMirrored && test.isWithin(mirrored(p, area.symmetry));
        if (area.side == ViewArea::Side::Inside)
            return (isWithin && isSeen(Symmetry::None)) || (isImageWithin && isSeen(area.symmetry));
        return !isWithin && !isImageWithin && (isSeen(Symmetry::None) || (isMirrored && isSeen(area.symmetry)));
    };
    std::vector<char> marks(mesh.slots().vertices); // written by several threads, unlike vector<bool>
    forEachChunk(marks.size(), verticesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Slot>(begin); v < end; ++v)
            marks[v] = mesh.isVertex(v) && !mesh.isHidden(v) && (!part || mesh.part(v) == *part) && isIn(v);
    });
    return std::vector<bool>(marks.begin(), marks.end());
}
} // namespace core
