// Tests of the scripted runtime itself, which other tests rely on: it follows the specification, executes its script,
// and detects a client's errors.
#include "tests/support/test_main.h"
#include "tests/vr/simulator/raw_client.h"
#include "tests/vr/simulator/scripted_runtime.h"
#include "tests/vr/vr_test.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QTemporaryDir>

#include <chrono>
#include <thread>

namespace
{
QList<QJsonObject> lines(const QString& path)
{
    QFile file(path);
    QList<QJsonObject> found;
    if (!file.open(QIODevice::ReadOnly))
        return found;
    while (!file.atEnd())
        found << QJsonDocument::fromJson(file.readLine()).object();
    return found;
}
} // namespace

class TestRuntime : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }
    void init();

    void followsTheEnvironment(); // must be first: later tests load scripts of their own
    void livesThroughASession();
    void keepsPictures();
    void showsPictures();
    void liveTime_isTheClocks();
    void keepsQuads();
    void writesALog();
    void isTheSameEveryTime();
    void givesTheContextBack();
    void passesTheValidationLayer();
    void comesAgain();

    void refusesWrongOrder();
    void refusesBadLayers_data();
    void refusesBadLayers();
    void warnsOfWhatSwims();

    void refusesBadScripts_data();
    void refusesBadScripts();
};

void TestRuntime::init()
{
    qunsetenv("FETTLE_XR_LOG");
    qunsetenv("FETTLE_XR_FRAMES");
    qunsetenv("XR_ENABLE_API_LAYERS");
}

void TestRuntime::followsTheEnvironment()
{
    QTemporaryDir folder;
    QFile script(folder.filePath("script"));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write(R"({"start": {"pace": "fast", "size": [20, 10]}})");
    script.close();
    qputenv("FETTLE_XR_SCRIPT", script.fileName().toUtf8());
    ScriptedRuntime::choose();
    RawClient client;
    QSUCCEEDS(client.enter());
    QCOMPARE(client.eyes[0].size.width, 20);
    QCOMPARE(client.eyes[1].size.height, 10);
}

void TestRuntime::livesThroughASession()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    QVERIFY(client.frameState.predictedDisplayPeriod == 11'111'111);
    const XrTime before = client.frameState.predictedDisplayTime;
    QSUCCEEDS(client.frame());
    QVERIFY(client.frameState.shouldRender);
    QCOMPARE(client.frameState.predictedDisplayTime, before + client.frameState.predictedDisplayPeriod);
    QSUCCEEDS(client.leave());
    const std::vector expected{XR_SESSION_STATE_IDLE,         XR_SESSION_STATE_READY,    XR_SESSION_STATE_SYNCHRONIZED,
                               XR_SESSION_STATE_VISIBLE,      XR_SESSION_STATE_FOCUSED,  XR_SESSION_STATE_VISIBLE,
                               XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_STOPPING, XR_SESSION_STATE_IDLE,
                               XR_SESSION_STATE_EXITING};
    QVERIFY(client.states == expected);
    QSUCCEEDS(xrDestroySession(client.session));
    QCOMPARE(runtime.clientErrors(), QStringList());
    QCOMPARE(runtime.clientWarnings(), QStringList());
}

void TestRuntime::keepsPictures()
{
    QTemporaryDir folder;
    qputenv("FETTLE_XR_FRAMES", folder.path().toUtf8());
    ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48], "keep": [4]}})");
    RawClient client;
    QSUCCEEDS(client.enter());
    while (client.frameState.predictedDisplayTime < 2'000'000'000)
        QSUCCEEDS(client.frame());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
             QStringList({"session0_frame0004_left.png", "session0_frame0004_right.png"}));
    const QImage left(folder.filePath("session0_frame0004_left.png"));
    const QImage right(folder.filePath("session0_frame0004_right.png"));
    QCOMPARE(left.size(), QSize(64, 48));
    QCOMPARE(left.pixel(0, 0), qRgb(0, 0, 255));
    QCOMPARE(left.pixel(63, 23), qRgb(0, 0, 255));
    QCOMPARE(left.pixel(0, 24), qRgb(255, 0, 0));
    QCOMPARE(left.pixel(63, 47), qRgb(255, 0, 0));
    QCOMPARE(right.pixel(32, 24), qRgb(0, 255, 0));
}

/// Checks that images are made only when requested, and that each is shown once.
void TestRuntime::showsPictures()
{
    ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48]}})");
    QVERIFY(runtime.picture().isNull());
    RawClient client;
    QSUCCEEDS(client.enter());
    const QImage first = runtime.picture();
    QCOMPARE(first.size(), QSize(64, 48));
    QCOMPARE(first.pixel(32, 0), qRgb(0, 0, 255));
    QCOMPARE(first.pixel(32, 47), qRgb(255, 0, 0));
    QVERIFY(runtime.picture().isNull());
    QSUCCEEDS(client.frame());
    QVERIFY(!runtime.picture().isNull());
    QSUCCEEDS(client.frame());
    runtime.set(R"({"should_render": false})"); // no new image from now on; the last one drawn is still shown once
    QSUCCEEDS(client.frame());
    QVERIFY(!runtime.picture().isNull());
    QSUCCEEDS(client.frame());
    QVERIFY(runtime.picture().isNull());
}

/// Tests a client that is slower than the display: predicted time follows the clock at pace "live", and counts the
/// client's frames at pace "real".
void TestRuntime::liveTime_isTheClocks()
{
    constexpr int frames = 8;
    constexpr auto slowness = std::chrono::milliseconds(30);
    for (const bool isLive : {false, true}) {
        ScriptedRuntime runtime(isLive ? R"({"start": {"pace": "live", "hz": 100}})"
                                       : R"({"start": {"pace": "real", "hz": 100}})");
        RawClient client;
        QSUCCEEDS(client.enter());
        const XrTime first = client.frameState.predictedDisplayTime;
        for (int i = 0; i < frames; ++i)
            QSUCCEEDS(client.frame([&] { std::this_thread::sleep_for(slowness); }));
        const XrTime passed = client.frameState.predictedDisplayTime - first;
        constexpr XrTime period = 10'000'000;
        QCOMPARE(passed % period, 0);
        if (isLive)
            QVERIFY2(passed >= (frames - 1) * std::chrono::nanoseconds(slowness).count() - period,
                     qPrintable(QString::number(passed)));
        else
            QCOMPARE(passed, frames * period);
    }
}

/// Checks images of two quad layers: one with alpha, in a linear format, on the second layer of an array texture, and
/// one opaque.
void TestRuntime::keepsQuads()
{
    constexpr std::int64_t linear = 0x8058, texture2DArray = 0x8C1A; // GL_RGBA8, GL_TEXTURE_2D_ARRAY
    QTemporaryDir folder;
    qputenv("FETTLE_XR_FRAMES", folder.path().toUtf8());
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    RawClient::Eye panel;
    panel.size = {8, 4};
    const XrSwapchainCreateInfo info{
        XR_TYPE_SWAPCHAIN_CREATE_INFO, nullptr, 0, XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT, linear, 1, 8, 4, 1, 2, 1};
    QSUCCEEDS(client.createSwapchain(info, panel));
    std::uint32_t image = 0;
    QSUCCEEDS(xrAcquireSwapchainImage(panel.swapchain, nullptr, &image));
    const XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, 0};
    QSUCCEEDS(xrWaitSwapchainImage(panel.swapchain, &wait));
    const std::vector<unsigned char> grey(8 * 4 * 4, 55); // red, green, blue and alpha of each pixel
    client.gl.functions()->glBindTexture(texture2DArray, panel.images[image]);
    client.gl.extraFunctions()->glTexSubImage3D(texture2DArray, 0, 0, 0, 1, 8, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                                                grey.data());
    QSUCCEEDS(xrReleaseSwapchainImage(panel.swapchain, nullptr));
    XrCompositionLayerQuad quads[2]{};
    for (XrCompositionLayerQuad& quad : quads)
        quad = {XR_TYPE_COMPOSITION_LAYER_QUAD,
                nullptr,
                0,
                client.local,
                XR_EYE_VISIBILITY_BOTH,
                {panel.swapchain, {{2, 0}, {6, 4}}, 1},
                {{0, 0, 0, 1}, {0, 0, -1}},
                {0.5F, 0.3F}};
    quads[0].layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    const XrCompositionLayerBaseHeader* layers[]{reinterpret_cast<XrCompositionLayerBaseHeader*>(&quads[0]),
                                                 reinterpret_cast<XrCompositionLayerBaseHeader*>(&quads[1])};
    runtime.set(R"({"keep": true})");
    QSUCCEEDS(xrWaitFrame(client.session, nullptr, &client.frameState));
    QSUCCEEDS(xrBeginFrame(client.session, nullptr));
    const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,           nullptr, client.frameState.predictedDisplayTime,
                             XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 2,       layers};
    QSUCCEEDS(xrEndFrame(client.session, &end));
    const QImage through(folder.filePath("session0_frame0003_quad0.png")),
        covering(folder.filePath("session0_frame0003_quad1.png"));
    QCOMPARE(through.size(), QSize(6, 4));
    QCOMPARE(through.pixel(3, 2), qRgba(128, 128, 128, 55)); // linear 55 of 255 is sRGB 128
    QCOMPARE(covering.pixel(3, 2), qRgba(128, 128, 128, 255));
    QCOMPARE(runtime.clientErrors(), QStringList());
}

void TestRuntime::writesALog()
{
    QTemporaryDir folder;
    qputenv("FETTLE_XR_LOG", folder.filePath("log").toUtf8());
    ScriptedRuntime runtime(fastScript());
    {
        RawClient client;
        QSUCCEEDS(client.enter());
        QSUCCEEDS(client.frame());
        QCOMPARE(xrBeginFrame(client.session, nullptr), XR_ERROR_CALL_ORDER_INVALID);
    }
    int begun = 0, shown = 0;
    QStringList complaints;
    for (const QJsonObject& line : lines(folder.filePath("log"))) {
        begun += line["call"] == "xrBeginFrame" && line["result"] == "XR_SUCCESS" ? 1 : 0;
        const QJsonObject frame = line["ended_frame"].toObject();
        const QJsonArray layers = frame["layers"].toArray();
        if (!layers.isEmpty()) {
            ++shown;
            QCOMPARE(layers[0]["space"].toString(), QString("local"));
            QCOMPARE(layers[0]["views"].toArray().size(), 2);
        }
        if (line.contains("client_error"))
            complaints << line["client_error"].toString();
    }
    QCOMPARE(begun, 4);
    QCOMPARE(shown, 2);
    QCOMPARE(complaints, QStringList("xrBeginFrame: XR_ERROR_CALL_ORDER_INVALID, no frame was waited for"));
}

void TestRuntime::isTheSameEveryTime()
{
    QTemporaryDir folder;
    QList<QByteArray> logs;
    for (int run = 0; run < 2; ++run) {
        const QString path = folder.filePath(QString::number(run));
        qputenv("FETTLE_XR_LOG", path.toUtf8());
        ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48]}, "steps": [{"frame": 4, "late_ms": 5},
            {"frame": 6, "over": 20, "head": {"position": [1, 1, 1]}}, {"frame": 20, "focus": false}]})");
        RawClient client;
        QSUCCEEDS(client.enter());
        for (int i = 0; i < 30; ++i)
            QSUCCEEDS(client.frame());
        QFile log(path);
        QVERIFY(log.open(QIODevice::ReadOnly));
        logs << log.readAll();
    }
    QVERIFY(logs[0].count('\n') > 300);
    QVERIFY(logs[0] == logs[1]);
}

void TestRuntime::givesTheContextBack()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.createInstance());
    QSUCCEEDS(client.prepare());
    QVERIFY(client.gl.functions()->glIsTexture(client.eyes[0].images[2]));
    client.gl.doneCurrent();
    XrSwapchain extra = XR_NULL_HANDLE;
    const XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO, nullptr, 0, 0, 0x8058, 1, 8, 8, 1, 1, 1};
    QSUCCEEDS(xrCreateSwapchain(client.session, &info, &extra));
    QCOMPARE(runtime.clientWarnings().size(), 1);
    QVERIFY(client.gl.makeCurrent(&client.surface));
}

void TestRuntime::passesTheValidationLayer()
{
    QTemporaryDir folder;
    qputenv("XR_ENABLE_API_LAYERS", "XR_APILAYER_LUNARG_core_validation");
    qputenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text");
    qputenv("XR_CORE_VALIDATION_FILE_NAME", folder.filePath("said").toUtf8());
    std::uint32_t count = 0;
    QSUCCEEDS(xrEnumerateApiLayerProperties(0, &count, nullptr));
    if (count == 0)
        QSKIP("openxr-layer-corevalidation is not installed");
    ScriptedRuntime runtime(fastScript());
    {
        RawClient client;
        QSUCCEEDS(client.enter());
        QSUCCEEDS(client.leave());
        QSUCCEEDS(xrDestroySession(client.session));
    }
    QCOMPARE(layerComplaints(folder.filePath("said")), QStringList());
    {
        RawClient client;
        QSUCCEEDS(client.createInstance());
        QCOMPARE(xrDestroySession(XR_NULL_HANDLE), XR_ERROR_HANDLE_INVALID);
    }
    QVERIFY(!layerComplaints(folder.filePath("said")).isEmpty()); // otherwise the layer was never active
}

void TestRuntime::comesAgain()
{
    ScriptedRuntime runtime(fastScript());
    for (int i = 0; i < 3; ++i) {
        RawClient client;
        QSUCCEEDS(client.enter());
        QCOMPARE(runtime.report()["sessions"].toInt(), i + 1);
    }
    QCOMPARE(runtime.clientErrors(), QStringList());
}

void TestRuntime::refusesWrongOrder()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.createInstance());
    QSUCCEEDS(client.prepare());
    XrFrameState state{XR_TYPE_FRAME_STATE, nullptr, 0, 0, XR_FALSE};
    const XrFrameEndInfo nothing{XR_TYPE_FRAME_END_INFO, nullptr, 1, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0, nullptr};
    const XrSessionBeginInfo begin{XR_TYPE_SESSION_BEGIN_INFO, nullptr, client.views};
    QCOMPARE(xrWaitFrame(client.session, nullptr, &state), XR_ERROR_SESSION_NOT_RUNNING);
    QCOMPARE(xrEndSession(client.session), XR_ERROR_SESSION_NOT_RUNNING);
    QCOMPARE(xrRequestExitSession(client.session), XR_ERROR_SESSION_NOT_RUNNING);
    QSUCCEEDS(xrBeginSession(client.session, &begin));
    QCOMPARE(xrBeginSession(client.session, &begin), XR_ERROR_SESSION_RUNNING);
    QCOMPARE(xrBeginFrame(client.session, nullptr), XR_ERROR_CALL_ORDER_INVALID);
    QCOMPARE(xrEndFrame(client.session, &nothing), XR_ERROR_CALL_ORDER_INVALID);
    QCOMPARE(xrEndSession(client.session), XR_ERROR_SESSION_NOT_STOPPING);
    QSUCCEEDS(xrWaitFrame(client.session, nullptr, &state));
    QSUCCEEDS(xrBeginFrame(client.session, nullptr));
    QSUCCEEDS(xrWaitFrame(client.session, nullptr, &state));
    const int before = static_cast<int>(runtime.clientErrors().size());
    QCOMPARE(xrBeginFrame(client.session, nullptr), XR_FRAME_DISCARDED);
    QCOMPARE(runtime.clientErrors().size(), before + 1);

    const XrSwapchain swapchain = client.eyes[0].swapchain;
    const XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, 0};
    std::uint32_t image = 0;
    QCOMPARE(xrWaitSwapchainImage(swapchain, &wait), XR_ERROR_CALL_ORDER_INVALID);
    for (std::uint32_t i = 0; i < 3; ++i) {
        QSUCCEEDS(xrAcquireSwapchainImage(swapchain, nullptr, &image));
        QCOMPARE(image, i);
    }
    QCOMPARE(xrAcquireSwapchainImage(swapchain, nullptr, &image), XR_ERROR_CALL_ORDER_INVALID);
    QCOMPARE(xrReleaseSwapchainImage(swapchain, nullptr), XR_ERROR_CALL_ORDER_INVALID);
    QSUCCEEDS(xrWaitSwapchainImage(swapchain, &wait));
    QCOMPARE(xrWaitSwapchainImage(swapchain, &wait), XR_ERROR_CALL_ORDER_INVALID);
    QSUCCEEDS(xrReleaseSwapchainImage(swapchain, nullptr));
    QSUCCEEDS(xrAcquireSwapchainImage(swapchain, nullptr, &image));
    QCOMPARE(image, 0U);

    QSUCCEEDS(xrDestroySession(client.session));
    QCOMPARE(xrDestroySwapchain(swapchain), XR_ERROR_HANDLE_INVALID);
}

void TestRuntime::refusesBadLayers_data()
{
    using Spoil =
        std::function<void(XrFrameEndInfo&, XrCompositionLayerProjection&, XrCompositionLayerProjectionView&)>;
    using End = XrFrameEndInfo;
    using Layer = XrCompositionLayerProjection;
    using View = XrCompositionLayerProjectionView;
    QTest::addColumn<Spoil>("spoil");
    QTest::addColumn<int>("result");
    const auto row = [](const char* name, const Spoil& spoil, XrResult result) {
        QTest::newRow(name) << spoil << static_cast<int>(result);
    };
    row(
        "nothing is wrong", [](End&, Layer&, View&) {}, XR_SUCCESS);
    row(
        "time", [](End& end, Layer&, View&) { end.displayTime = 0; }, XR_ERROR_TIME_INVALID);
    row(
        "blend mode", [](End& end, Layer&, View&) { end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE; },
        XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED);
    row(
        "too many layers", [](End& end, Layer&, View&) { end.layerCount = 1000; }, XR_ERROR_LAYER_LIMIT_EXCEEDED);
    row(
        "unknown layer", [](End&, Layer& layer, View&) { layer.type = XR_TYPE_COMPOSITION_LAYER_CUBE_KHR; },
        XR_ERROR_LAYER_INVALID);
    row(
        "no space", [](End&, Layer& layer, View&) { layer.space = XR_NULL_HANDLE; }, XR_ERROR_HANDLE_INVALID);
    row(
        "one view", [](End&, Layer& layer, View&) { layer.viewCount = 1; }, XR_ERROR_VALIDATION_FAILURE);
    row(
        "no rotation",
        [](End&, Layer&, View& view) {
            view.pose.orientation = {0, 0, 0, 0};
        },
        XR_ERROR_POSE_INVALID);
    row(
        "wide view", [](End&, Layer&, View& view) { view.fov.angleUp = 1.6F; }, XR_ERROR_VALIDATION_FAILURE);
    row(
        "wide rectangle", [](End&, Layer&, View& view) { view.subImage.imageRect.extent.width += 1; },
        XR_ERROR_SWAPCHAIN_RECT_INVALID);
    row(
        "array layer", [](End&, Layer&, View& view) { view.subImage.imageArrayIndex = 1; },
        XR_ERROR_VALIDATION_FAILURE);
}

void TestRuntime::refusesBadLayers()
{
    using Spoil =
        std::function<void(XrFrameEndInfo&, XrCompositionLayerProjection&, XrCompositionLayerProjectionView&)>;
    QFETCH(Spoil, spoil);
    QFETCH(int, result);
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    QSUCCEEDS(xrWaitFrame(client.session, nullptr, &client.frameState));
    QSUCCEEDS(xrBeginFrame(client.session, nullptr));
    std::vector<XrCompositionLayerProjectionView> views;
    client.putProjection(views);
    XrCompositionLayerProjection layer{XR_TYPE_COMPOSITION_LAYER_PROJECTION, nullptr, 0, client.local, 2, views.data()};
    const auto* layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
    XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,           nullptr, client.frameState.predictedDisplayTime,
                       XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 1,       &layers};
    spoil(end, layer, views[1]);
    QCOMPARE(static_cast<int>(xrEndFrame(client.session, &end)), result);
    QCOMPARE(runtime.clientErrors().isEmpty(), result == XR_SUCCESS);
}

void TestRuntime::warnsOfWhatSwims()
{
    ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48]}, "steps": [
        {"frame": 5, "over": 90, "head": {"position": [1, 1.6, 0]}}]})");
    RawClient client;
    QSUCCEEDS(client.enter());
    for (int i = 0; i < 5; ++i)
        QSUCCEEDS(client.frame());
    QCOMPARE(runtime.clientWarnings(), QStringList());
    QSUCCEEDS(client.frame([&] { client.frameState.predictedDisplayTime += 100'000'000; }));
    QCOMPARE(runtime.clientWarnings().size(), 3); // one for each view, and one for the display time
}

void TestRuntime::refusesBadScripts_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::newRow("not JSON") << QByteArray("{");
    QTest::newRow("unknown") << QByteArray(R"({"start": {"headdset": true}})");
    QTest::newRow("unknown of a wand") << QByteArray(R"({"start": {"left": {"tigger": 1}}})");
    QTest::newRow("no frame") << QByteArray(R"({"steps": [{"focus": false}]})");
    QTest::newRow("type") << QByteArray(R"({"start": {"focus": 1}})");
    QTest::newRow("quaternion") << QByteArray(R"({"start": {"head": {"rotation": [1, 1, 0, 0]}}})");
    QTest::newRow("profile") << QByteArray(R"({"start": {"profile": "/interaction_profiles/acme/stick"}})");
    QTest::newRow("result") << QByteArray(R"({"start": {"fail": {"call": "xrWaitFrame", "result": "XR_OH_NO"}}})");
}

void TestRuntime::refusesBadScripts()
{
    QFETCH(QByteArray, script);
    ScriptedRuntime runtime(fastScript());
    QVERIFY(!ScriptedRuntime::load(script).isEmpty());
}

FETTLE_TEST(TestRuntime, vr::GlxTestApplication)
#include "tst_runtime.moc"
