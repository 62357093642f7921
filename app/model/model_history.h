#pragma once

#include "core/mesh/mesh_delta.h"

#include <functional>
#include <memory>
#include <optional>

namespace core
{
class Mesh;
}

namespace app
{
/// The states of a model after each undo step, for visiting them from the last to the first.
struct ModelHistory
{
    std::shared_ptr<core::Mesh> mesh; ///< a copy of the present model; null: there was not enough memory
    int first = 0, present = 0;       ///< undo indices of the earliest reachable state and of `mesh`
    /// Returns the delta that undoes the step with this index; nothing if it cannot be read or the visit was cancelled.
    /// Thread: any except the gui thread.
    std::function<std::optional<core::MeshDelta>(int index)> change;
};
} // namespace app
