#pragma once

#include "mesh.h"
#include "model_command.h"

namespace core
{
/// Changes the whole model's mask; nothing else of it. Precondition: a stroke is open. O(mesh), steps of a ring at a time.
void changeMask(Mesh& mesh, const ChangeMask& command);

/// By their names in stroke files.
std::string_view name(ChangeMask::How how);
std::optional<ChangeMask::How> maskChangeNamed(std::string_view name);
} // namespace core
