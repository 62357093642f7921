#pragma once

#include "core/operations/model_command.h"
#include "core/stroke/tool.h"

namespace core
{
/// How even a mesh is.
struct Evenness
{
    std::size_t edges = 0;
    std::size_t tooLong = 0;  ///< longer than d_detail; of these two what is masked is left out
    std::size_t tooShort = 0; ///< shorter than d

    /// What a dab leaves behind, and what a uniform remeshing aims at: none too long, one in twenty too short.
    bool isUniform() const { return tooLong == 0 && !hasManyShort(); }
    bool hasManyShort() const { return 20 * tooShort > edges; }
};
Evenness evennessOf(const Mesh& mesh, const EdgeBounds& bounds);

double areaOf(const Mesh& mesh);

/// Edits the mesh, whose stroke is open. Stopped or refused, it leaves the mesh half done: the caller takes the stroke
/// back.
void remeshUniformly(Mesh& mesh, const RemeshUniformly& command, ModelChange& change, const JobControl& control);
} // namespace core
