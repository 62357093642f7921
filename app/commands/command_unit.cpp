#include "app/commands/command_unit.h"

#include "app/commands/command_line.h"

#include "core/geometry/scale_mesh.h"
#include "ui/util/error_messages.h"

namespace app
{
namespace
{
constexpr std::pair<const char*, double> units[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};
const QString unitOption = QStringLiteral("unit");

QStringList words()
{
    QStringList words;
    for (const auto& [word, millimetres] : units)
        words << QString::fromLatin1(word);
    return words;
}
} // namespace

void CommandUnit::addTo(QCommandLineParser& parser)
{
    parser.addOption({unitOption, tr("Unit of the files that are read (default: mm)."), words().join(u'|')});
}

double CommandUnit::of(const CommandOptions& options)
{
    return units[options.choice(unitOption, words())].second;
}

void CommandUnit::scale(const QString& file, core::TriangleMesh& mesh, double factor)
{
    if (!core::scaleMesh(mesh, factor))
        CommandLine::fail(ui::ErrorMessages::tooLarge(file));
}
} // namespace app
