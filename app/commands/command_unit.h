#pragma once

#include "app/commands/command_options.h"

#include "core/io/mesh_io.h"

namespace app
{
/// --unit of the subcommands: what models' files are measured in. Throws CommandFailure.
class CommandUnit
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandUnit)

public:
    static void addTo(QCommandLineParser& parser);
    /// Millimetres a unit; 1 if the option is not set.
    static double of(const CommandOptions& options);
    /// Each coordinate rounded once. `file`: for the sentence, if the coordinates become no numbers.
    static void scale(const QString& file, core::TriangleMesh& mesh, double factor);
};
} // namespace app
