#pragma once

#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <utility>

namespace core
{
/// A change of the mesh that is either verified and committed, or undone completely. The destructor rolls back the
/// mesh, and the region, unless commit() succeeded.
class MeshTransaction
{
public:
    /// Begins a change that also changes the region. Cost: a copy of the region.
    MeshTransaction(VerifiedMesh& surface, Region& region)
        : m_surface(surface)
        , m_region(&region)
        , m_saved(region.save())
        , m_mark(surface.mesh().mark())
    {}
    /// Begins a change that leaves the region unchanged.
    explicit MeshTransaction(VerifiedMesh& surface) : m_surface(surface), m_mark(surface.mesh().mark()) {}
    ~MeshTransaction() { rollBack(); }
    MeshTransaction(const MeshTransaction&) = delete;
    MeshTransaction& operator=(const MeshTransaction&) = delete;

    /// Verifies the change and commits it if it is sound. Otherwise returns false and leaves the change in place, so
    /// that VerifiedMesh::badFaces() can be examined before rollBack().
    bool commit()
    {
        m_isOpen = !m_surface.verify(m_mark);
        return !m_isOpen;
    }

    /// Undoes the change. Does nothing after a commit or a rollback.
    void rollBack()
    {
        if (!std::exchange(m_isOpen, false))
            return;
        m_surface.mesh().rollback(m_mark);
        if (m_region)
            m_region->restore(m_saved);
    }

private:
    VerifiedMesh& m_surface;
    Region* m_region = nullptr;
    Region::Saved m_saved;
    Mesh::Mark m_mark;
    bool m_isOpen = true;
};
} // namespace core
