// Tests of a frame's inputs and outputs for a client, against the scripted runtime behind Khronos' validation layer.
#include "tests/support/test_main.h"
#include "tests/vr/simulator/scripted_headset.h"
#include "tests/vr/vr_test.h"

#include "vr/openxr/xr_bindings.h"

#include <QJsonArray>

#include <array>
#include <cmath>

using core::Vec3;
using vr::HeadsetStage;
using vr::Side;

namespace
{
/// Returns the sRGB byte for a linear value, 0 to 1.
int encoded(double linear)
{
    return static_cast<int>(
        std::lround(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055)));
}

constexpr std::string_view handProfile = "/interaction_profiles/ext/hand_interaction_ext";

bool isClose(const Vec3& a, const Vec3& b)
{
    return (a - b).norm() < 1e-4;
}
} // namespace

class TestHeadsetFrames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { m_headset->load("{'start': {'pace': 'stepped'}}"); }
    void cleanup();

    void picturesArrive();
    void sizesAndViewsAreTheRuntimes_data();
    void sizesAndViewsAreTheRuntimes();
    void hiddenAreasAreTheRuntimes();
    void hiddenAreasMayGrowWhileTheyAreRead();
    void hiddenAreasMayBeRefused();
    void hiddenAreasAreNotAskedForInVain();
    void depthComesWithThePictures();
    void formatsAreTried_data();
    void formatsAreTried();
    void depthFormatsAreTried_data();
    void depthFormatsAreTried();
    void lostEventsAreMadeUpFor();
    void refreshRateIsTheNearestToTheWanted_data();
    void refreshRateIsTheNearestToTheWanted();
    void eyesAreBesideEachOther();
    void nothingIsDrawnThatIsNotShown();
    void lostHeadsShowNothing();
    void wandsAreFeltAndSeen();
    void handsAndHeadAreWhereTheyWillBeSeen();
    void lostWandsStayWhereTheyWere();
    void wandsMayChange();
    void wandsOfEveryKindAreRead_data();
    void wandsOfEveryKindAreRead();
    void bareHandsAreRead();
    void jointsOfBareHandsAreFound();
    void jointsMayBeRefused_data();
    void jointsMayBeRefused();
    void unknownKindsOfWandsAreNotSuggested();
    void restingHandsSqueezeNothing();
    void refusedKindsOfWandsAreLeftOut();
    void passthroughIsTheRuntimes_data();
    void passthroughIsTheRuntimes();
    void pulsesAreFelt();
    void theClientRecentres_data();
    void theClientRecentres();
    void theFloorIsTheRuntimes();
    void theRuntimeRecentres();
    void theClientLeaves();
    void lateFramesAreCounted();
    void phasesAreMeasured();

private:
    /// Enters the headset at pace "stepped" and checks that the session has the focus.
    void enter(Visitor& visitor);
    void leave(Visitor& visitor);

    std::unique_ptr<ScriptedHeadset> m_headset; ///< null if the tests are skipped
};

void TestHeadsetFrames::initTestCase()
{
    SKIP_WITHOUT_GLX();
    m_headset = std::make_unique<ScriptedHeadset>();
}

void TestHeadsetFrames::cleanup()
{
    if (m_headset)
        QCOMPARE(m_headset->complaints(), QString());
}

void TestHeadsetFrames::enter(Visitor& visitor)
{
    QVERIFY(visitor.enter());
    QTRY_VERIFY(m_headset->report()["is_running"].toBool());
    for (int i = 0; i < 20 && !visitor.client->last().hasFocus; ++i)
        QVERIFY(m_headset->frames(1));
    QVERIFY(visitor.client->last().hasFocus);
}

void TestHeadsetFrames::leave(Visitor& visitor)
{
    m_headset->step("{'pace': 'fast'}");
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, vr::HeadsetEnd::Left);
    QCOMPARE(visitor.client->glErrors, 0);
}

/// Checks that linear colours appear in the image as sRGB, neither too dark nor too bright.
void TestHeadsetFrames::picturesArrive()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'keep': true}");
    QVERIFY(m_headset->frames(1));
    const int frame = visitor.client->frames - 1;
    leave(visitor);
    std::size_t eye = 0;
    for (const char* name : {"left", "right"}) {
        const QImage picture = m_headset->picture(0, frame, name);
        QCOMPARE(picture.size(), QSize(1080, 1200));
        const QColor written = RecordingClient::linear(eye++);
        for (const QPoint at : {QPoint(0, 0), QPoint(540, 600), QPoint(1079, 1199)}) {
            const QColor seen = picture.pixelColor(at);
            QVERIFY(std::abs(seen.red() - encoded(written.redF())) <= 1);
            QVERIFY(std::abs(seen.green() - encoded(written.greenF())) <= 1);
            QVERIFY(std::abs(seen.blue() - encoded(written.blueF())) <= 1);
        }
    }
}

void TestHeadsetFrames::sizesAndViewsAreTheRuntimes_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("views");
    QTest::newRow("as on a Vive") << "'size': [1080, 1200]" << QSize(1080, 1200) << 2;
    QTest::newRow("small") << "'size': [320, 240], 'hz': 20" << QSize(320, 240) << 2;
    QTest::newRow("odd") << "'size': [641, 333], 'hz': 5" << QSize(641, 333) << 2;
    QTest::newRow("one eye") << "'views': 'mono'" << QSize(1080, 1200) << 1;
    QTest::newRow("two are better than one") << "'views': 'mono_first'" << QSize(1080, 1200) << 2;
}

void TestHeadsetFrames::sizesAndViewsAreTheRuntimes()
{
    QFETCH(QString, step);
    QFETCH(QSize, size);
    QFETCH(int, views);
    Visitor before(*m_headset); // a session with default settings before
    enter(before);
    leave(before);
    Visitor visitor(*m_headset);
    m_headset->load(qPrintable("{'start': {'pace': 'stepped', " + step + "}}"));
    enter(visitor);
    QVERIFY(m_headset->frames(1));
    const auto images = visitor.client->images();
    QCOMPARE(static_cast<int>(images.size()), views);
    for (const vr::EyeImage& image : images) {
        QCOMPARE(QSize(image.width, image.height), size);
        QVERIFY(image.texture != 0);
        QCOMPARE(image.format, GLenum(GL_SRGB8_ALPHA8));
    }
    for (const vr::EyeView& view : visitor.client->views()) {
        QCOMPARE(QSize(view.width, view.height), size);
        QVERIFY(view.isSrgb);
    }
    leave(visitor);
}

/// Places the mask's triangles in eye space at z = -1 and checks that they are at the edges of each eye's view. A new
/// mask must be adopted.
void TestHeadsetFrames::hiddenAreasAreTheRuntimes()
{
    m_headset->load("{'start': {'pace': 'stepped', 'hidden': 0.25}}");
    Visitor visitor(*m_headset);
    enter(visitor);
    const auto shares = [&] {
        std::vector<double> seen;
        for (const vr::EyeView& view : visitor.client->views()) {
            double area = 0;
            for (std::size_t i = 0; i < view.hidden->size(); i += 3) {
                std::array<Eigen::Vector2f, 3> corners;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Eigen::Vector2f& point = (*view.hidden)[i + k];
                    corners[k] = (view.projection * Eigen::Vector4f(point.x(), point.y(), -1, 1)).head<2>();
                    [&] { QVERIFY(corners[k].cwiseAbs().maxCoeff() < 1 + 1e-4F); }();
                }
                const Eigen::Vector2f a = corners[1] - corners[0], b = corners[2] - corners[0];
                area += std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
            }
            seen.push_back(area / 4); // fraction of clip space
        }
        return seen;
    };
    for (const double share : {0.25, 0.5, 0.0}) {
        m_headset->step(qPrintable(QStringLiteral("{'hidden': %1}").arg(share)));
        QVERIFY(m_headset->frames(2));
        QCOMPARE(shares().size(), std::size_t(2));
        for (const double seen : shares())
            QVERIFY2(std::abs(seen - 2 * share * share) < 1e-3, qPrintable(QString::number(seen)));
    }
    leave(visitor);
}

/// Lets the mask grow between the query of its size and the query of its data.
void TestHeadsetFrames::hiddenAreasMayGrowWhileTheyAreRead()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'fail': {'call': 'xrGetVisibilityMaskKHR', 'result': 'XR_ERROR_SIZE_INSUFFICIENT', 'after': 1},"
                    " 'hidden': 0.25}");
    QVERIFY(m_headset->frames(3));
    QCOMPARE(visitor.client->views().size(), std::size_t(2));
    for (const vr::EyeView& view : visitor.client->views())
        QVERIFY(!view.hidden->empty());
    leave(visitor);
}

/// Lets queries of the mask fail. The old mask must not be kept, because it would hide visible areas; the next mask
/// must be adopted.
void TestHeadsetFrames::hiddenAreasMayBeRefused()
{
    m_headset->load("{'start': {'pace': 'stepped', 'hidden': 0.25}}");
    Visitor visitor(*m_headset);
    enter(visitor);
    const auto areHidden = [&](bool expected) {
        for (const vr::EyeView& view : visitor.client->views())
            QCOMPARE(!view.hidden->empty(), expected);
    };
    m_headset->step("{'fail': {'call': 'xrGetVisibilityMaskKHR', 'result': 'XR_ERROR_RUNTIME_FAILURE', 'times': 2},"
                    " 'hidden': 0.125}");
    QVERIFY(m_headset->frames(3));
    QCOMPARE(visitor.client->views().size(), std::size_t(2));
    areHidden(false);
    m_headset->step("{'hidden': 0.25}");
    QVERIFY(m_headset->frames(3));
    areHidden(true);
    leave(visitor);
}

/// Checks that masks are not queried from a runtime without the extension.
void TestHeadsetFrames::hiddenAreasAreNotAskedForInVain()
{
    m_headset->load("{'start': {'pace': 'stepped', 'hidden': 0.25, 'extensions': false}}");
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(m_headset->frames(1));
    for (const vr::EyeView& view : visitor.client->views())
        QVERIFY(view.hidden->empty());
    leave(visitor);
}

/// Checks that each eye's depth is submitted with the data for reading it, and that a runtime without the extension
/// gets none.
void TestHeadsetFrames::depthComesWithThePictures()
{
    for (const bool isOffered : {true, false}) {
        m_headset->load(isOffered ? "{'start': {'pace': 'stepped'}}"
                                  : "{'start': {'pace': 'stepped', 'extensions': false}}");
        Visitor visitor(*m_headset);
        enter(visitor);
        m_headset->step("{'keep': true}");
        QVERIFY(m_headset->frames(1));
        const int frame = visitor.client->frames - 1;
        for (const vr::EyeImage& image : visitor.client->images())
            QCOMPARE(image.depthTexture != 0, isOffered);
        leave(visitor);
        QCOMPARE(m_headset->complaints(), QString());
        if (!isOffered)
            continue;
        std::size_t eye = 0;
        for (const char* name : {"left_depth", "right_depth"}) {
            const QImage picture = m_headset->picture(0, frame, name);
            const double written = RecordingClient::depth(eye++);
            QCOMPARE(picture.size(), QSize(1080, 1200));
            for (const QPoint at : {QPoint(0, 0), QPoint(540, 600), QPoint(1079, 1199)}) {
                const QColor seen = picture.pixelColor(at);
                const double depth = (seen.red() * 65536 + seen.green() * 256 + seen.blue()) / 16777215.0;
                QVERIFY2(std::abs(depth - written) < 1e-6, qPrintable(QString::number(depth)));
            }
        }
    }
}

void TestHeadsetFrames::formatsAreTried_data()
{
    QTest::addColumn<QByteArray>("failing");
    QTest::addColumn<int>("format");
    QTest::newRow("all are made") << QByteArray() << GL_SRGB8_ALPHA8;
    QTest::newRow("no sRGB") << QByteArray("'srgb8_alpha8'") << GL_RGBA16F;
    QTest::newRow("only the last") << QByteArray("'srgb8_alpha8', 'rgba16f'") << GL_RGBA8;
}

/// Checks that the next format is tried where the runtime makes no images of one that it offers, and that the colours
/// are right in each.
void TestHeadsetFrames::formatsAreTried()
{
    QFETCH(QByteArray, failing);
    QFETCH(int, format);
    m_headset->step(("{'failing_formats': [" + failing + "]}").constData());
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'keep': true}");
    QVERIFY(m_headset->frames(1));
    const int frame = visitor.client->frames - 1;
    const std::vector<vr::EyeImage> images = visitor.client->images();
    QCOMPARE(images.size(), std::size_t(2));
    for (const vr::EyeImage& image : images)
        QCOMPARE(int(image.format), format);
    for (const vr::EyeView& view : visitor.client->views())
        QCOMPARE(view.isSrgb, format == GL_SRGB8_ALPHA8);
    leave(visitor);
    constexpr int tolerance = 2; // the simulator reads linear light with 8 bits
    const QColor written = RecordingClient::linear(0);
    const QColor seen = m_headset->picture(0, frame, "left").pixelColor(540, 600);
    QVERIFY(std::abs(seen.red() - encoded(written.redF())) <= tolerance);
    QVERIFY(std::abs(seen.green() - encoded(written.greenF())) <= tolerance);
    QVERIFY(std::abs(seen.blue() - encoded(written.blueF())) <= tolerance);
}

void TestHeadsetFrames::depthFormatsAreTried_data()
{
    QTest::addColumn<QByteArray>("failing");
    QTest::addColumn<int>("format");
    QTest::newRow("all are made") << QByteArray() << GL_DEPTH_COMPONENT24;
    QTest::newRow("only one") << QByteArray("'depth24'") << GL_DEPTH_COMPONENT32F;
    QTest::newRow("none") << QByteArray("'depth24', 'depth32f'") << 0;
}

void TestHeadsetFrames::depthFormatsAreTried()
{
    QFETCH(QByteArray, failing);
    QFETCH(int, format);
    m_headset->step(("{'failing_formats': [" + failing + "]}").constData());
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(m_headset->frames(1));
    for (const vr::EyeImage& image : visitor.client->images()) {
        QCOMPARE(int(image.depthFormat), format);
        QCOMPARE(image.depthTexture != 0, format != 0);
    }
    leave(visitor);
}

/// Checks that after lost events the client queries their contents, here a new mask.
void TestHeadsetFrames::lostEventsAreMadeUpFor()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    for (const vr::EyeView& view : visitor.client->views())
        QVERIFY(view.hidden->empty());
    m_headset->step("{'hidden': 0.25}");
    m_headset->step("{'lose_events': true}");
    QVERIFY(m_headset->frames(3));
    QCOMPARE(visitor.client->views().size(), std::size_t(2));
    for (const vr::EyeView& view : visitor.client->views())
        QVERIFY(!view.hidden->empty());
    leave(visitor);
}

void TestHeadsetFrames::refreshRateIsTheNearestToTheWanted_data()
{
    QTest::addColumn<QByteArray>("offered");
    QTest::addColumn<double>("wanted");
    QTest::newRow("with 90") << QByteArray("'hz': 72, 'rates': [72, 80, 90, 120]") << 90.0;
    QTest::newRow("without") << QByteArray("'hz': 60, 'rates': [60, 72, 144]") << 72.0;
    QTest::newRow("one") << QByteArray("'hz': 144") << 144.0;
    QTest::newRow("not asked") << QByteArray("'hz': 72, 'rates': [90], 'extensions': false") << 72.0;
}

void TestHeadsetFrames::refreshRateIsTheNearestToTheWanted()
{
    QFETCH(QByteArray, offered);
    QFETCH(double, wanted);
    m_headset->load(QByteArray("{'start': {'pace': 'stepped', " + offered + "}}").constData());
    Visitor visitor(*m_headset);
    enter(visitor);
    const std::int64_t before = visitor.client->last().displayNs;
    QVERIFY(m_headset->frames(1));
    const double seconds = static_cast<double>(visitor.client->last().displayNs - before) * 1e-9;
    QVERIFY2(std::abs(seconds * wanted - 1) < 1e-6, qPrintable(QString::number(1 / seconds)));
    leave(visitor);
}

/// Checks the eyes' poses for a head at (0, 1.7, 0) that looks along -Z, with an eye distance of 6.4 cm.
void TestHeadsetFrames::eyesAreBesideEachOther()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'head': {'position': [0, 1.7, 0], 'rotation': [0, 0, 0, 1]}}");
    QVERIFY(m_headset->frames(1));
    const auto views = visitor.client->views();
    QCOMPARE(views.size(), std::size_t(2));
    for (std::size_t eye = 0; eye < 2; ++eye) {
        const Vec3 place = views[eye].view.inverse().translation().cast<double>();
        QVERIFY(isClose(place, {eye == 0 ? -0.032 : 0.032, 1.7, 0}));
        const Eigen::Vector4f ahead =
            views[eye].projection * (views[eye].view * Eigen::Vector3f(0, 1.7F, -2)).homogeneous();
        QVERIFY(ahead.w() > 0 && std::abs(ahead.x()) < ahead.w() && std::abs(ahead.y()) < ahead.w() &&
                std::abs(ahead.z()) < ahead.w());
    }
    const auto head = visitor.client->last().head;
    QVERIFY(head && isClose(head->position, {0, 1.7, 0}) && isClose(head->forward(), -Vec3::UnitZ()));
    leave(visitor);
}

void TestHeadsetFrames::nothingIsDrawnThatIsNotShown()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'should_render': false}");
    QVERIFY(m_headset->frames(1));
    const int draws = visitor.client->draws, frames = visitor.client->frames;
    QVERIFY(m_headset->frames(5));
    QCOMPARE(visitor.client->draws, draws);
    QCOMPARE(visitor.client->frames, frames + 5);
    QCOMPARE(m_headset->report()["last_frame"].toObject()["layers"].toArray().size(), 0);

    m_headset->step("{'should_render': true}");
    QVERIFY(m_headset->frames(2));
    QVERIFY(visitor.client->draws >= draws + 2);
    QCOMPARE(m_headset->report()["last_frame"].toObject()["layers"].toArray().size(), 1);
    leave(visitor);
}

/// Checks that nothing is shown without a head pose. If only the head's position is untracked, drawing continues from
/// the position that the runtime assumes, or from the last one.
void TestHeadsetFrames::lostHeadsShowNothing()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'head': {'position': [0.5, 1.6, 0.25], 'tracked': 'rotation'}}");
    QVERIFY(m_headset->frames(2));
    QCOMPARE(visitor.client->views().size(), std::size_t(2));
    QVERIFY(isClose(visitor.client->last().head->position, {0.5, 1.6, 0.25}));

    m_headset->step("{'head': {'position': [2, 2, 2], 'yaw_pitch_roll': [90, 0, 0], 'tracked': 'no_position'}}");
    QVERIFY(m_headset->frames(2));
    QCOMPARE(visitor.client->views().size(), std::size_t(2));
    const core::Vec3 eye = visitor.client->views()[0].view.inverse().translation().cast<double>();
    QVERIFY(isClose(eye, {0.468, 1.6, 0.25}));
    QVERIFY(isClose(visitor.client->last().head->position, {0.5, 1.6, 0.25}));
    QVERIFY(isClose(visitor.client->last().head->forward(), -Vec3::UnitX()));

    m_headset->step("{'head': {'position': [3, 3, 3], 'tracked': false}}");
    QVERIFY(m_headset->frames(2));
    QVERIFY(visitor.client->views().empty());
    QVERIFY(isClose(visitor.client->last().head->position, {0.5, 1.6, 0.25}));
    QCOMPARE(m_headset->report()["last_frame"].toObject()["layers"].toArray().size(), 0);

    m_headset->step("{'head': {'tracked': true}}");
    QVERIFY(m_headset->frames(2));
    QCOMPARE(visitor.client->views().size(), std::size_t(2));
    QVERIFY(isClose(visitor.client->last().head->position, {3, 3, 3}));
    leave(visitor);
}

void TestHeadsetFrames::wandsAreFeltAndSeen()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step(
        "{'left': {'position': [-0.2, 1.1, -0.3], 'trigger': 0.25, 'squeeze': true},"
        " 'right': {'position': [0.2, 1, -0.4], 'yaw_pitch_roll': [90, 0, 0], 'trigger': 1, 'pad': [0.5, -0.75],"
        "           'pad_touch': true, 'pad_press': true, 'menu': true}}");
    QVERIFY(m_headset->frames(1));
    const auto& [left, right] = visitor.client->last().wands;
    QVERIFY(left.isTracked && left.isActive && right.isTracked && right.isActive);
    QVERIFY(isClose(left.grip.position, {-0.2, 1.1, -0.3}));
    QVERIFY(isClose(right.grip.position, {0.2, 1, -0.4}));
    QVERIFY(isClose(right.grip.forward(), -Vec3::UnitX()));
    QVERIFY(std::abs(left.trigger - 0.25) < 1e-6 && right.trigger == 1);
    QVERIFY(left.side && !left.menu && !left.padTouched && !left.padPressed && left.pad.isZero());
    QVERIFY(!right.side && right.menu && right.padTouched && right.padPressed);
    QVERIFY((right.pad - Eigen::Vector2d(0.5, -0.75)).norm() < 1e-6);
    QVERIFY(!left.isStick && !right.isStick);
    leave(visitor);
}

/// Checks that poses are predicted for the frame's display time: the movement takes ten frames, so each frame adds a
/// tenth.
void TestHeadsetFrames::handsAndHeadAreWhereTheyWillBeSeen()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'right': {'position': [0.2, 1, -0.4]}, 'head': {'position': [0, 1.6, 0]}}");
    QVERIFY(m_headset->frames(1));
    m_headset->step("{'over': 10, 'right': {'position': [0.7, 1, -0.4]}, 'head': {'position': [0, 1.6, 1]}}");
    for (int frame = 0; frame <= 12; ++frame) {
        QVERIFY(m_headset->frames(1));
        const double share = std::min(frame / 10.0, 1.0);
        QVERIFY(isClose(visitor.client->last().wands[1].grip.position, {0.2 + 0.5 * share, 1, -0.4}));
        QVERIFY(isClose(visitor.client->last().head->position, {0, 1.6, share}));
    }
    leave(visitor);
}

void TestHeadsetFrames::lostWandsStayWhereTheyWere()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'right': {'position': [0.2, 1, -0.4]}}");
    QVERIFY(m_headset->frames(2));
    m_headset->step("{'right': {'tracked': false, 'position': [2, 2, 2], 'trigger': 0.5}}");
    QVERIFY(m_headset->frames(2));
    const vr::WandState lost = visitor.client->last().wands[1];
    QVERIFY(!lost.isTracked && lost.isActive && lost.trigger == 0.5);
    QVERIFY(isClose(lost.grip.position, {0.2, 1, -0.4}));
    QVERIFY(visitor.client->last().wands[0].isTracked);

    m_headset->step("{'right': {'on': false}}");
    QVERIFY(m_headset->frames(2));
    const vr::WandState off = visitor.client->last().wands[1];
    QVERIFY(!off.isTracked && !off.isActive && off.trigger == 0);
    leave(visitor);
}

void TestHeadsetFrames::wandsMayChange()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'profile': '/interaction_profiles/valve/index_controller', 'left': {'stick': [0.25, 0.5], "
                    "'button_b': true}}");
    QVERIFY(m_headset->frames(4));
    const SeenFrame frame = visitor.client->last();
    QVERIFY(frame.wands[0].isStick && frame.wands[0].menu);
    QVERIFY((frame.wands[0].pad - Eigen::Vector2d(0.25, 0.5)).norm() < 1e-6);
    QVERIFY(!frame.wands[0].isSimple);
    m_headset->step("{'profile': '/interaction_profiles/khr/simple_controller'}");
    QVERIFY(m_headset->frames(4));
    QVERIFY(visitor.client->last().wands[0].isSimple && !visitor.client->last().wands[0].isStick);
    leave(visitor);
}

void TestHeadsetFrames::wandsOfEveryKindAreRead_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("isStick");
    for (const vr::WandProfile& profile : vr::wandProfiles())
        if ((profile.isInCore(XR_MAKE_VERSION(1, 0, 0)) || profile.extension) && profile.path != handProfile)
            QTest::newRow(profile.path) << profile.path << profile.isStick;
}

void TestHeadsetFrames::wandsOfEveryKindAreRead()
{
    QFETCH(QString, path);
    QFETCH(bool, isStick);
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step(qPrintable(QStringLiteral("{'profile': '%1'}").arg(path)));
    QVERIFY(m_headset->frames(4));
    for (const char* hand : {"left", "right"})
        m_headset->step(qPrintable(QStringLiteral("{'%1': {'trigger': 1, 'squeeze': 1, 'menu': true, 'button_b': true, "
                                                  "'pad': [0.5, -0.25], 'pad_touch': true, 'stick': [0.5, -0.25]}}")
                                       .arg(hand)));
    QVERIFY(m_headset->frames(2));
    for (const vr::WandState& wand : visitor.client->last().wands) {
        QVERIFY(wand.isTracked && wand.isActive && wand.menu && !wand.isHand);
        QCOMPARE(wand.trigger, 1.0);
        QCOMPARE(wand.isStick, isStick);
        QCOMPARE(wand.isSimple, path.contains("simple"));
        QCOMPARE(wand.side, !wand.isSimple);
        QVERIFY(wand.isSimple || (wand.pad - Eigen::Vector2d(0.5, -0.25)).norm() < 1e-6);
    }
    leave(visitor);
}

/// Checks the gestures and poses of bare hands, and that a hand that is lost, or takes up a wand, is none.
void TestHeadsetFrames::bareHandsAreRead()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step(qPrintable(QStringLiteral("{'profile': '%1', 'pinch_at': {'position': [0, 0.02, -0.1]}}")
                                   .arg(QString::fromStdString(std::string(handProfile)))));
    m_headset->step("{'left': {'position': [-0.3, 1.2, -0.4], 'pinch': 0.6, 'grasp': 0.2},"
                    " 'right': {'grasp': 0.9, 'yaw_pitch_roll': [90, 0, 0], 'position': [0.3, 1.2, -0.4]}}");
    QVERIFY(m_headset->frames(4));
    const vr::Wands hands = visitor.client->last().wands;
    for (const vr::WandState& hand : hands)
        QVERIFY(hand.isHand && hand.isTracked && hand.isActive && !hand.isStick && !hand.isSimple && !hand.menu);
    QVERIFY(std::abs(hands[0].trigger - 0.6) < 1e-6 && std::abs(hands[0].squeeze - 0.2) < 1e-6 && !hands[0].side);
    QVERIFY(hands[1].trigger == 0 && std::abs(hands[1].squeeze - 0.9) < 1e-6 && hands[1].side);
    QVERIFY(isClose(hands[0].pinch.position, {-0.3, 1.22, -0.5}));
    QVERIFY(isClose(hands[1].pinch.position, {0.2, 1.22, -0.4}));
    m_headset->step("{'left': {'tracked': false}}");
    QVERIFY(m_headset->frames(2));
    QVERIFY(!visitor.client->last().wands[0].isTracked && visitor.client->last().wands[1].isTracked);
    m_headset->step("{'left': {'on': false}}"); // the runtime finds no device, but it may have been a hand
    QVERIFY(m_headset->frames(4));
    QVERIFY(!visitor.client->last().wands[0].isActive && visitor.client->last().wands[0].isHand);
    vr::FrameOutput output;
    output.pulses = {{Side::Right, 0.5, 160, 0.02}}; // nothing vibrates, and nothing fails
    visitor.client->answer(output);
    QVERIFY(m_headset->frames(2));
    QCOMPARE(m_headset->report()["haptics"].toArray().size(), 0);
    m_headset->step("{'profile': '/interaction_profiles/htc/vive_controller'}");
    QVERIFY(m_headset->frames(4));
    QVERIFY(!visitor.client->last().wands[1].isHand);
    leave(visitor);
}

/// Checks that the joints of a bare hand move with it, and that a wand has none.
void TestHeadsetFrames::jointsOfBareHandsAreFound()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(!visitor.client->last().joints[0] && !visitor.client->last().joints[1]);
    const QString profile = QString::fromStdString(std::string(handProfile));
    m_headset->step(
        qPrintable(QStringLiteral("{'profile': '%1', 'left': {'position': [-0.3, 1.2, -0.4]}}").arg(profile)));
    QVERIFY(m_headset->frames(4));
    const auto joints = visitor.client->last().joints;
    QVERIFY(joints[0] && joints[1]);
    QVERIFY(isClose((*joints[0])[XR_HAND_JOINT_PALM_EXT].position, {-0.3, 1.2, -0.4}));
    QVERIFY((*joints[0])[XR_HAND_JOINT_WRIST_EXT].position.z() >
            (*joints[0])[XR_HAND_JOINT_INDEX_TIP_EXT].position.z());
    for (const vr::HandJoint& joint : *joints[0])
        QVERIFY((joint.position - Vec3(-0.3, 1.2, -0.4)).norm() < 0.2 && joint.radius > 0.001 && joint.radius < 0.05);
    m_headset->step("{'left': {'position': [-0.3, 1.4, -0.4]}, 'right': {'tracked': false}}");
    QVERIFY(m_headset->frames(2));
    QVERIFY(isClose((*visitor.client->last().joints[0])[XR_HAND_JOINT_PALM_EXT].position, {-0.3, 1.4, -0.4}));
    QVERIFY(!visitor.client->last().joints[1]);
    leave(visitor);
}

void TestHeadsetFrames::jointsMayBeRefused_data()
{
    QTest::addColumn<QByteArray>("step");
    QTest::newRow("not offered") << QByteArray("'withheld': ['XR_EXT_hand_tracking']");
    for (const char* call : {"xrCreateHandTrackerEXT", "xrLocateHandJointsEXT"})
        QTest::newRow(call) << "'fail': {'call': '" + QByteArray(call) +
                                   "', 'result': 'XR_ERROR_RUNTIME_FAILURE', 'times': 999}";
}

/// Checks that hands sculpt without joints, too.
void TestHeadsetFrames::jointsMayBeRefused()
{
    QFETCH(QByteArray, step);
    m_headset->step(("{" + step + ", 'profile': '" + QByteArray(handProfile.data()) + "'}").constData());
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(m_headset->frames(4));
    QVERIFY(!visitor.client->last().joints[0] && !visitor.client->last().joints[1]);
    QVERIFY(visitor.client->last().wands[0].isHand && visitor.client->last().wands[0].isTracked);
    leave(visitor);
}

/// Checks that bindings are suggested only for kinds of wands of which the runtime has the extension. The runtime
/// counts others as errors of the client, as cleanup() would notice.
void TestHeadsetFrames::unknownKindsOfWandsAreNotSuggested()
{
    QStringList withheld;
    int inCore = 0;
    for (const vr::WandProfile& profile : vr::wandProfiles()) {
        inCore += profile.isInCore(XR_MAKE_VERSION(1, 0, 0)) ? 1 : 0;
        if (profile.extension)
            withheld << QStringLiteral("'%1'").arg(QLatin1StringView(profile.extension));
    }
    m_headset->step(qPrintable(QStringLiteral("{'withheld': [%1]}").arg(withheld.join(", "))));
    Visitor visitor(*m_headset);
    enter(visitor);
    QCOMPARE(m_headset->calls("xrSuggestInteractionProfileBindings"), inCore);
    m_headset->step("{'profile': '/interaction_profiles/valve/frame_controller_valve'}");
    QVERIFY(m_headset->frames(3));
    QVERIFY(!visitor.client->last().wands[0].isActive && !visitor.client->last().wands[1].isActive);
    leave(visitor);
}

/// Checks the hysteresis of the squeeze on a Touch controller: it begins above the force of a resting hand, and ends
/// below the force at which it began.
void TestHeadsetFrames::restingHandsSqueezeNothing()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'profile': '/interaction_profiles/oculus/touch_controller'}");
    QVERIFY(m_headset->frames(4));
    const auto isSqueezed = [&](double squeeze) {
        m_headset->step(qPrintable(QStringLiteral("{'right': {'squeeze': %1}}").arg(squeeze)));
        [&] { QVERIFY(m_headset->frames(2)); }();
        return visitor.client->last().wands[1].side;
    };
    QVERIFY(!isSqueezed(0.1) && !isSqueezed(0.4) && !isSqueezed(0.6));
    QVERIFY(isSqueezed(0.8) && isSqueezed(0.6));
    QVERIFY(!isSqueezed(0.4) && !isSqueezed(0.6) && isSqueezed(1));
    leave(visitor);
}

void TestHeadsetFrames::refusedKindsOfWandsAreLeftOut()
{
    m_headset->step("{'fail': {'call': 'xrSuggestInteractionProfileBindings', 'result': 'XR_ERROR_PATH_UNSUPPORTED'},"
                    " 'profile': '/interaction_profiles/oculus/touch_controller', 'right': {'button_b': true}}");
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(m_headset->frames(2));
    QVERIFY(visitor.client->last().wands[1].menu);
    leave(visitor);
}

void TestHeadsetFrames::passthroughIsTheRuntimes_data()
{
    QTest::addColumn<QByteArray>("offered");
    QTest::addColumn<QString>("off");
    QTest::addColumn<QString>("on");
    QTest::addColumn<bool>("isShownIfOff");
    QTest::addColumn<bool>("isShownIfOn");
    const QString opaque = "XR_ENVIRONMENT_BLEND_MODE_OPAQUE", alpha = "XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND",
                  additive = "XR_ENVIRONMENT_BLEND_MODE_ADDITIVE";
    QTest::newRow("not offered") << QByteArray("'opaque'") << opaque << opaque << false << false;
    QTest::newRow("by alpha") << QByteArray("'opaque', 'alpha_blend'") << opaque << alpha << false << true;
    QTest::newRow("only by alpha") << QByteArray("'alpha_blend'") << alpha << alpha << false << true;
    QTest::newRow("glasses") << QByteArray("'additive'") << additive << additive << true << true;
}

/// Checks that the client learns whether the real room can be shown, that a frame is drawn and submitted as the client
/// wants it, and that this can change from frame to frame.
void TestHeadsetFrames::passthroughIsTheRuntimes()
{
    QFETCH(QByteArray, offered);
    QFETCH(QString, off);
    QFETCH(QString, on);
    QFETCH(bool, isShownIfOff);
    QFETCH(bool, isShownIfOn);
    m_headset->step(("{'blend_modes': [" + offered + "]}").constData());
    Visitor visitor(*m_headset);
    enter(visitor);
    QCOMPARE(visitor.client->last().offersPassthrough, isShownIfOn);
    for (const bool isOn : {true, false, true}) {
        vr::FrameOutput output;
        output.passthrough = isOn;
        visitor.client->answer(output);
        QVERIFY(m_headset->frames(1));
        const QJsonObject frame = m_headset->report()["last_frame"].toObject();
        const bool isShown = isOn ? isShownIfOn : isShownIfOff;
        QCOMPARE(frame["blend_mode"].toString(), isOn ? on : off);
        QCOMPARE(frame["layers"].toArray().at(0)["alpha"].toBool(), isShown);
        QCOMPARE(visitor.client->views().size(), std::size_t(2));
        for (const vr::EyeView& view : visitor.client->views())
            QCOMPARE(view.hasPassthrough, isShown);
    }
    leave(visitor);
}

void TestHeadsetFrames::pulsesAreFelt()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    vr::FrameOutput output;
    output.pulses = {{Side::Right, 0.5, 160, 0.02}};
    visitor.client->answer(output);
    QVERIFY(m_headset->frames(2));
    output.pulses = {{Side::Left, 2, 0, 0}};
    visitor.client->answer(output);
    QVERIFY(m_headset->frames(2));
    const QJsonArray felt = m_headset->report()["haptics"].toArray();
    QCOMPARE(felt.size(), 2);
    const QJsonObject first = felt[0].toObject(), second = felt[1].toObject();
    QVERIFY(first["hand"].toString().contains("right") && second["hand"].toString().contains("left"));
    QCOMPARE(first["amplitude"].toDouble(), 0.5);
    QCOMPARE(first["frequency"].toDouble(), 160.0);
    QCOMPARE(second["amplitude"].toDouble(), 1.0);
    leave(visitor);
}

void TestHeadsetFrames::theClientRecentres_data()
{
    QTest::addColumn<QString>("start");
    QTest::addColumn<double>("height");
    QTest::newRow("the floor is known: it stays") << "'stage': true" << 1.2;
    QTest::newRow("it is not: the eyes are 1.5 m above it") << "'stage': false" << 1.5;
}

/// Checks that recentring puts the head above the origin, looking along -Z, however it was tilted. Then recentres again
/// from another pose.
void TestHeadsetFrames::theClientRecentres()
{
    QFETCH(QString, start);
    QFETCH(double, height);
    m_headset->load(qPrintable("{'start': {'pace': 'stepped', " + start + "}}"));
    Visitor visitor(*m_headset);
    enter(visitor);
    for (const char* head : {"{'head': {'position': [1, 1.2, 2], 'yaw_pitch_roll': [70, 20, 10]}}",
                             "{'head': {'position': [-1, 1.2, 0.5], 'yaw_pitch_roll': [-160, -30, 0]}}"}) {
        m_headset->step(head);
        QVERIFY(m_headset->frames(2));
        const int moves = visitor.client->moves;
        vr::FrameOutput output;
        output.recentre = true;
        visitor.client->answer(output);
        QVERIFY(m_headset->frames(3));
        QCOMPARE(visitor.client->moves, moves + 1);
        const vr::Pose now = *visitor.client->last().head;
        QVERIFY(isClose(now.position, {0, height, 0}));
        QVERIFY(std::abs(now.forward().x()) < 1e-4 && now.forward().z() < 0);
        QVERIFY(std::abs(now.forward().y()) > 0.1);
    }
    leave(visitor);
}

/// Checks that a runtime without a stage space uses the floor of LOCAL_FLOOR, if offered: recentring keeps the eyes'
/// height above it. Runs without the validation layer, which does not know this space.
void TestHeadsetFrames::theFloorIsTheRuntimes()
{
    const auto layer = m_headset->withoutLayer();
    m_headset->load("{'start': {'pace': 'stepped', 'stage': false, 'local_floor': true}}");
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'head': {'position': [1, 1.2, 2], 'yaw_pitch_roll': [70, 20, 10]}}");
    QVERIFY(m_headset->frames(2));
    QVERIFY(isClose(visitor.client->last().head->position, {1, 1.2, 2}));
    vr::FrameOutput output;
    output.recentre = true;
    visitor.client->answer(output);
    QVERIFY(m_headset->frames(3));
    QVERIFY(isClose(visitor.client->last().head->position, {0, 1.2, 0}));
    leave(visitor);
}

/// Checks that the program's own recentring is discarded in the very frame in which the runtime recentres.
void TestHeadsetFrames::theRuntimeRecentres()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    m_headset->step("{'head': {'position': [1, 1.7, 2], 'rotation': [0, 0, 0, 1]}}");
    QVERIFY(m_headset->frames(1));
    vr::FrameOutput output;
    output.recentre = true;
    visitor.client->answer(output);
    QVERIFY(m_headset->frames(2));
    QVERIFY(isClose(visitor.client->last().head->position, {0, 1.7, 0}));

    const int moves = visitor.client->moves;
    m_headset->step("{'recentre': {'space': 'stage', 'position': [0, 0, 5], 'after': 3}}");
    int frames = 0;
    for (; frames < 10 && visitor.client->moves == moves; ++frames) {
        QVERIFY(m_headset->frames(1));
        QVERIFY(isClose(visitor.client->last().head->position,
                        visitor.client->last().roomMoved ? Vec3(1, 1.7, -3) : Vec3(0, 1.7, 0)));
    }
    QVERIFY(frames >= 3 && frames < 10);
    QVERIFY(m_headset->frames(3));
    QCOMPARE(visitor.client->moves, moves + 1);
    QVERIFY(isClose(visitor.client->last().head->position, {1, 1.7, -3}));
    leave(visitor);
}

void TestHeadsetFrames::theClientLeaves()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    vr::FrameOutput output;
    output.leave = true;
    visitor.client->answer(output);
    m_headset->step("{'pace': 'fast'}");
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, vr::HeadsetEnd::Left);
}

void TestHeadsetFrames::lateFramesAreCounted()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(m_headset->frames(5));
    QCOMPARE(visitor.thread.timings().droppedFrames(), quint64(0));
    m_headset->step("{'late_ms': 40}"); // the next frame is displayed four periods of 11.1 ms late
    QVERIFY(m_headset->frames(5));
    QCOMPARE(visitor.thread.timings().droppedFrames(), quint64(4));
    leave(visitor);
}

/// Checks that the phases together take no longer than the frame's work, and that the draw calls' time is counted as a
/// part of the Draw phase.
void TestHeadsetFrames::phasesAreMeasured()
{
    Visitor visitor(*m_headset);
    enter(visitor);
    QVERIFY(m_headset->frames(20));
    leave(visitor);
    const auto timings = visitor.thread.timings().recent();
    QCOMPARE(timings.size(), static_cast<std::size_t>(visitor.client->frames));
    int shown = 0;
    for (const vr::FrameTiming& timing : timings) {
        double work = 0;
        for (const auto phase : {vr::FramePhase::Input, vr::FramePhase::Client, vr::FramePhase::Images,
                                 vr::FramePhase::Draw, vr::FramePhase::Submit})
            work += timing.of(phase);
        QVERIFY(timing.of(vr::FramePhase::Input) > 0 && timing.of(vr::FramePhase::Submit) > 0);
        QVERIFY(work < timing.workMs + 0.5);
        QCOMPARE(timing.of(vr::FramePhase::Draw) > 0, timing.isShown);
        QCOMPARE(timing.drawCallMs > 0, timing.isShown);
        QVERIFY(timing.drawCallMs <= timing.of(vr::FramePhase::Draw));
        shown += timing.isShown ? 1 : 0;
    }
    QVERIFY(shown >= 20);
    QCOMPARE(2 * shown, visitor.client->draws.load());
}

FETTLE_TEST(TestHeadsetFrames, vr::GlxTestApplication)
#include "tst_headset_frames.moc"
