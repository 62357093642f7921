#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::DabReport;
using core::Sculptor;
using core::StrokeSettings;
using core::Tool;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
StrokeSettings strong(Tool tool, double radius, double strength, double detail)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    settings.strength = strength;
    settings.detail = detail;
    settings.place = core::Placement::Nearest;
    return settings;
}

/// Sculpts along the equator of the unit ball, with a dab every 0.126 radii.
std::vector<DabReport> strokeAround(Sculptor& sculptor, const StrokeSettings& settings, int dabs)
{
    std::vector<DabReport> reports;
    sculptor.beginStroke(settings);
    for (int i = 0; i < dabs; ++i) {
        const double angle = 0.126 * settings.radius * i;
        core::StrokeSample sample;
        sample.position = {std::cos(angle), std::sin(angle), 0};
        for (const DabReport& report : sculptor.addSample(sample))
            reports.push_back(report);
    }
    sculptor.endStroke();
    return reports;
}
} // namespace

/// Tests dabs where the surface folds.
class TestFoldSmoothing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void strongStrokes_reachWhatIsAsked_data();
    void strongStrokes_reachWhatIsAsked();
    void motionStoppedAtContact_isNotCalledReached();
};

void TestFoldSmoothing::strongStrokes_reachWhatIsAsked_data()
{
    QTest::addColumn<int>("tool");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("strength");
    QTest::addColumn<double>("detail");
    QTest::newRow("pull, fine") << int(Tool::Pull) << 0.25 << 3.0 << 0.4;
    QTest::newRow("push, fine") << int(Tool::Push) << 0.25 << 3.0 << 0.4;
    QTest::newRow("push, wide") << int(Tool::Push) << 0.4 << 5.0 << 1.0;
    QTest::newRow("pull, widest") << int(Tool::Pull) << 0.5 << 8.0 << 0.8;
}

/// Creases form where opposite flanks of a bulge or a pit approach each other. They must close without blocking the
/// motion and without making holes.
void TestFoldSmoothing::strongStrokes_reachWhatIsAsked()
{
    QFETCH(int, tool);
    QFETCH(double, radius);
    QFETCH(double, strength);
    QFETCH(double, detail);
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    const std::vector<DabReport> reports = strokeAround(sculptor, strong(Tool(tool), radius, strength, detail), 16);
    const auto reached = std::ranges::count_if(reports, [](const DabReport& r) { return r.reached >= 0.95 * r.asked; });
    QCOMPARE(reports.size(), std::size_t(16));
    QVERIFY2(reached >= 15, qPrintable(QStringLiteral("%1 of 16").arg(reached)));
    VERIFY_VALID(sculptor.mesh());
    QCOMPARE(sculptor.mesh().live().vertices + sculptor.mesh().live().faces, sculptor.mesh().live().edges + 2);
}

/// A bulge grows without fusion towards a plate until it touches it. Displacement that smoothing takes back must not
/// count as reached.
void TestFoldSmoothing::motionStoppedAtContact_isNotCalledReached()
{
    const double gap = 0.2;
    const core::TriangleMesh plates =
        shapes::together(clay::slab(1, 0.1f, 16), shapes::moved(clay::slab(1, 0.1f, 16), {0, float(0.1 + gap), 0}));
    Sculptor sculptor(sculptable(plates));
    StrokeSettings settings = strong(Tool::Pull, 0.3, 1, 1);
    settings.fusion = false;
    double reached = 0;
    bool contact = false;
    core::StrokeSample sample;
    sample.position = {0, 0.05, 0};
    sculptor.beginStroke(settings);
    for (int i = 0; i < 40; ++i) {
        for (const DabReport& report : sculptor.addSample(sample)) {
            reached += report.reached;
            contact = contact || report.contact;
            QVERIFY(!report.contact || reached > 0.3 * gap); // no contact before the surfaces are near
        }
    }
    sculptor.endStroke();
    QVERIFY(contact);
    VERIFY_VALID(sculptor.mesh());
    QVERIFY(reached >= 0.5 * gap);
    QVERIFY2(reached <= 2 * gap, qPrintable(QString::number(reached)));
}

FETTLE_TEST(TestFoldSmoothing)
#include "tst_fold_smoothing.moc"
