#include "ui/print/print_findings.h"

#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"

#include <QCoreApplication>
#include <QLocale>

namespace ui
{
namespace
{
class PrintText
{
    Q_DECLARE_TR_FUNCTIONS(ui::PrintFindings)
};

QString percent(double share)
{
    return PrintText::tr("%1 %").arg(QLocale().toString(100 * share, 'f', share < 0.1 ? 1 : 0));
}

QString degrees(double angle)
{
    return PrintText::tr("%1°").arg(QLocale().toString(angle, 'f', 0));
}

PrintFinding surface(const core::MeshReport& mesh)
{
    if (mesh.printReady())
        return {PrintVerdict::Good,
                PrintText::tr("Watertight surface"),
                PrintText::tr("Closed, all faces outwards, no self-intersections. Checked exactly."),
                {},
                {}};
    return {PrintVerdict::Bad, PrintText::tr("The surface needs repair"),
            PrintText::tr("It is open, intersects itself or encloses no space; walls were not measured.")};
}

PrintFinding parts(const core::MeshReport& mesh)
{
    const QString text = PrintText::tr("%Ln parts", nullptr, static_cast<int>(mesh.components));
    return {mesh.components == 1 ? PrintVerdict::Good : PrintVerdict::Warning, text,
            PrintText::tr("Separate parts of the surface; closed hollows count as parts.")};
}

PrintFinding overlap(PrintedParts united)
{
    if (united == PrintedParts::United)
        return {
            PrintVerdict::Good, PrintText::tr("Overlapping parts checked as one"),
            PrintText::tr("The visible parts overlap. They were united for the check, as exporting for print unites "
                          "them.")};
    return {PrintVerdict::Warning, PrintText::tr("Overlapping parts cannot be united"),
            PrintText::tr("Each part was checked alone. Move one a little; otherwise the export will not unite them, "
                          "either.")};
}

PrintFinding bed(const core::MeshReport& mesh, const core::PrintReport& print, const QString& printer)
{
    const QString size = PrintText::tr("%1 mm wide, %2 mm deep, %3 mm high.")
                             .arg(millimetres(mesh.size.x()), millimetres(mesh.size.z()), millimetres(mesh.size.y()));
    switch (print.fit) {
    case core::BedFit::AsItStands:
        return {PrintVerdict::Good, PrintText::tr("Fits %1").arg(printer), size};
    case core::BedFit::Turned:
        return {PrintVerdict::Good, PrintText::tr("Fits %1, turned by 90°").arg(printer), size};
    case core::BedFit::Not:
        break;
    }
    return {PrintVerdict::Bad, PrintText::tr("Too large for %1").arg(printer), size};
}

/// Returns a length in mm with two decimals, at least 0.01; printers do not resolve more.
QString hundredths(double millimetres)
{
    return QLocale().toString(std::max(millimetres, 0.01), 'f', 2);
}

QString placeArea(double squareMillimetres)
{
    return squareMillimetres < 1 ? PrintText::tr("%1 mm²").arg(hundredths(squareMillimetres))
                                 : areaText(squareMillimetres);
}

PrintFinding walls(const core::PrintReport& print, const core::PrintLimits& limits)
{
    const auto mm = [](const std::optional<double>& length) {
        return length ? millimetres(*length) : QStringLiteral("–");
    };
    PrintFinding finding;
    finding.tip = PrintText::tr("Shares are of the surface. The thinnest place: %1 mm.").arg(mm(print.thinnest));
    if (print.thin.count == 0) {
        finding.text = print.thinnest ? PrintText::tr("Walls from %1 mm on").arg(mm(print.thinnest))
                                      : PrintText::tr("No thin walls");
        return finding;
    }
    const QString limit = QLocale().toString(limits.minWall, 'g', 4);
    if (core::hasThinWalls(print, limits)) {
        finding.verdict = PrintVerdict::Bad;
        finding.text = PrintText::tr("%1 thinner than %2 mm").arg(percent(print.thin.area / print.area), limit);
    } else {
        finding.text = PrintText::tr("Only specks thinner than %1 mm").arg(limit);
    }
    finding.picture = core::PrintPicture::Thickness;
    finding.places = print.thin.places;
    for (const core::PrintPlace& place : finding.places)
        finding.placeTexts
            << PrintText::tr("%1 mm, %2", "thickness, area").arg(hundredths(place.worst), placeArea(place.area));
    return finding;
}

PrintFinding overhangs(const core::PrintReport& print, double limit)
{
    PrintFinding finding;
    finding.tip =
        PrintText::tr(
            "Faces that lean out more than %1 from the vertical print on supports only; those on the bed do not count.")
            .arg(degrees(limit));
    if (print.overhangs.count == 0) {
        finding.text = PrintText::tr("No overhangs beyond %1").arg(degrees(limit));
        return finding;
    }
    finding.verdict = PrintVerdict::Warning;
    finding.text =
        PrintText::tr("%1 overhangs beyond %2").arg(percent(print.overhangs.area / print.area), degrees(limit));
    finding.picture = core::PrintPicture::Overhang;
    finding.places = print.overhangs.places;
    for (const core::PrintPlace& place : finding.places)
        finding.placeTexts << PrintText::tr("up to %1, %2").arg(degrees(place.worst), placeArea(place.area));
    return finding;
}

PrintFinding base(const core::PrintReport& print)
{
    const QString tip = PrintText::tr("Area of the surface that is flat on the bed.");
    if (print.baseArea > 0)
        return {PrintVerdict::Good, PrintText::tr("Stands on %1").arg(areaText(print.baseArea)), tip};
    return {PrintVerdict::Warning, PrintText::tr("Rests on a point or an edge"), tip};
}
} // namespace

QList<PrintFinding> printFindings(const core::MeshReport& mesh, const core::PrintReport& print,
                                  const core::PrintLimits& limits, const QString& printer, PrintedParts united)
{
    QList<PrintFinding> findings{surface(mesh)};
    if (!printer.isEmpty())
        findings << bed(mesh, print, printer);
    if (mesh.printReady())
        findings << walls(print, limits);
    findings << overhangs(print, limits.overhang) << base(print) << parts(mesh);
    if (united != PrintedParts::Apart)
        findings << overlap(united);
    if (const QString doubt = mesh.volume ? ErrorMessages::unitDoubt(*mesh.volume) : QString(); !doubt.isEmpty())
        findings << PrintFinding{PrintVerdict::Warning, doubt,
                                 PrintText::tr("Scale the model, or choose millimetres in the slicer.")};
    return findings;
}
} // namespace ui
