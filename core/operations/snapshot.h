#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// As it was when the snapshot was taken, slot for slot.
std::unique_ptr<Mesh> meshOf(const Snapshot& snapshot);
} // namespace core
