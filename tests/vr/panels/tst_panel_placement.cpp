#include "tests/support/test_main.h"
#include "vr/input/model_placement.h"
#include "vr/panels/panel_manager.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using core::Vec3;
using vr::AheadPanelPlacement;
using vr::Pose;

namespace
{
constexpr double degree = std::numbers::pi / 180;
const Eigen::Vector2d size(0.43, 0.35);

struct HeadAngles
{
    double yaw = 0, pitch = 0, roll = 0; ///< degrees; positive: left, up, to the left shoulder
};

Pose head(const Vec3& position, const HeadAngles& angles)
{
    const Eigen::Quaterniond rotation = Eigen::AngleAxisd(angles.yaw * degree, Vec3::UnitY()) *
                                        Eigen::AngleAxisd(angles.pitch * degree, Vec3::UnitX()) *
                                        Eigen::AngleAxisd(angles.roll * degree, Vec3::UnitZ());
    return {rotation, position};
}

Vec3 normalOf(const Pose& panel)
{
    return panel.rotation * Vec3::UnitZ();
}

/// Returns true if the pose's rotation has unit length and its position is finite.
bool isRotation(const Pose& pose)
{
    return std::abs(pose.rotation.norm() - 1) < 1e-9 && pose.position.allFinite();
}

/// Calls `look` with random poses of heads and hands, some of them unusual.
void forManyPeople(const std::function<void(const Pose& head, const Pose& grip)>& look)
{
    std::mt19937 random(5);
    const auto between = [&](double min, double max) { return std::uniform_real_distribution(min, max)(random); };
    for (int i = 0; i < 2000; ++i) {
        const Pose eyes = head({between(-2, 2), between(0.6, 2), between(-2, 2)},
                               {between(-180, 180), between(-89, 89), between(-60, 60)});
        const Vec3 reach = Vec3(between(-1, 1), between(-1, 1), between(-1, 1)).normalized() * between(0.2, 0.8);
        look(eyes, {Eigen::Quaterniond::UnitRandom(), eyes.position + reach});
    }
}
} // namespace

class TestPanelPlacement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void atAHand_itFacesTheHead();
    void atAHand_itIsUprightToTheEyes();
    void atAHand_itStandsAboveTheWand();
    void atAHand_itMovesNoFartherThanTheHandsDo();
    void atAHand_itKeepsClearOfTheModel_data();
    void atAHand_itKeepsClearOfTheModel();
    void atAHand_inTheModelItStaysThere();
    void ahead_itIsUprightAtArmsLength();
    void ahead_itIsWhereTheHeadTurnsTo_data();
    void ahead_itIsWhereTheHeadTurnsTo();
    void ahead_itKeepsClearOfTheModel_data();
    void ahead_itKeepsClearOfTheModel();
    void ahead_itIsInSight();
    void ahead_itTakesAnothersPlace();
    void ahead_whereNothingIsClear_itIsAhead();
    void ahead_noneHidesAnother();
    void overlap_isInSight();
    void somebodyWalksAway();
    void aRay_meetsItFromTheFrontOnly();
    void aRay_meetsThePointItAimsAt();
};

void TestPanelPlacement::atAHand_itFacesTheHead()
{
    forManyPeople([](const Pose& eyes, const Pose& grip) {
        const Pose panel = vr::placeAtHand(grip, eyes, {size});
        QVERIFY(isRotation(panel));
        QVERIFY(normalOf(panel).cross(eyes.position - panel.position).norm() < 1e-9);
        QVERIFY(normalOf(panel).dot(eyes.position - panel.position) > 0);
    });
}

/// Checks that the lines of a panel are level for a head that looks at it without tilting.
void TestPanelPlacement::atAHand_itIsUprightToTheEyes()
{
    for (double yaw = -180; yaw < 180; yaw += 15)
        for (double pitch = -80; pitch < 60; pitch += 10) {
            const Pose eyes = head({0, 1.6, 0}, {yaw, pitch, 0});
            const Pose grip{Eigen::Quaterniond::Identity(), eyes.position + 0.5 * eyes.forward()};
            const Pose panel = vr::placeAtHand(grip, eyes, {size});
            const Vec3 right = panel.rotation * Vec3::UnitX();
            QVERIFY(right.dot(eyes.rotation * Vec3::UnitX()) > 0.9);
            QVERIFY(std::abs(right.y()) < 0.15);
        }
}

void TestPanelPlacement::atAHand_itStandsAboveTheWand()
{
    for (const double height : {0.9, 1.1, 1.3}) {
        const Pose eyes = head({0, 1.6, 0}, {0, -30, 0}), grip{Eigen::Quaterniond::Identity(), {-0.2, height, -0.35}};
        const Pose panel = vr::placeAtHand(grip, eyes, {size});
        const Vec3 hand = panel.inverse() * grip.position;
        QVERIFY(hand.y() < -size.y() / 2);
        QVERIFY(panel.position.y() > grip.position.y());
        QVERIFY((panel.position - eyes.position).norm() < 0.75);
    }
}

/// Checks that trembling by millimetres moves the panel only by millimetres.
void TestPanelPlacement::atAHand_itMovesNoFartherThanTheHandsDo()
{
    std::mt19937 random(9);
    std::normal_distribution<double> tremor(0, 0.001);
    const Pose eyes = head({0, 1.6, 0}, {0, -40, 0}), grip{Eigen::Quaterniond::Identity(), {-0.2, 1.2, -0.35}};
    const Pose still = vr::placeAtHand(grip, eyes, {size});
    for (int i = 0; i < 500; ++i) {
        Pose shakenHead = eyes, shakenGrip = grip;
        shakenHead.position += Vec3(tremor(random), tremor(random), tremor(random));
        shakenGrip.position += Vec3(tremor(random), tremor(random), tremor(random));
        const Pose shaken = vr::placeAtHand(shakenGrip, shakenHead, {size});
        QVERIFY((shaken.position - still.position).norm() < 0.012);
        QVERIFY(shaken.rotation.angularDistance(still.rotation) < 1.5 * degree);
    }
}

void TestPanelPlacement::atAHand_itKeepsClearOfTheModel_data()
{
    QTest::addColumn<double>("turnsTo");
    QTest::newRow("left") << 1.0;
    QTest::newRow("right") << -1.0;
}

/// Moves the hand beside and in front of the model. The panel must be neither in the model nor behind it, and must move
/// without jumps.
void TestPanelPlacement::atAHand_itKeepsClearOfTheModel()
{
    QFETCH(double, turnsTo);
    constexpr double step = 0.005;
    const Pose eyes = head({0, 1.6, 0}, {0, -15, 0});
    const core::Sphere clay{{0, 1.4, -0.6}, 0.25};
    std::optional<Vec3> before;
    for (double x = 0.05; x <= 0.6; x += step) {
        const Pose grip{Eigen::Quaterniond::Identity(), {-turnsTo * x, 1.2, -0.3}};
        const Pose panel = vr::placeAtHand(grip, eyes, {size, clay, turnsTo}),
                   plain = vr::placeAtHand(grip, eyes, {size});
        for (const double u : {-0.5, 0.0, 0.5})
            for (const double v : {-0.5, 0.0, 0.5}) {
                const Vec3 seen = panel * Vec3(u * size.x(), v * size.y(), 0), way = seen - eyes.position;
                const double along = std::min(1.0, way.dot(clay.center - eyes.position) / way.squaredNorm());
                QVERIFY((eyes.position + along * way - clay.center).norm() > clay.radius - 1e-6);
            }
        QVERIFY(turnsTo * (plain.position - panel.position).x() >= 0);
        QVERIFY(std::abs((panel.position - eyes.position).norm() - (plain.position - eyes.position).norm()) < 1e-9);
        QVERIFY(!before || (panel.position - *before).norm() < 3 * step);
        before = panel.position;
        if (x > 0.5)
            QVERIFY((panel.position - plain.position).norm() < 1e-9);
    }
}

/// Checks that the panel is not moved if the model is so large that it would hide the panel anywhere.
void TestPanelPlacement::atAHand_inTheModelItStaysThere()
{
    forManyPeople([](const Pose& eyes, const Pose& grip) {
        const Pose plain = vr::placeAtHand(grip, eyes, {size});
        QVERIFY((vr::placeAtHand(grip, eyes, {size, core::Sphere{eyes.position, 5}}).position - plain.position).norm() <
                1e-9);
    });
}

void TestPanelPlacement::ahead_itIsUprightAtArmsLength()
{
    forManyPeople([](const Pose& eyes, const Pose&) {
        const AheadPanelPlacement place{.aside = 0.3};
        const Pose panel = vr::placeAhead(eyes, place);
        QVERIFY(isRotation(panel));
        QVERIFY((panel.rotation * Vec3::UnitY() - Vec3::UnitY()).norm() < 1e-9);
        const Vec3 way = panel.position - eyes.position;
        QVERIFY(std::abs(way.y() + place.below) < 1e-9);
        QVERIFY(std::abs(Vec3(way.x(), 0, way.z()).norm() - place.distance) < 1e-9);
        QVERIFY(normalOf(panel).dot(-way) > 0.9 * way.norm());
        QVERIFY(normalOf(panel).cross(Vec3(way.x(), 0, way.z())).norm() < 1e-9);
    });
}

void TestPanelPlacement::ahead_itIsWhereTheHeadTurnsTo_data()
{
    QTest::addColumn<double>("pitch");
    for (const double pitch : {-88.0, -60.0, 0.0, 60.0, 88.0})
        QTest::newRow(qPrintable(QString::number(pitch))) << pitch;
}

void TestPanelPlacement::ahead_itIsWhereTheHeadTurnsTo()
{
    QFETCH(double, pitch);
    for (double yaw = -180; yaw < 180; yaw += 20) {
        const Pose panel = vr::placeAhead(head({1, 1.7, 2}, {yaw, pitch, 0}), {});
        const Vec3 wanted = head({}, {yaw, 0, 0}).forward();
        QVERIFY(Vec3(panel.position - Vec3(1, 1.7, 2)).dot(wanted) > 0.59);
        const Pose left = vr::placeAhead(head({1, 1.7, 2}, {yaw, pitch, 0}), {.aside = 30 * degree});
        QVERIFY((left.position - panel.position).dot(head({}, {yaw, 0, 0}).rotation * Vec3::UnitX()) < -0.2);
    }
}

void TestPanelPlacement::ahead_itKeepsClearOfTheModel_data()
{
    QTest::addColumn<double>("yaw");
    QTest::addColumn<double>("turnsTo");
    for (const double yaw : {-40.0, 0.0, 25.0})
        for (const double turnsTo : {1.0, -1.0})
            QTest::addRow("%g, %g", yaw, turnsTo) << yaw << turnsTo;
}

/// Checks that a panel opened in front of the user is neither in the model nor behind it, for a model of comfortable
/// size.
void TestPanelPlacement::ahead_itKeepsClearOfTheModel()
{
    QFETCH(double, yaw);
    QFETCH(double, turnsTo);
    const Eigen::Vector2d large(0.59, 0.49);
    vr::ModelPlacement placement;
    placement.place(head({0, 1.6, 0}, {}));
    const core::Sphere model{placement.middle(), vr::ModelPlacement::comfortableSize / 2};
    const Pose eyes = head({0, 1.6, 0}, {yaw, -20, 0});
    const double aside = turnsTo * 0.1;
    const Pose panel = vr::placeAhead(eyes, {.size = large, .aside = aside, .clear = model});
    for (double x = -0.5; x <= 0.5; x += 0.1)
        for (double y = -0.5; y <= 0.5; y += 0.1)
            for (double t = 0; t <= 1; t += 0.02) {
                const Vec3 point = panel * Vec3(x * large.x(), y * large.y(), 0);
                QVERIFY((eyes.position + t * (point - eyes.position) - model.center).norm() > 0.97 * model.radius);
            }
    const auto wanted = vr::placeAhead(eyes, {.size = large, .aside = aside});
    const bool isWanted = (panel.position - wanted.position).norm() < 1e-9;
    const auto awayFromGaze = [&](const Pose& pose) {
        return (pose.position - vr::placeAhead(eyes, {.size = large}).position).norm();
    };
    for (const double side : {1.0, -1.0}) // no place on either side is nearer to where the user looks
        QVERIFY(isWanted ||
                awayFromGaze(panel) <=
                    awayFromGaze(vr::placeAhead(eyes, {.size = large, .aside = side * 1.9, .clear = model})) + 1e-9);
}

/// Checks that a panel opens in sight wherever the user looks while the model is elsewhere.
void TestPanelPlacement::ahead_itIsInSight()
{
    using vr::PanelKind;
    vr::ModelPlacement placement;
    placement.place(head({0, 1.6, 0}, {}));
    const core::Sphere model{placement.middle(), vr::ModelPlacement::comfortableSize / 2};
    const vr::PanelContent contents[] = {vr::ToolPanel(), vr::ColorPanel(), vr::FilesPanel(), vr::SettingsPanel()};
    for (const vr::PanelContent& content : contents)
        for (double yaw = -180; yaw < 180; yaw += 5) {
            const vr::PanelManager::Sight sight{head({0, 1.6, 0}, {yaw, 0, 0}), {}, vr::Side::Right, model};
            const vr::PanelLayout layout = vr::layoutOf(content);
            const auto angleTo = [&](const Pose& panel, const Pose& eyes) {
                const Vec3 way = eyes.inverse().rotation * (panel.position - eyes.position);
                return std::abs(std::atan2(way.x(), -way.z())) / degree;
            };
            const double angle = angleTo(vr::PanelManager::placeOnOpening(layout.kind, sight, layout), sight.head);
            QVERIFY2(angle < 60, qPrintable(QStringLiteral("%1: %2").arg(yaw).arg(angle)));
        }
}

/// Opens a panel while the tool panel is at a hand beside the model, for many directions in which the user looks. The
/// new panel must be in the tool panel's direction.
void TestPanelPlacement::ahead_itTakesAnothersPlace()
{
    vr::ModelPlacement placement;
    placement.place(head({0, 1.6, 0}, {}));
    const core::Sphere model{placement.middle(), vr::ModelPlacement::comfortableSize / 2};
    const vr::PanelLayout tools = vr::layoutOf(vr::ToolPanel());
    for (const vr::PanelContent& content : {vr::PanelContent(vr::FilesPanel()), vr::PanelContent(vr::SettingsPanel())})
        for (const double side : {1.0, -1.0})
            for (double yaw = -60; yaw <= 60; yaw += 10) {
                const vr::PanelManager::Sight sight{head({0, 1.6, 0}, {yaw, -15, 0}), {}, vr::Side::Right, model};
                const Pose grip{Eigen::Quaterniond::Identity(), {-side * 0.3, 1.2, -0.3}};
                const Pose before = vr::placeAtHand(grip, sight.head, {tools.metres(), model, side});
                const vr::PanelLayout layout = vr::layoutOf(content);
                const Pose panel = vr::PanelManager::placeOnOpening(layout.kind, sight, layout, before);
                const Vec3 a = before.position - sight.head.position, b = panel.position - sight.head.position;
                const double angle = std::atan2(a.x() * b.z() - a.z() * b.x(), a.x() * b.x() + a.z() * b.z());
                QVERIFY2(std::abs(angle) < 11 * degree, qPrintable(QString::number(angle / degree)));
            }
}

void TestPanelPlacement::ahead_whereNothingIsClear_itIsAhead()
{
    const Pose eyes = head({0, 1.6, 0}, {});
    const core::Sphere around{{0, 1.6, 0}, 3};
    QVERIFY((vr::placeAhead(eyes, {.clear = around}).position - vr::placeAhead(eyes, {}).position).norm() < 1e-12);
    const core::Sphere behind{{0, 1.6, 1}, 0.3};
    QVERIFY((vr::placeAhead(eyes, {.clear = behind}).position - vr::placeAhead(eyes, {}).position).norm() < 1e-12);
}

/// Checks that the files, settings and performance panels, opened around a model of comfortable size, do not hide each
/// other.
void TestPanelPlacement::ahead_noneHidesAnother()
{
    vr::PanelManager::Sight sight{head({0, 1.6, 0}, {30, -15, 0}), {}, vr::Side::Right, {}};
    vr::ModelPlacement placement;
    placement.place(sight.head);
    sight.model = {placement.middle(), vr::ModelPlacement::comfortableSize / 2};
    std::vector<vr::PlacedPanel> panels;
    for (const vr::PanelContent& content : {vr::PanelContent(vr::FilesPanel()), vr::PanelContent(vr::SettingsPanel()),
                                            vr::PanelContent(vr::PerformancePanel())}) {
        const auto layout = std::make_shared<const vr::PanelLayout>(vr::layoutOf(content));
        panels.push_back({vr::PanelManager::placeOnOpening(layout->kind, sight, *layout), layout});
    }
    for (const vr::PlacedPanel& seen : panels)
        for (const vr::PlacedPanel& other : panels)
            for (double u = -0.5; u <= 0.5 && &seen != &other; u += 0.125)
                for (double v = -0.5; v <= 0.5; v += 0.125) {
                    const Eigen::Vector2d size = seen.layout->metres();
                    const Vec3 way = seen.pose * Vec3(u * size.x(), v * size.y(), 0) - sight.head.position;
                    const auto point = vr::intersect({sight.head.position, way}, other.pose);
                    QVERIFY(!point || !other.layout->contains(point->at));
                }
}

/// Compares overlap() with rays from the eye.
void TestPanelPlacement::overlap_isInSight()
{
    const Pose eyes = head({0, 1.6, 0}, {20, -10, 0});
    const vr::PanelTarget far{vr::placeAhead(eyes, {.distance = 0.9}), {0.4, 0.3}, {}};
    int hidden = 0, apart = 0;
    for (double aside = -0.9; aside <= 0.9; aside += 0.06)
        for (double below = -0.6; below <= 0.6; below += 0.04) {
            const vr::PanelTarget near{vr::placeAhead(eyes, {.aside = aside, .below = below}), {0.4, 0.3}, {}};
            bool isHidden = false;
            for (double u = -0.5; u <= 0.5; u += 0.05)
                for (double v = -0.5; v <= 0.5; v += 0.05) {
                    const Vec3 way = far.pose * Vec3(u * far.size.x(), v * far.size.y(), 0) - eyes.position;
                    const auto point = vr::intersect({eyes.position, way}, near.pose);
                    isHidden = isHidden || (point && (2 * point->at.cwiseAbs() - near.size).maxCoeff() <= 0);
                }
            const bool overlap = vr::overlapInSight(near, far, eyes);
            QVERIFY(overlap || !isHidden);
            QCOMPARE(overlap, vr::overlapInSight(far, near, eyes));
            hidden += isHidden;
            apart += !overlap;
        }
    QVERIFY(hidden > 50 && apart > 200);
}

void TestPanelPlacement::somebodyWalksAway()
{
    const Pose panel = vr::placeAhead(head({0, 1.6, 0}, {}), {});
    for (double yaw = -180; yaw < 180; yaw += 30)
        QVERIFY(!vr::isOutOfReach(panel, head({0.1, 1.5, 0.1}, {yaw, 0, 0})));
    QVERIFY(vr::isOutOfReach(panel, head({0, 1.6, 1.5}, {})));
}

void TestPanelPlacement::aRay_meetsItFromTheFrontOnly()
{
    const Pose panel = vr::placeAhead(head({0, 1.6, 0}, {20, 0, 0}), {});
    const Vec3 normal = normalOf(panel);
    QVERIFY(vr::intersect({panel.position + normal, -normal}, panel));
    QVERIFY(!vr::intersect({panel.position + normal, normal}, panel));
    QVERIFY(!vr::intersect({panel.position - normal, normal}, panel));
    QVERIFY(!vr::intersect({panel.position - normal, -normal}, panel));
    QVERIFY(!vr::intersect({panel.position + normal, panel.rotation * Vec3::UnitX()}, panel));
}

void TestPanelPlacement::aRay_meetsThePointItAimsAt()
{
    std::mt19937 random(11);
    const auto between = [&](double min, double max) { return std::uniform_real_distribution(min, max)(random); };
    forManyPeople([&](const Pose& eyes, const Pose& grip) {
        const Pose panel = vr::placeAtHand(grip, eyes, {size});
        const Eigen::Vector2d at(between(-0.3, 0.3), between(-0.3, 0.3));
        const Vec3 target = panel * Vec3(at.x(), at.y(), 0),
                   from = panel * Vec3(between(-1, 1), between(-1, 1), between(0.05, 1));
        const auto point = vr::intersect({from, (target - from) * between(0.1, 9)}, panel);
        QVERIFY(point && (point->at - at).norm() < 1e-9);
        QVERIFY(std::abs(point->distance - (target - from).norm()) < 1e-9);
    });
}

FETTLE_TEST(TestPanelPlacement, QCoreApplication)
#include "tst_panel_placement.moc"
