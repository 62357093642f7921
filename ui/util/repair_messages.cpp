#include "ui/util/repair_messages.h"

#include "ui/util/number_format.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
/// Returns a length in mm with at least three significant digits but at most six decimals.
QString shortMillimetres(double length)
{
    constexpr double min = 5e-7; // smallest length that six decimals show, mm
    if (length < min)
        return QLocale().toString(0);
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(length))), 0, 6);
    return QLocale().toString(length, 'f', decimals);
}

QString coordinates(const core::Vec3& p)
{
    return QStringLiteral("%1, %2, %3").arg(millimetres(p.x()), millimetres(p.y()), millimetres(p.z()));
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
    if (report.sheets > 0)
        steps << tr("%n open sheets left out, which enclose no space; the largest is %1 x %2 mm", nullptr,
                    static_cast<int>(report.sheets))
                     .arg(shortMillimetres(report.sheetLength), shortMillimetres(report.sheetWidth));
    add(report.holes, tr("Holes filled: %1"));
    add(report.largeHoles, tr("of these, longer than a quarter of the model: %1"));
    add(report.innerParts, tr("Parts inside of others: %1"));
    add(report.contacts, tr("Walls on each other within rounding, joined or removed: %1"));
    add(report.intersections, tr("Intersections resolved: %1"));
    add(report.touchingEdges + report.touchingVertices, tr("Touching edges and points separated: %1"));
    if (report.knots > 0)
        steps << tr("Tangles that could not be resolved, covered by small solids: %1, the widest %2 mm")
                     .arg(number(report.knots), shortMillimetres(report.widestKnot));
    add(report.crumbs, tr("Tiny thin parts left out: %1"));
    add(report.unmasked, tr("Masked points lost in the repair: %1"));
    if (report.remeshedAt)
        steps << tr("The surface was rebuilt, with edges of about %1 mm.").arg(shortMillimetres(*report.remeshedAt));
    return steps;
}

QString RepairMessages::progress(const QString& file, core::RepairStep step)
{
    const QString sentences[] = {tr("Repairing %1: points and faces"),
                                 tr("Repairing %1: cracks"),
                                 tr("Repairing %1: face directions"),
                                 tr("Repairing %1: holes"),
                                 tr("Repairing %1: intersections"),
                                 tr("Repairing %1: new surface"),
                                 tr("Repairing %1: check"),
                                 tr("Repairing %1: measuring the changes")};
    static_assert(std::size(sentences) == static_cast<std::size_t>(core::RepairStep::Measure) + 1);
    return sentences[static_cast<std::size_t>(step)].arg(file);
}

QStringList RepairMessages::losses(const core::RepairReport& report)
{
    const auto& [areaBefore, volumeBefore, partsBefore] = report.before;
    const auto& [areaAfter, volumeAfter, partsAfter] = report.after;
    return {tr("Volume: %1, before %2").arg(volumeText(volumeAfter), volumeText(volumeBefore)),
            tr("Surface: %1, before %2").arg(areaText(areaAfter), areaText(areaBefore)),
            tr("Parts: %1, before %2").arg(number(partsAfter), number(partsBefore)),
            tr("The new surface is at most %1 mm (mean %2 mm) from the old one; the old one at most %3 mm (mean %4 mm) "
               "from the new.")
                .arg(shortMillimetres(report.fromNew.largest), shortMillimetres(report.fromNew.mean),
                     shortMillimetres(report.fromOld.largest), shortMillimetres(report.fromOld.mean))};
}

QString RepairMessages::doubt(const QString& file, const core::RepairReport& report)
{
    constexpr double percent = 100;
    if (report.isFaithful() && report.keepsSurface())
        return {};
    if (report.isFaithful())
        return tr("%1 was repaired, but lost surface inside: on average, the old one is %2 mm (%3 %) away.")
            .arg(file, shortMillimetres(report.fromOld.mean),
                 QLocale().toString(percent * report.fromOld.mean / report.size, 'f', 1));
    if (report.remeshedAt)
        return tr("%1 could only be rebuilt, with edges of about %2 mm: its shape is close to the old one, but detail "
                  "is lost.")
            .arg(file, shortMillimetres(*report.remeshedAt));
    const double kept = report.keptVolume();
    const bool isLost = report.lost > core::RepairReport::maxLost * report.size;
    const bool isOfOtherVolume = kept < core::RepairReport::minVolume || kept > core::RepairReport::maxVolume;
    if (!isLost && isOfOtherVolume)
        return tr("%1 was repaired, but now has %2 % of its volume.")
            .arg(file, QLocale().toString(percent * kept, 'f', 1));
    const double space = std::max(report.space.lost + report.space.gained,
                                  report.singleSpace.lost + report.singleSpace.gained),
                 otherSpace = report.otherSpace.lost + report.otherSpace.gained;
    if (!isLost && otherSpace > core::RepairReport::maxOtherSpace)
        return tr("%1 was repaired, but parts that could be holes were treated as parts that face the wrong way: %2 % "
                  "of the space.")
            .arg(file, QLocale().toString(percent * otherSpace, 'f', 1));
    if (!isLost)
        return tr("%1 was repaired, but the space that it encloses differs by %2 % from what its faces enclosed "
                  "before.")
            .arg(file, QLocale().toString(percent * space, 'f', 1));
    return tr("%1 was repaired, but part of its surface was lost: it is %2 mm from the new one on average, %3 % of the "
              "size.")
        .arg(file, shortMillimetres(report.lost), QLocale().toString(percent * report.lost / report.size, 'f', 1));
}

QString RepairMessages::refusal(const QString& file, const core::RepairResult& result)
{
    switch (result.refusal) {
    case core::RepairRefusal::LargeHoles:
        return tr("%1 was not repaired: it has holes longer than a quarter of its size (%2), the largest near %3.")
            .arg(file, number(result.report.largeHoles), coordinates(*result.place));
    case core::RepairRefusal::Unresolved:
        return result.place ? tr("%1 cannot be repaired as it is: its faces could not be separated near %2.")
                                  .arg(file, coordinates(*result.place))
                            : tr("%1 cannot be repaired as it is: its faces could not be separated.").arg(file);
    case core::RepairRefusal::TooMuchLost:
        return result.place ? tr("%1 cannot be repaired as it is: its faces are too badly connected, and most of it "
                                 "would be lost. Openings: %2, the widest near %3.")
                                  .arg(file, number(result.report.holes), coordinates(*result.place))
                            : tr("%1 cannot be repaired as it is: its faces are too badly connected, and most of it "
                                 "would be lost.")
                                  .arg(file);
    default:
        break;
    }
    if (result.report.sheets > 0)
        return tr("%1 cannot be repaired: it has %n open sheets that enclose no space, the largest %2 x %3 mm.",
                  nullptr, static_cast<int>(result.report.sheets))
            .arg(file, shortMillimetres(result.report.sheetLength), shortMillimetres(result.report.sheetWidth));
    return tr("%1 cannot be repaired: its faces enclose no space.").arg(file);
}
} // namespace ui
