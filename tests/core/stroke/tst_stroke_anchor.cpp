#include "core/stroke/stroke_anchor.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;

namespace
{
constexpr double brushRadius = 2;
constexpr double maxMotion = 0.1 * brushRadius; ///< of a dab, mm

StrokeSettings settingsOf(Tool tool)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = brushRadius;
    return settings;
}

Dab dabAt(const Vec3& position)
{
    Dab dab;
    dab.position = position;
    dab.direction = {0, 0, -1};
    dab.radius = brushRadius;
    dab.strength = 1;
    return dab;
}
} // namespace

class TestStrokeAnchor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longMotion_isDivided_data();
    void longMotion_isDivided();
    void firstDabAndOtherTools_areOneDab();
};

void TestStrokeAnchor::longMotion_isDivided_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("radii");
    QTest::addColumn<int>("dabs");
    for (const Tool tool : {Tool::Grab, Tool::SnakeHook, Tool::Twist}) {
        for (const auto& [radii, dabs] :
             {std::pair(0.0, 1), {0.05, 1}, {0.1, 1}, {0.101, 2}, {0.25, 3}, {1.0, 10}, {2.0, 20}, {1000.0, 20}})
            QTest::addRow("%s, %g radii", name(tool).data(), radii) << tool << radii << dabs;
    }
}

/// Moves by a length in several directions. The parts must be equal, and together the whole.
void TestStrokeAnchor::longMotion_isDivided()
{
    QFETCH(Tool, tool);
    QFETCH(double, radii);
    QFETCH(int, dabs);
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0.8, -0.6, 0), Vec3(1, 2, 3).normalized().eval()}) {
        StrokeAnchor anchor(settingsOf(tool));
        Dab first = dabAt({5, 6, 7});
        anchor.place(first);
        const Dab last = dabAt(first.position + radii * brushRadius * way);
        std::vector<Dab> parts = anchor.divide(last);
        QCOMPARE(static_cast<int>(parts.size()), dabs);
        QCOMPARE(parts.back().position, last.position);
        Vec3 sum = Vec3::Zero();
        for (Dab& part : parts) {
            anchor.place(part);
            sum += part.motion;
            QVERIFY(part.motion.norm() <= std::max(1.000001 * maxMotion, 1.000001 * radii * brushRadius / dabs));
        }
        QVERIFY((sum - (last.position - Vec3(5, 6, 7))).norm() <= 1e-12 * (1 + radii));
    }
}

void TestStrokeAnchor::firstDabAndOtherTools_areOneDab()
{
    StrokeAnchor grab(settingsOf(Tool::Grab));
    QCOMPARE(grab.divide(dabAt({50, 0, 0})).size(), 1U);
    StrokeAnchor pull(settingsOf(Tool::Pull));
    Dab first = dabAt({5, 6, 7});
    pull.place(first);
    QCOMPARE(pull.divide(dabAt({50, 0, 0})).size(), 1U);
}

FETTLE_TEST(TestStrokeAnchor)
#include "tst_stroke_anchor.moc"
