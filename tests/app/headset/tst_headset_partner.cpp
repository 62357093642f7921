// Tests two users at one model: one in the headset, one at the desktop.
// FETTLE_HEADSET_PICTURES=<folder> saves the pictures of the left eye and of the window.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include "app/classroom/class_pin.h"
#include "app/classroom/classroom_mode.h"
#include "core/analysis/mesh_check.h"
#include "ui/brush/brush_caption.h"
#include "ui/classroom/pupil_name_panel.h"
#include "ui/headset/partner_bar.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/viewport/pointer_highlight.h"

using namespace app;
using core::Vec3;
using vr::Side;

namespace
{
void sendMove(QWidget* widget, const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton)
{
    QMouseEvent move(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, buttons, {});
    QApplication::sendEvent(widget, &move);
}

bool isOfTheLight(const QColor& color)
{
    return color.green() > 140 && color.green() > color.red() + 25 && color.green() > color.blue() + 50;
}

int differences(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

int countLight(const QImage& picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += isOfTheLight(picture.pixelColor(x, y));
    return count;
}

/// A visit with a second user at the desktop.
struct Pair : Visit
{
    explicit Pair(const QSize& pixels = HeadsetHand::few) : Visit({}, keepsPictures() ? QSize(540, 600) : pixels)
    {
        QObject::connect(viewport().spotlight(), &ui::PointerSpotlight::pointed, &program.window,
                         [this](const auto& where) { place = where; });
    }
    ui::Viewport& viewport() const { return *program.window.viewport(); }
    QAction* action(const char* id) const { return program.window.action(QLatin1StringView(id)); }
    ui::BrushCaption& caption() const { return *program.window.findChild<ui::BrushCaption*>(); }
    ui::PartnerBar& bar() const { return *program.window.findChild<ui::PartnerBar*>(); }

    void pointAt(const QPoint& pixel)
    {
        action("vr.point")->setChecked(true);
        sendMove(&viewport(), pixel);
        QTRY_VERIFY(place);
        hand.frames(3);
    }
    /// Draws a stroke across the model with the mouse.
    void drawAtTheDesktop()
    {
        const int before = changes();
        drag(&viewport(), {20, 10});
        QTRY_COMPARE(changes(), before + 1);
        hand.settle();
    }
    static bool keepsPictures() { return !qEnvironmentVariableIsEmpty("FETTLE_HEADSET_PICTURES"); }
    void keep(const char* name)
    {
        if (!keepsPictures())
            return;
        const QString folder = qEnvironmentVariable("FETTLE_HEADSET_PICTURES");
        if (place)
            sendMove(&viewport(), middle(&viewport()));
        else
            hand.waitForPanels();
        hand.frames(2);
        hand.picture().save(QStringLiteral("%1/%2-eye.png").arg(folder, QLatin1StringView(name)));
        program.window.grab().save(QStringLiteral("%1/%2-window.png").arg(folder, QLatin1StringView(name)));
    }
    bool isSound()
    {
        return core::checkMesh(hand.ask([](core::Sculptor& sculptor) {
                   return core::extractMesh(sculptor.mesh());
               })).boundsSolid == true;
    }

    std::optional<core::SurfaceHit> place; ///< last place pointed at
};

vr::HapticInput tick()
{
    vr::HapticInput feeling;
    feeling.stepped = true;
    return feeling;
}

/// A document port without a headset, which receives the updates of a visit.
struct Listener
{
    Listener() { port = controller.open(); }
    vr::DocumentUpdate update()
    {
        QCoreApplication::processEvents();
        if (auto next = port->takeUpdate())
            last = *next;
        return last;
    }

    HeadsetFixture fixture;
    HeadsetController controller{{&fixture.program.document, &fixture.program.worker, &fixture.program.window}};
    std::shared_ptr<HeadsetPort> port;
    vr::DocumentUpdate last;
};
} // namespace

class TestHeadsetPartner : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pointing_isALightInBoth();
    void pointing_sculptsNothing();
    void pointing_pulsesUnlessCalm_data();
    void pointing_pulsesUnlessCalm();
    void pointing_endsAtRestAndBeside();
    void pointing_byAKeyThatIsHeld();
    void choices_comeToTheHand();
    void choices_areAnnounced();
    void aToolChosenInTheHeadset_leavesTheRadiusThere();
    void takingOver_refusesTheHeadset();
    void takingOver_endsWithTheVisit();
    void takingOver_isTold();
    void caption_tellsTheBrush();
    void caption_isReadFromThreeMetres();
    void lesson_isOnAPanel();
    void classTime_isToldInBoth();
};

/// The pointer of the mouse appears as a green light in the eye's picture, exactly at its place, only while it is on.
void TestHeadsetPartner::pointing_isALightInBoth()
{
    Pair v(HeadsetHand::enough);
    v.hand.put(Side::Right, {0.5, 1.0, -0.1});
    v.hand.put(Side::Left, {-0.5, 1.0, -0.1});
    v.hand.frames(2);
    const QImage before = v.hand.picture();
    QCOMPARE(countLight(before), 0);
    v.pointAt(middle(&v.viewport()) + QPoint(12, -8));
    auto* light = v.program.window.findChild<ui::PointerHighlight*>();
    QTRY_VERIFY(light->isVisible());
    QVERIFY((light->geometry().center() - (middle(&v.viewport()) + QPoint(12, -8))).manhattanLength() < 6);

    const Look look{v.hand.picture(), v.hand.head};
    const Vec3 place = v.model() * v.place->position;
    QPoint nearest;
    int distance = 1000;
    for (int y = 0; y < look.picture.height(); ++y)
        for (int x = 0; x < look.picture.width(); ++x)
            if (isOfTheLight(look.picture.pixelColor(x, y)) &&
                (QPoint(x, y) - look.at(place)).manhattanLength() < distance)
                distance = (QPoint(nearest = {x, y}) - look.at(place)).manhattanLength();
    QVERIFY2(distance <= 2 + look.picture.width() / 100,
             qPrintable(QStringLiteral("%1, of %2 pixels").arg(distance).arg(countLight(look.picture))));
    v.keep("pointing");

    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&v.viewport(), &leave);
    QVERIFY(!v.place);
    v.hand.frames(3);
    QCOMPARE(countLight(v.hand.picture()), 0);
    QTRY_VERIFY(!light->isVisible());
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPartner::pointing_pulsesUnlessCalm_data()
{
    QTest::addColumn<bool>("isCalm");
    QTest::newRow("pulses") << false;
    QTest::newRow("stands still") << true;
}

/// A wave around the light pulses in the eye and in the window, unless motion is reduced.
void TestHeadsetPartner::pointing_pulsesUnlessCalm()
{
    QFETCH(bool, isCalm);
    Pair v(HeadsetHand::enough);
    v.viewport().setReducesMotion(isCalm);
    v.hand.put(Side::Right, {0.5, 1.0, -0.1});
    v.hand.put(Side::Left, {-0.5, 1.0, -0.1});
    v.pointAt(middle(&v.viewport()));
    auto* light = v.program.window.findChild<ui::PointerHighlight*>();
    QSet<int> eye;
    QSet<QByteArray> window;
    const auto bytes = [](const QImage& image) {
        return QByteArray(reinterpret_cast<const char*>(image.constBits()),
                          static_cast<qsizetype>(image.sizeInBytes()));
    };
    for (int i = 0; i < 4; ++i) {
        v.hand.frames(20);
        v.pointAt(middle(&v.viewport())); // keeps moving, because a resting light goes out
        eye.insert(countLight(v.hand.picture()));
        window.insert(bytes(light->grab().toImage()));
    }
    QCOMPARE(eye.size() == 1, isCalm);
    QCOMPARE(window.size() == 1, isCalm);
}

void TestHeadsetPartner::pointing_sculptsNothing()
{
    Pair v;
    v.pointAt(middle(&v.viewport()));
    drag(&v.viewport(), {20, 10});
    v.hand.settle();
    QVERIFY(v.isUntouched() && v.place);
    v.pull(); // the headset's user can sculpt meanwhile
    QCOMPARE(v.changes(), 1);
    QTest::keyClick(&v.viewport(), Qt::Key_Escape);
    QVERIFY(!v.action("vr.point")->isChecked() && !v.viewport().spotlight()->isOn() && !v.place);
    v.drawAtTheDesktop();
    QVERIFY(v.isSound());
    v.action("vr.point")->setChecked(true);
    v.hand.leave();
    QVERIFY(!v.viewport().spotlight()->isOn() && !v.action("vr.point")->isEnabled());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPartner::pointing_endsAtRestAndBeside()
{
    Pair v;
    v.pointAt(middle(&v.viewport()));
    sendMove(&v.viewport(), {2, 2});
    QTRY_VERIFY(!v.place);
    v.pointAt(middle(&v.viewport()));
    QVERIFY(v.viewport().spotlight()->isOn());
    QTRY_VERIFY(!v.place); // the light goes out without motion
    QVERIFY(v.viewport().spotlight()->isOn());
    sendMove(&v.viewport(), middle(&v.viewport()) + QPoint(3, 0));
    QTRY_VERIFY(v.place);
}

/// The light key toggles the light when pressed briefly, and shows it only while held otherwise.
void TestHeadsetPartner::pointing_byAKeyThatIsHeld()
{
    Pair v;
    v.viewport().setFocus();
    QTest::keyClick(&v.viewport(), Qt::Key_Q);
    QVERIFY(v.viewport().spotlight()->isOn());
    QTest::keyClick(&v.viewport(), Qt::Key_Q);
    QVERIFY(!v.viewport().spotlight()->isOn());
    QTest::keyPress(&v.viewport(), Qt::Key_Q);
    QVERIFY(v.viewport().spotlight()->isOn());
    QTest::qWait(500);
    QTest::keyRelease(&v.viewport(), Qt::Key_Q);
    QVERIFY(!v.viewport().spotlight()->isOn() && !v.action("vr.point")->isChecked());
}

/// A radius in mm chosen at the desktop has that size on the displayed model. A change of the radius in the headset
/// stays local.
void TestHeadsetPartner::choices_comeToTheHand()
{
    Pair v;
    const double own = v.hand.seen().radius;
    QVERIFY(own > 0);
    v.trigger("tool.push");
    v.program.window.brush()->setValue(core::Parameter::Radius, 9);
    v.hand.frames(3);
    QVERIFY(std::abs(v.hand.seen().radius - 9 * v.scale()) < 1e-6);
    QVERIFY(pulsesOf(v.hand, Side::Right, tick()) > 0);
    v.hand.stroke({0, 51, 0}, {0, 46, 0}, 8);
    QVERIFY(v.box().max().y() < 49.9);
    v.trigger("edit.undo");
    v.hand.settle();
    QVERIFY(v.isUntouched());
    v.trigger("edit.redo");
    v.hand.settle();
    QCOMPARE(v.changes(), 1);

    v.hand.slide(Side::Right, {0.8, 0});
    const double slid = v.hand.seen().radius;
    v.trigger("tool.pull");
    v.hand.frames(3);
    QCOMPARE(v.hand.seen().radius, slid);
    QVERIFY(v.isSound());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPartner::choices_areAnnounced()
{
    Listener listener;
    QVERIFY(listener.update().notice.isEmpty());
    HeadsetFixture& fixture = listener.fixture;
    fixture.trigger("tool.clay");
    fixture.program.window.brush()->setValue(core::Parameter::Radius, 12);
    QTRY_COMPARE(listener.update().notice, QStringLiteral("Your partner chose Clay, 12 mm."));
    QCOMPARE(listener.last.radiusChange, 1U);
    fixture.program.window.brush()->setValue(core::Parameter::Strength, 0.8);
    QTRY_COMPARE(listener.update().notice, QStringLiteral("Your partner chose a strength of 80 %."));

    core::StrokeSettings paint = listener.last.brush;
    paint.tool = core::Tool::Paint;
    const quint64 notices = listener.last.noticeCount;
    listener.port->request(vr::ChooseBrush{paint});
    QTRY_COMPARE(listener.update().brush.tool, core::Tool::Paint);
    QTest::qWait(700);
    QCOMPARE(listener.update().noticeCount, notices); // a user's own choices are not announced to that user

    drag(fixture.program.window.viewport(), {30, 10});
    QTRY_COMPARE(fixture.changes(), 1);
    fixture.trigger("edit.undo");
    QTRY_COMPARE(listener.update().notice, QStringLiteral("Your partner undid: Paint."));
    fixture.trigger("edit.redo");
    QTRY_COMPARE(listener.update().notice, QStringLiteral("Your partner redid: Paint."));
}

/// Choosing a tool in the headset keeps its own radius, whatever radius the window has for the tool.
void TestHeadsetPartner::aToolChosenInTheHeadset_leavesTheRadiusThere()
{
    Listener listener;
    ui::BrushSettings& brush = *listener.fixture.program.window.brush();
    brush.tools()->setSharesRadius(false);
    brush.setTool(core::Tool::Paint);
    brush.scaleRadius(0.5);
    brush.setTool(core::Tool::Pull);
    QTRY_COMPARE(listener.update().brush.tool, core::Tool::Pull);
    QTest::qWait(200);
    core::StrokeSettings paint = listener.update().brush;
    const quint64 radiusChange = listener.last.radiusChange;
    const double radius = brush.stroke().radius;
    paint.tool = core::Tool::Paint;
    listener.port->request(vr::ChooseBrush{paint});
    QTRY_COMPARE(listener.update().brush.tool, core::Tool::Paint);
    QTest::qWait(200);
    QVERIFY(brush.stroke().radius < radius);
    QCOMPARE(listener.update().radiusChange, radiusChange);
}

void TestHeadsetPartner::takingOver_refusesTheHeadset()
{
    Pair v;
    v.pull();
    v.hand.begin({0, -49, 0}, {0, -54, 0}, 6); // begins a stroke whose trigger stays pulled
    v.action("vr.takeOver")->setChecked(true);
    QCOMPARE(v.action("vr.takeOver")->iconText(), QStringLiteral("Give Back"));
    QTRY_COMPARE(v.changes(), 2); // the open stroke is kept up to this point
    const std::uint64_t kept = v.hash();
    v.hand.begin({0, -54, 0}, {0, -70, 0}, 6);
    v.hand.end();
    v.hand.settle();
    v.pull();
    QCOMPARE(v.hash(), kept);
    QVERIFY(pulsesOf(v.hand, Side::Right, {.refused = true}) > 0);
    v.keep("refused");
    v.hand.pressPad(Side::Right, -0.8, 0); // presses Undo, which is refused, too
    v.hand.settle();
    QCOMPARE(v.hash(), kept);
    QCOMPARE(v.changes(), 2);
    v.keep("taken-over");

    v.drawAtTheDesktop();
    QCOMPARE(v.changes(), 3);
    v.action("vr.takeOver")->setChecked(false);
    v.hand.settle();
    v.pull();
    QCOMPARE(v.changes(), 4);
    QVERIFY(v.isSound());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPartner::takingOver_endsWithTheVisit()
{
    Pair v;
    QVERIFY(v.action("vr.takeOver")->isEnabled());
    v.action("vr.takeOver")->setChecked(true);
    v.hand.leave();
    QVERIFY(!v.action("vr.takeOver")->isChecked() && !v.action("vr.takeOver")->isEnabled());
    v.hand.enter();
    v.pull();
    QCOMPARE(v.changes(), 1);
}

void TestHeadsetPartner::takingOver_isTold()
{
    Listener listener;
    listener.controller.partner().setTakenOver(true);
    QCOMPARE(listener.update().notice, QStringLiteral("Your partner is sculpting now."));
    const quint64 first = listener.last.noticeCount;
    QVERIFY(!listener.port->beginStroke({}));
    listener.port->show({});
    QTRY_VERIFY(listener.update().noticeCount > first);
    const quint64 brush = listener.last.brushChange;
    core::StrokeSettings paint = listener.last.brush;
    paint.tool = core::Tool::Paint;
    listener.port->request(vr::ChooseBrush{paint});
    QTRY_VERIFY(listener.update().brushChange > brush); // the headset is told the actual brush
    QVERIFY(listener.last.brush.tool != core::Tool::Paint);
    listener.controller.partner().setTakenOver(false);
    QCOMPARE(listener.update().notice, QStringLiteral("It is your turn again."));
    QVERIFY(listener.port->beginStroke({}));
    listener.port->endStroke();
}

void TestHeadsetPartner::caption_tellsTheBrush()
{
    Pair v;
    QVERIFY(v.bar().isVisible() && v.caption().isVisible());
    const double mm = v.hand.seen().radius / v.scale();
    QCOMPARE(v.caption().text().tool, QStringLiteral("Pull"));
    QVERIFY(v.caption().text().radius.startsWith(QString::number(static_cast<int>(mm))));
    QVERIFY(v.caption().text().time.isEmpty());
    v.trigger("tool.crease");
    v.program.window.brush()->setValue(core::Parameter::Radius, 12);
    v.hand.frames(3);
    QCOMPARE(v.caption().text().tool, QStringLiteral("Crease"));
    QTRY_COMPARE(v.caption().text().radius, QStringLiteral("12 mm"));
    v.hand.slide(Side::Right, {0.8, 0});
    // the caption shows the radius as changed in the headset
    QTRY_VERIFY(v.caption().text().radius != QStringLiteral("12 mm"));
    v.keep("caption");
    v.trigger("view.caption");
    QTRY_VERIFY(!v.caption().isVisible() && v.bar().isVisible());
    v.trigger("view.caption");
    QTRY_VERIFY(v.caption().isVisible());
    v.hand.leave();
    QVERIFY(!v.bar().isVisible());
    v.bar().setVisible(true); // as if a saved window state showed the bar
    QVERIFY(!v.bar().isVisible());
}

/// Letters are 14 mm high on a screen of 96 dpi and grow with the text size. A narrow caption wraps instead of
/// clipping.
void TestHeadsetPartner::caption_isReadFromThreeMetres()
{
    ui::BrushCaption caption;
    caption.setText({QIcon(), QStringLiteral("Clay"), QStringLiteral("12 mm"), QStringLiteral("3 min"), true});
    caption.resize(1500, 10);
    caption.show();
    QVERIFY(QTest::qWaitForWindowExposed(&caption));
    const auto inked = [&caption] {
        const QImage picture = caption.grab().toImage();
        int top = picture.height(), bottom = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width() / 2; ++x)
                if (picture.pixelColor(x, y) != picture.pixelColor(0, 0))
                    top = std::min(top, y), bottom = std::max(bottom, y);
        return bottom - top;
    };
    const double usual = caption.font().pointSizeF();
    const int tall = caption.height();
    QVERIFY2(inked() >= 14 / 25.4 * 96 * usual / 10, qPrintable(QStringLiteral("%1 of %2 pt").arg(inked()).arg(usual)));
    QFont large = caption.font();
    large.setPointSizeF(1.5 * usual);
    caption.setFont(large);
    QTRY_VERIFY(caption.height() > 1.4 * tall);
    caption.resize(300, caption.height());
    QTRY_VERIFY(caption.height() < tall);
    QVERIFY(caption.sizeHint().width() < 500);
}

/// The class time is announced in front of the clay and in the window.
void TestHeadsetPartner::classTime_isToldInBoth()
{
    constexpr qint64 minute = 60'000;
    const QTemporaryDir home;
    HeadsetFixture fixture({}, {270, 300});
    RecoveryStore store(home.filePath(QStringLiteral("journals")).toStdString());
    qint64 now = 0;
    const ui::Classroom classroom{QStringLiteral("5b"),
                                  home.path(),
                                  {core::Starter::Ball},
                                  {core::Tool::Pull},
                                  20,
                                  3,
                                  false,
                                  ui::Language::System,
                                  pinRecord(QStringLiteral("2468"))};
    const ClassPaths places{home.filePath(QStringLiteral("journals")).toStdString(),
                            home.filePath(QStringLiteral("waiting")), home.filePath(QStringLiteral("turn.json"))};
    ClassroomMode mode({&fixture.program.window, &fixture.program.document, &store}, classroom, places,
                       [&now] { return now; });
    connectClassroom(fixture.program.window, mode);
    mode.begin();
    auto* panel = fixture.program.window.findChild<ui::PupilNamePanel*>();
    const auto rests = [&] {
        return fixture.program.document.queue().isSettled() && !fixture.program.document.job().isBusy();
    };
    QTRY_VERIFY(panel->isVisible() && rests());
    auto* name = fixture.program.window.findChild<QLineEdit*>(QStringLiteral("pupilName"));
    QTest::keyClicks(name, QStringLiteral("Anna"));
    QTest::keyClick(name, Qt::Key_Return);
    QTRY_VERIFY(!panel->isVisible() && rests());
    fixture.hand.enter();
    fixture.hand.frames(5);
    const QImage before = fixture.hand.picture();
    fixture.hand.frames(5);
    const int still = differences(before, fixture.hand.picture());
    now = 17 * minute;
    mode.tick();
    QVERIFY(notice(fixture.program).contains(QStringLiteral("3 minutes left")));
    fixture.hand.waitForPanels();
    fixture.hand.frames(20);
    const int told = differences(before, fixture.hand.picture());
    QCOMPARE(still, 0);
    QVERIFY2(told > 300, qPrintable(QString::number(told)));
}

void TestHeadsetPartner::lesson_isOnAPanel()
{
    Pair v(HeadsetHand::enough);
    v.trigger("help.lessons");
    auto* panel = v.program.window.findChild<ui::LessonPanel*>();
    Q_EMIT panel->lessonChosen(QStringLiteral("first-clay"));
    QTRY_VERIFY(panel->shown());
    v.hand.settle();
    v.hand.placeModelAgain();
    v.hand.waitForPanels();
    const auto content = [&] {
        const ui::LessonPanelState& shown = *panel->shown();
        vr::LessonPanel lesson{shown.page.lesson,  shown.page.title, shown.page.text,
                               shown.page.step,    shown.page.steps, {},
                               shown.page.isShown, shown.isPlaying};
        for (const ui::LessonMark& mark : shown.marks)
            lesson.marks.append({mark.text, mark.holds});
        return lesson;
    };
    QTRY_VERIFY(!panel->shown()->marks.isEmpty());
    v.keep("lesson");
    QVERIFY(v.hand.choose(content(), vr::LessonRequest::Next, [&] { return panel->shown()->page.step == 1; }));
    QVERIFY(v.hand.choose(content(), vr::LessonRequest::Back, [&] { return panel->shown()->page.step == 0; }));
    QVERIFY(v.hand.choose(content(), vr::LessonRequest::Play, [&] { return panel->shown()->isPlaying; }));
    const auto frameUntil = [&](const auto& isSo) {
        for (int i = 0; i < 2000 && !isSo(); ++i) {
            v.hand.frame();
            QTest::qWait(5);
        }
        return isSo();
    };
    QVERIFY(frameUntil(
        [&] { return v.program.document.history().stack().index() > 0 || !v.program.document.queue().isSettled(); }));
    if (v.keepsPictures())
        v.hand.picture().save(qEnvironmentVariable("FETTLE_HEADSET_PICTURES") + QStringLiteral("/teacher-eye.png"));
    v.keep("lesson-playing");
    QVERIFY(frameUntil([&] { return !panel->shown()->isPlaying; }));
    v.hand.settle();
    QVERIFY(v.changes() > 0);
    v.keep("lesson-shown");
    QVERIFY(v.hand.choose(content(), vr::LessonRequest::TryIt, [&] { return v.changes() == 0; }));
    QVERIFY(v.isSound());
    panel->closed();
    v.hand.settle();
    QVERIFY(!panel->shown());
    v.keep("lesson-left");
    QCOMPARE(v.hand.headset().complaints(), QString());
}

FETTLE_TEST(TestHeadsetPartner, app::OnScreen)
#include "tst_headset_partner.moc"
