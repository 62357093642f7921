// Tests sculpting a rotating model (paper, section 3.5.4): a brush at rest makes a groove around it.
#include "core/io/stroke/stroke_file.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>

using core::Sculptor;
using core::Vec3;

namespace
{
constexpr double drumRadius = 1;
constexpr int degreesAround = 360;

/// Returns a cylinder about the y axis.
core::TriangleMesh drum()
{
    std::vector<Vec3> profile = {{0, -1, 0}};
    for (int i = 1; i < 4; ++i)
        profile.emplace_back(0.25 * i * drumRadius, -1, 0);
    for (int i = 0; i <= 16; ++i)
        profile.emplace_back(drumRadius, -1 + 0.125 * i, 0);
    for (int i = 3; i >= 0; --i)
        profile.emplace_back(0.25 * i * drumRadius, 1, 0);
    return clay::revolved(profile, 48);
}

struct TurntableRun
{
    double degreesPerSecond = 30;
    double seconds = 12;
    double dabsPerSecond = 6;
};

/// Returns a stroke file in which a push brush rests at a point on the x axis and points inwards.
std::vector<core::FileEntry> groove(const TurntableRun& turn)
{
    std::string text =
        R"({"format":"fettle-strokes","version":1,"strokes":[{"tool":"push","radius":0.3,"strength":0.3,)"
        R"("place":"ray","turntable_deg_per_s":)" +
        std::to_string(turn.degreesPerSecond) + R"(,"samples":[)";
    for (int i = 0; i < turn.seconds * turn.dabsPerSecond; ++i)
        text += (i == 0 ? "" : ",") +
                (R"({"position":[3,0,0],"direction":[-1,0,0],"t":)" + std::to_string(i / turn.dabsPerSecond)) + "}";
    return core::parseStrokes(text + "]}]}");
}

void play(Sculptor& sculptor, const std::vector<core::FileEntry>& entries)
{
    for (const core::FileEntry& entry : entries) {
        const core::Stroke& stroke = std::get<core::Stroke>(entry);
        sculptor.beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples)
            sculptor.addSample(sample);
        sculptor.endStroke();
    }
}

std::unique_ptr<Sculptor> turned(const TurntableRun& turn)
{
    auto sculptor = std::make_unique<Sculptor>(mesh_asserts::sculptable(drum()));
    play(*sculptor, groove(turn));
    return sculptor;
}

/// Returns the depth below the original cylinder at this height, for each degree around from x towards z.
std::vector<double> depths(const Sculptor& sculptor, double height)
{
    std::vector<double> result;
    for (int i = 0; i < degreesAround; ++i) {
        const double angle = (i + 0.5) * std::numbers::pi / 180;
        const Vec3 outward(std::cos(angle), 0, std::sin(angle));
        const auto hit = sculptor.hit({3 * outward + Vec3(0, height, 0), -outward});
        result.push_back(hit ? drumRadius - hit->position.dot(outward) : drumRadius);
    }
    return result;
}

double mean(const std::vector<double>& values)
{
    double sum = 0;
    for (double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}
} // namespace

class TestTurntable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void groove_isEvenAllAround_data();
    void groove_isEvenAllAround();
    void bothDirections_mirrorEachOther();
    void partOfATurn_leavesTheRestAlone();
    void replay_isDeterministic();
};

void TestTurntable::groove_isEvenAllAround_data()
{
    QTest::addColumn<double>("speed");
    QTest::newRow("counterclockwise") << 30.0;
    QTest::newRow("clockwise") << -30.0;
}

void TestTurntable::groove_isEvenAllAround()
{
    QFETCH(double, speed);
    const auto sculptor = turned({.degreesPerSecond = speed});
    VERIFY_VALID(sculptor->mesh());
    const std::vector<double> floor = depths(*sculptor, 0);
    const double depth = mean(floor);
    const auto [least, most] = std::ranges::minmax(floor);
    QVERIFY(depth > 0.03);
    QVERIFY2(most - least < 0.1 * depth, qPrintable(QStringLiteral("%1 to %2").arg(least).arg(most)));
    for (double beside : {-0.5, 0.5}) // beyond the reach of the brush
        QVERIFY(std::ranges::max(depths(*sculptor, beside)) < 0.1 * depth);
}

void TestTurntable::bothDirections_mirrorEachOther()
{
    const std::vector<double> one = depths(*turned({.degreesPerSecond = 30}), 0);
    const std::vector<double> other = depths(*turned({.degreesPerSecond = -30}), 0);
    double worst = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        worst = std::max(worst, std::abs(one[i] - other[one.size() - 1 - i]));
    QVERIFY2(worst < 0.05 * mean(one), qPrintable(QString::number(worst)));
}

/// A quarter turn at 30 degrees per second. The model turns from z towards x, so the brush moves from x towards z on
/// it.
void TestTurntable::partOfATurn_leavesTheRestAlone()
{
    const std::vector<double> floor = depths(*turned({.degreesPerSecond = 30, .seconds = 3}), 0);
    for (int i = 0; i < degreesAround; ++i) {
        if (i > 10 && i < 80)
            QVERIFY2(floor[static_cast<std::size_t>(i)] > 0.03, qPrintable(QString::number(i)));
        if (i > 120 && i < 330)
            QVERIFY2(floor[static_cast<std::size_t>(i)] < 0.01, qPrintable(QString::number(i)));
    }
}

void TestTurntable::replay_isDeterministic()
{
    const TurntableRun turn = {.degreesPerSecond = -45, .seconds = 8};
    QCOMPARE(turned(turn)->mesh().stateHash(), turned(turn)->mesh().stateHash());
}

FETTLE_TEST(TestTurntable, QCoreApplication)
#include "tst_turntable.moc"
