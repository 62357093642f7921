// Cuts a flat base: removes everything below a level plane and closes the cut in the plane.
//   1. settle   move vertices that are almost in the plane into it
//   2. part     split edges that cross the plane at a lattice point exactly in it
//   3. cap      remove faces without a corner above the plane, and fill the boundary loops          polygon_fill
//   4. check    the whole mesh exactly; if it is not sound, retry without step 1, then with a slightly higher plane

#include "core/operations/flatten_base.h"

#include "core/geometry/polygon_triangulation.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/transform.h"

#include <algorithm>
#include <unordered_map>

namespace core
{
namespace
{
/// Largest distance of a vertex from the plane at which settle() moves it, as a fraction of its shortest edge.
constexpr double settledHeightPerEdge = 0.1;
/// Lattice units by which the plane is raised, one try after the other, if a cut is not sound.
constexpr int raisings[] = {0, 1, 17};
constexpr double afterCapping = 0.4; ///< progress after capping, 0 to 1

class BaseCutter
{
public:
    BaseCutter(Mesh& mesh, float level) : m_mesh(mesh), m_level(level) {}

    void settle();
    void part();
    bool cap();

private:
    float height(Slot v) const { return m_mesh.point(v).y() - m_level; }
    bool isKept(const Triangle& t) const { return height(t[0]) > 0 || height(t[1]) > 0 || height(t[2]) > 0; }
    std::vector<std::vector<Slot>> openLoops() const;

    Mesh& m_mesh;
    float m_level;
};

void BaseCutter::settle()
{
    for (const Slot v : m_mesh.vertices()) {
        if (height(v) == 0 || std::abs(static_cast<double>(height(v))) > settledHeightPerEdge * shortestEdge(m_mesh, v))
            continue;
        Vec3f p = m_mesh.point(v);
        p.y() = m_level;
        m_mesh.setPoint(v, p);
    }
}

/// Splits all edges that cross the plane. One pass suffices because no new edge crosses it.
void BaseCutter::part()
{
    for (const Slot e : m_mesh.edges()) {
        const Slot a = m_mesh.to(2 * e), b = m_mesh.to(2 * e + 1);
        const auto ha = static_cast<double>(height(a)), hb = static_cast<double>(height(b));
        if (ha * hb >= 0)
            continue;
        const Vec3 p = m_mesh.point(a).cast<double>(), q = m_mesh.point(b).cast<double>();
        Vec3f cut = m_mesh.lattice().snap(p + ha / (ha - hb) * (q - p));
        cut.y() = m_level;
        m_mesh.splitEdge(e, cut);
    }
}

/// Returns the boundary loops of the kept faces, in the direction of the faces that will close them. Empty if two loops
/// touch in a vertex.
std::vector<std::vector<Slot>> BaseCutter::openLoops() const
{
    std::unordered_map<Slot, Slot> next;
    std::vector<Slot> starts;
    for (const Slot f : m_mesh.faces()) {
        if (!isKept(m_mesh.corners(f)))
            continue;
        Slot h = m_mesh.faceHalfedge(f);
        for (int i = 0; i < 3; ++i, h = m_mesh.next(h)) {
            if (isKept(m_mesh.corners(m_mesh.face(h ^ 1))))
                continue;
            if (!next.emplace(m_mesh.to(h), m_mesh.from(h)).second)
                return {};
            starts.push_back(m_mesh.to(h));
        }
    }
    std::vector<std::vector<Slot>> loops;
    for (const Slot start : starts) {
        std::vector<Slot> loop;
        for (auto step = next.find(start); step != next.end(); step = next.find(loop.back())) {
            loop.push_back(step->second);
            next.erase(step);
        }
        if (!loop.empty())
            loops.push_back(std::move(loop));
    }
    return loops;
}

/// Removes the faces below the plane and fills the loops. Returns false if the cut cannot be closed.
bool BaseCutter::cap()
{
    std::vector<std::vector<Slot>> loops = openLoops();
    std::vector<Slot> vertices;
    std::vector<FlatPoint> points;
    for (std::vector<Slot>& loop : loops) {
        for (Slot& v : loop) {
            const LatticePoint p = m_mesh.latticePoint(v);
            vertices.push_back(v);
            points.emplace_back(p.x(), p.z());
            v = static_cast<Slot>(points.size()) - 1;
        }
    }
    const auto filling = loops.empty() ? std::nullopt : triangulatePolygon(points, std::move(loops));
    if (!filling)
        return false;
    Surgery surgery;
    surgery.nearby = vertices[0];
    for (const auto& [a, b, c] : *filling)
        surgery.faces.push_back({vertices[a], vertices[b], vertices[c]});
    std::ranges::copy_if(m_mesh.faces(), std::back_inserter(surgery.removed),
                         [&](Slot f) { return !isKept(m_mesh.corners(f)); });
    if (!isSurgeryOk(m_mesh, surgery))
        return false;
    m_mesh.replaceFaces(surgery);
    return true;
}
} // namespace

void flattenBase(Mesh& mesh, const FlattenBase& command, ModelChange& change, const JobControl& control)
{
    const Box box = boxOf(mesh);
    const double level = mesh.lattice().snap(box.min().y() + command.height);
    if (!(level > box.min().y() && level < box.max().y())) {
        change.refusal = ModelRefusal::NoBase;
        return;
    }
    const Mesh::Mark mark = mesh.mark();
    for (const int raising : raisings) {
        for (const bool settled : {true, false}) {
            BaseCutter cutter(mesh, static_cast<float>(level + raising * mesh.lattice().unit()));
            if (settled)
                cutter.settle();
            cutter.part();
            const bool closed = cutter.cap();
            control.reportProgress(afterCapping);
            if (closed && !control.isCancelled() &&
                checkMesh(extractMesh(mesh), control.part(afterCapping, 1)).printReady())
                return;
            mesh.rollback(mark);
            if (control.isCancelled())
                return;
        }
    }
    change.refusal = ModelRefusal::NoBase;
}
} // namespace core
