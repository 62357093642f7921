#include "app/headset/simulator_gaze.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using app::SimulatorGaze;
using core::Vec3;
using vr::PanelKind;

namespace
{
constexpr double sideTangent = 1.1, tick = 0.016;

/// Returns a panel at arm's length that faces the head, `left` radians to the left of the room's middle.
vr::PanelTarget panelAt(double left, PanelKind kind = PanelKind::Tools)
{
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(left, Vec3::UnitY()));
    return {{turn, turn * Vec3(0, 0, -0.5)}, {0.6, 0.5}, {}, kind};
}

struct User
{
    vr::Pose head() const { return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Vec3::UnitY())), Vec3::Zero()}; }
    void look(const std::vector<vr::PanelTarget>& panels, double seconds = 2)
    {
        for (double time = 0; time < seconds; time += tick) {
            const double by = gaze.step(panels, head(), sideTangent, tick);
            fastest = std::max(fastest, std::abs(by));
            yaw += by;
        }
    }
    bool seesAll(const vr::PanelTarget& panel) const
    {
        bool all = true;
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) {
                const Vec3 own = head().inverse() * (panel.pose * Vec3(x * panel.size.x(), y * panel.size.y(), 0));
                all = all && own.z() < 0 && std::abs(own.x() / own.z()) < sideTangent;
            }
        return all;
    }

    SimulatorGaze gaze;
    double yaw = 0, fastest = 0;
};
} // namespace

class TestSimulatorGaze : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The head turns to an opened panel and back after it closes, in small steps.
    void head_turnsToWhatIsOpened()
    {
        for (const double left : {-2.5, -0.9, -0.1, 0.0, 0.3, 0.9, 1.5}) {
            User user;
            user.look({panelAt(left)});
            QVERIFY(user.seesAll(panelAt(left)));
            QVERIFY(std::abs(left) > 0.2 || user.yaw == 0);
            user.look({});
            QVERIFY(std::abs(user.yaw) < 0.01);
            QVERIFY(user.fastest < 0.05);
        }
    }

    /// The head turns to a panel that replaces the tools, and to the colours that open beside them.
    void head_turnsToTheNextOne()
    {
        User user;
        user.look({panelAt(0.9)});
        user.look({panelAt(1.2, PanelKind::Settings)});
        QVERIFY(user.seesAll(panelAt(1.2, PanelKind::Settings)));
        user.look({panelAt(-0.9, PanelKind::Color), panelAt(1.2, PanelKind::Settings)});
        QVERIFY(user.seesAll(panelAt(-0.9, PanelKind::Color)));
        user.look({panelAt(1.2, PanelKind::Settings)});
        user.look({});
        QVERIFY(std::abs(user.yaw) < 0.01);
    }

    void head_staysWhereTheUserTurnsIt()
    {
        User user;
        user.look({panelAt(0.9)});
        user.yaw += 0.2;
        user.gaze.cancel();
        const double yaw = user.yaw;
        user.look({panelAt(0.9)});
        user.look({});
        QCOMPARE(user.yaw, yaw);
    }

    /// Panels that open by themselves, such as a lesson's, do not turn the head.
    void head_doesNotTurnToOthers()
    {
        User user;
        user.look({panelAt(0.9, PanelKind::Lesson), panelAt(-0.9, PanelKind::Performance)});
        QCOMPARE(user.yaw, 0.0);
    }

    void head_turnsAtOnceWhereNothingShallMove()
    {
        User user;
        user.yaw += user.gaze.step(std::vector{panelAt(0.9)}, user.head(), sideTangent, 0);
        QVERIFY(user.seesAll(panelAt(0.9)));
    }
};

FETTLE_TEST(TestSimulatorGaze, QCoreApplication)
#include "tst_simulator_gaze.moc"
