// Tests of each fault that a script can cause for a client.
#include "tests/support/test_main.h"
#include "tests/vr/simulator/raw_client.h"
#include "tests/vr/simulator/scripted_runtime.h"
#include "tests/vr/vr_test.h"

#include <QElapsedTimer>

#include <atomic>
#include <thread>

namespace
{
int lastFrame(const ScriptedRuntime& runtime)
{
    return runtime.report()["last_frame"].toObject()["number"].toInt();
}
} // namespace

class TestFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void losesAndRegainsFocus();
    void isTakenOffAndPutOnAgain();
    void isAskedToStop();
    void losesTheSession();
    void losesTheInstance();
    void isNotThere();
    void changesSize();
    void offersOneView();
    void isLate();
    void pacesFrames();
    void stepsFrames();
    void hidesFrames();
    void answersInACallsStead();
    void freezes();
};

void TestFaults::losesAndRegainsFocus()
{
    ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48]}, "steps": [
        {"frame": 10, "focus": false}, {"frame": 20, "visible": false},
        {"frame": 30, "visible": true, "focus": true}]})");
    RawClient client;
    QSUCCEEDS(client.enter());
    client.states.clear();
    for (int i = 0; i < 40; ++i)
        QSUCCEEDS(client.frame());
    const std::vector expected{XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE,
                               XR_SESSION_STATE_FOCUSED};
    QVERIFY(client.states == expected);
}

void TestFaults::isTakenOffAndPutOnAgain()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    runtime.set(R"({"worn": false})");
    QSUCCEEDS(client.framesUntil(XR_SESSION_STATE_IDLE));
    QVERIFY(!client.isRunning);
    runtime.set(R"({"worn": true})");
    QSUCCEEDS(client.framesUntil(XR_SESSION_STATE_FOCUSED));
    QCOMPARE(runtime.clientErrors(), QStringList());
}

void TestFaults::isAskedToStop()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    runtime.set(R"({"exit": true})");
    QSUCCEEDS(client.framesUntil(XR_SESSION_STATE_EXITING));
}

void TestFaults::losesTheSession()
{
    ScriptedRuntime runtime(
        R"({"start": {"pace": "fast", "size": [64, 48]}, "steps": [{"frame": 10, "lose_session": 5}]})");
    RawClient client;
    QSUCCEEDS(client.createInstance());
    QSUCCEEDS(client.prepare());
    QSUCCEEDS(client.framesUntil(XR_SESSION_STATE_LOSS_PENDING));
    XrResult result = XR_SESSION_LOSS_PENDING;
    while (result == XR_SESSION_LOSS_PENDING)
        result = client.frame();
    QCOMPARE(result, XR_ERROR_SESSION_LOST);
    QCOMPARE(lastFrame(runtime), 14);
    std::uint32_t image = 0;
    QCOMPARE(xrAcquireSwapchainImage(client.eyes[0].swapchain, nullptr, &image), XR_ERROR_SESSION_LOST);
    QSUCCEEDS(xrDestroySwapchain(client.eyes[0].swapchain));
    QSUCCEEDS(xrDestroySession(client.session));
    QSUCCEEDS(client.prepare());
    client.states.clear();
    QSUCCEEDS(client.framesUntil(XR_SESSION_STATE_FOCUSED));
}

void TestFaults::losesTheInstance()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    runtime.set(R"({"lose_instance": 0, "runtime": false})");
    QCOMPARE(client.frame(), XR_ERROR_INSTANCE_LOST);
    QCOMPARE(xrRequestExitSession(client.session), XR_ERROR_INSTANCE_LOST);
    XrSystemId system = 0;
    const XrSystemGetInfo wanted{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
    QCOMPARE(xrGetSystem(client.instance, &wanted, &system), XR_ERROR_INSTANCE_LOST);
    QSUCCEEDS(xrDestroySession(client.session));
    QSUCCEEDS(xrDestroyInstance(client.instance));
    client.instance = XR_NULL_HANDLE;
    QCOMPARE(client.createInstance(), XR_ERROR_RUNTIME_UNAVAILABLE);
    runtime.set(R"({"runtime": true})");
    client.states.clear();
    QSUCCEEDS(client.enter());
    QCOMPARE(runtime.clientErrors(), QStringList());
}

void TestFaults::isNotThere()
{
    ScriptedRuntime runtime(R"({"start": {"headset": false}})");
    RawClient client;
    QCOMPARE(client.createInstance(), XR_ERROR_FORM_FACTOR_UNAVAILABLE);
    QSUCCEEDS(xrDestroyInstance(client.instance));
    client.instance = XR_NULL_HANDLE;
    runtime.set(R"({"opengl": false})");
    QCOMPARE(client.createInstance(), XR_ERROR_EXTENSION_NOT_PRESENT);
}

void TestFaults::changesSize()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    QCOMPARE(client.eyes[0].size.width, 64);
    runtime.set(R"({"size": [30, 20]})");
    QSUCCEEDS(client.frame());
    QSUCCEEDS(client.leave());
    QSUCCEEDS(xrDestroySession(client.session));
    QSUCCEEDS(client.prepare());
    QCOMPARE(client.eyes[0].size.width, 30);
    QCOMPARE(client.eyes[0].size.height, 20);
}

void TestFaults::offersOneView()
{
    ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48], "views": "mono"}})");
    RawClient client;
    QSUCCEEDS(client.createInstance());
    std::uint32_t count = 0;
    XrViewConfigurationType type = XR_VIEW_CONFIGURATION_TYPE_MAX_ENUM;
    QSUCCEEDS(xrEnumerateViewConfigurations(client.instance, client.system, 1, &count, &type));
    QCOMPARE(type, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_MONO);
    QCOMPARE(client.createSession(), XR_SUCCESS);
    QCOMPARE(client.createSwapchains(), XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED);
    client.views = type;
    QSUCCEEDS(client.createSwapchains());
    QCOMPARE(client.eyes.size(), std::size_t(1));
    QSUCCEEDS(client.createSpaces());
    QSUCCEEDS(client.framesUntil(XR_SESSION_STATE_FOCUSED));
    QCOMPARE(runtime.clientWarnings(), QStringList());
}

void TestFaults::isLate()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    const XrTime before = client.frameState.predictedDisplayTime;
    runtime.set(R"({"late_ms": 30})");
    QElapsedTimer timer;
    timer.start();
    QSUCCEEDS(client.frame());
    QVERIFY(timer.elapsed() >= 30);
    QCOMPARE(client.frameState.predictedDisplayTime, before + 4 * client.frameState.predictedDisplayPeriod);
}

void TestFaults::pacesFrames()
{
    ScriptedRuntime runtime(R"({"start": {"size": [64, 48], "hz": 50}})");
    RawClient client;
    QSUCCEEDS(client.enter());
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 5; ++i)
        QSUCCEEDS(client.frame());
    QVERIFY(timer.elapsed() >= 80);
    runtime.set(R"({"hz": 5})");
    timer.start(); // the runtime begins the second frame one period after the first
    QSUCCEEDS(client.frame());
    QCOMPARE(client.frameState.predictedDisplayPeriod, 200'000'000);
    QSUCCEEDS(client.frame());
    QVERIFY(timer.elapsed() >= 199);
}

void TestFaults::stepsFrames()
{
    ScriptedRuntime runtime(R"({"start": {"pace": "stepped", "size": [64, 48]}})");
    XrResult result = XR_ERROR_RUNTIME_FAILURE;
    std::thread aside([&] {
        RawClient client;
        result = client.enter();
        while (XR_SUCCEEDED(result) && client.states.back() != XR_SESSION_STATE_EXITING)
            result = client.frame();
    });
    QVERIFY(runtime.frames(5));
    QCOMPARE(lastFrame(runtime), 4);
    QCOMPARE(runtime.report()["state"].toString(), QString("XR_SESSION_STATE_FOCUSED"));
    QVERIFY(runtime.frames(2));
    QCOMPARE(lastFrame(runtime), 6);
    runtime.set(R"({"exit": true, "pace": "fast"})");
    aside.join();
    QSUCCEEDS(result);
    QCOMPARE(runtime.clientErrors(), QStringList());
}

void TestFaults::hidesFrames()
{
    ScriptedRuntime runtime(R"({"start": {"pace": "fast", "size": [64, 48]}, "steps": [
        {"frame": 10, "should_render": false}, {"frame": 12, "should_render": true}]})");
    RawClient client;
    QSUCCEEDS(client.enter());
    QList<bool> seen;
    for (int i = 3; i < 14; ++i) {
        QSUCCEEDS(client.frame());
        seen << (client.frameState.shouldRender == XR_TRUE);
    }
    QCOMPARE(seen, QList<bool>({true, true, true, true, true, true, true, false, false, true, true}));
}

void TestFaults::answersInACallsStead()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.createInstance());
    QSUCCEEDS(client.createSession());
    runtime.set(R"({"fail": {"call": "xrCreateSwapchain", "result": "XR_ERROR_OUT_OF_MEMORY", "times": 1}})");
    QCOMPARE(client.createSwapchains(), XR_ERROR_OUT_OF_MEMORY);
    QSUCCEEDS(client.createSwapchains());
    QCOMPARE(runtime.clientErrors(), QStringList());
}

/// Checks that a frozen call continues when another call is named, and that other calls are answered meanwhile.
void TestFaults::freezes()
{
    ScriptedRuntime runtime(fastScript());
    RawClient client;
    QSUCCEEDS(client.enter());
    runtime.set(R"({"freeze": "xrEndFrame"})");
    std::atomic<bool> isOver = false;
    XrResult result = XR_ERROR_RUNTIME_FAILURE;
    std::thread waker([&] {
        while (!runtime.report()["is_frozen"].toBool())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const int before = lastFrame(runtime);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        result = isOver || lastFrame(runtime) != before ? XR_ERROR_RUNTIME_FAILURE : XR_SUCCESS;
        runtime.set(R"({"freeze": ""})");
    });
    const XrResult ended = client.frame();
    isOver = true;
    waker.join();
    QSUCCEEDS(ended);
    QSUCCEEDS(result);
    QVERIFY(!runtime.report()["is_frozen"].toBool());
    QCOMPARE(runtime.clientErrors(), QStringList());
}

FETTLE_TEST(TestFaults, vr::GlxTestApplication)
#include "tst_faults.moc"
