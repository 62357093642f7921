#pragma once

#include "core/operations/model_command.h"
#include "core/stroke/tool.h"

namespace core
{
/// Counts of edges outside the bounds of a uniform mesh.
struct Evenness
{
    std::size_t edges = 0;
    std::size_t tooLong = 0;  ///< edges longer than d_detail, except masked ones
    std::size_t tooShort = 0; ///< edges shorter than d, except masked ones

    /// Returns true if no edge is too long and at most one in 20 is too short: the state after a dab, and the target of
    /// a uniform remeshing.
    bool isUniform() const { return tooLong == 0 && !hasManyShort(); }
    bool hasManyShort() const { return 20 * tooShort > edges; }
};
Evenness evennessOf(const Mesh& mesh, const EdgeBounds& bounds);

double areaOf(const Mesh& mesh);

/// Remeshes the whole model to one d_detail. Precondition: a stroke of the mesh is open. If cancelled or refused, the
/// mesh may be half done, and the caller must roll the stroke back.
void remeshUniformly(Mesh& mesh, const RemeshUniformly& command, ModelChange& change, const JobControl& control);
} // namespace core
