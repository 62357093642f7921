#include "core/io/mesh/mesh_assembly.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace core::io
{
namespace
{
/// Largest numbers of vertices and triangles for each byte of the file. `alwaysTaken` vertices and twice as many
/// triangles are always allowed.
constexpr std::size_t maxVertexCopies = 16, maxFaceCopies = 32, alwaysTaken = std::size_t(1) << 20;
} // namespace

void removeUnusedVertices(TriangleMesh& mesh)
{
    // Initially 1 for used vertices, later the new index of each vertex.
    std::vector<Slot> places(mesh.points.size(), 0);
    for (const Triangle& triangle : mesh.triangles)
        for (const Slot corner : triangle)
            places[corner] = 1;
    Slot count = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool isUsed = places[i] == 1;
        places[i] = count;
        if (!isUsed)
            continue;
        mesh.points[count] = mesh.points[i];
        if (!mesh.colors.empty())
            mesh.colors[count] = mesh.colors[i];
        ++count;
    }
    mesh.points.resize(count);
    mesh.colors.resize(mesh.colors.empty() ? 0 : count);
    for (Triangle& triangle : mesh.triangles)
        for (Slot& corner : triangle)
            corner = places[corner];
}

MeshAssembly::MeshAssembly(const FileBytes& file) : m_file(file), m_stopCheck(file.stop), m_labels(file.keepsObjects) {}

void MeshAssembly::add(const TriangleMesh& mesh, const Eigen::Matrix4d& transform)
{
    requireRoom("vertices", m_mesh.points.size() + mesh.points.size(),
                std::min(maxVertices, std::max(alwaysTaken, maxVertexCopies * m_file.bytes.size())));
    requireRoom("faces", m_mesh.triangles.size() + mesh.triangles.size(),
                std::min(maxFaces, std::max(2 * alwaysTaken, maxFaceCopies * m_file.bytes.size())));
    const auto first = static_cast<Slot>(m_mesh.points.size());
    const bool isPlain = transform == Eigen::Matrix4d::Identity();
    for (Vec3f point : mesh.points) {
        m_stopCheck();
        if (!isPlain)
            point = (transform * point.cast<double>().homogeneous()).head<3>().cast<float>();
        if (!point.allFinite())
            throw errorWithToken(FileErrorKind::NotANumber, m_file, {});
        m_mesh.points.push_back(point);
    }
    m_labels.label(m_mesh);
    if (!mesh.colors.empty()) {
        m_mesh.colors.resize(first, Rgb());
        m_mesh.colors.insert(m_mesh.colors.end(), mesh.colors.begin(), mesh.colors.end());
    }
    const bool isMirrored = transform.topLeftCorner<3, 3>().determinant() < 0;
    for (auto [a, b, c] : mesh.triangles) {
        m_stopCheck();
        if (isMirrored)
            std::swap(b, c);
        m_mesh.triangles.push_back({first + a, first + b, first + c});
    }
}

TriangleMesh MeshAssembly::take()
{
    if (!m_mesh.colors.empty())
        m_mesh.colors.resize(m_mesh.points.size(), Rgb());
    m_parts = m_labels.finish(m_mesh);
    return std::exchange(m_mesh, {});
}

void MeshAssembly::requireRoom(std::string_view what, std::size_t wanted, std::size_t max) const
{
    if (wanted > max)
        throw tooMany(what, max, errorWithToken({}, m_file, {}));
}
} // namespace core::io
