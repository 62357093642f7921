#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// Edits the mesh; on refusal leaves it unchanged and sets `change.refusal`. A curve beside the model changes nothing.
/// Vertices keep place, colour and mask, except that corners of cut faces may move by two lattice units; new ones have
/// no mask. A model that is symmetric, bit for bit, about the command's plane remains so: one half of the result is
/// replaced by the image of the other. Precondition: a stroke of the mesh is open.
void trim(Mesh& mesh, const Trim& command, ModelChange& change, const JobControl& control);

/// Cuts the mesh as trim() does, and returns the solid that was cut away, on the mesh's lattice. Nothing, and leaves
/// the mesh with what it has, if the curve does not divide the model or on refusal. Precondition as above.
std::optional<TriangleMesh> split(Mesh& mesh, const Trim& command, ModelChange& change, const JobControl& control);
} // namespace core
