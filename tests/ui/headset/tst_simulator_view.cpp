// The controls of the VR simulator: each key and mouse motion has the effect given in the legend.
#include "ui/headset/simulator_view.h"
#include "ui/headset/simulator_window.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QSignalSpy>
#include <QWheelEvent>

using core::Vec3;
using ui::SimulatedButtons;
using ui::SimulatedHand;
using ui::SimulatorControls;
using ui::SimulatorView;

namespace
{
/// Returns the position of a point in the eye's picture: -1 to 1 from edge to edge, right and up.
Eigen::Vector2d seen(const SimulatorControls& controls, const Vec3& point)
{
    const Vec3 own = controls.head().inverse() * point;
    return Eigen::Vector2d(own.x() / SimulatorControls::sideTangent, own.y() / SimulatorControls::upTangent) / -own.z();
}

double farFromEye(const SimulatorControls& controls)
{
    return (controls.tip(controls.hand()).translation() - controls.head().translation()).norm();
}

void move(SimulatorView& view, const Eigen::Vector2d& place, Qt::MouseButton button = Qt::NoButton,
          Qt::KeyboardModifiers modifiers = {})
{
    sendMouse(&view, QEvent::MouseMove, view.placeOf(place).toPoint(), button, modifiers);
}

void wheel(SimulatorView& view, int notches, Qt::KeyboardModifiers modifiers = {})
{
    QWheelEvent event(QPointF(9, 9), view.mapToGlobal(QPointF(9, 9)), {}, {0, 120 * notches}, {}, modifiers,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
}

/// An event filter that records the window that was raised last.
class Raised : public QObject
{
public:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::ZOrderChange)
            last = object;
        return false;
    }

    QObject* last = nullptr;
};

struct Seated
{
    Seated() { view.resize(900, 600); }
    const SimulatorControls& controls() const { return view.controls(); }
    const SimulatedButtons& right() const { return controls().buttons(SimulatedHand::Right); }
    const SimulatedButtons& left() const { return controls().buttons(SimulatedHand::Left); }
    Vec3 tip() const { return controls().tip(controls().hand()).translation(); }

    SimulatorView view;
};
} // namespace

class TestSimulatorView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tip_isWhereTheMouseIs()
    {
        Seated at;
        for (const Eigen::Vector2d& place :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(-0.7, 0.4), Eigen::Vector2d(0.9, -0.8)}) {
            move(at.view, place);
            QVERIFY((seen(at.controls(), at.tip()) - place).norm() < 0.01);
        }
        sendMouse(&at.view, QEvent::MouseMove, QPoint(-500, 2000)); // outside the window, while a button is held
        QVERIFY((seen(at.controls(), at.tip()) - Eigen::Vector2d(-1, -1)).norm() < 1e-9);
    }

    void wheel_reachesFartherAlongTheSight()
    {
        Seated at;
        move(at.view, {0.2, 0.1});
        const double before = farFromEye(at.controls());
        const Eigen::Vector2d place = seen(at.controls(), at.tip());
        wheel(at.view, 3);
        QVERIFY(std::abs(farFromEye(at.controls()) - before - 0.06) < 1e-9);
        QVERIFY((seen(at.controls(), at.tip()) - place).norm() < 1e-9);
        wheel(at.view, -200);
        QVERIFY(farFromEye(at.controls()) > 0.1);
    }

    /// Initially the tip is on the surface under the mouse. The wheel moves it before or behind the surface, and it
    /// keeps that offset.
    void tip_goesWithTheSurface()
    {
        using Following = SimulatorControls::Following;
        Seated at;
        const auto isAt = [&](double distance) { return std::abs(farFromEye(at.controls()) - distance) < 1e-9; };
        const double before = farFromEye(at.controls());
        QVERIFY(!at.controls().depth());
        at.view.meet({}, Following::Freely, false);
        QVERIFY(isAt(before));
        at.view.meet(SimulatorControls::Surface{0.5}, Following::Freely, false);
        QVERIFY(isAt(0.5) && at.controls().depth() == 0.0);
        wheel(at.view, -2);
        QVERIFY(isAt(0.46));
        at.view.meet(SimulatorControls::Surface{0.7}, Following::Freely, false);
        QVERIFY(isAt(0.66) && std::abs(*at.controls().depth() + 0.04) < 1e-9);
        at.view.meet(SimulatorControls::Surface{0.6}, Following::Not, false);
        QVERIFY(isAt(0.66));
        at.view.meet({}, Following::Freely, false);
        QVERIFY(isAt(0.66) && !at.controls().depth());
    }

    /// While a button is pressed, a surface that grows towards the eye does not move the resting wand; a surface along
    /// which the mouse moves does.
    void tip_thatSculptsGoesAsTheMouseDoes()
    {
        using Following = SimulatorControls::Following;
        Seated at;
        move(at.view, {0, 0});
        at.view.meet(SimulatorControls::Surface{0.6}, Following::Freely, false);
        for (int i = 0; i < 9; ++i)
            at.view.meet(SimulatorControls::Surface{0.5}, Following::WithTheMouse, false);
        QVERIFY(std::abs(farFromEye(at.controls()) - 0.6) < 1e-9);
        move(at.view, {0.1, 0});
        at.view.meet(SimulatorControls::Surface{0.5}, Following::WithTheMouse, false);
        const double by = 0.6 - farFromEye(at.controls());
        QVERIFY2(by > 0.05 && by < 0.08, qPrintable(QString::number(by)));
    }

    /// Wands that point (at a panel, or with a ray brush) hit the point under the mouse at any distance.
    void wand_thatPointsHitsWhatIsUnderTheMouse()
    {
        using Following = SimulatorControls::Following;
        for (const bool isPanel : {false, true})
            for (const double distance : {0.3, 0.6, 1.4})
                for (const Eigen::Vector2d& place :
                     {Eigen::Vector2d(0, 0), Eigen::Vector2d(-0.7, 0.4), Eigen::Vector2d(0.9, -0.8)}) {
                    Seated at;
                    move(at.view, place);
                    at.view.meet(SimulatorControls::Surface{distance, isPanel}, Following::Freely, !isPanel);
                    const core::Ray sight = at.controls().sight();
                    const Vec3 target = sight.origin + distance * sight.direction;
                    QVERIFY((seen(at.controls(), target) - place).norm() < 0.01);
                    const Eigen::Isometry3d tip = at.controls().tip(SimulatedHand::Right);
                    const Vec3 way = target - tip.translation(), forward = tip.linear() * -Vec3::UnitZ();
                    QVERIFY(way.norm() > 0.05 && way.cross(forward).norm() < 1e-9 && way.dot(forward) > 0);
                    QVERIFY(!at.controls().depth());
                }
    }

    /// A wand that was pressed on a panel keeps its distance beyond the panel's edge.
    void wand_thatPressesAPanelStaysWithIt()
    {
        using Following = SimulatorControls::Following;
        Seated at;
        at.view.meet(SimulatorControls::Surface{0.5, true}, Following::Freely, false);
        const Eigen::Isometry3d before = at.controls().tip(SimulatedHand::Right);
        at.view.meet(SimulatorControls::Surface{0.9, false}, Following::WithTheMouse, false);
        QVERIFY((at.controls().tip(SimulatedHand::Right).translation() - before.translation()).norm() < 1e-9);
    }

    void wheel_withShiftTurnsTheWandAboutItself()
    {
        Seated at;
        const Eigen::Isometry3d before = at.controls().tip(SimulatedHand::Right);
        wheel(at.view, 2, Qt::ShiftModifier);
        const Eigen::Isometry3d turned = before.inverse() * at.controls().tip(SimulatedHand::Right);
        QVERIFY(turned.translation().norm() < 1e-9 && (turned * Vec3::UnitZ() - Vec3::UnitZ()).norm() < 1e-9);
        QVERIFY((turned * Vec3::UnitX() - Vec3::UnitX()).norm() > 0.2);
    }

    void trigger_byButtonOrSpace()
    {
        Seated at;
        QSignalSpy changes(&at.view, &SimulatorView::buttonsChanged);
        sendMouse(&at.view, QEvent::MouseButtonPress, {9, 9}, Qt::LeftButton);
        QCOMPARE(at.right().trigger, 1.0);
        sendMouse(&at.view, QEvent::MouseButtonRelease, {9, 9}, Qt::LeftButton);
        QCOMPARE(at.right().trigger, 0.0);
        sendMouse(&at.view, QEvent::MouseButtonPress, {9, 9}, Qt::LeftButton, Qt::ShiftModifier);
        QVERIFY(at.right().trigger > 0.6 && at.right().trigger < 0.8);
        sendMouse(&at.view, QEvent::MouseButtonRelease, {9, 9}, Qt::LeftButton);
        QTest::keyPress(&at.view, Qt::Key_Space);
        QCOMPARE(at.right().trigger, 1.0);
        QTest::keyRelease(&at.view, Qt::Key_Space);
        QCOMPARE(at.right(), SimulatedButtons());
        QCOMPARE(changes.count(), 6);
    }

    void pad_isPressedByArrows_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<QPointF>("side");
        QTest::newRow("left") << Qt::Key_Left << QPointF(-1, 0);
        QTest::newRow("right") << Qt::Key_Right << QPointF(1, 0);
        QTest::newRow("top") << Qt::Key_Up << QPointF(0, 1);
        QTest::newRow("bottom") << Qt::Key_Down << QPointF(0, -1);
    }

    void pad_isPressedByArrows()
    {
        QFETCH(Qt::Key, key);
        QFETCH(QPointF, side);
        Seated at;
        QTest::keyPress(&at.view, key);
        QVERIFY(at.right().pressesPad && at.right().touchesPad);
        QVERIFY(at.right().pad.dot(Eigen::Vector2d(side.x(), side.y())) > 0.5);
        QTest::keyRelease(&at.view, key);
        QCOMPARE(at.right(), SimulatedButtons());
    }

    void thumb_slidesWithCtrl()
    {
        Seated at;
        move(at.view, {0, 0});
        const Vec3 tip = at.tip();
        QTest::keyPress(&at.view, Qt::Key_Control);
        QVERIFY(at.right().touchesPad);
        move(at.view, {0.2, 0}, Qt::NoButton, Qt::ControlModifier);
        QVERIFY(at.right().pad.x() > 0.2 && !at.right().pressesPad);
        move(at.view, {1, 1}, Qt::NoButton, Qt::ControlModifier);
        QVERIFY(at.right().pad.norm() < 1 + 1e-9);
        QCOMPARE(at.tip(), tip); // the hand does not move while the thumb slides
        QTest::keyRelease(&at.view, Qt::Key_Control);
        QCOMPARE(at.right(), SimulatedButtons());
    }

    void menuAndSqueeze()
    {
        Seated at;
        QTest::keyPress(&at.view, Qt::Key_M);
        QVERIFY(at.right().pressesMenu && !at.left().pressesMenu);
        QTest::keyRelease(&at.view, Qt::Key_M);
        QTest::keyPress(&at.view, Qt::Key_G);
        QVERIFY(at.right().squeezes && !at.left().squeezes);
        QTest::keyRelease(&at.view, Qt::Key_G);
        QTest::keyPress(&at.view, Qt::Key_B);
        QVERIFY(at.right().squeezes && at.left().squeezes);
        QTest::keyRelease(&at.view, Qt::Key_B);
        QVERIFY(at.right() == SimulatedButtons() && at.left() == SimulatedButtons());
    }

    /// A hand that squeezes keeps squeezing and stays in place; otherwise the hand returns to its rest pose.
    void tab_changesTheHand()
    {
        Seated at;
        QSignalSpy hands(&at.view, &SimulatorView::handChanged);
        const Vec3 leftAtRest = at.controls().tip(SimulatedHand::Left).translation();
        move(at.view, {0.1, 0.1});
        const Vec3 place = at.tip();
        QTest::keyPress(&at.view, Qt::Key_G);
        QTest::keyClick(&at.view, Qt::Key_Tab);
        QVERIFY(at.controls().hand() == SimulatedHand::Left && hands.count() == 1);
        move(at.view, {-0.4, 0});
        QVERIFY(at.right().squeezes && !at.left().squeezes);
        QVERIFY((at.controls().tip(SimulatedHand::Right).translation() - place).norm() < 1e-9);
        QTest::keyRelease(&at.view, Qt::Key_G);
        QVERIFY(!at.right().squeezes);
        QTest::keyPress(&at.view, Qt::Key_Space);
        QVERIFY(at.left().trigger == 1 && at.right().trigger == 0);
        QTest::keyClick(&at.view, Qt::Key_Tab);
        QVERIFY(at.left() == SimulatedButtons());
        QVERIFY((at.controls().tip(SimulatedHand::Left).translation() - leftAtRest).norm() < 1e-9);
    }

    void head_looksAndWalks()
    {
        Seated at;
        sendMouse(&at.view, QEvent::MouseButtonPress, {400, 300}, Qt::RightButton);
        sendMouse(&at.view, QEvent::MouseMove, {400 - 393, 300}, Qt::RightButton);
        const Vec3 ahead = at.controls().head().linear() * Vec3(0, 0, -1);
        QVERIFY(ahead.x() < -0.9);
        const Vec3 from = at.controls().head().translation();
        QTest::keyPress(&at.view, Qt::Key_W);
        at.view.advance(0.5);
        QTest::keyRelease(&at.view, Qt::Key_W);
        at.view.advance(0.5);
        const Vec3 way = at.controls().head().translation() - from;
        QVERIFY(way.x() < -0.39 && std::abs(way.y()) < 1e-9 && way.norm() < 0.41);
        QTest::keyPress(&at.view, Qt::Key_Q);
        at.view.advance(60);
        QVERIFY(at.controls().head().translation().y() > 0.2); // above the floor
    }

    void focus_thatIsLostLetsGo()
    {
        Seated at;
        QTest::keyPress(&at.view, Qt::Key_G);
        QTest::keyPress(&at.view, Qt::Key_W);
        QFocusEvent lost(QEvent::FocusOut);
        QCoreApplication::sendEvent(&at.view, &lost);
        QCOMPARE(at.right(), SimulatedButtons());
        const Vec3 from = at.controls().head().translation();
        at.view.advance(1);
        QCOMPARE(at.controls().head().translation(), from);
    }

    /// A modal dialog comes to the front when the simulator window opens, and also when the dialog opens later.
    void question_isNotHiddenBehindTheWindow()
    {
        QWidget main;
        main.show();
        auto* window = new ui::SimulatorWindow(&main);
        Raised raised;
        QDialog before(&main), after(&main);
        for (QDialog* question : {&before, &after}) {
            question->setModal(true);
            question->installEventFilter(&raised);
        }
        before.show();
        window->begin();
        QTRY_VERIFY(raised.last == &before);
        window->installEventFilter(&raised);
        before.close();
        QTRY_VERIFY(raised.last == window);
        after.show();
        QTRY_VERIFY(raised.last == &after);
    }

    void window_saysItsKeysAndCloses()
    {
        QWidget main;
        auto* window = new ui::SimulatorWindow(&main);
        window->begin();
        QVERIFY(QTest::qWaitForWindowExposed(window));
        auto* hand = window->findChild<QLabel*>(QStringLiteral("simulatedHand"));
        const QString right = hand->text();
        QTest::keyClick(window->view(), Qt::Key_Tab);
        QVERIFY(hand->text() != right);
        QSignalSpy closed(window, &ui::SimulatorWindow::closed);
        QTest::keyClick(window->view(), Qt::Key_Escape);
        QVERIFY(!window->isVisible());
        QCOMPARE(closed.count(), 1);
    }
};

FETTLE_TEST(TestSimulatorView, ui::TestApplication)
#include "tst_simulator_view.moc"
