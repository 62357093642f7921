#include "app/classroom/class_works.h"

#include "app/classroom/work_archive.h"
#include "app/model/model_loader.h"

#include "core/util/file_error.h"
#include "ui/util/path_display.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace app
{
namespace
{
/// Returns a work. If turn.json has no name, uses the name of the folder, which a pupil or teacher may have renamed.
FoundModel workIn(const QString& folder)
{
    FoundModel found{toPath(WorkArchive::modelOf(folder)), folder, WorkArchive::turnOf(folder)};
    const QString name = found.turn.pupil.simplified();
    found.pupil = name.isEmpty() ? QFileInfo(folder).fileName() : name;
    return found;
}

/// Returns the works in the folder, only the last one of each turn.
QList<FoundModel> worksOf(const QString& folder)
{
    QList<FoundModel> works;
    for (const QString& work : WorkArchive::worksIn(folder)) {
        const FoundModel found = workIn(work);
        works.removeIf(
            [&found](const FoundModel& other) { return !other.turn.id.isEmpty() && other.turn.id == found.turn.id; });
        works << found;
    }
    return works;
}

/// Adds the turn's beginning to names that several turns have.
void tellApart(QList<FoundModel>& works)
{
    QStringList names;
    for (const FoundModel& work : works)
        names << work.pupil;
    for (FoundModel& work : works)
        if (names.count(work.pupil) > 1)
            work.pupil += QStringLiteral(" (%1)").arg(work.turn.begun.isValid()
                                                          ? QLocale().toString(work.turn.begun, QLocale::ShortFormat)
                                                          : QFileInfo(work.work).fileName());
}
} // namespace

std::optional<double> TurnFacts::seconds() const
{
    if (used)
        return used;
    if (!begun.isValid() || !ended.isValid() || ended < begun)
        return std::nullopt;
    return static_cast<double>(begun.secsTo(ended));
}

QString FoundModel::title() const
{
    return pupil.isEmpty() ? ui::displayName(file.filename()) : pupil;
}

QList<FoundModel> modelsAndWorks(const std::filesystem::path& folder)
{
    const QString name = ui::displayName(folder);
    if (WorkArchive::isWork(name))
        return {workIn(name)};
    QList<FoundModel> works = worksOf(name);
    const QCollator collator = ui::nameCollator();
    std::ranges::stable_sort(works, [&collator](const FoundModel& a, const FoundModel& b) {
        return collator.compare(a.pupil, b.pupil) < 0;
    });
    tellApart(works);
    try {
        for (const std::filesystem::path& file : ui::modelsIn(folder))
            works << FoundModel{file};
    } catch (const core::FileError& error) {
        if (error.kind != core::FileErrorKind::NoModel || works.isEmpty())
            throw;
    }
    return works;
}
} // namespace app
