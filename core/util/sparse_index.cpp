#include "core/util/sparse_index.h"

#include <algorithm>
#include <new>

namespace core
{
namespace
{
/// Smallest capacity: 32 MiB. malloc always takes this much from fresh pages, which cost nothing until they are
/// touched.
constexpr Slot minCapacity = 1u << 23;
} // namespace

void SparseIndex::grow(Slot slot)
{
    const Slot capacity = std::max(minCapacity, 2 * slot);
    std::unique_ptr<Slot[], Free> larger(static_cast<Slot*>(std::malloc(capacity * sizeof(Slot))));
    if (!larger)
        throw std::bad_alloc();
    for (Slot i = 0; i < size(); ++i)
        larger[slots()[i]] = i;
    m_position = std::move(larger);
    m_capacity = capacity;
}
} // namespace core
