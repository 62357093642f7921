#pragma once

#include "core/operations/model_command.h"

#include <span>

namespace core
{
/// Returns the vertices' positions by slot; the origin for free slots.
std::vector<Vec3> placesOf(const Mesh& mesh);
/// Returns the corners of the live faces, in the order of their slots.
std::vector<Triangle> liveFaces(const Mesh& mesh);
/// Returns the part of each vertex slot.
std::vector<PartId> partsOf(const Mesh& mesh);
Box boxOf(const Mesh& mesh);
/// Returns the length of the shortest edge at the vertex, mm.
double shortestEdge(const Mesh& mesh, Slot v);

/// Returns TooLarge if a bounding box exceeds ModelLimits, else None.
ModelRefusal refusalOf(const Box& box);

/// Each transform() edits the mesh; on refusal leaves it unchanged and sets `change.refusal`. Precondition: a stroke of
/// the mesh is open. `part`: the part that moves; nothing: all parts.
void transform(Mesh& mesh, const Move& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control);
void transform(Mesh& mesh, const Rotate& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control);
void transform(Mesh& mesh, const Mirror& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control);
void transform(Mesh& mesh, const Transform& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control);
void transform(Mesh& mesh, const Scale& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const PlaceOnBed& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const Recentre& command, ModelChange& change, const JobControl& control);
} // namespace core
