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
/// The states of a model after each of its steps, to be visited from the last to the first.
struct ModelHistory
{
    std::shared_ptr<core::Mesh> mesh; ///< a copy, after the last step; null: there was no memory for it
    int first = 0, present = 0;       ///< states: so many steps were done
    /// What takes the step at that index back; nothing if it cannot be read any more, or it was stopped. Not on the gui
    /// thread.
    std::function<std::optional<core::MeshDelta>(int index)> change;
};
} // namespace app
