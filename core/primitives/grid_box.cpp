#include "core/primitives/grid_box.h"

#include <map>

namespace core
{
namespace
{
/// Returns the coordinate of grid line `i` of `count` cells: the opposite of that of line count - i.
double coordinate(int i, int count, double size)
{
    const double half = size / 2;
    if (i == 0 || i == count)
        return i == 0 ? -half : half;
    return half * (2 * i - count) / count;
}
} // namespace

void addQuad(TriangleMesh& mesh, const std::array<Slot, 4>& q, bool even)
{
    if (even)
        mesh.triangles.insert(mesh.triangles.end(), {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}});
    else
        mesh.triangles.insert(mesh.triangles.end(), {{q[0], q[1], q[3]}, {q[1], q[2], q[3]}});
}

TriangleMesh gridBox(const std::array<int, 3>& cells, const Vec3& sizes)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, Slot> known;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [entry, isNew] = known.try_emplace(at, static_cast<Slot>(mesh.points.size()));
        if (isNew) {
            Vec3 p;
            for (std::size_t k = 0; k < 3; ++k)
                p[static_cast<Eigen::Index>(k)] = coordinate(at[k], cells[k], sizes[static_cast<Eigen::Index>(k)]);
            mesh.points.push_back(p.cast<float>());
        }
        return entry->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const int side : {0, cells[axis]}) {
            for (int i = 0; i < cells[u]; ++i) {
                for (int j = 0; j < cells[v]; ++j) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> at{};
                        at[axis] = side;
                        at[u] = i + di;
                        at[v] = j + dj;
                        return vertex(at);
                    };
                    std::array<Slot, 4> quad = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    if (side == 0)
                        std::swap(quad[1], quad[3]);
                    addQuad(mesh, quad, (i + j) % 2 == 0);
                }
            }
        }
    }
    return mesh;
}
} // namespace core
