#pragma once

#include "core/io/mesh/object_labels.h"

#include <Eigen/Core>

namespace core::io
{
/// Removes the vertices that no triangle uses; the others keep their order. Precondition: the mesh is as required by
/// MeshAssembly::add().
void removeUnusedVertices(TriangleMesh& mesh);

/// Joins placed copies of a file's meshes to one mesh. A file may place a mesh very often. The result is therefore
/// limited to 16 vertices and 32 triangles for each byte of the file, or to about a million and two million if that is
/// more.
class MeshAssembly
{
public:
    explicit MeshAssembly(const FileBytes& file);

    /// Begins an object of the file; all copies up to the next one belong to it. `name`: as in the file. Must be called
    /// before the first add() if FileBytes::keepsObjects is set.
    void beginObject(std::string_view name) { m_labels.begin(name); }

    /// Adds a copy of the mesh. `transform` applies to column vectors. A mirrored copy has its triangles reversed, so
    /// that its outside stays outside. Precondition: the indices of `mesh` are in range; it has one colour for each
    /// point, or none. Throws ReadingCancelled, and FileError: TooManyElements, or NotANumber if a point is not finite.
    void add(const TriangleMesh& mesh, const Eigen::Matrix4d& transform);
    /// Returns the mesh and leaves this object empty. If some vertices have colours, the others get the default colour.
    /// If there are several objects that are to be kept, the mesh has labels.
    TriangleMesh take();
    /// Returns the parts of the mesh that take() returned.
    const PartList& parts() const { return m_parts; }

private:
    void requireRoom(std::string_view what, std::size_t wanted, std::size_t max) const;

    const FileBytes& m_file;
    StopCheck m_stopCheck;
    ObjectLabels m_labels;
    TriangleMesh m_mesh;
    PartList m_parts;
};
} // namespace core::io
