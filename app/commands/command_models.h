#pragma once

#include "app/classroom/class_works.h"
#include "app/commands/command_line.h"
#include "app/commands/command_options.h"
#include "core/operations/part_union.h"

namespace app
{
/// The model files that a subcommand was given.
struct CommandModels
{
    QList<FoundModel> files; ///< some may be missing or unreadable
    bool hasFolder = false;  ///< whether a folder was among the arguments
    /// BadInput if a folder could not be read or had no model; standard error says which one.
    ExitStatus status = Done;
};

/// Returns the models named by the arguments. A folder is replaced by its models, sorted by name, or by the pupils'
/// works if it belongs to a class; "-" is standard input. Throws CommandFailure if no file was given or standard input
/// cannot be read.
CommandModels commandModels(const CommandOptions& options);

/// Unites the parts of the mesh if they overlap and a file of this name cannot keep them apart
/// (ModelExport::joinsPartsByDefault()). Failed: no sound union was found, and the mesh is as it was.
core::PartUnion unitePartsFor(const QString& out, core::TriangleMesh& mesh);
} // namespace app
