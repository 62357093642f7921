#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// Returns the mesh as it was when the snapshot was taken, slot for slot.
std::unique_ptr<Mesh> meshOf(const Snapshot& snapshot);
} // namespace core
