#include "ui/viewport/navigation_cube.h"

#include "tests/ui/ui_test.h"

#include <QSignalSpy>

using Side = ui::OrbitCamera::Side;

namespace
{
/// A navigation cube in its own view, with a camera that looks at the given side.
struct Cube
{
    explicit Cube(Side side)
    {
        view.resize(400, 300);
        view.show();
        camera.setViewport(400, 300);
        camera.frame(core::Box(core::Vec3::Constant(-1), core::Vec3::Constant(1)));
        camera.turnTo(side);
        cube.showFor(camera);
    }

    QPoint middle() const { return cube.rect().center(); }

    QWidget view;
    ui::NavigationCube cube{&view};
    ui::OrbitCamera camera;
};
} // namespace

class TestNavigationCube : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clicks_chooseTheSideThatIsSeen_data()
    {
        QTest::addColumn<int>("side");
        for (const auto& [side, name] : ui::viewSides)
            QTest::addRow("%s", name) << static_cast<int>(side);
    }

    void clicks_chooseTheSideThatIsSeen()
    {
        QFETCH(const int, side);
        Cube c(static_cast<Side>(side));
        const QSignalSpy chosen(&c.cube, &ui::NavigationCube::sideChosen);
        QTest::mouseClick(&c.cube, Qt::LeftButton, {}, c.middle());
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].value<Side>(), static_cast<Side>(side));
    }

    /// Clicks on the middle of a visible face choose this face, in any orientation.
    void middlesOfFaces_areTheirs()
    {
        constexpr double halfEdge = 25;
        Cube c(Side::Front);
        QSignalSpy chosen(&c.cube, &ui::NavigationCube::sideChosen);
        int seen = 0;
        for (int turn = 0; turn < 40; ++turn) {
            c.camera.orbit({37.0 + turn, turn % 2 == 0 ? 23.0 : -29.0});
            c.cube.showFor(c.camera);
            for (const auto& [side, name] : ui::viewSides) {
                ui::OrbitCamera there = c.camera;
                there.turnTo(side);
                const core::Vec3 outwards = -there.viewDirection();
                if (outwards.dot(-c.camera.viewDirection()) < 0.3)
                    continue;
                chosen.clear();
                const QPointF middle(outwards.dot(c.camera.right()), -outwards.dot(c.camera.up()));
                QTest::mouseClick(&c.cube, Qt::LeftButton, {},
                                  (QRectF(c.cube.rect()).center() + halfEdge * middle).toPoint());
                QVERIFY2(chosen.size() == 1 && chosen[0][0].value<Side>() == side, name);
                ++seen;
            }
        }
        QVERIFY(seen > 40);
    }

    void drags_turnAndChooseNothing()
    {
        Cube c(Side::Front);
        QSignalSpy chosen(&c.cube, &ui::NavigationCube::sideChosen), turned(&c.cube, &ui::NavigationCube::turned);
        sendMouse(&c.cube, QEvent::MouseButtonPress, c.middle(), Qt::LeftButton);
        sendMouse(&c.cube, QEvent::MouseMove, c.middle() + QPoint(20, 0), Qt::LeftButton);
        sendMouse(&c.cube, QEvent::MouseMove, c.middle() + QPoint(20, 30), Qt::LeftButton);
        sendMouse(&c.cube, QEvent::MouseButtonRelease, c.middle() + QPoint(20, 30), Qt::LeftButton);
        QVERIFY(chosen.isEmpty());
        QCOMPARE(turned.size(), 2);
        QVERIFY(turned[0][0].toDouble() > 0 && turned[0][1].toDouble() == 0);
        QVERIFY(turned[1][0].toDouble() == 0 && turned[1][1].toDouble() > 0);
    }

    void itStandsInTheCorner()
    {
        Cube c(Side::Front);
        for (const QSize size : {QSize(400, 300), QSize(800, 500)}) {
            c.view.resize(size);
            QTRY_VERIFY(c.cube.geometry().right() <= size.width() && c.cube.x() > size.width() / 2 && c.cube.y() >= 0);
        }
    }
};

FETTLE_TEST(TestNavigationCube, ui::TestApplication)
#include "tst_navigation_cube.moc"
