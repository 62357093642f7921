#pragma once

#include "app/classroom/class_works.h"
#include "app/commands/command_line.h"
#include "app/commands/command_options.h"

namespace app
{
/// The models that a subcommand was given, as files.
struct CommandModels
{
    QList<FoundModel> files; ///< each may be missing or unreadable
    bool hasFolder = false;  ///< there was a folder among the arguments
    /// BadInput: there was one that could not be read, or held no model; standard error says which.
    ExitStatus status = Done;
};

/// A folder stands for the models in it, by name, that of a class for its pupils' works, and "-" for the standard
/// input. Throws CommandFailure if no file was given.
CommandModels commandModels(const CommandOptions& options);
} // namespace app
