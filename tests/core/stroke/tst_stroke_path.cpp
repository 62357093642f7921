#include "core/stroke/stroke_path.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using core::StrokePath;
using core::StrokeSample;
using core::StrokeSettings;
using core::Vec3;

namespace
{
const StrokePath::CenterOf whereItIs = [](const Vec3& position, const Vec3&) { return std::optional(position); };

StrokeSample at(const Vec3& position)
{
    StrokeSample sample;
    sample.position = position;
    return sample;
}

std::vector<core::Dab> dabsDue(StrokePath& path, const StrokePath::CenterOf& centerOf = whereItIs)
{
    std::vector<core::Dab> dabs;
    while (const auto due = path.next(centerOf)) {
        if (due->hasCenter)
            dabs.push_back(due->dab);
    }
    return dabs;
}

std::vector<core::Dab> dabsOf(StrokePath& path, const StrokeSample& sample,
                              const StrokePath::CenterOf& centerOf = whereItIs)
{
    path.add(sample);
    return dabsDue(path, centerOf);
}

std::vector<core::Dab> dabsOfLast(StrokePath& path, const StrokeSample& sample,
                                  const StrokePath::CenterOf& centerOf = whereItIs)
{
    path.add(sample);
    path.finish();
    return dabsDue(path, centerOf);
}

StrokeSettings spaced(double spacing, double radius = 1)
{
    StrokeSettings settings;
    settings.radius = radius;
    settings.spacing = spacing;
    return settings;
}
} // namespace

class TestStrokePath : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void spacingZero_isOneDabASample();
    void firstSample_isADab();
    void straightLine_hasEvenDabsWhereverSamplesFall();
    void corner_isMeasuredAlongThePath();
    void circleOfTwelveSamples_isACircle();
    void unevenSamples_doNotSwingOut();
    void twoSamples_areStraight();
    void pressureAndRadius_areInterpolated();
    void rotation_turnsBack();
    void turntable_hasEvenDabsHoweverFewTheSamples();
    void up_isTheHands();
    void up_alongTheDirection();
    void anchored_isOneDabThatTheHandDragsOut();
    void anchored_byRaysIsDraggedAcrossTheFirst();
    void anchored_clickIsAsLargeAsTheBrush();
    void anchored_isNothingToADragTool();
    void miss_isEmptyAndStartsAnew();
    void rest_makesNoDabs();
    void airbrush_goesOnAtItsRateHoweverManyTheSamples();
    void airbrush_leavesASlowPathAlone();
    void airbrush_endsWhateverTheTimesAre();
    void longJump_ends();
    void surfaceThatRises_ends();
};

void TestStrokePath::spacingZero_isOneDabASample()
{
    StrokePath path(spaced(0));
    for (int i = 0; i < 5; ++i) {
        const auto dabs = dabsOf(path, at(Vec3(i % 2, 0, 0)));
        QCOMPARE(dabs.size(), std::size_t(1));
        QVERIFY(dabs.front().position == Vec3(i % 2, 0, 0));
    }
    QCOMPARE(dabsOf(path, at({0, 0, 0})).size(), std::size_t(1)); // a sample that has not moved gives a dab, too
}

void TestStrokePath::firstSample_isADab()
{
    StrokePath path(spaced(0.5));
    const auto dabs = dabsOf(path, at({3, 4, 5}));
    QCOMPARE(dabs.size(), std::size_t(1));
    QVERIFY(dabs.front().position == Vec3(3, 4, 5));
}

void TestStrokePath::straightLine_hasEvenDabsWhereverSamplesFall()
{
    for (double sampleStep : {0.01, 0.1, 0.37, 1.0, 7.3, 20.0}) {
        StrokePath path(spaced(0.25, 2)); // spacing of 0.25 radii, so a dab every 0.5
        std::vector<core::Dab> dabs;
        for (double x = 0; x <= 20; x += sampleStep) {
            for (const core::Dab& dab : dabsOf(path, at({x, 0, 0})))
                dabs.push_back(dab);
        }
        path.finish();
        for (const core::Dab& dab : dabsDue(path))
            dabs.push_back(dab);
        QVERIFY(dabs.size() >= 29);
        for (std::size_t i = 0; i < dabs.size(); ++i)
            QVERIFY((dabs[i].position - Vec3(0.5 * static_cast<double>(i), 0, 0)).norm() < 1e-9);
    }
}

void TestStrokePath::corner_isMeasuredAlongThePath()
{
    StrokePath path(spaced(1));
    dabsOf(path, at({0, 0, 0}));
    QVERIFY(dabsOf(path, at({2.4, 0, 0})).empty());
    const auto dabs = dabsOf(path, at({2.4, 3, 0}));
    QCOMPARE(dabs.size(), std::size_t(5)); // two before the corner, at x = 1 and 2, and three after it
    QVERIFY((dabs[1].position - Vec3(2, 0, 0)).norm() < 1e-12);
    QVERIFY((dabs[2].position - Vec3(2.4, 0.6, 0)).norm() < 1e-12);
    QVERIFY((dabs[4].position - Vec3(2.4, 2.6, 0)).norm() < 1e-12);
}

/// The distances of dabs from the centre must be within 2 % of the radius, from the first sample on.
void TestStrokePath::circleOfTwelveSamples_isACircle()
{
    StrokePath path(spaced(0.05));
    std::vector<core::Dab> dabs;
    for (int i = 0; i <= 12; ++i) {
        const double angle = i * M_PI / 6;
        for (const core::Dab& dab : dabsOf(path, at({10 * std::cos(angle), 10 * std::sin(angle), 0})))
            dabs.push_back(dab);
    }
    QVERIFY(dabs.size() > 1200);
    for (const core::Dab& dab : dabs)
        QVERIFY2(std::abs(dab.position.norm() - 10) < 0.2, qPrintable(QString::number(dab.position.norm())));
}

void TestStrokePath::unevenSamples_doNotSwingOut()
{
    StrokePath path(spaced(0.05));
    std::vector<core::Dab> dabs;
    for (const double x : {0.0, 0.01, 5.0, 5.1, 9.0}) {
        for (const core::Dab& dab : dabsOf(path, at({x, 0.02 * x * x, 0})))
            dabs.push_back(dab);
    }
    for (const core::Dab& dab : dabs)
        QVERIFY(std::abs(dab.position.y() - 0.02 * dab.position.x() * dab.position.x()) < 0.15);
}

/// A path holds dabs back until a third sample comes or it is finished.
void TestStrokePath::twoSamples_areStraight()
{
    StrokePath path(spaced(0.5));
    QCOMPARE(dabsOf(path, at({0, 0, 0})).size(), std::size_t(1));
    QVERIFY(dabsOf(path, at({2, 2, 0})).empty());
    path.finish();
    const auto dabs = dabsDue(path);
    QCOMPARE(dabs.size(), std::size_t(5));
    for (const core::Dab& dab : dabs)
        QVERIFY(std::abs(dab.position.x() - dab.position.y()) < 1e-12);
}

void TestStrokePath::pressureAndRadius_areInterpolated()
{
    StrokePath path(spaced(1));
    StrokeSample a = at({0, 0, 0}), b = at({4, 0, 0});
    a.pressure = 0;
    b.strength = a.strength = 2;
    dabsOf(path, a);
    const auto dabs = dabsOfLast(path, b);
    QCOMPARE(dabs.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(std::abs(dabs[i].strength - 0.5 * static_cast<double>(i + 1)) < 1e-12);
}

void TestStrokePath::rotation_turnsBack()
{
    StrokePath path(spaced(0));
    StrokeSample sample = at({1, 0, 0});
    sample.direction = {0, 0, -1};
    sample.rotation = Eigen::Quaterniond(std::sqrt(0.5), 0, std::sqrt(0.5), 0); // a quarter turn about y
    const auto dabs = dabsOf(path, sample);
    // in model space: the sample's position and direction, rotated back by the quarter turn
    QVERIFY((dabs.front().position - Vec3(0, 0, 1)).norm() < 1e-12);
    QVERIFY((dabs.front().direction - Vec3(1, 0, 0)).norm() < 1e-12);
}

/// The brush rests beside a rotating model, which turns by 15 degrees per sample.
void TestStrokePath::turntable_hasEvenDabsHoweverFewTheSamples()
{
    StrokePath path(spaced(0.25));
    std::vector<core::Dab> dabs;
    for (int i = 0; i <= 24; ++i) {
        StrokeSample sample = at({5, 0, 0});
        sample.rotation = Eigen::AngleAxisd(i * M_PI / 12, Vec3::UnitY());
        for (const core::Dab& dab : dabsOf(path, sample))
            dabs.push_back(dab);
    }
    QVERIFY(dabs.size() > 120 && dabs.size() < 132); // 2 pi 5 / 0.25 = 125.7
    for (std::size_t i = 1; i < dabs.size(); ++i) {
        QVERIFY(std::abs(dabs[i].position.norm() - 5) < 1e-9);
        const double step = (dabs[i].position - dabs[i - 1].position).norm();
        QVERIFY2(step > 0.235 && step < 0.265, qPrintable(QString::number(step)));
    }
}

/// A sample's up direction is rotated into model space, and `ahead` is perpendicular to it. Position and direction of
/// the dab do not depend on it.
void TestStrokePath::up_isTheHands()
{
    StrokeSample sample = at({1, 2, 3});
    sample.direction = {0, -1, -1};
    sample.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
    const Eigen::Quaterniond back = sample.rotation.conjugate();
    StrokePath plain(spaced(0)), held(spaced(0));
    const core::Dab before = dabsOf(plain, sample).at(0);
    QVERIFY(before.up == back * Vec3::UnitY() && before.ahead == back * -Vec3::UnitZ());
    sample.up = Vec3(3, 3, 1);
    const core::Dab dab = dabsOf(held, sample).at(0);
    QVERIFY(dab.up.isApprox(back * sample.up->normalized(), 1e-12));
    QVERIFY(std::abs(dab.ahead.norm() - 1) < 1e-12 && std::abs(dab.ahead.dot(dab.up)) < 1e-12);
    QVERIFY(dab.ahead.dot(dab.direction) > 0 && std::abs(dab.ahead.dot(dab.up.cross(dab.direction))) < 1e-12);
    QVERIFY(dab.position == before.position && dab.direction == before.direction);
}

/// A stroke file may have an up direction parallel to the direction of the sample.
void TestStrokePath::up_alongTheDirection()
{
    for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0, 0, -4), Vec3(0, 0, 0)}) {
        StrokeSample sample = at({1, 2, 3});
        sample.direction = direction;
        sample.up = Vec3(0, 0, 2);
        StrokePath path(spaced(0));
        const core::Dab dab = dabsOf(path, sample).at(0);
        QVERIFY(std::abs(dab.ahead.norm() - 1) < 1e-12 && std::abs(dab.ahead.dot(dab.up)) < 1e-12);
    }
}

/// An anchored stroke is one dab at the first sample, with the distance to the last sample as its radius. It is made at
/// the end of the stroke.
void TestStrokePath::anchored_isOneDabThatTheHandDragsOut()
{
    StrokeSettings settings = spaced(0.1);
    settings.tool = core::Tool::Stamp;
    settings.anchored = true;
    StrokePath path(settings);
    QVERIFY(dabsOf(path, at({1, 2, 3})).empty() && dabsOf(path, at({9, 2, 3})).empty());
    StrokeSample last = at({1, 6, 0});
    last.pressure = 0.1; // lifting a pen ends with a low pressure
    const auto dabs = dabsOfLast(path, last);
    QCOMPARE(dabs.size(), std::size_t(1));
    QCOMPARE(dabs.front().position, Vec3(1, 2, 3));
    QVERIFY(std::abs(dabs.front().radius - 5) < 1e-12 && dabs.front().strength == settings.strength);
    QVERIFY(dabs.front().up.isApprox(Vec3(0, 0.8, -0.6), 1e-12));
}

/// A drag by rays is measured in the plane perpendicular to the first ray, not on the surface.
void TestStrokePath::anchored_byRaysIsDraggedAcrossTheFirst()
{
    const StrokePath::CenterOf onPlane = [](const Vec3& p, const Vec3& way) {
        return std::optional<Vec3>(p - p.z() / way.z() * way);
    };
    StrokeSettings settings = spaced(0.1);
    settings.tool = core::Tool::Stamp;
    settings.place = core::Placement::Ray;
    settings.anchored = true;
    StrokePath path(settings);
    StrokeSample sample = at({0, 0, 10});
    sample.direction = -Vec3::UnitZ();
    QVERIFY(dabsOf(path, sample, onPlane).empty());
    sample.direction = Vec3(0.3, 0.4, -1);
    const auto dabs = dabsOfLast(path, sample, onPlane);
    QCOMPARE(dabs.size(), std::size_t(1));
    QVERIFY(dabs.front().position.norm() < 1e-12 && std::abs(dabs.front().radius - 5) < 1e-12);
    QVERIFY(dabs.front().up.isApprox(Vec3(0.6, 0.8, 0), 1e-12));
}

/// A click, even with a slight tremor, gives a dab with the radius of the brush.
void TestStrokePath::anchored_clickIsAsLargeAsTheBrush()
{
    StrokeSettings settings = spaced(0.1, 2);
    settings.tool = core::Tool::Paint;
    settings.anchored = true;
    for (const Vec3& last : {Vec3(1, 2, 3), Vec3(1, 2.09, 3)}) {
        StrokePath path(settings);
        QVERIFY(dabsOf(path, at({1, 2, 3})).empty());
        const auto dabs = dabsOfLast(path, at(last));
        QCOMPARE(dabs.size(), std::size_t(1));
        QVERIFY(dabs.front().radius == 2 && dabs.front().up == Vec3::UnitY());
    }
}

/// Drag tools ignore the anchored setting.
void TestStrokePath::anchored_isNothingToADragTool()
{
    StrokeSettings settings = spaced(0);
    settings.tool = core::Tool::Grab;
    settings.anchored = true;
    StrokePath path(settings);
    QCOMPARE(dabsOf(path, at({1, 2, 3})).size(), std::size_t(1));
}

void TestStrokePath::miss_isEmptyAndStartsAnew()
{
    const StrokePath::CenterOf onlyRight = [](const Vec3& p, const Vec3&) {
        return p.x() >= 0 ? std::optional(p) : std::nullopt;
    };
    StrokePath single(spaced(0));
    single.add(at({-1, 0, 0}));
    const auto due = single.next(onlyRight);
    QVERIFY(due && !due->hasCenter);
    QVERIFY(!single.next(onlyRight));

    StrokePath path(spaced(1));
    QCOMPARE(dabsOf(path, at({-5, 0, 0}), onlyRight).size(), std::size_t(0));
    QCOMPARE(dabsOf(path, at({0, 0, 0}), onlyRight).size(), std::size_t(1)); // the sample meets the surface
    QCOMPARE(dabsOf(path, at({2.5, 0, 0}), onlyRight).size(), std::size_t(0));
    QCOMPARE(dabsOf(path, at({-2, 0, 0}), onlyRight).size(), std::size_t(2));
    // the path does not continue across the gap
    QCOMPARE(dabsOf(path, at({3, 0, 0}), onlyRight).size(), std::size_t(1));
}

void TestStrokePath::rest_makesNoDabs()
{
    StrokePath path(spaced(0.1));
    dabsOf(path, at({1, 1, 1}));
    for (int i = 0; i < 100; ++i)
        QVERIFY(dabsOf(path, at({1, 1, 1})).empty());
}

/// An airbrush gives ten dabs per second, beginning a quarter of a second after the press.
void TestStrokePath::airbrush_goesOnAtItsRateHoweverManyTheSamples()
{
    for (const double samplesPerSecond : {5.0, 60.0, 250.0}) {
        StrokeSettings settings = spaced(0.25);
        settings.airbrush = 10;
        StrokePath path(settings);
        std::size_t dabs = 0;
        for (int i = 0; i <= 2 * samplesPerSecond; ++i) {
            StrokeSample sample = at({1, 1, 1});
            sample.time = i / samplesPerSecond;
            dabs += dabsOf(path, sample).size();
            QVERIFY(sample.time > 0.24 || dabs == 1 || samplesPerSecond == 5);
        }
        QVERIFY2(dabs >= 18 && dabs <= 19, qPrintable(QString::number(dabs)));
    }
}

/// A slow motion must not count as rest, so that a ring on a turntable stays even.
void TestStrokePath::airbrush_leavesASlowPathAlone()
{
    StrokeSettings settings = spaced(0.25);
    settings.airbrush = 10;
    StrokePath path(settings);
    std::vector<core::Dab> dabs;
    for (int i = 0; i <= 1000; ++i) {
        StrokeSample sample = at({0.003 * i, 0, 0});
        sample.time = 0.01 * i;
        for (const core::Dab& dab : dabsOf(path, sample))
            dabs.push_back(dab);
    }
    QCOMPARE(dabs.size(), std::size_t(13));
    for (std::size_t i = 0; i < dabs.size(); ++i)
        QVERIFY(std::abs(dabs[i].position.x() - 0.25 * static_cast<double>(i)) < 1e-9);
}

void TestStrokePath::airbrush_endsWhateverTheTimesAre()
{
    for (const double gap : {core::maxSampleMagnitude, -core::maxSampleMagnitude, 0.0}) {
        StrokeSettings settings = spaced(0.25);
        settings.airbrush = core::maxAirbrush;
        StrokePath path(settings);
        std::size_t dabs = 0;
        for (int i = 0; i < 3; ++i) {
            StrokeSample sample = at({1, 1, 1});
            sample.time = gap * i;
            dabs += dabsOf(path, sample).size();
        }
        QVERIFY2(static_cast<double>(dabs) <= 1 + 2 * 10 * core::maxAirbrush, qPrintable(QString::number(dabs)));
    }
}

void TestStrokePath::longJump_ends()
{
    StrokePath path(spaced(0.05, 0.01));
    dabsOf(path, at({0, 0, 0}));
    // 10 km away if the unit is mm
    QCOMPARE(dabsOfLast(path, at({1e7, 0, 0})).size(), std::size_t(StrokePath::maxDabsPerSample));
    const auto dabs = dabsOf(path, at({1e7 + 0.01, 0, 0})); // the path continues from the last sample
    QVERIFY(dabs.size() > 10 && dabs.size() < 30);
    QVERIFY(dabs.front().position.x() >= 1e7 - 1e-3);
}

/// Each dab raises the surface by fifty times the distance between dabs.
void TestStrokePath::surfaceThatRises_ends()
{
    StrokePath path(spaced(0.1));
    double height = 0;
    const auto risen = [&](const Vec3& position, const Vec3&) {
        return std::optional<Vec3>(position + height * Vec3::UnitZ());
    };
    const auto dabsTo = [&](const Vec3& position) {
        int dabs = 0;
        for (path.add(at(position)); path.next(risen); ++dabs)
            height += 5;
        return dabs;
    };
    QCOMPARE(dabsTo({0, 0, 0}), 1);
    path.finish();
    // the first dab has raised the surface by 5, so the path is sqrt(10^2 + 5^2) = 11.2 long: 112 dabs at spacing 0.1
    const int dabs = dabsTo({10, 0, 0});
    QVERIFY(dabs >= 100 && dabs <= StrokePath::maxLengthRatio * 112);
}

FETTLE_TEST(TestStrokePath)
#include "tst_stroke_path.moc"
