#pragma once

#include "app/commands/command_options.h"

#include "core/io/mesh_io.h"

namespace app
{
/// The option --unit of the subcommands: the unit of length of the models' files.
class CommandUnit
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandUnit)

public:
    static void addTo(QCommandLineParser& parser);
    /// Returns millimetres per unit; 1 if the option is not set. Throws CommandFailure for an unknown unit.
    static double of(const CommandOptions& options);
    /// Scales the mesh; each coordinate is rounded once. Throws CommandFailure if coordinates become infinite. `file`:
    /// name of the mesh's file for the error message.
    static void scale(const QString& file, core::TriangleMesh& mesh, double factor);
};
} // namespace app
