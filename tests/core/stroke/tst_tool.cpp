#include "core/stroke/stroke.h"
#include "core/stroke/tool.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using namespace core;

class TestTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void falloff_isThePapersCurve();
    void falloff_isOneWithoutWeighting();
    void falloff_fallsFromOneToZero_data();
    void falloff_fallsFromOneToZero();
    void edgeBounds_keepThePapersRelation();
    void names_comeBack();
    void parameters_haveTheirDefaultsInRange();
};

void TestTool::falloff_isThePapersCurve()
{
    // Formula: b(x) = (n-1) x^n - n x^(n-1) + 1; for n = 4: 3 x^4 - 4 x^3 + 1.
    QCOMPARE(falloff(0.5, 4), 3.0 / 16 - 4.0 / 8 + 1);
    QCOMPARE(falloff(0.25, 3), 2.0 / 64 - 3.0 / 16 + 1);
}

void TestTool::falloff_isOneWithoutWeighting()
{
    for (const double x : {0.0, 0.3, 1.0})
        QCOMPARE(falloff(x, 0), 1.0);
}

void TestTool::falloff_fallsFromOneToZero_data()
{
    QTest::addColumn<int>("n");
    for (int n = 3; n <= 16; ++n)
        QTest::newRow(qPrintable(QString::number(n))) << n;
}

void TestTool::falloff_fallsFromOneToZero()
{
    QFETCH(int, n);
    QVERIFY(isFalloff(n));
    QCOMPARE(falloff(0, n), 1.0);
    QVERIFY(falloff(1, n) <= 1e-14);
    QCOMPARE(falloff(1.5, n), falloff(1, n)); // the falloff is constant outside the ball
    for (int i = 0; i < 1000; ++i) {
        const double here = falloff(i / 1000.0, n), next = falloff((i + 1) / 1000.0, n);
        QVERIFY(here >= 0 && here <= 1 && next <= here + 1e-14);
    }
    // The slope is 0 at both ends.
    QVERIFY(1 - falloff(1e-4, n) < 1e-7);
    QVERIFY(falloff(1 - 1e-4, n) < 2e-6);
}

void TestTool::edgeBounds_keepThePapersRelation()
{
    for (const double radius : {1e-6, 0.02, 0.25, 10.0, 1e6}) {
        const EdgeBounds bounds = edgeBounds(radius, 1);
        QVERIFY(std::abs(bounds.detail * bounds.detail / (0.05 * radius * radius) - 1) < 1e-14);
        QVERIFY(std::abs(bounds.minimum * bounds.minimum / (0.25 * bounds.detail * bounds.detail) - 1) < 1e-14);
        QCOMPARE(edgeBounds(radius, 2).detail, 2 * bounds.detail);
        QCOMPARE(edgeBounds(radius, 2).minimum, 2 * bounds.minimum);
    }
}

void TestTool::names_comeBack()
{
    for (const std::string_view word : toolNames()) {
        QVERIFY(named<Tool>(word));
        QVERIFY(name(*named<Tool>(word)) == word);
    }
    QVERIFY(!named<Tool>("melt"));
    QVERIFY(!named<Tool>(""));
    for (const core::Symmetry plane : {core::Symmetry::None, core::Symmetry::X, core::Symmetry::Y, core::Symmetry::Z})
        QVERIFY(core::named<core::Symmetry>(core::name(plane)) == plane);
    for (const Placement placement : {Placement::Point, Placement::Nearest, Placement::Ray})
        QVERIFY(named<Placement>(name(placement)) == placement);
    QVERIFY(name(DabOutcome::Committed) == "committed");
    QVERIFY(name(DabOutcome::Fallback) == "careful");
    QVERIFY(name(DabOutcome::EndedEarly) == "ended_early");
    QVERIFY(name(DabOutcome::Empty) == "empty");
}

void TestTool::parameters_haveTheirDefaultsInRange()
{
    for (const ParameterInfo& row : parameterTable)
        QVERIFY(row.min <= row.defaultValue && row.defaultValue <= row.max);
}

FETTLE_TEST(TestTool)
#include "tst_tool.moc"
