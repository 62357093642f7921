// Tests entering and leaving VR, two users at one document, and faults of a headset, against the scripted runtime with
// Khronos' validation layer.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/effort.h"
#include "tests/support/other_windows_x11.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include "core/analysis/mesh_check.h"

#include <QAction>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QThread>

using namespace app;
using core::Vec3;
using vr::Side;

namespace
{
constexpr core::Rgb red{230, 20, 20};

/// Returns whether a pixel shows painted clay.
bool isRed(const QColor& color)
{
    return color.red() > 60 && color.red() > 2 * color.green() && color.red() > 2 * color.blue();
}

/// Returns the number of red pixels in the middle of a picture.
int redPixels(const QImage& picture)
{
    int count = 0;
    for (int y = picture.height() / 4; y < 3 * picture.height() / 4; ++y)
        for (int x = picture.width() / 4; x < 3 * picture.width() / 4; ++x)
            count += isRed(picture.pixelColor(x, y));
    return count;
}

/// Paints across the middle of the view at the desktop.
void paintRed(HeadsetFixture& fixture)
{
    ui::BrushSettings& brush = *fixture.program.window.brush();
    brush.setTool(core::Tool::Paint);
    brush.set(&core::StrokeSettings::color, red);
    brush.setValue(core::Parameter::Radius, 40);
    drag(fixture.program.window.viewport(), {40, 0});
    QTRY_COMPARE(fixture.changes(), 1);
}

/// Returns the first picture of a visit, or a null image.
QImage firstPicture(HeadsetHand& hand, int session)
{
    for (int frame = 0; frame < 8; ++frame)
        if (const QImage picture = hand.headset().picture(session, frame, "left"); !picture.isNull())
            return picture;
    return {};
}

/// Returns the headset's message: from the status bar during a visit, otherwise from the banner.
QString sentence(const Program& program)
{
    const auto* text = program.window.findChild<QLabel*>(QStringLiteral("headsetText"));
    return text->isVisible() ? text->text() : notice(program);
}

/// Returns whether the window shows this text eventually. Frames continue meanwhile, if there are any.
bool says(HeadsetFixture& fixture, const QString& words)
{
    const auto isSaid = [&] {
        if (fixture.hand.isIn())
            fixture.hand.frame();
        return sentence(fixture.program).contains(words);
    };
    return QTest::qWaitFor(isSaid, longestWait);
}

const vr::HapticInput refusal{.refused = true}, contact{.touches = true}, fusion{.fused = true};
} // namespace

class TestHeadsetVisits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }
    void cleanupTestCase() { qInfo("%s", qPrintable(s_table.join(QLatin1Char('\n')))); }

    void repeatedVisits();
    void repeatedVisits_midStroke();
    void firstFrame_holdsTheModel();
    void eyes_seeTheModelApart();
    void depth_isTheModels();

    void partner_changesAndUndoes();
    void partner_seesGhostsAndFollows();
    void partner_opensAnotherModel();
    void undo_fromBothSides();
    void undo_whileTheWindowIsStalled();
    void strokes_areOneAtATime();
    void contactAndFusion_feelDifferent();

    void faults_beforeAVisit_data();
    void faults_beforeAVisit();
    void faults_thatEndIt_data();
    void faults_thatEndIt();
    void faults_thatItOutlives_data();
    void faults_thatItOutlives();
    void framesThatComeLate();
    void recentredByTheRuntime();
    void noFloor();
    void oneView();

    void frozen_isGivenUp();
    void frozen_beforeAVisit();

    void program_endsDuringAVisit();
    void program_endsThoughAllIsFrozen();
    void process_endsThoughAllIsFrozen();

private:
    static void keep(const char* fault, const HeadsetFixture& fixture, const char* kept);
    static inline QStringList s_table; ///< rows of Markdown: fault, message at the desktop, what is kept
};

void TestHeadsetVisits::keep(const char* fault, const HeadsetFixture& fixture, const char* kept)
{
    s_table << QStringLiteral("| %1 | %2 | %3 |")
                   .arg(QLatin1StringView(fault), sentence(fixture.program), QLatin1StringView(kept));
}

/// Changes made at the desktop and in the headset are kept across all visits, and each is one step.
void TestHeadsetVisits::repeatedVisits()
{
    HeadsetFixture fixture;
    const int visits = byEffort(3, 10);
    std::vector<std::uint64_t> hashes{fixture.startHash};
    const auto changed = [&] {
        fixture.hand.settle();
        hashes.push_back(fixture.hash());
        return hashes.back() != hashes[hashes.size() - 2] && fixture.changes() == static_cast<int>(hashes.size()) - 1;
    };
    for (int i = 0; i < visits; ++i) {
        drag(fixture.program.window.viewport(), {10 + 3 * i, 2 * i});
        QVERIFY(changed());
        fixture.hand.enter();
        QVERIFY(says(fixture, QStringLiteral("In VR with")));
        fixture.hand.stroke({0, 49, 0}, {0, 51.0 + i, 0}, 4);
        QVERIFY(changed());
        fixture.hand.leave();
        QCOMPARE(sentence(fixture.program), QStringLiteral("Left VR."));
    }
    for (std::size_t i = hashes.size() - 1; i-- > 0;) {
        fixture.trigger("edit.undo");
        fixture.hand.settle();
        QCOMPARE(fixture.hash(), hashes[i]);
    }
    QVERIFY(fixture.isUntouched());
    QCOMPARE(fixture.hand.headset().report()["sessions"].toInt(), visits);
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

/// A stroke in progress is kept when the visit ends.
void TestHeadsetVisits::repeatedVisits_midStroke()
{
    HeadsetFixture fixture;
    for (int i = 1; i <= 3; ++i) {
        fixture.hand.enter();
        fixture.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
        fixture.hand.leave();
        fixture.hand.end();
        fixture.hand.settle();
        QCOMPARE(fixture.changes(), i);
    }
    for (int i = 0; i < 3; ++i)
        fixture.trigger("edit.undo");
    fixture.hand.settle();
    QVERIFY(fixture.isUntouched());
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

/// The first frame must show the model as it is at the desktop now, not as in the file or in the previous visit.
void TestHeadsetVisits::firstFrame_holdsTheModel()
{
    HeadsetFixture fixture({}, HeadsetHand::enough);
    fixture.hand.headset().step("{'keep': [0, 1, 2, 3, 4, 5]}");
    fixture.hand.drawAllFrames();
    fixture.hand.enter();
    const QImage plain = firstPicture(fixture.hand, 0);
    QVERIFY(!plain.isNull());
    QCOMPARE(redPixels(plain), 0);
    fixture.hand.leave();

    paintRed(fixture);
    fixture.hand.headset().step("{'keep': [0, 1, 2, 3, 4, 5]}");
    fixture.hand.enter();
    const QImage painted = firstPicture(fixture.hand, 1);
    const int seen = redPixels(painted);
    QVERIFY2(seen > 300, qPrintable(QString::number(seen)));
    const int later = redPixels(fixture.hand.picture());
    QVERIFY2(std::abs(later - seen) < seen / 5, qPrintable(QStringLiteral("%1 %2").arg(seen).arg(later)));
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

/// Tests the depth image that the runtime receives with the picture: the front and sides of the ball, and empty space.
void TestHeadsetVisits::depth_isTheModels()
{
    Alone v({}, HeadsetHand::enough);
    v.hand.put(Side::Left, {-1, 0.5, 0.5});
    v.hand.put(Side::Right, {1, 0.5, 0.5});
    v.hand.frames(2);
    const Look depth{v.hand.picture("left_depth"), v.hand.head};
    QVERIFY(!depth.picture.isNull());
    const core::Vec3 eye = v.hand.head.position + core::Vec3(-0.032, 0, 0);
    for (const core::Vec3& place : {core::Vec3(0, 0, 50), core::Vec3(-30, 0, 40), core::Vec3(0, 30, 40)}) {
        const core::Vec3 point = v.hand.place(place);
        const double seen = distanceAt(depth.picture, depth.at(point)), wanted = eye.z() - point.z();
        QVERIFY2(std::abs(seen - wanted) < 0.01, qPrintable(QStringLiteral("%1 %2").arg(seen).arg(wanted)));
    }
    QVERIFY(distanceAt(depth.picture, depth.at(v.hand.place({0, 60, 0}))) > 50);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::eyes_seeTheModelApart()
{
    HeadsetFixture fixture({}, HeadsetHand::enough);
    paintRed(fixture);
    fixture.hand.enter();
    const auto middleOfRed = [&](const char* eye) {
        const QImage picture = fixture.hand.picture(eye);
        double sum = 0, count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (isRed(picture.pixelColor(x, y))) {
                    sum += x;
                    ++count;
                }
        return count > 300 ? sum / count : -1e3;
    };
    const double apart = middleOfRed("left") - middleOfRed("right");
    const auto expected = [](double metres) {
        const double outwards = std::tan(0.94), inwards = std::tan(0.81), between = 0.064;
        return HeadsetHand::enough.width() * (between / metres + outwards - inwards) / (outwards + inwards);
    };
    QVERIFY2(apart > expected(0.6) - 1 && apart < expected(0.35) + 1, qPrintable(QString::number(apart)));
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::partner_changesAndUndoes()
{
    Alone v;
    v.pull();
    v.trigger("edit.undo");
    v.hand.settle();
    QVERIFY(v.isUntouched());
    v.program.window.brush()->setTool(core::Tool::Push); // the headset has the same tool
    v.hand.settle();
    v.hand.stroke({0, 51, 0}, {0, 46, 0}, 8);
    QVERIFY(v.box().max().y() < 49.9);
    v.program.window.brush()->setTool(core::Tool::Pull);
    const ui::OrbitCamera::Pose before = v.program.window.viewport()->camera().pose();
    ui::Viewport* viewport = v.program.window.viewport();
    const QPoint from = middle(viewport), to = from + QPoint(40, 0);
    QTest::mousePress(viewport, Qt::MiddleButton, {}, from);
    sendMouse(viewport, QEvent::MouseMove, to, Qt::MiddleButton);
    QTest::mouseRelease(viewport, Qt::MiddleButton, {}, to);
    v.hand.frames(2);
    QVERIFY(std::abs(viewport->camera().pose().yaw - before.yaw) > 0.05);
    v.hand.stroke({0, -49, 0}, {0, -54, 0}, 8);
    QCOMPARE(v.changes(), 2);
    QVERIFY(v.box().min().y() < -51);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::partner_seesGhostsAndFollows()
{
    HeadsetFixture fixture;
    ui::Viewport& viewport = *fixture.program.window.viewport();
    const auto lookFromTheFront = [&] {
        viewport.navigation()->turnTo(ui::OrbitCamera::Side::Front);
        viewport.navigation()->frame();
        fixture.hand.settle();
        return viewport.grabFramebuffer();
    };
    const QImage alone = lookFromTheFront();
    fixture.hand.enter();
    fixture.hand.put(Side::Right, fixture.hand.place({60, 20, 50}));
    QVERIFY(lookFromTheFront() != alone);
    fixture.hand.leave();
    fixture.hand.settle();
    QCOMPARE(viewport.grabFramebuffer(), alone);

    fixture.hand.enter();
    fixture.trigger("vr.follow");
    QVERIFY(viewport.navigation()->isFollowing());
    const auto isFollowed = [&] {
        fixture.hand.frame();
        return viewport.camera().pose().distance < 200 || viewport.camera().pose().pitch > 0.1;
    };
    QTRY_VERIFY(isFollowed());
    fixture.hand.leave();
    QVERIFY(!viewport.navigation()->isFollowing());
    QCOMPARE(lookFromTheFront(), alone);
    QCOMPARE(fixture.changes(), 0);
    QVERIFY(fixture.isUntouched());
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::partner_opensAnotherModel()
{
    Alone v;
    core::TriangleMesh other = core::icosphere(3, 20);
    core::writeMesh(v.path("other.glb").toStdU16String(), other);
    const double before = v.scale();
    Q_EMIT v.program.window.files()->openRequested(v.path("other.glb"));
    QTRY_COMPARE(v.program.document.modelInfo().path, v.path("other.glb"));
    v.hand.settle();
    QVERIFY(std::abs(v.scale() / before - 2.5) < 0.05); // scaled to the same size in the room as the first model
    v.hand.placeModelAgain();
    v.hand.stroke({0, 19.6, 0}, {0, 22, 0}, 8);
    QCOMPARE(v.changes(), 1);
    QVERIFY(v.box().max().y() > 20.1);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::undo_fromBothSides()
{
    Visit v;
    std::vector<std::uint64_t> hashes{v.startHash};
    for (const Vec3& out : {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0)}) {
        v.hand.stroke(49 * out, 54 * out, 8);
        hashes.push_back(v.hash());
    }
    const auto undoAtTheWand = [&] { v.hand.pressPad(Side::Right, -0.8, 0); };
    const auto redoAtTheWand = [&] { v.hand.pressPad(Side::Right, 0.8, 0); };
    undoAtTheWand();
    v.trigger("edit.undo");
    undoAtTheWand();
    v.hand.settle();
    QCOMPARE(v.hash(), hashes[1]);
    v.trigger("edit.redo");
    redoAtTheWand();
    v.hand.settle();
    QCOMPARE(v.hash(), hashes[3]);
    v.trigger("edit.undo");
    v.hand.stroke({0, -49, 0}, {0, -54, 0}, 8);
    QCOMPARE(v.changes(), 3);
    QVERIFY(!v.program.document.history().canRedo());
    undoAtTheWand();
    v.hand.settle();
    QCOMPARE(v.hash(), hashes[2]);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Tests stroke, undo, stroke while the window processes no events.
void TestHeadsetVisits::undo_whileTheWindowIsStalled()
{
    const auto second = [](Visit& v) {
        v.hand.begin({49, 0, 0}, {54, 0, 0}, 8);
        v.hand.end();
    };
    Alone v;
    second(v);
    v.hand.settle();
    const std::uint64_t expected = v.hash();
    v.trigger("edit.undo");
    v.hand.settle();

    v.hand.setStalled(true);
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    v.hand.end();
    v.hand.pressPad(Side::Right, -0.8, 0);
    QThread::msleep(300);
    second(v);
    v.hand.setStalled(false);
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.program.document.history().stack().count(), 1);
    QCOMPARE(v.hash(), expected);
    v.trigger("edit.undo");
    v.hand.settle();
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::strokes_areOneAtATime()
{
    Alone v;
    ui::Viewport* viewport = v.program.window.viewport();
    QTest::mousePress(viewport, Qt::LeftButton, {}, middle(viewport));
    QTRY_VERIFY((v.hand.frame(), viewport->input()->strokeOpen()));
    sendMouse(viewport, QEvent::MouseMove, middle(viewport) + QPoint(8, 0), Qt::LeftButton);
    v.hand.frame();
    const int before = pulsesOf(v.hand, Side::Right, refusal);
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    QCOMPARE(pulsesOf(v.hand, Side::Right, refusal), before + 1);
    QVERIFY(v.box().max().y() < 50.1);
    v.hand.end();
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, middle(viewport) + QPoint(8, 0));
    v.hand.settle();
    QCOMPARE(v.changes(), 1);

    const std::uint64_t hash = v.hash();
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    drag(viewport, {40, 0});
    QVERIFY2(!notice(v.program).isEmpty(), qPrintable(sentence(v.program)));
    v.hand.end();
    v.hand.settle();
    QCOMPARE(v.changes(), 2);
    QCOMPARE(v.program.document.history().stack().count(), 2);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.settle();
    QCOMPARE(v.hash(), hash);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::contactAndFusion_feelDifferent()
{
    Alone v;
    v.hand.hover({0, 70, 0});
    const int touched = pulsesOf(v.hand, Side::Right, contact);
    v.hand.hover({0, 52, 0});
    v.hand.frames(2);
    QCOMPARE(pulsesOf(v.hand, Side::Right, contact), touched + 1);
    QCOMPARE(v.changes(), 0);

    v.hand.stroke({0, 63, 0}, {0, 63, 0}, 1); // adds a ball
    QCOMPARE(v.hand.ask([](core::Sculptor& sculptor) {
        return core::checkMesh(core::extractMesh(sculptor.mesh())).components;
    }),
             2);
    QCOMPARE(pulsesOf(v.hand, Side::Right, fusion), 0);
    v.hand.stroke({0, 57.5, 0}, {0, 48, 0}, 40);
    QCOMPARE(v.hand.ask([](core::Sculptor& sculptor) {
        return core::checkMesh(core::extractMesh(sculptor.mesh())).components;
    }),
             1);
    QVERIFY(pulsesOf(v.hand, Side::Right, fusion) > 0);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::faults_beforeAVisit_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("repaired");
    QTest::addColumn<QString>("words");
    QTest::newRow("no runtime") << "'runtime': false"
                                << "'runtime': true"
                                << "No OpenXR runtime answers";
    QTest::newRow("no headset") << "'headset': false"
                                << "'headset': true"
                                << "no headset is ready";
    QTest::newRow("a runtime without OpenGL") << "'opengl': false"
                                              << "'opengl': true"
                                              << "OpenGL";
}

/// The validation layer is switched off, because it would replace this fault by an answer of its own.
void TestHeadsetVisits::faults_beforeAVisit()
{
    QFETCH(QString, step);
    QFETCH(QString, repaired);
    QFETCH(QString, words);
    HeadsetFixture fixture;
    {
        const auto layer = fixture.hand.headset().withoutLayer();
        fixture.hand.headset().step(qPrintable("{" + step + "}"));
        fixture.trigger("vr.enter");
        QVERIFY(says(fixture, words));
        keep(QTest::currentDataTag(), fixture, "everything; VR was not begun");
        QVERIFY(!fixture.program.window.findChild<Headset*>()->isActive());
        QVERIFY(fixture.isUntouched());
    }
    fixture.hand.headset().step(qPrintable("{" + repaired + "}"));
    fixture.hand.enter();
    fixture.hand.stroke({0, 49, 0}, {0, 54, 0}, 8);
    QCOMPARE(fixture.changes(), 1);
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::faults_thatEndIt_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("words");
    QTest::newRow("the runtime dies") << "'lose_instance': 0"
                                      << "The headset's program has stopped.";
    QTest::newRow("the runtime will die") << "'lose_instance': 5"
                                          << "The headset's program has stopped.";
    QTest::newRow("the session is lost") << "'lose_session': 0"
                                         << "The headset is gone.";
    QTest::newRow("the session will be lost") << "'lose_session': 5"
                                              << "The headset is gone.";
    QTest::newRow("the runtime ends the visit") << "'exit': true"
                                                << "VR was ended in the headset's own program.";
    QTest::newRow("a call fails") << "'fail': {'call': 'xrEndFrame', 'result': 'XR_ERROR_RUNTIME_FAILURE'}"
                                  << "xrEndFrame";
}

/// Each fault occurs during a stroke. The stroke so far is kept and can be undone.
void TestHeadsetVisits::faults_thatEndIt()
{
    QFETCH(QString, step);
    QFETCH(QString, words);
    Visit v;
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    v.hand.headset().step(qPrintable("{" + step + "}"));
    v.hand.waitUntilOut();
    QVERIFY2(sentence(v.program).contains(words), qPrintable(sentence(v.program)));
    keep(QTest::currentDataTag(), v, "the stroke as far as it came; it can be undone");
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    const core::Box box = v.box();
    QVERIFY(box.max().y() > 51);
    v.trigger("edit.undo");
    v.hand.settle();
    QVERIFY(v.isUntouched());

    v.hand.set(Side::Right, "trigger", 0);
    v.hand.enter();
    QVERIFY(says(v, QStringLiteral("In VR with")));
    v.pull();
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::faults_thatItOutlives_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("back");
    QTest::newRow("the focus is lost") << "'focus': false"
                                       << "The headset's own menu is open"
                                       << "'focus': true";
    QTest::newRow("another program is shown") << "'visible': false"
                                              << "the headset shows another program"
                                              << "'visible': true";
    QTest::newRow("the headset is taken off") << "'worn': false"
                                              << "The headset is not worn."
                                              << "'worn': true";
    QTest::newRow("the wand is lost") << "'right': {'tracked': false}"
                                      << "In VR with"
                                      << "'right': {'tracked': true}";
    QTest::newRow("the wand is switched off") << "'right': {'on': false}"
                                              << "In VR with"
                                              << "'right': {'on': true}";
    QTest::newRow("the head is lost") << "'head': {'tracked': false}"
                                      << "In VR with"
                                      << "'head': {'tracked': true}";
}

/// Each fault occurs during a stroke. A trigger still pulled afterwards has no effect.
void TestHeadsetVisits::faults_thatItOutlives()
{
    QFETCH(QString, step);
    QFETCH(QString, words);
    QFETCH(QString, back);
    const bool endsStroke = QLatin1StringView(QTest::currentDataTag()) != QLatin1StringView("the head is lost");
    Alone v;
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    v.hand.headset().step(qPrintable("{" + step + "}"));
    for (int i = 0; i < 12 && v.hand.isIn(); ++i)
        v.hand.frame();
    QVERIFY2(says(v, words), qPrintable(sentence(v.program)));
    keep(QTest::currentDataTag(), v, endsStroke ? "the stroke as far as it came; VR goes on" : "the stroke goes on");
    if (endsStroke)
        QTRY_COMPARE(v.changes(), 1);
    const std::uint64_t kept = v.hash();
    v.hand.headset().step(qPrintable("{" + back + "}"));
    QVERIFY(says(v, QStringLiteral("In VR with")));
    QTRY_VERIFY(v.hand.isIn());
    v.hand.frames(8);
    if (endsStroke) {
        QCOMPARE(v.changes(), 1);
        QCOMPARE(v.hash(), kept);
    }
    v.hand.end();
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    v.hand.stroke({0, -49, 0}, {0, -54, 0}, 8);
    QCOMPARE(v.changes(), 2);
    QVERIFY(v.box().min().y() < -51);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.settle();
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// The clay follows the controller at five frames per second and after a late frame. Slow frames of the same motion
/// give the same stroke, bit for bit.
void TestHeadsetVisits::framesThatComeLate()
{
    Alone v;
    const auto height = [&] { return v.changes() == 1 ? v.box().max().y() : 0; };
    const auto undo = [&] {
        v.trigger("edit.undo");
        v.hand.settle();
    };
    v.hand.stroke({0, 49, 0}, {0, 60, 0}, 6);
    const double expected = height();
    const std::uint64_t hash = v.hash();
    QVERIFY(expected > 55);
    undo();

    v.hand.headset().step("{'hz': 5}");
    v.hand.stroke({0, 49, 0}, {0, 60, 0}, 6);
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.hash(), hash);
    keep("5 frames a second", v, "strokes are the same");
    undo();

    v.hand.headset().step("{'hz': 90}");
    v.hand.begin({0, 49, 0}, {0, 54.5, 0}, 3);
    v.hand.headset().step("{'late_ms': 400}");
    for (const double y : {56.3, 58.2, 60.0}) {
        v.hand.put(Side::Right, v.hand.place({0, y, 0}));
        v.hand.frame();
    }
    v.hand.end();
    v.hand.settle();
    QVERIFY2(std::abs(height() - expected) < 0.5, qPrintable(QString::number(height())));
    keep("a frame that is late", v, "the stroke goes on");
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// When the runtime recentres, the stroke ends at its last place before that, and the model is placed in front of the
/// user again.
void TestHeadsetVisits::recentredByTheRuntime()
{
    Alone v;
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    v.hand.headset().step("{'recentre': {'space': 'stage', 'position': [1, 0, 0.5], 'after': 2}}");
    v.hand.frames(6);
    v.hand.end();
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    keep("the runtime recentres the room", v, "the stroke as far as it came; VR goes on");
    QVERIFY(v.hand.seen().head);
    const Vec3 head = v.hand.seen().head->position;
    QVERIFY((head - Vec3(-1, 1.6, -0.5)).norm() < 1e-3);
    // vector from the head to the model's centre
    QVERIFY((v.model().translation() - head - Vec3(0, -0.2, -0.6)).norm() < 0.02);
    v.hand.stroke({0, -49, 0}, {0, -54, 0}, 8); // at the same place relative to the head
    QCOMPARE(v.changes(), 2);
    QVERIFY(v.box().min().y() < -51);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// The floor is assumed below the eyes if the runtime does not give it.
void TestHeadsetVisits::noFloor()
{
    HeadsetFixture fixture;
    fixture.hand.headset().step("{'stage': false}");
    fixture.hand.enter();
    QVERIFY(says(fixture, QStringLiteral("In VR with")));
    keep("a runtime without a floor", fixture, "everything; VR goes on");
    QVERIFY(fixture.hand.seen().head);
    QVERIFY((fixture.hand.seen().head->position - Vec3(0, 1.5, 0)).norm() < 1e-3);
    fixture.hand.stroke({0, 49, 0}, {0, 54, 0}, 8); // at the same place relative to the head
    QCOMPARE(fixture.changes(), 1);
    QVERIFY(fixture.box().max().y() > 51);
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::oneView()
{
    HeadsetFixture fixture;
    fixture.hand.headset().step("{'views': 'mono'}");
    fixture.hand.enter();
    QVERIFY(says(fixture, QStringLiteral("In VR with")));
    keep("a headset with one view", fixture, "everything; VR goes on");
    fixture.hand.stroke({0, 49, 0}, {0, 54, 0}, 8);
    QCOMPARE(fixture.changes(), 1);
    QVERIFY(!fixture.hand.picture("mono").isNull());
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

/// The runtime freezes in xrWaitFrame during a stroke. The stroke is kept, later actions of the abandoned visit are
/// ignored, and VR can be entered again.
void TestHeadsetVisits::frozen_isGivenUp()
{
    Visit v;
    const auto* headset = v.program.window.findChild<Headset*>();
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    v.trigger("vr.enter");
    QCOMPARE(sentence(v.program), QStringLiteral("Leaving VR…"));
    QVERIFY(!v.program.window.action(QStringLiteral("vr.enter"))->isEnabled());
    QTRY_VERIFY(!headset->isActive());
    QVERIFY2(sentence(v.program).contains("The headset's program does not answer."), qPrintable(sentence(v.program)));
    keep("the runtime is frozen", v, "the stroke as far as it came; it can be undone");
    QTRY_VERIFY(v.program.document.queue().isSettled());
    QCOMPARE(v.changes(), 1);
    QVERIFY(v.box().max().y() > 51);

    for (const char* action : {"vr.enter", "vr.status"}) {
        v.program.window.showNotice(QStringLiteral("Something else."));
        v.trigger(action);
        QVERIFY2(sentence(v.program).contains("still does not answer"), qPrintable(sentence(v.program)));
        QVERIFY(v.program.window.action(QStringLiteral("vr.enter"))->isEnabled());
    }
    drag(v.program.window.viewport(), {40, 0});
    QTRY_COMPARE(v.changes(), 2);
    const std::uint64_t hash = v.hash();
    v.program.window.showNotice(QStringLiteral("Something else."));

    v.hand.put(Side::Right, v.hand.place({0, 60, 0}));
    v.hand.headset().step("{'pace': 'fast'}");
    QTRY_VERIFY(!headset->isStuck());
    v.hand.headset().step("{'pace': 'stepped'}");
    v.hand.set(Side::Right, "trigger", 0);
    v.hand.settle();
    QCOMPARE(sentence(v.program), QStringLiteral("Something else."));
    QCOMPARE(v.changes(), 2);
    QCOMPARE(v.hash(), hash);

    v.hand.enter();
    QVERIFY(says(v, QStringLiteral("In VR with")));
    v.hand.stroke({0, -49, 0}, {0, -54, 0}, 8);
    QCOMPARE(v.changes(), 3);
    v.hand.leave();
    QCOMPARE(sentence(v.program), QStringLiteral("Left VR."));
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetVisits::frozen_beforeAVisit()
{
    HeadsetFixture fixture;
    const QString words = QStringLiteral("The headset's program does not answer. If it is not just starting");
    fixture.hand.headset().step("{'freeze': 'xrCreateInstance'}");
    fixture.trigger("vr.status");
    QTRY_VERIFY(sentence(fixture.program).contains(words));
    keep("the runtime is frozen when it is looked for", fixture, "everything; VR was not begun");
    fixture.program.window.showNotice(QStringLiteral("Something else."));
    fixture.trigger("vr.status");
    QVERIFY2(sentence(fixture.program).contains(words), qPrintable(sentence(fixture.program)));
    fixture.hand.headset().step("{'freeze': ''}");
    QVERIFY(says(fixture, QStringLiteral("is ready, through")));
    fixture.hand.enter();
    fixture.hand.stroke({0, 49, 0}, {0, 54, 0}, 8);
    QCOMPARE(fixture.changes(), 1);
    QCOMPARE(fixture.hand.headset().complaints(), QString());
}

/// Closing the window leaves VR first, and then asks about unsaved changes.
void TestHeadsetVisits::program_endsDuringAVisit()
{
    Alone v;
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    answerQuestion(v.program, QMessageBox::Discard);
    v.hand.headset().step("{'pace': 'fast'}");
    v.program.window.close();
    QTRY_VERIFY(!v.program.window.isVisible());
    QVERIFY(!v.hand.isIn());
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// The window stays visible meanwhile and shows what it waits for.
void TestHeadsetVisits::program_endsThoughAllIsFrozen()
{
    Alone v;
    const auto* headset = v.program.window.findChild<Headset*>();
    v.hand.begin({0, 49, 0}, {0, 54, 0}, 8);
    answerQuestion(v.program, QMessageBox::Discard);
    v.program.window.close();
    QVERIFY(v.program.window.isVisible());
    QCOMPARE(sentence(v.program), QStringLiteral("Leaving VR…"));
    v.program.window.close();
    QVERIFY(v.program.window.isVisible() && headset->isActive());
    QTRY_VERIFY(!v.program.window.isVisible());
    QVERIFY(!headset->isActive() && headset->isStuck());
    QCOMPARE(v.changes(), 1);
    v.hand.headset().step("{'pace': 'fast'}");
    QTRY_VERIFY(!headset->isStuck());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Tests the real program with a runtime that freezes and wakes, if at all, during the program's exit.
void TestHeadsetVisits::process_endsThoughAllIsFrozen()
{
    constexpr auto* script = R"({"start": {"pace": "fast", "size": [64, 72]}, "steps": [
        {"frame": 9, "keep": true, "freeze": "xrWaitFrame", "wake_at_exit": true}]})";
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("script.json")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(script) > 0);
    file.close();
    const ScriptedHeadset here; // sets the environment for the runtime and the validation layer
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("FETTLE_XR_SCRIPT"), file.fileName());
    environment.insert(QStringLiteral("FETTLE_XR_FRAMES"), folder.path());
    environment.insert(QStringLiteral("XR_CORE_VALIDATION_FILE_NAME"),
                       folder.filePath(QStringLiteral("validation.txt")));
    for (const char* home : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"})
        environment.insert(QString::fromLatin1(home), folder.filePath(QString::fromLatin1(home)));
    const auto journals = [&folder] {
        return QDir(folder.filePath(QStringLiteral("XDG_STATE_HOME/fettle/journals")))
            .entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    };
    QProcess fettle;
    fettle.setProcessEnvironment(environment);
    fettle.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    fettle.start(QStringLiteral(FETTLE_PROGRAM), {QStringLiteral("--vr")});
    QTRY_VERIFY(QFile::exists(folder.filePath(QStringLiteral("session0_frame0009_left.png"))));
    QVERIFY(!journals().isEmpty());
    QTRY_VERIFY(askToClose(fettle.processId()));
    QElapsedTimer closing;
    closing.start();
    QTRY_COMPARE(fettle.state(), QProcess::NotRunning);
    QVERIFY(closing.elapsed() > 5'000); // the visit was abandoned after a timeout, not left normally
    QCOMPARE(fettle.exitStatus(), QProcess::NormalExit);
    QCOMPARE(fettle.exitCode(), 0);
    QCOMPARE(journals(), QStringList()); // the document was closed normally
    QCOMPARE(layerComplaints(folder.filePath(QStringLiteral("validation.txt"))), QStringList());
}

FETTLE_TEST(TestHeadsetVisits, app::OnScreen)
#include "tst_headset_visits.moc"
