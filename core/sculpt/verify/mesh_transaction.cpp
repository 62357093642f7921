#include "core/sculpt/verify/mesh_transaction.h"

#include <utility>

namespace core
{
void MeshTransaction::rollBack()
{
    if (!std::exchange(m_isOpen, false))
        return;
    m_surface.mesh().rollback(m_mark);
    if (m_region)
        m_region->restore(m_saved);
}
} // namespace core
