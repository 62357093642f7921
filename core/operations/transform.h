#pragma once

#include "core/operations/model_command.h"

#include <span>

namespace core
{
/// The vertices' places as they are, by slot; those of free slots are the origin.
std::vector<Vec3> placesOf(const Mesh& mesh);
/// The corners of the live faces, in the order of their slots.
std::vector<Triangle> liveFaces(const Mesh& mesh);
Box boxOf(const Mesh& mesh);
/// The length of the shortest edge at the vertex, in mm.
double shortestEdge(const Mesh& mesh, Slot v);

/// Why no model may have this box.
ModelRefusal refusalOf(const Box& box);

/// Each edits the mesh, whose stroke is open, or leaves it alone and says why in `change`.
void transform(Mesh& mesh, const Move& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const Rotate& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const Scale& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const Mirror& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const PlaceOnBed& command, ModelChange& change, const JobControl& control);
void transform(Mesh& mesh, const Recentre& command, ModelChange& change, const JobControl& control);
} // namespace core
