#include "tests/bench/bench_models.h"

#include "core/geometry/morton_order.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/stroke_fuzzer.h"

#include <map>
#include <numeric>

namespace bench
{
using core::Slot;
using core::TriangleMesh;
using core::Vec3;

namespace
{
TriangleMesh builtSphere(Slot n)
{
    const TriangleMesh base = core::icosphere(0, 1);
    TriangleMesh mesh;
    std::map<std::array<Slot, 6>, Slot>
        known; // vertices on edges and corners of the icosahedron; key: three pairs (corner, weight), 0 if unused
    const auto vertex = [&](const core::Triangle& t, std::array<Slot, 3> weights) {
        Vec3 p = Vec3::Zero();
        std::array<std::pair<Slot, Slot>, 3> parts{};
        std::size_t used = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            p += static_cast<double>(weights[i]) * base.points[t[i]].cast<double>();
            if (weights[i] > 0)
                parts[used++] = {t[i] + 1, weights[i]};
        }
        const auto add = [&] {
            mesh.points.push_back(p.normalized().cast<float>());
            return static_cast<Slot>(mesh.points.size() - 1);
        };
        if (used == 3)
            return add();
        std::ranges::sort(parts);
        const std::array<Slot, 6> key = {parts[0].first,  parts[0].second, parts[1].first,
                                         parts[1].second, parts[2].first,  parts[2].second};
        const auto found = known.find(key);
        return found != known.end() ? found->second : known.emplace(key, add()).first->second;
    };
    for (const core::Triangle& t : base.triangles) {
        std::vector<std::vector<Slot>> rows(n + 1);
        for (Slot i = 0; i <= n; ++i) {
            for (Slot j = 0; j <= i; ++j)
                rows[i].push_back(vertex(t, {n - i, i - j, j}));
        }
        for (Slot i = 0; i < n; ++i) {
            for (Slot j = 0; j <= i; ++j) {
                mesh.triangles.push_back({rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]});
                if (j < i)
                    mesh.triangles.push_back({rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]});
            }
        }
    }
    return mesh;
}
} // namespace

const TriangleMesh& geodesicSphere(Slot cuts)
{
    static std::map<Slot, TriangleMesh> spheres;
    const auto known = spheres.find(cuts);
    return known != spheres.end() ? known->second : spheres.emplace(cuts, builtSphere(cuts)).first->second;
}

TriangleMesh shuffled(const TriangleMesh& mesh)
{
    StrokeFuzzer random(20240812);
    const auto shuffle = [&](auto& values) {
        for (std::size_t i = values.size(); i > 1; --i)
            std::swap(values[i - 1], values[random.below(i)]);
    };
    std::vector<Slot> newOf(mesh.points.size());
    std::iota(newOf.begin(), newOf.end(), Slot(0));
    shuffle(newOf);
    TriangleMesh result = mesh;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        result.points[newOf[v]] = mesh.points[v];
    for (core::Triangle& t : result.triangles)
        t = {newOf[t[0]], newOf[t[1]], newOf[t[2]]};
    shuffle(result.triangles);
    return result;
}

std::unique_ptr<core::Mesh> opened(const TriangleMesh& mesh)
{
    const core::Lattice lattice = core::Lattice::forExtent(1);
    return mesh_asserts::sculptable(core::inMortonOrder(mesh, lattice), lattice);
}
} // namespace bench
