#include "ui/util/repair_messages.h"

#include "ui/util/number_format.h"

#include <QLocale>

#include <cmath>

namespace ui
{
namespace
{
/// Three digits that count.
QString shortMillimetres(double length)
{
    constexpr double min = 5e-7; // that is seen of six decimals
    if (length < min)
        return QLocale().toString(0);
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(length))), 0, 6);
    return QLocale().toString(length, 'f', decimals);
}
} // namespace

QStringList RepairMessages::steps(const core::RepairReport& report)
{
    QStringList steps;
    const auto add = [&steps](std::uint64_t count, const QString& step) {
        if (count > 0)
            steps << step.arg(number(count));
    };
    add(report.welded, tr("Points welded: %1"));
    add(report.degenerateFaces, tr("Faces without area removed: %1"));
    add(report.duplicateFaces, tr("Duplicate faces removed: %1"));
    if (report.joined > 0)
        steps << tr("Open points joined at cracks: %1, within %2 mm")
                     .arg(number(report.joined), shortMillimetres(report.joinedWithin));
    add(report.turnedFaces, tr("Faces or parts turned outwards: %1"));
    add(report.membraneFaces, tr("Faces of inner sheets removed: %1"));
    add(report.holes, tr("Holes filled: %1"));
    add(report.largeHoles, tr("of these, longer than a quarter of the model: %1"));
    add(report.innerParts, tr("Parts inside of others: %1"));
    add(report.intersections, tr("Pairs of faces that met, cut and joined: %1"));
    add(report.touchingEdges + report.touchingVertices,
        tr("Edges and points at which parts merely touched, drawn apart: %1"));
    add(report.unmasked, tr("Masked points that went, and their mask with them: %1"));
    if (report.remeshedAt)
        steps << tr("The surface was made anew, with edges of about %1 mm.").arg(shortMillimetres(*report.remeshedAt));
    return steps;
}

QString RepairMessages::progress(const QString& file, core::RepairStep step)
{
    const QString sentences[] = {tr("Mending %1: points and faces"),
                                 tr("Mending %1: cracks"),
                                 tr("Mending %1: directions of the faces"),
                                 tr("Mending %1: holes"),
                                 tr("Mending %1: intersections"),
                                 tr("Mending %1: a new surface"),
                                 tr("Mending %1: the check"),
                                 tr("Mending %1: measuring what moved")};
    static_assert(std::size(sentences) == static_cast<std::size_t>(core::RepairStep::Measure) + 1);
    return sentences[static_cast<std::size_t>(step)].arg(file);
}

QString RepairMessages::distance(const core::RepairReport& report)
{
    return tr("The new surface is at most %1 mm (mean %2 mm) from the old one; the old one at most %3 mm (mean %4 mm) "
              "from the new.")
        .arg(shortMillimetres(report.fromNew.largest), shortMillimetres(report.fromNew.mean),
             shortMillimetres(report.fromOld.largest), shortMillimetres(report.fromOld.mean));
}

QString RepairMessages::refusal(const QString& file, const core::RepairResult& result)
{
    if (result.refusal == core::RepairRefusal::LargeHoles)
        return tr("%1 was not mended: it has holes longer than a quarter of it (%2).")
            .arg(file, number(result.report.largeHoles));
    return tr("%1 cannot be mended: its faces enclose no space.").arg(file);
}
} // namespace ui
