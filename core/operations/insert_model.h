#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// Edits the mesh. On refusal sets `change.refusal`, and the mesh must be given up or rolled back. Precondition: a
/// stroke of the mesh is open.
void insertModel(Mesh& mesh, const Insert& command, ModelChange& change, const JobControl& control);
} // namespace core
