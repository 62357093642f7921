#include "core/geometry/rotation.h"
#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using core::Alpha;
using core::Mesh;
using core::Sculptor;
using core::Slot;
using core::StrokeSettings;
using core::Tool;
using core::Vec3;

namespace
{
using clay::ball;
using clay::ballRadius;
using mesh_asserts::isSound;

/// Returns an image whose right half is white and whose left half is black.
std::shared_ptr<const Alpha> rightHalf()
{
    return std::make_shared<Alpha>(
        4, 4, std::vector<std::uint8_t>{0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255}, "right");
}

/// Returns an image whose upper half is white and whose lower half is black.
std::shared_ptr<const Alpha> upperHalf()
{
    return std::make_shared<Alpha>(2, 4, std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 0}, "upper");
}

StrokeSettings alphaSettings(Tool tool, std::shared_ptr<const Alpha> alpha, double radius = 15)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    settings.alpha = std::move(alpha);
    return settings;
}

core::MeshDelta alphaStroke(Sculptor& sculptor, const StrokeSettings& settings, const std::vector<Vec3>& path)
{
    sculptor.beginStroke(settings);
    for (const Vec3& at : path) {
        core::StrokeSample sample;
        sample.position = at;
        sample.direction = -at;
        sculptor.addSample(sample);
    }
    return sculptor.endStroke();
}

Vec3 front(double x, double y)
{
    return ballRadius * Vec3(x, y, ballRadius).normalized();
}

/// Returns the height of the surface at (x, y) above the ball, mm.
double raisedAt(const Sculptor& sculptor, double x, double y)
{
    return sculptor.hit({{x, y, 200}, -Vec3::UnitZ()})->position.norm() - ballRadius;
}
} // namespace

class TestAlpha : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void at_isTheImage();
    void at_isBlackBesideTheImage();
    void at_ofOnePixel();
    void builtIns_haveShades();
    void fingerprint_tellsImagesApart();
    void stroke_movesWhereItIsBright();
    void stroke_paintsWhereItIsBright();
    void stroke_followsItsWay();
    void anchored_isDraggedOut();
    void stroke_standsUprightOnATurntable();
    void stroke_isSymmetric_data();
    void stroke_isSymmetric();
    void painted_isSymmetric();
    void mirrored_isSeenInAMirror();
    void grab_hasNone();
    void undone();
};

void TestAlpha::at_isTheImage()
{
    const Alpha alpha(2, 2, {0, 255, 51, 102}, "four");
    QCOMPARE(alpha.at(-0.5, 0.5), 0.0); // at pixel centres the value is the pixel's
    QCOMPARE(alpha.at(0.5, 0.5), 1.0);
    QCOMPARE(alpha.at(-0.5, -0.5), 0.2);
    QCOMPARE(alpha.at(0.5, -0.5), 0.4);
    QVERIFY(std::abs(alpha.at(0, 0.5) - 0.5) < 1e-12);
    QVERIFY(std::abs(alpha.at(0, 0) - 0.4) < 1e-12);
    QCOMPARE(alpha.at(1, 1), 1.0); // beyond the outermost pixel centres its value is repeated
}

void TestAlpha::at_isBlackBesideTheImage()
{
    const Alpha wide(4, 2, std::vector<std::uint8_t>(8, 255), "wide");
    QCOMPARE(wide.at(0.99, 0.49), 1.0);
    QCOMPARE(wide.at(0, 0.51), 0.0);
    QCOMPARE(wide.at(1.01, 0), 0.0);
    QCOMPARE(wide.at(std::nan(""), 0), 0.0);
}

void TestAlpha::at_ofOnePixel()
{
    const Alpha alpha(1, 1, {51}, "one");
    for (const double u : {-1.0, 0.0, 1.0})
        QCOMPARE(alpha.at(u, -u), 0.2);
}

void TestAlpha::builtIns_haveShades()
{
    QVERIFY(core::builtInAlphas().size() >= 8);
    for (const std::string_view name : core::builtInAlphas()) {
        const auto alpha = core::builtInAlpha(name);
        QVERIFY2(alpha && alpha->isBuiltIn(), name.data());
        const auto [least, most] = std::ranges::minmax(alpha->pixels());
        QVERIFY2(least < 100 && most > 240, name.data());
    }
    QVERIFY(!core::builtInAlpha("none of ours"));
    QVERIFY(!rightHalf()->isBuiltIn());
}

void TestAlpha::fingerprint_tellsImagesApart()
{
    QCOMPARE(rightHalf()->fingerprint(), rightHalf()->fingerprint());
    QCOMPARE(rightHalf()->fingerprint().size(), std::size_t(16));
    QVERIFY(rightHalf()->fingerprint() != upperHalf()->fingerprint());
    QVERIFY(Alpha(2, 1, {1, 2}, "a").fingerprint() != Alpha(1, 2, {1, 2}, "a").fingerprint());
}

void TestAlpha::stroke_movesWhereItIsBright()
{
    for (const Tool tool : {Tool::Pull, Tool::Push, Tool::Inflate, Tool::Clay, Tool::Layer}) {
        const auto right = ball(), up = ball();
        alphaStroke(*right, alphaSettings(tool, rightHalf()), {front(0, 0)});
        alphaStroke(*up, alphaSettings(tool, upperHalf()), {front(0, 0)});
        const double least = 0.15;
        QVERIFY2(std::abs(raisedAt(*right, 6, 0)) > least && std::abs(raisedAt(*right, -6, 0)) < 0.05,
                 core::name(tool).data());
        QVERIFY2(std::abs(raisedAt(*up, 0, 3)) > least && std::abs(raisedAt(*up, 0, -5)) < 0.05,
                 core::name(tool).data());
        QVERIFY(isSound(*right) && isSound(*up));
    }
}

void TestAlpha::stroke_paintsWhereItIsBright()
{
    const auto sculptor = ball();
    StrokeSettings settings = alphaSettings(Tool::Paint, rightHalf());
    settings.color = {1, 2, 3};
    settings.falloff = 0;
    const core::Rgb clay = sculptor->hit({{-6, 0, 200}, -Vec3::UnitZ()})->color;
    alphaStroke(*sculptor, settings, {front(0, 0)});
    QVERIFY(sculptor->hit({{6, 0, 200}, -Vec3::UnitZ()})->color.r < 40);
    QVERIFY(sculptor->hit({{-8, 0, 200}, -Vec3::UnitZ()})->color == clay);
}

/// The top of the image points in the direction of the stroke.
void TestAlpha::stroke_followsItsWay()
{
    const auto sculptor = ball();
    StrokeSettings settings = alphaSettings(Tool::Pull, upperHalf(), 10);
    settings.alphaFollows = true;
    alphaStroke(*sculptor, settings, {front(-25, 0), front(0, 0)});
    QVERIFY(raisedAt(*sculptor, 3, 0) > 0.1);
    QVERIFY(std::abs(raisedAt(*sculptor, -4, 0)) < 0.05);
}

/// The final drag vector sets direction and radius of the image. Images shown during the drag leave no trace.
void TestAlpha::anchored_isDraggedOut()
{
    const auto sculptor = ball(), once = ball();
    StrokeSettings settings = alphaSettings(Tool::Pull, upperHalf(), 4);
    settings.anchored = true;
    sculptor->beginStroke(settings);
    for (const Vec3& hand : {front(0, 0), front(0, 9), front(-7, 3), front(12, 0)}) {
        core::StrokeSample sample;
        sample.position = hand;
        sculptor->addSample(sample, core::Sculptor::Anchored::Shown);
    }
    sculptor->endStroke();
    alphaStroke(*once, settings, {front(0, 0), front(12, 0)});
    QCOMPARE(sculptor->mesh().stateHash(), once->mesh().stateHash());
    QVERIFY(raisedAt(*sculptor, 4, 0) > 0.1);
    QVERIFY(std::abs(raisedAt(*sculptor, -4, 0)) < 0.05);
    QVERIFY(isSound(*sculptor));
}

void TestAlpha::stroke_standsUprightOnATurntable()
{
    const auto sculptor = ball();
    sculptor->beginStroke(alphaSettings(Tool::Pull, upperHalf()));
    core::StrokeSample sample; // rotates the model onto its side, so that its x axis points up
    sample.rotation = core::rotationBetween(Vec3::UnitX(), Vec3::UnitY());
    sample.position = front(0, 0);
    sculptor->addSample(sample);
    sculptor->endStroke();
    QVERIFY(raisedAt(*sculptor, 5, 0) > 0.2);
    QVERIFY(std::abs(raisedAt(*sculptor, -5, 0)) < 0.05);
}

void TestAlpha::stroke_isSymmetric_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<bool>("follows");
    for (const double x : {2.0, -30.0}) {
        for (const bool follows : {false, true})
            QTest::addRow("%g %d", x, follows) << x << follows;
    }
}

void TestAlpha::stroke_isSymmetric()
{
    QFETCH(double, x);
    QFETCH(bool, follows);
    const auto sculptor = ball();
    StrokeSettings settings = alphaSettings(Tool::Pull, core::builtInAlpha("cracks"), 12);
    settings.symmetry = core::Symmetry::X;
    settings.alphaFollows = follows;
    alphaStroke(*sculptor, settings, {front(x, 0), front(x + 3, 4), front(x + 5, 9)});
    VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
    QVERIFY(isSound(*sculptor));
}

void TestAlpha::painted_isSymmetric()
{
    const auto sculptor = ball();
    StrokeSettings settings = alphaSettings(Tool::Paint, core::builtInAlpha("noise"), 12);
    settings.symmetry = core::Symmetry::X;
    settings.color = {1, 2, 3};
    alphaStroke(*sculptor, settings, {front(3, 0), front(20, 4)});
    VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
}

/// The image is unmirrored on the side where the user sculpts, whichever side it is.
void TestAlpha::mirrored_isSeenInAMirror()
{
    for (const double side : {1.0, -1.0}) {
        const auto sculptor = ball();
        StrokeSettings settings = alphaSettings(Tool::Pull, rightHalf(), 12);
        settings.symmetry = core::Symmetry::X;
        alphaStroke(*sculptor, settings, {front(25 * side, 0)});
        const double x = 50 * 25 / std::sqrt(25.0 * 25 + 50 * 50) * side;
        QVERIFY(raisedAt(*sculptor, x + 4, 0) > 0.1);
        QVERIFY(std::abs(raisedAt(*sculptor, x - 4, 0)) < 0.05);
        QVERIFY(raisedAt(*sculptor, -x - 4, 0) > 0.1);
        QVERIFY(std::abs(raisedAt(*sculptor, -x + 4, 0)) < 0.05);
    }
}

/// A drag tool ignores the alpha, because its vertices move away from under the image.
void TestAlpha::grab_hasNone()
{
    const auto with = ball(), without = ball();
    alphaStroke(*with, alphaSettings(Tool::Grab, rightHalf()), {front(0, 0), {0, 0, 60}});
    alphaStroke(*without, alphaSettings(Tool::Grab, nullptr), {front(0, 0), {0, 0, 60}});
    QCOMPARE(with->mesh().stateHash(), without->mesh().stateHash());
}

void TestAlpha::undone()
{
    const auto used = ball(), fresh = ball();
    const StrokeSettings settings = alphaSettings(Tool::Pull, core::builtInAlpha("scales"));
    core::MeshDelta delta = alphaStroke(*used, settings, {front(0, 0), front(12, 0)});
    QVERIFY(used->mesh().stateHash() != fresh->mesh().stateHash());
    used->swap(delta);
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
    for (Sculptor* sculptor : {used.get(), fresh.get()})
        alphaStroke(*sculptor, settings, {front(5, 5)});
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
}

FETTLE_TEST(TestAlpha, QCoreApplication)
#include "tst_alpha.moc"
