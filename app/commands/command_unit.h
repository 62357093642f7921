#pragma once

#include "core/io/mesh_io.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// --unit of the subcommands: what a model's file is measured in. Throws CommandFailure.
class CommandUnit
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandUnit)

public:
    /// Millimetres a unit.
    static double named(const QString& command, const QString& word);
    /// The words that there are, as usage shows them.
    static QString words();
    /// Each coordinate rounded once. `file`: for the sentence, if the coordinates become no numbers.
    static void scale(const QString& file, core::TriangleMesh& mesh, double factor);
};
} // namespace app
