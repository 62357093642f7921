#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// Edits the mesh, whose stroke is open, or leaves it alone and says why in `change`.
void symmetrize(Mesh& mesh, const Symmetrize& command, ModelChange& change, const JobControl& control);
} // namespace core
