#include "tests/support/mesh_asserts.h"

#include "core/geometry/triangle_intersection.h"

#include <algorithm>
#include <sstream>

namespace mesh_asserts
{
using core::LatticePoint;
using core::LatticePredicates;
using core::Mesh;
using core::noSlot;
using core::Slot;
using core::Triangle;
using core::TriangleMesh;

std::unique_ptr<Mesh> sculptable(TriangleMesh mesh)
{
    float largest = 0;
    for (const core::Vec3f& p : mesh.points)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return sculptable(std::move(mesh), core::Lattice::forExtent(static_cast<double>(largest)));
}

std::unique_ptr<Mesh> sculptable(TriangleMesh mesh, core::Lattice lattice)
{
    for (core::Vec3f& p : mesh.points)
        p = lattice.snap(p.cast<double>());
    return std::make_unique<Mesh>(mesh, lattice);
}

namespace
{
class LinkCheck
{
public:
    explicit LinkCheck(const Mesh& mesh) : m_mesh(mesh) {}

    std::string run()
    {
        for (Slot f = 0; f < m_mesh.slots().faces; ++f) {
            if (m_mesh.isFace(f))
                checkFace(f);
            else
                expect(m_mesh.corners(f) == Triangle{0, 0, 0}, "a free face has corners", f);
        }
        for (Slot e = 0; e < m_mesh.slots().edges; ++e) {
            if (m_mesh.isEdge(e))
                checkEdge(e);
        }
        for (Slot v = 0; v < m_mesh.slots().vertices; ++v) {
            if (m_mesh.isVertex(v))
                checkVertex(v);
        }
        expect(2 * m_mesh.live().edges == 3 * m_mesh.live().faces, "edges do not fit the faces", 0);
        return m_problem;
    }

private:
    bool expect(bool condition, const char* what, Slot where)
    {
        if (!condition && m_problem.empty()) {
            std::ostringstream text;
            text << what << " (slot " << where << ")";
            m_problem = text.str();
        }
        return condition;
    }

    bool isLiveHalfedge(Slot h) const { return h / 2 < m_mesh.slots().edges && m_mesh.isEdge(h / 2); }

    void checkFace(Slot f)
    {
        Slot h = m_mesh.faceHalfedge(f);
        std::array<Slot, 3> loop{};
        for (Slot& corner : loop) {
            if (!expect(isLiveHalfedge(h), "a face's half-edge is not live", f))
                return;
            expect(m_mesh.face(h) == f, "a face's half-edge belongs to another face", f);
            expect(m_mesh.prev(m_mesh.next(h)) == h, "prev is not the inverse of next", f);
            corner = m_mesh.from(h);
            h = m_mesh.next(h);
        }
        expect(h == m_mesh.faceHalfedge(f), "a face is no triangle", f);
        const Triangle& corners = m_mesh.corners(f);
        const auto first = std::ranges::find(loop, corners[0]);
        std::ranges::rotate(loop, first == loop.end() ? loop.begin() : first);
        expect(loop == corners, "corners do not agree with the half-edges", f);
        expect(loop[0] != loop[1] && loop[1] != loop[2] && loop[2] != loop[0], "a corner appears twice", f);
    }

    void checkEdge(Slot e)
    {
        for (Slot h : {2 * e, 2 * e + 1}) {
            const Slot f = m_mesh.face(h), v = m_mesh.to(h);
            if (!expect(f < m_mesh.slots().faces && m_mesh.isFace(f), "a half-edge's face is not live", e) ||
                !expect(v < m_mesh.slots().vertices && m_mesh.isVertex(v), "a half-edge's vertex is not live", e))
                return;
            const Slot first = m_mesh.faceHalfedge(f);
            const Slot second = m_mesh.next(first);
            expect(h == first || h == second || h == m_mesh.next(second), "a half-edge is not in its face's loop", e);
        }
        expect(m_mesh.to(2 * e) != m_mesh.to(2 * e + 1), "an edge is a loop", e);
    }

    /// Checks that the faces around `v` form one umbrella: rotate() visits each outgoing half-edge once, each to a
    /// different neighbour.
    void checkVertex(Slot v)
    {
        if (m_leaving.empty())
            countLeaving();
        std::vector<Slot> neighbours;
        const Slot first = m_mesh.outgoing(v);
        Slot h = first;
        do {
            if (!expect(isLiveHalfedge(h) && m_mesh.from(h) == v, "an outgoing half-edge does not leave its vertex",
                        v) ||
                !expect(neighbours.size() < m_leaving[v], "a vertex has no end of neighbours", v))
                return;
            neighbours.push_back(m_mesh.to(h));
            h = m_mesh.rotate(h);
        } while (h != first);
        expect(neighbours.size() == m_leaving[v], "a vertex has two umbrellas", v);
        expect(neighbours.size() >= 3, "a vertex has fewer than three neighbours", v);
        std::ranges::sort(neighbours);
        expect(std::ranges::adjacent_find(neighbours) == neighbours.end(), "two edges join the same vertices", v);
        expect(m_mesh.lattice().isOnLattice(m_mesh.point(v)), "a vertex is not on the lattice", v);
    }

    void countLeaving()
    {
        m_leaving.resize(m_mesh.slots().vertices);
        for (Slot h = 0; h < 2 * m_mesh.slots().edges; ++h) {
            if (m_mesh.isEdge(h / 2))
                ++m_leaving[m_mesh.from(h)];
        }
    }

    const Mesh& m_mesh;
    std::vector<std::size_t> m_leaving;
    std::string m_problem;
};
} // namespace

std::string brokenLinks(const Mesh& mesh)
{
    return LinkCheck(mesh).run();
}

std::int64_t eulerNumber(const Mesh& mesh)
{
    const core::SlotCounts live = mesh.live();
    return std::int64_t(live.vertices) - live.edges + live.faces;
}

std::vector<Slot> badFaces(const Mesh& mesh)
{
    struct Face
    {
        core::CornerTriangle<LatticePredicates> shape;
        LatticePoint min, max;
        Slot slot;
    };
    std::vector<Face> faces;
    std::vector<Slot> bad;
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        if (!mesh.isFace(f))
            continue;
        const Triangle& t = mesh.corners(f);
        const LatticePoint a = mesh.latticePoint(t[0]), b = mesh.latticePoint(t[1]), c = mesh.latticePoint(t[2]);
        if (LatticePredicates::collinear(a, b, c))
            bad.push_back(f);
        else
            faces.push_back({{t, {a, b, c}}, a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), f});
    }
    std::ranges::sort(faces, {}, [](const Face& face) { return face.min.x(); });
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Face& s = faces[i];
        for (std::size_t j = i + 1; j < faces.size() && faces[j].min.x() <= s.max.x(); ++j) {
            const Face& t = faces[j];
            const bool apart =
                t.min.y() > s.max.y() || s.min.y() > t.max.y() || t.min.z() > s.max.z() || s.min.z() > t.max.z();
            if (!apart && core::trianglesIntersect(s.shape, t.shape))
                bad.insert(bad.end(), {s.slot, t.slot});
        }
    }
    std::ranges::sort(bad);
    bad.erase(std::ranges::unique(bad).begin(), bad.end());
    return bad;
}

TriangleMesh surfaceOf(const Mesh& mesh)
{
    TriangleMesh surface;
    std::vector<Slot> index(mesh.slots().vertices, noSlot);
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (!mesh.isVertex(v))
            continue;
        index[v] = static_cast<Slot>(surface.points.size());
        surface.points.push_back(mesh.point(v));
        surface.colors.push_back(mesh.color(v));
    }
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        const Triangle& t = mesh.corners(f);
        if (mesh.isFace(f))
            surface.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
    }
    return surface;
}
} // namespace mesh_asserts
