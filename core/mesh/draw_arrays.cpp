#include "core/mesh/draw_arrays.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core
{
namespace
{
template <class Value>
void put(const std::vector<SlotSpan>& spans, const std::vector<Value>& values, std::vector<Value>& array)
{
    auto from = values.begin();
    for (const SlotSpan& span : spans) {
        const auto to = array.begin() + static_cast<std::ptrdiff_t>(span.first);
        std::copy_n(from, span.count, to);
        from += static_cast<std::ptrdiff_t>(span.count);
    }
}
} // namespace

void DrawArrays::apply(const MeshPatch& patch)
{
    vertices.resize(patch.vertexSlots, DrawVertex{Vec3f::Zero(), {}, {}});
    faces.resize(patch.faceSlots, Triangle{0, 0, 0});
    put(patch.vertexSpans, patch.vertices, vertices);
    put(patch.faceSpans, patch.faces, faces);
}

DrawArrays drawArraysOf(const TriangleMesh& mesh)
{
    constexpr double longest = 127; // length of a unit normal in a DrawVertex
    std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.points[t[0]].cast<double>(), b = mesh.points[t[1]].cast<double>(),
                   c = mesh.points[t[2]].cast<double>();
        const Vec3 area = (b - a).cross(c - a);
        for (const Slot corner : t)
            normals[corner] += area;
    }
    DrawArrays model{{}, mesh.triangles};
    model.vertices.reserve(mesh.points.size());
    const auto toByte = [](double x) { return static_cast<std::int8_t>(std::lrint(x)); };
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const double length = normals[v].norm();
        const Vec3 n = length > 0 ? Vec3(normals[v] * (longest / length)) : Vec3::Zero();
        const Rgb color = mesh.colors.empty() ? Rgb() : mesh.colors[v];
        model.vertices.push_back({mesh.points[v],
                                  {toByte(n.x()), toByte(n.y()), toByte(n.z()), 0},
                                  {color.r, color.g, color.b, DrawVertex::flat}});
    }
    return model;
}

MeshPatch wholePatchOf(DrawArrays arrays)
{
    MeshPatch patch;
    patch.whole = true;
    patch.vertexSlots = patch.liveVertices = static_cast<Slot>(arrays.vertices.size());
    patch.faceSlots = patch.liveFaces = static_cast<Slot>(arrays.faces.size());
    patch.vertexSpans = {{0, patch.vertexSlots}};
    patch.faceSpans = {{0, patch.faceSlots}};
    patch.vertices = std::move(arrays.vertices);
    patch.faces = std::move(arrays.faces);
    return patch;
}
} // namespace core
