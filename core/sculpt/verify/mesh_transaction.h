#pragma once

#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <utility>

namespace core
{
/// A change of the mesh that either verifies and is committed, or never was: rolls the mesh back, and the region with
/// it, unless commit() succeeded.
class MeshTransaction
{
public:
    /// Cost: a copy of the region.
    MeshTransaction(VerifiedMesh& surface, Region& region)
        : m_surface(surface)
        , m_region(&region)
        , m_saved(region.save())
        , m_mark(surface.mesh().mark())
    {}
    /// For a change that leaves the region as it is.
    explicit MeshTransaction(VerifiedMesh& surface) : m_surface(surface), m_mark(surface.mesh().mark()) {}
    ~MeshTransaction() { rollBack(); }
    MeshTransaction(const MeshTransaction&) = delete;
    MeshTransaction& operator=(const MeshTransaction&) = delete;

    /// Verifies what changed, and commits it if it is sound. Otherwise the change is still there to be looked at:
    /// VerifiedMesh::badFaces() tells what is wrong with it.
    bool commit()
    {
        m_isOpen = !m_surface.verify(m_mark);
        return !m_isOpen;
    }

    /// Does nothing after a commit or a rollback.
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
