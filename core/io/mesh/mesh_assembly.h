#pragma once

#include "core/io/mesh/format.h"

#include <Eigen/Core>

namespace core::io
{
/// Removes the vertices that no triangle names; those that stay keep their order. Precondition: as of
/// MeshAssembly::add().
void removeUnusedVertices(TriangleMesh& mesh);

/// Copies of a file's meshes, put to their places, as one mesh. A file may place a mesh very often, so that there is a
/// limit: 16 vertices and 32 triangles for each byte of the file, or a million and two million if that is more.
class MeshAssembly
{
public:
    explicit MeshAssembly(const FileBytes& file);

    /// Precondition: the indices of `mesh` are in range; its colours are one for each point, or none. `transform` is
    /// for columns; a mirrored copy is turned, so that its outside stays outside. Throws FileError: TooManyElements,
    /// and NotANumber for a point that is not finite.
    void add(const TriangleMesh& mesh, const Eigen::Matrix4d& transform);
    /// Returns the mesh, and leaves none. Vertices that have no colour get the default one where others have theirs.
    TriangleMesh take();

private:
    void requireRoom(std::string_view what, std::size_t wanted, std::size_t max) const;

    const FileBytes& m_file;
    StopCheck m_stopCheck;
    TriangleMesh m_mesh;
};
} // namespace core::io
