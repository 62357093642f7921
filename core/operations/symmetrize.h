#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// Edits the mesh; on refusal leaves it unchanged and sets `change.refusal`. Precondition: a stroke of the mesh is
/// open.
void symmetrize(Mesh& mesh, const Symmetrize& command, ModelChange& change, const JobControl& control);
} // namespace core
