// The print check: its findings as texts, their colours on the model, and the list of printers.

#include "ui/print/print_findings.h"
#include "ui/print/print_legend.h"
#include "ui/settings/settings.h"

#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QSettings>

#include <algorithm>
#include <limits>

using core::PrintPicture;
using ui::PrintVerdict;

namespace
{
QList<ui::PrintFinding> findingsOf(const core::TriangleMesh& mesh, const core::PrintLimits& limits,
                                   const QString& printer)
{
    const core::PrintMeasures measures = core::measureForPrint(mesh);
    return ui::printFindings(measures.report, core::checkForPrint(measures, limits), limits, printer);
}

PrintVerdict worstOf(const QList<ui::PrintFinding>& findings)
{
    return std::ranges::max_element(findings, {}, &ui::PrintFinding::verdict)->verdict;
}
} // namespace

class TestPrintFindings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void shades_areFaultsBeyondTheLimit()
    {
        const ui::PrintScale thickness{PrintPicture::Thickness, 0.8};
        QCOMPARE(thickness.shade(0), std::uint8_t(255));
        QVERIFY(thickness.shade(0.79F) > 127 && thickness.shade(0.81F) <= 127);
        QCOMPARE(thickness.shade(std::numeric_limits<float>::infinity()), std::uint8_t(0));
        const ui::PrintScale overhang{PrintPicture::Overhang, 45};
        QCOMPARE(overhang.shade(90), std::uint8_t(255));
        QCOMPARE(overhang.shade(-90), std::uint8_t(0));
        QVERIFY(overhang.shade(46) > 127 && overhang.shade(44) <= 127);
        for (float angle = -90; angle < 90; ++angle)
            QVERIFY(overhang.shade(angle) <= overhang.shade(angle + 1));
        for (float mm = 0; mm < 4; mm += 0.01F)
            QVERIFY(thickness.shade(mm) >= thickness.shade(mm + 0.01F));
        const ui::PrintScale none{PrintPicture::Overhang, 90}, all{PrintPicture::Overhang, 0};
        QVERIFY(none.shade(90) <= 127 && all.shade(1) > 127);
    }

    void verdicts_areOfWhatWasFound()
    {
        const core::PrintBed bed{250, 210, 220};
        const QString printer = QStringLiteral("Printer");
        QVERIFY(worstOf(findingsOf(shapes::cube(20), {.bed = bed}, printer)) == PrintVerdict::Good);
        QVERIFY(worstOf(findingsOf(core::icosphere(4, 20), {.bed = bed}, printer)) == PrintVerdict::Warning);
        QVERIFY(worstOf(findingsOf(shapes::cube(300), {.bed = bed}, printer)) == PrintVerdict::Bad);
        QVERIFY(worstOf(findingsOf(clay::slab(20, 0.5, 4), {.bed = bed}, printer)) == PrintVerdict::Bad);
        QVERIFY(worstOf(findingsOf(shapes::cubeWithFlippedFace(), {.bed = bed}, printer)) == PrintVerdict::Bad);
        // Is it in inches?
        QVERIFY(worstOf(findingsOf(shapes::cube(1.5F), {.bed = bed}, printer)) == PrintVerdict::Warning);
    }

    /// Slivers in creases and at tips of edges are listed, but are not counted as faults.
    void specks_areNoFault()
    {
        const core::PrintMeasures measures = core::measureForPrint(shapes::cube(20));
        core::PrintReport report = core::checkForPrint(measures, {.minWall = 0.8});
        report.thin.count = 1;
        const auto findings = [&](double area) {
            report.thin.area = area;
            report.thin.places = {{.worst = 0.00456, .area = area}};
            return ui::printFindings(measures.report, report, {.minWall = 0.8}, {});
        };
        QVERIFY(worstOf(findings(0.00236)) == PrintVerdict::Good);
        QVERIFY(worstOf(findings(0.63)) == PrintVerdict::Good);
        QVERIFY(worstOf(findings(0.65)) == PrintVerdict::Bad);
        QStringList texts;
        for (const ui::PrintFinding& finding : findings(0.00236))
            texts += finding.placeTexts;
        QCOMPARE(texts, {QStringLiteral("0.01 mm, 0.01 mm²")});
    }

    /// The panel says whether overlapping parts were united; that they were is no fault.
    void overlappingParts_areTold()
    {
        const core::PrintMeasures measures = core::measureForPrint(shapes::cube(20));
        const core::PrintReport report = core::checkForPrint(measures, {});
        const auto findings = [&](ui::PrintedParts parts) {
            return ui::printFindings(measures.report, report, {}, {}, parts);
        };
        const auto apart = findings(ui::PrintedParts::Apart), united = findings(ui::PrintedParts::United),
                   alone = findings(ui::PrintedParts::EachAlone);
        QCOMPARE(united.size(), apart.size() + 1);
        QVERIFY(worstOf(united) == PrintVerdict::Good);
        QCOMPARE(alone.size(), apart.size() + 1);
        QVERIFY(worstOf(alone) == PrintVerdict::Warning);
    }

    void places_haveWords()
    {
        for (const ui::PrintFinding& finding :
             findingsOf(clay::slab(20, 0.5, 4), {.bed = {99, 99, 99}}, QStringLiteral("Printer"))) {
            QCOMPARE(static_cast<std::size_t>(finding.placeTexts.size()), finding.places.size());
            QVERIFY(!finding.text.isEmpty() && !finding.tip.isEmpty());
        }
    }

    void legend_saysItsFigures()
    {
        ui::PrintLegend legend;
        legend.setScale({PrintPicture::Thickness, 0.8});
        const QString thickness = legend.accessibleDescription();
        QVERIFY(thickness.contains(QStringLiteral("0.8")) && thickness.contains(QStringLiteral("1.6")));
        legend.setScale({PrintPicture::Overhang, 50});
        QVERIFY(legend.accessibleDescription().contains(QStringLiteral("50")));
    }

    void printers_areKept()
    {
        QSettings().clear();
        ui::Settings settings;
        QCOMPARE(settings.get(&ui::Setting::printers).size(), ui::defaultPrinters().size());
        settings.set(&ui::Setting::printers, {{QStringLiteral("A; \"b\", c"), {100.5, 200, 300}}});
        QCOMPARE(settings.get(&ui::Setting::printers).size(), 1);
        QCOMPARE(settings.get(&ui::Setting::printers)[0].name, QStringLiteral("A; \"b\", c"));
        QCOMPARE(settings.get(&ui::Setting::printers)[0].bed.x, 100.5);
        settings.reset();
        QCOMPARE(settings.get(&ui::Setting::printers).size(), 1); // a printer added by the user survives a reset
        for (const char* broken : {"", "Name", "Name\t1\t2", "Name\t100\t100\tx", "\t100\t100\t100",
                                   "Name\t1\t100\t100", "Name\t1e9\t100\t100", "Name\tnan\t100\t100"})
            QVERIFY2(ui::printersOf({QString::fromLatin1(broken)}).isEmpty(), broken);
    }

    void choices_areKept()
    {
        QSettings().clear();
        ui::Settings settings;
        QCOMPARE(settings.get<ui::PrintSettings>().wall, 0.8);
        settings.set(ui::PrintSettings{QStringLiteral("Mine"), 1.2, 60, 2});
        QCOMPARE(settings.get<ui::PrintSettings>().printer, QStringLiteral("Mine"));
        QCOMPARE(settings.get<ui::PrintSettings>().wall, 1.2);
        QCOMPARE(settings.get<ui::PrintSettings>().overhang, 60.0);
        QCOMPARE(settings.get<ui::PrintSettings>().picture, 2);
        QSettings().setValue(QStringLiteral("print/wall"), QStringLiteral("thick"));
        QSettings().setValue(QStringLiteral("print/picture"), 7);
        QCOMPARE(settings.get<ui::PrintSettings>().wall, 0.8);
        QCOMPARE(settings.get<ui::PrintSettings>().picture, 1);
    }
};

FETTLE_TEST(TestPrintFindings, ui::TestApplication)
#include "tst_print_findings.moc"
