#include "app/commands/command_unit.h"

#include "app/commands/command_line.h"

#include "core/geometry/scale_mesh.h"
#include "ui/util/error_messages.h"

namespace app
{
namespace
{
constexpr std::pair<const char*, double> units[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};
} // namespace

double CommandUnit::named(const QString& command, const QString& word)
{
    for (const auto& [name, millimetres] : units)
        if (word == QLatin1String(name))
            return millimetres;
    CommandLine::fail(tr("%1: --unit is mm, cm, m or in, not %2.").arg(command, word));
}

QString CommandUnit::words()
{
    return QStringLiteral("mm|cm|m|in");
}

void CommandUnit::scale(const QString& file, core::TriangleMesh& mesh, double factor)
{
    if (!core::scaleMesh(mesh, factor))
        CommandLine::fail(ui::ErrorMessages::tooLarge(file));
}
} // namespace app
