// Draws areas over a ball in the view, and looks at what the requested commands do to it.

#include "ui/model/area_actions.h"

#include "core/analysis/mesh_check.h"
#include "core/mesh/dirty_slots.h"
#include "core/mesh/mesh_builder.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"
#include "ui/actions/actions.h"
#include "ui/viewport/area_bar.h"
#include "ui/viewport/curve_drawing.h"
#include "ui/viewport/navigation_cube.h"

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QSet>
#include <QSignalSpy>
#include <QToolButton>

#include <cmath>
#include <numbers>

using Projection = ui::OrbitCamera::Projection;

namespace
{
/// A window with a ball seen from the front, and the last command that was requested.
struct Stage
{
    explicit Stage(Projection projection = Projection::Perspective)
    {
        window.setCentralWidget(viewport);
        window.resize(600, 450);
        ui::connectAreas(actions, viewport, &brush, [this](const core::ModelCommand& command) { requested = command; });
        viewport->setPatchSource([this] { return std::exchange(next, std::nullopt); });
        viewport->setReducesMotion(true);
        viewport->showModel({core::Vec3::Constant(-30), core::Vec3::Constant(30)});
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        viewport->navigation()->turnTo(ui::OrbitCamera::Side::Front);
        viewport->navigation()->setProjection(projection);
        show();
    }

    ui::CurveDrawing* drawing() const { return viewport->findChild<ui::CurveDrawing*>(); }
    double volume() const { return core::checkMesh(core::extractMesh(*mesh)).volume.value(); }

    /// Returns the pixel at this place in units of the ball's radius from its middle, y up.
    QPoint at(double x, double y) const
    {
        const ui::OrbitCamera::Pixel p = viewport->camera().project(30 * core::Vec3(x, y, 0));
        return QPointF(p.x(), p.y()).toPoint();
    }

    QToolButton* button(const char* name) const { return viewport->findChild<QToolButton*>(QLatin1StringView(name)); }
    QString hint() const { return viewport->findChild<QLabel*>(QStringLiteral("curveHint"))->text(); }

    /// Starts a command, and chooses the shape in the bar.
    void start(const char* id, const char* shape)
    {
        actions.get(QLatin1StringView(id))->trigger();
        QVERIFY(drawing()->isActive() && drawing()->isVisible());
        QVERIFY(button(shape)->isVisible());
        QTest::mouseClick(button(shape), Qt::LeftButton);
        QVERIFY(button(shape)->isChecked() && drawing()->isActive());
    }

    void press(const QPoint& p, Qt::MouseButton button = Qt::LeftButton)
    {
        sendMouse(viewport, QEvent::MouseButtonPress, p, button);
    }
    void release(const QPoint& p, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {})
    {
        QMouseEvent event(QEvent::MouseButtonRelease, p, viewport->mapToGlobal(p), button, Qt::NoButton, keys);
        QCoreApplication::sendEvent(viewport, &event);
    }
    void click(const QPoint& p, Qt::MouseButton button = Qt::LeftButton)
    {
        press(p, button);
        release(p, button);
    }
    void move(const QPoint& p, Qt::KeyboardModifiers keys = {}, Qt::MouseButtons held = Qt::LeftButton)
    {
        QMouseEvent event(QEvent::MouseMove, p, viewport->mapToGlobal(p), Qt::NoButton, held, keys);
        QCoreApplication::sendEvent(viewport, &event);
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = Qt::NoModifier)
    {
        press(from);
        for (int i = 1; i <= 10; ++i)
            move(from + (to - from) * i / 10, keys);
        release(to, Qt::LeftButton, keys);
    }

    /// Makes the requested cut, checks the result, and that undo restores the model. Returns the share of the volume
    /// that is left; -1 on a fault.
    double shareLeft()
    {
        if (!requested || drawing()->isActive())
            return -1;
        const double whole = volume();
        const std::uint64_t before = mesh->stateHash();
        core::ModelChange change = applyToCopy(*mesh, *requested);
        if (!change.changes)
            return -1;
        mesh->swap(change.delta);
        const bool isSound = core::checkMesh(core::extractMesh(*mesh)).printReady();
        const double left = volume();
        mesh->swap(change.delta);
        const bool isUndone = mesh->stateHash() == before;
        mesh->swap(change.delta);
        show();
        return isSound && isUndone ? left / whole : -1;
    }

    void show()
    {
        const quint64 before = viewport->stats().patches;
        next = core::wholePatchOf(*mesh);
        viewport->patchReady();
        QTRY_COMPARE(viewport->stats().patches, before + 1);
    }

    QMainWindow window;
    ui::Actions actions{&window};
    ui::BrushSettings brush;
    ui::Viewport* viewport = new ui::Viewport(&brush);
    std::unique_ptr<core::Mesh> mesh = core::buildMesh(core::icosphere(4, 30)).mesh;
    std::optional<core::MeshPatch> next;
    std::optional<core::ModelCommand> requested;
};

const std::vector<core::Vec3>& outlineOf(const core::ModelCommand& command)
{
    return std::get<core::Trim>(command).area.outline;
}

void addProjections()
{
    QTest::addColumn<Projection>("projection");
    QTest::newRow("perspective") << Projection::Perspective;
    QTest::newRow("orthographic") << Projection::Orthographic;
}
} // namespace

class TestAreaActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void lasso_cutsThrough_data() { addProjections(); }
    void lasso_cutsThrough()
    {
        QFETCH(Projection, projection);
        constexpr int samples = 300;
        constexpr double radius = 0.4;
        Stage s(projection);
        const auto sample = [&](int i) {
            const double angle = 2 * std::numbers::pi * i / samples;
            return s.at(radius * std::cos(angle), radius * std::sin(angle));
        };
        s.start("area.trim", "areaLasso");
        s.press(sample(0));
        for (int i = 1; i < samples; ++i)
            s.move(sample(i));
        const QImage before = s.window.grab().toImage();
        s.release(sample(samples - 1));
        QVERIFY(s.requested);
        QVERIFY2(outlineOf(*s.requested).size() < samples / 2,
                 qPrintable(QString::number(outlineOf(*s.requested).size())));
        const double left = s.shareLeft();
        if (projection == Projection::Orthographic) {
            // a cylinder through a ball leaves (1 - radius^2)^1.5 of it
            QVERIFY2(std::abs(left - std::pow(1 - radius * radius, 1.5)) < 0.02, qPrintable(QString::number(left)));
        } else {
            QVERIFY2(left > 0.65 && left < 0.85, qPrintable(QString::number(left)));
        }
        // the hole is seen through, and the tint has gone
        const QImage after = s.window.grab().toImage();
        QVERIFY(after.pixelColor(s.viewport->mapTo(&s.window, s.at(0, 0))) !=
                before.pixelColor(s.viewport->mapTo(&s.window, s.at(0, 0))));
    }

    void box_isCutOut()
    {
        Stage s(Projection::Orthographic);
        s.start("area.trim", "areaBox");
        s.drag(s.at(-0.5, 1.2), s.at(1.2, -1.2));
        const double left = s.shareLeft(); // a cap of half the radius has 5/32
        QVERIFY2(std::abs(left - 5.0 / 32) < 0.02, qPrintable(QString::number(left)));
    }

    void line_takesItsRightSide()
    {
        Stage s;
        s.start("area.trim", "areaLine");
        s.drag(s.at(-0.3, 0), s.at(0.4, 0));
        const double left = s.shareLeft();
        QVERIFY2(std::abs(left - 0.5) < 0.02, qPrintable(QString::number(left)));
        for (const core::Slot v : s.mesh->vertices())
            QVERIFY(s.mesh->point(v).y() > -2);
    }

    void polygon_endsWithADoubleClick()
    {
        Stage s;
        s.start("area.trim", "areaPolygon");
        for (const QPoint& corner : {s.at(-1.2, 0), s.at(1.2, 0), s.at(0.1, 0.1)})
            s.click(corner);
        QTest::keyClick(s.viewport, Qt::Key_Backspace);
        s.click(s.at(1.2, 1.2));
        s.click(s.at(-1.2, 1.2));
        QVERIFY(s.drawing()->isActive());
        sendMouse(s.viewport, QEvent::MouseButtonDblClick, s.at(-1.2, 1.2), Qt::LeftButton);
        s.release(s.at(-1.2, 1.2));
        const double left = s.shareLeft();
        QVERIFY2(std::abs(left - 0.5) < 0.02, qPrintable(QString::number(left)));
    }

    void polygon_endsWithReturnAndAtItsFirstCorner()
    {
        Stage s;
        const QPoint corners[] = {s.at(-1.2, 0), s.at(1.2, 0), s.at(1.2, 1.2), s.at(-1.2, 1.2)};
        s.start("area.trim", "areaPolygon");
        for (const QPoint& corner : corners)
            s.click(corner);
        QTest::keyClick(s.viewport, Qt::Key_Return);
        QVERIFY(!s.drawing()->isActive() && s.requested);
        const std::size_t size = outlineOf(*s.requested).size();
        s.requested.reset();
        s.start("area.trim", "areaPolygon");
        for (const QPoint& corner : corners)
            s.click(corner);
        s.click(corners[0] + QPoint(2, 1));
        QVERIFY(!s.drawing()->isActive() && s.requested);
        QCOMPARE(outlineOf(*s.requested).size(), size);
    }

    void shift_takesTheOutside()
    {
        Stage s(Projection::Orthographic);
        s.start("area.trim", "areaBox");
        s.drag(s.at(-0.5, 1.2), s.at(1.2, -1.2), Qt::ShiftModifier);
        const double left = s.shareLeft();
        QVERIFY2(std::abs(left - 27.0 / 32) < 0.02, qPrintable(QString::number(left)));
    }

    void symmetry_isThatOfTheBrush()
    {
        Stage s(Projection::Orthographic);
        s.brush.setSymmetric(true);
        s.start("area.trim", "areaBox");
        s.drag(s.at(0.5, 1.2), s.at(1.2, -1.2));
        const double left = s.shareLeft();
        QVERIFY2(std::abs(left - 22.0 / 32) < 0.03, qPrintable(QString::number(left)));
    }

    /// Each command asks for what its hint says, with the choices of the bar.
    void commands_areAsked()
    {
        Stage s;
        const auto draw = [&](const char* id) {
            s.requested.reset();
            s.start(id, "areaBox");
            s.drag(s.at(-0.5, 0.5), s.at(0.5, -0.5));
            return s.requested.value();
        };
        const auto mask = std::get<core::MaskArea>(draw("area.mask"));
        QVERIFY(!mask.isErasing && mask.area.side == core::ViewArea::Side::Inside && !mask.area.isFrontOnly);
        QVERIFY(std::get<core::MaskArea>(draw("area.unmask")).isErasing);
        QCOMPARE(std::get<core::HideArea>(draw("area.hide")).area.outline.size(), std::size_t(4));
        QTest::mouseClick(s.button("areaOutside"), Qt::LeftButton);
        QTest::mouseClick(s.button("areaFront"), Qt::LeftButton);
        const auto split = std::get<core::SplitPart>(draw("area.split"));
        QVERIFY(split.area.isFrontOnly && split.area.side == core::ViewArea::Side::Outside);
        // Shift means the other side than the bar
        s.start("area.trim", "areaBox");
        s.drag(s.at(-0.5, 0.5), s.at(0.5, -0.5), Qt::ShiftModifier);
        QVERIFY(std::get<core::Trim>(*s.requested).area.side == core::ViewArea::Side::Inside);
        QVERIFY(!s.button("areaBox")->isVisible());
    }

    /// Only a cut can be coloured, and the bar offers it only then.
    void cut_hasThePaintColorIfWished()
    {
        Stage s;
        s.brush.set(&core::StrokeSettings::color, core::Rgb{20, 160, 90});
        const auto trim = [&] {
            s.start("area.trim", "areaBox");
            s.drag(s.at(-0.5, 0.5), s.at(0.5, -0.5));
            return std::get<core::Trim>(s.requested.value());
        };
        QVERIFY(!trim().color);
        s.start("area.trim", "areaBox");
        QTest::keyClick(s.viewport, Qt::Key_P);
        QVERIFY(s.button("areaColor")->isVisible() && s.button("areaColor")->isChecked());
        QVERIFY(trim().color == s.brush.stroke().color);
        s.start("area.split", "areaBox");
        QVERIFY(!s.button("areaColor")->isVisible());
    }

    /// A curve without area says what it lacks; the tool stays ready.
    void curveWithoutArea_saysWhatItLacks()
    {
        Stage s;
        QSignalSpy refused(s.drawing(), &ui::CurveDrawing::refused);
        QSet<QString> sentences;
        const auto note = [&] {
            QVERIFY(s.drawing()->isActive() && !s.requested);
            QVERIFY(!refused.isEmpty());
            sentences << refused.takeLast().front().toString();
            QVERIFY(refused.isEmpty()); // once
        };
        s.start("area.trim", "areaLasso");
        s.click(s.at(0, 0));
        note();
        s.drag(s.at(-0.5, 0), s.at(0.5, 0)); // there are two points only
        note();
        QCOMPARE(sentences.size(), 1);
        s.start("area.trim", "areaBox");
        s.click(s.at(0, 0));
        note();
        s.start("area.trim", "areaLine");
        s.click(s.at(0, 0));
        note();
        s.start("area.trim", "areaPolygon");
        s.click(s.at(0, 0));
        s.click(s.at(0.5, 0));
        QTest::keyClick(s.viewport, Qt::Key_Return);
        note();
        QCOMPARE(sentences.size(), 4);
    }

    /// In a narrow view the bar is below the cube in the corner.
    void bar_leavesTheCubeFree()
    {
        Stage s;
        for (const int width : {900, 380}) {
            s.window.resize(width, 450);
            QTRY_COMPARE(s.viewport->width(), width);
            s.start("area.trim", "areaBox");
            const auto* cube = s.viewport->findChild<ui::NavigationCube*>();
            QVERIFY(cube->isVisible());
            QVERIFY(!s.button("areaBox")->parentWidget()->geometry().intersects(cube->geometry()));
        }
    }

    void keys_chooseInTheBar()
    {
        Stage s;
        s.start("area.hide", "areaLasso");
        const QString hint = s.hint();
        QTest::keyClick(s.viewport, Qt::Key_3);
        QVERIFY(s.button("areaLine")->isChecked() && s.hint() != hint);
        const QString inside = s.hint();
        QTest::keyClick(s.viewport, Qt::Key_O);
        QVERIFY(s.button("areaOutside")->isChecked() && s.hint() != inside);
        QTest::keyPress(s.viewport, Qt::Key_Shift, Qt::ShiftModifier);
        QCOMPARE(s.hint(), inside);
        QTest::keyRelease(s.viewport, Qt::Key_Shift);
        QTest::keyClick(s.viewport, Qt::Key_F);
        QVERIFY(s.button("areaFront")->isChecked() && s.drawing()->isActive());
        // the next command begins with the same shape
        QTest::keyClick(s.viewport, Qt::Key_Escape);
        s.actions.get(QStringLiteral("area.trim"))->trigger();
        QVERIFY(s.button("areaLine")->isChecked());
        s.drag(s.at(-0.3, 0), s.at(0.4, 0));
        QVERIFY(std::holds_alternative<core::Trim>(s.requested.value()));
    }

    void curve_canBeGivenUp()
    {
        Stage s;
        s.start("area.trim", "areaLasso");
        s.press(s.at(-0.3, 0));
        s.move(s.at(0.3, 0.2));
        QTest::keyClick(s.viewport, Qt::Key_Escape);
        QVERIFY(!s.drawing()->isActive() && !s.drawing()->isVisible());
        s.release(s.at(0.3, 0.2));

        s.start("area.trim", "areaPolygon");
        s.click(s.at(0, 0));
        s.click(s.at(0.3, 0));
        QTest::keyClick(s.viewport, Qt::Key_Return); // two corners have no area
        QVERIFY(s.drawing()->isActive());
        s.click(s.at(0.3, 0.3), Qt::RightButton);
        QVERIFY(!s.drawing()->isActive());

        s.start("area.trim", "areaBox");
        s.click(s.at(0, 0)); // a click is no box
        QVERIFY(s.drawing()->isActive());
        s.start("area.trim", "areaLine");
        s.window.resize(500, 400); // the curve would no longer be where it was drawn
        QTRY_VERIFY(!s.drawing()->isActive());
        QVERIFY(!s.requested);
    }

    /// While a curve is awaited, the middle button turns the view; the left one does not sculpt.
    void view_canBeTurnedBefore()
    {
        Stage s;
        const core::Vec3 before = s.viewport->camera().viewDirection();
        s.start("area.trim", "areaLasso");
        s.press({100, 100}, Qt::MiddleButton);
        for (int i = 1; i <= 5; ++i)
            s.move({100 + 20 * i, 100}, {}, Qt::MiddleButton);
        s.release({200, 100}, Qt::MiddleButton);
        QVERIFY((s.viewport->camera().viewDirection() - before).norm() > 0.1);
        QVERIFY(s.drawing()->isActive());
        s.press(s.at(0, 0));
        QVERIFY(!s.viewport->input()->strokeOpen() && !s.viewport->input()->isPressPending());
    }
};

FETTLE_TEST(TestAreaActions, ui::TestApplication)
#include "tst_area_actions.moc"
