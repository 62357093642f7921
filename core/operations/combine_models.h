#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// An inserted model at its place.
struct PlacedModel
{
    const TriangleMesh& model; ///< print-ready, without unused vertices
    Vec3 offset;               ///< translation that puts it into its place, mm
    Box whole;                 ///< box of both models
};

/// Joins, subtracts or intersects the solids that both models bound (mesh_boolean.h). The result is on the mesh's
/// lattice, unless the inserted model needs a coarser one. Faces and vertices of the mesh that the result also has keep
/// their slots, and the vertices their colours and masks; new vertices have no mask. Edits the mesh; on refusal leaves
/// it unchanged and sets `change.refusal`. Precondition: a stroke of the mesh is open, and `how` is Join, Subtract or
/// Intersect.
void combineModels(Mesh& mesh, Insert::Combination how, const PlacedModel& added, ModelChange& change,
                   const JobControl& control);
} // namespace core
