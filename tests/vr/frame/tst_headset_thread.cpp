// Tests of visits to the headset: how they begin, go on and end, and that another visit can follow. Against the
// scripted runtime behind Khronos' validation layer.
#include "tests/support/test_main.h"
#include "tests/vr/simulator/scripted_headset.h"
#include "tests/vr/vr_test.h"

#include "vr/gl/gl_context.h"
#include "vr/openxr/openxr_runtime.h"

#include <QDir>
#include <QElapsedTimer>
#include <QRegularExpression>

#include <openxr/openxr.h>

#include <cstring>

using vr::HeadsetEnd;
using vr::HeadsetStage;

namespace
{
int entriesOf(const char* folder)
{
    return static_cast<int>(QDir(folder).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size());
}

struct Held
{
    int threads = entriesOf("/proc/self/task");
    int files = entriesOf("/proc/self/fd");
};

/// Returns true if the thread polls for events at most every 50 ms during the next `ms` milliseconds.
bool asksSeldom(const ScriptedHeadset& headset, int ms)
{
    QElapsedTimer timer;
    timer.start();
    const int before = headset.calls("xrPollEvent");
    QTest::qWait(ms);
    const int asked = headset.calls("xrPollEvent") - before;
    return asked <= 2 + timer.elapsed() / 50;
}

/// A script with small images, for tests that ignore them.
constexpr const char* small = "{'start': {'size': [64, 72]}}";

/// Time to wait for a runtime that stays frozen.
constexpr auto littlePatience = std::chrono::milliseconds(300);

/// Phase of a visit in which the runtime freezes in a call.
enum class Moment { OnTheWayIn, During, OnTheWayOut };

/// All OpenXR calls of a visit that may fail with an error, except those whose error is an expected answer.
const char* const refusable[] = {
    "xrEnumerateViewConfigurations",
    "xrEnumerateEnvironmentBlendModes",
    "xrEnumerateViewConfigurationViews",
    "xrGetOpenGLGraphicsRequirementsKHR",
    "xrCreateSession",
    "xrEnumerateSwapchainFormats",
    "xrCreateActionSet",
    "xrCreateAction",
    "xrStringToPath",
    "xrAttachSessionActionSets",
    "xrCreateActionSpace",
    "xrEnumerateReferenceSpaces",
    "xrCreateReferenceSpace",
    "xrCreateSwapchain",
    "xrEnumerateSwapchainImages",
    "xrPollEvent",
    "xrBeginSession",
    "xrWaitFrame",
    "xrBeginFrame",
    "xrSyncActions",
    "xrLocateSpace",
    "xrGetActionStateFloat",
    "xrGetActionStateVector2f",
    "xrGetActionStateBoolean",
    "xrGetCurrentInteractionProfile",
    "xrLocateViews",
    "xrAcquireSwapchainImage",
    "xrWaitSwapchainImage",
    "xrReleaseSwapchainImage",
    "xrEndFrame",
};

/// A step for the simulator that refuses OpenGL; %1: the version that the runtime requires.
constexpr const char* refusedOpenGl =
    "{'least_opengl': %1, 'fail': {'call': 'xrCreateSession', 'result': 'XR_ERROR_GRAPHICS_DEVICE_INVALID'}}";
} // namespace

class TestHeadsetThread : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { m_headset->load(small); }
    void cleanup();

    void entersAndLeaves();
    void asksForOpenXr10();
    void asksForOpenXr11IfItMust();
    void entersAgainAndAgain();
    void entersFromTheLastReport();
    void leavesWhenItGoes();
    void leavesBeforeItIsIn();
    void theGuiIsNotWaitedFor();
    void onlyOneAtATime();

    void whatIsNotThereIsAnAnswer_data();
    void whatIsNotThereIsAnAnswer();
    void anOldOpenGlMayBeTaken();
    void anOldOpenGlMayBeRefused();
    void anOpenGlThatIsNotTooOldIsNotBlamed();
    void faults_data();
    void faults();
    void refusals_data();
    void refusals();
    void requestsMayBeRefused_data();
    void requestsMayBeRefused();
    void aClientThatCannotDraw();
    void aRuntimeThatDoesNotReturn();
    void aRuntimeThatTakesItsTime();
    void aFrozenRuntimeIsGivenUp_data();
    void aFrozenRuntimeIsGivenUp();
    void aFrozenRuntimeIsLeftBehind();
    void aRuntimeThatAnswersLateIsWaitedFor();
    void whatIsDrawnIsDoneBeforeTheImagesGo_data();
    void whatIsDrawnIsDoneBeforeTheImagesGo();

    void losesFocusAndGetsItBack();
    void isHidden();
    void isTakenOffAndPutOnAgain();
    void isLeftWhileTakenOff();

private:
    bool isFrozen() const { return m_headset->report()["is_frozen"].toBool(); }
    /// Returns the resources held after an ordinary visit. Drivers keep some of them for the next context.
    Held heldAfterAVisit();

    std::unique_ptr<ScriptedHeadset> m_headset; ///< null if the tests are skipped
};

void TestHeadsetThread::initTestCase()
{
    SKIP_WITHOUT_GLX();
    m_headset = std::make_unique<ScriptedHeadset>();
}

void TestHeadsetThread::cleanup()
{
    if (m_headset)
        QCOMPARE(m_headset->complaints(), QString());
}

void TestHeadsetThread::entersAndLeaves()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enter());
    QVERIFY(visitor.thread.isActive());
    QVERIFY(visitor.waitFor(HeadsetStage::Running));
    QVERIFY(m_headset->frames(10));
    QVERIFY(visitor.leave());

    QList<HeadsetStage> stages;
    for (const vr::HeadsetReport& report : visitor.reports) {
        stages << report.stage;
        QVERIFY(!report.text.isEmpty());
    }
    QCOMPARE(stages, (QList{HeadsetStage::Starting, HeadsetStage::Running, HeadsetStage::Ended}));
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
    QVERIFY(!visitor.thread.isActive());
    QCOMPARE(visitor.client->creates, 1);
    QCOMPARE(visitor.client->destroys, 1);
    QCOMPARE(visitor.client->glErrors, 0);
    QVERIFY(visitor.client->thread != std::this_thread::get_id());
    QVERIFY(visitor.client->draws > 0);
    QCOMPARE(visitor.thread.timings().frames(), quint64(visitor.client->frames));
    QCOMPARE(m_headset->report()["sessions"].toInt(), 1);
    QCOMPARE(m_headset->report()["is_running"].toBool(), false);
}

/// Checks that the client requests OpenXR 1.0: runtimes of that version are common and refuse a client of 1.1.
void TestHeadsetThread::asksForOpenXr10()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QCOMPARE(m_headset->report()["api_minor"].toInt(-1), 0);
    QVERIFY(visitor.leave());
}

/// Checks that a runtime that refuses OpenXR 1.0 is asked for 1.1. The loader must know that version, too; if it does
/// not, the reason is said. Runs without the validation layer, which knows only the version of its headers.
void TestHeadsetThread::asksForOpenXr11IfItMust()
{
    const auto layer = m_headset->withoutLayer();
    m_headset->load("{'start': {'pace': 'fast', 'size': [64, 48], 'api_minors': [1]}}");
    XrInstanceCreateInfo info{};
    info.type = XR_TYPE_INSTANCE_CREATE_INFO;
    std::strcpy(info.applicationInfo.applicationName, "Loader test");
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 1, 0);
    XrInstance probed = XR_NULL_HANDLE;
    const bool isLoaderOf11 = xrCreateInstance(&info, &probed) == XR_SUCCESS;
    if (isLoaderOf11)
        xrDestroyInstance(probed);
    m_headset->load("{'start': {'pace': 'fast', 'size': [64, 48], 'api_minors': [1]}}"); // forgets the refusal
    Visitor visitor(*m_headset);
    if (isLoaderOf11) {
        QVERIFY(visitor.enterAndRun());
        QCOMPARE(m_headset->report()["api_minor"].toInt(-1), 1);
        QVERIFY(visitor.leave());
    } else {
        QVERIFY(visitor.enter());
        QVERIFY(visitor.waitForEnd());
        QCOMPARE(visitor.reports.last().end, HeadsetEnd::Unavailable);
        QVERIFY2(visitor.reports.last().text.contains("newer loader"), qPrintable(visitor.reports.last().text));
    }
    m_headset->load(small);
}

/// Checks that threads, files and contexts are released after each visit.
void TestHeadsetThread::entersAgainAndAgain()
{
    m_headset->load("{'start': {'pace': 'fast', 'size': [64, 72]}}");
    Visitor visitor(*m_headset);
    std::optional<Held> before;
    constexpr int visits = 20;
    for (int i = 0; i < visits; ++i) {
        QVERIFY(visitor.enterAndRun());
        QVERIFY(m_headset->frames(3));
        QVERIFY(visitor.leave());
        QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
        QVERIFY(visitor.client->context.isNull());
        const Held now;
        if (!before)
            before = now; // drivers keep some resources for the next context
        QCOMPARE(now.threads, before->threads);
        QCOMPARE(now.files, before->files);
    }
    QCOMPARE(visitor.client->destroys, visits);
    QCOMPARE(m_headset->report()["sessions"].toInt(), visits);
    QCOMPARE(m_headset->calls("xrDestroyInstance"), visits);
}

void TestHeadsetThread::entersFromTheLastReport()
{
    Visitor visitor(*m_headset);
    int more = 2;
    QObject::connect(&visitor.thread, &vr::HeadsetThread::reported, &visitor.thread,
                     [&](const vr::HeadsetReport& report) {
                         if (report.stage == HeadsetStage::Running)
                             visitor.thread.leave();
                         if (report.isEnded() && more-- > 0)
                             QVERIFY(visitor.enter());
                     });
    QVERIFY(visitor.enter());
    QTRY_COMPARE(visitor.client->destroys, 3);
    QVERIFY(visitor.waitForEnd());
}

void TestHeadsetThread::leavesWhenItGoes()
{
    const auto client = std::make_shared<RecordingClient>();
    {
        Visitor visitor(*m_headset);
        visitor.client = client;
        QVERIFY(visitor.enterAndRun());
    }
    QCOMPARE(client->destroys, 1);
    QVERIFY(client->context.isNull());
    QCOMPARE(m_headset->calls("xrDestroyInstance"), 1);
}

void TestHeadsetThread::leavesBeforeItIsIn()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enter());
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
    QCOMPARE(visitor.reports.size(), 1); // the start is not reported after leaving
    QCOMPARE(visitor.client->creates, visitor.client->destroys);
}

/// Checks that frames do not wait for the gui thread: this thread is the gui thread and runs no event loop meanwhile.
void TestHeadsetThread::theGuiIsNotWaitedFor()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(m_headset->frames(90));
    QVERIFY(visitor.leave());
}

void TestHeadsetThread::onlyOneAtATime()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(!visitor.thread.enter(visitor.client));
    QCOMPARE(vr::OpenXrRuntime::probe().state, vr::HeadsetStatus::State::InUse);
    QVERIFY(visitor.leave());
    const vr::HeadsetStatus status = vr::OpenXrRuntime::probe();
    QCOMPARE(status.state, vr::HeadsetStatus::State::Ready);
    QVERIFY(status.text.contains(status.headset) && status.text.contains(status.runtime));
}

void TestHeadsetThread::whatIsNotThereIsAnAnswer_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no runtime") << "'runtime': false"
                                << "XR_ERROR_RUNTIME_UNAVAILABLE";
    QTest::newRow("no headset") << "'headset': false"
                                << "XR_ERROR_FORM_FACTOR_UNAVAILABLE";
    QTest::newRow("no OpenGL") << "'opengl': false"
                               << "OpenGL";
}

/// Checks the reported reason if OpenXR or the headset is unavailable. Runs without the validation layer, which returns
/// errors of its own.
void TestHeadsetThread::whatIsNotThereIsAnAnswer()
{
    QFETCH(QString, step);
    QFETCH(QString, reason);
    const auto layer = m_headset->withoutLayer();
    m_headset->step(qPrintable("{" + step + "}"));
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enter());
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Unavailable);
    QVERIFY2(visitor.reports.last().text.contains(reason), qPrintable(visitor.reports.last().text));
    QCOMPARE(visitor.reports.last().text, vr::OpenXrRuntime::probe().text);
    QCOMPARE(visitor.client->creates, 0);

    m_headset->load(small);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(visitor.leave());
}

void TestHeadsetThread::anOldOpenGlMayBeTaken()
{
    m_headset->step("{'least_opengl': [9, 7]}");
    QTest::ignoreMessage(QtInfoMsg, QRegularExpression(QStringLiteral("asks for OpenGL 9.7")));
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
}

void TestHeadsetThread::anOldOpenGlMayBeRefused()
{
    m_headset->step(qPrintable(QString(refusedOpenGl).arg("[9, 7]")));
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enter());
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Unavailable);
    const auto [major, minor] = vr::GlContext().context().format().version();
    const QString text = visitor.reports.last().text;
    for (const QString& version : {QStringLiteral("9.7"), QStringLiteral("%1.%2").arg(major).arg(minor)})
        QVERIFY2(text.contains("OpenGL " + version), qPrintable(text));
    QCOMPARE(visitor.client->creates, visitor.client->destroys);
}

/// Checks that the OpenGL version is not blamed if it suffices. A runtime may refuse for other reasons, such as a
/// second graphics card.
void TestHeadsetThread::anOpenGlThatIsNotTooOldIsNotBlamed()
{
    m_headset->step(qPrintable(QString(refusedOpenGl).arg("[3, 3]")));
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enter());
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Failed);
    const QString text = visitor.reports.last().text;
    QVERIFY2(text.contains("xrCreateSession: XR_ERROR_GRAPHICS_DEVICE_INVALID"), qPrintable(text));
}

void TestHeadsetThread::faults_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<HeadsetEnd>("end");
    QTest::newRow("the session is lost at once") << "'lose_session': 0" << HeadsetEnd::SessionLost;
    QTest::newRow("the session will be lost") << "'lose_session': 20" << HeadsetEnd::SessionLost;
    QTest::newRow("the runtime dies at once") << "'lose_instance': 0" << HeadsetEnd::RuntimeLost;
    QTest::newRow("the runtime will die") << "'lose_instance': 20" << HeadsetEnd::RuntimeLost;
    QTest::newRow("the runtime ends it") << "'exit': true" << HeadsetEnd::EndedByRuntime;
    for (const char* call : {"xrWaitFrame", "xrBeginFrame", "xrSyncActions", "xrLocateViews", "xrAcquireSwapchainImage",
                             "xrEndFrame", "xrPollEvent"}) {
        const auto failing = [call](const char* result) {
            return QStringLiteral("'fail': {'call': '%1', 'result': '%2'}").arg(call, result);
        };
        QTest::addRow("the session is lost in %s", call) << failing("XR_ERROR_SESSION_LOST") << HeadsetEnd::SessionLost;
        QTest::addRow("the runtime dies in %s", call) << failing("XR_ERROR_INSTANCE_LOST") << HeadsetEnd::RuntimeLost;
    }
}

/// Checks that each fault ends the visit with a message, and that the next visit works.
void TestHeadsetThread::faults()
{
    QFETCH(QString, step);
    QFETCH(HeadsetEnd, end);
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(m_headset->frames(3));
    m_headset->step(qPrintable("{" + step + "}"));
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, end);
    QVERIFY(!visitor.reports.last().text.isEmpty());
    QCOMPARE(visitor.client->creates, visitor.client->destroys);
    QCOMPARE(m_headset->complaints(), QString());

    m_headset->load(small);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(visitor.leave());
}

void TestHeadsetThread::refusals_data()
{
    QTest::addColumn<QString>("call");
    for (const char* call : refusable)
        QTest::newRow(call) << call;
}

/// Checks that a refused call ends the visit, is named in the report, and that everything begun is ended. Images are
/// asked for in each of the runtime's three colour formats.
void TestHeadsetThread::refusals()
{
    QFETCH(QString, call);
    const bool isOfImages = call == "xrCreateSwapchain" || call == "xrEnumerateSwapchainImages";
    m_headset->step(
        qPrintable(QStringLiteral("{'fail': {'call': '%1', 'result': 'XR_ERROR_RUNTIME_FAILURE', 'times': %2}}")
                       .arg(call)
                       .arg(isOfImages ? 3 : 1)));
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enter());
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Failed);
    QVERIFY2(visitor.reports.last().text.contains(call + ": XR_ERROR_RUNTIME_FAILURE"),
             qPrintable(visitor.reports.last().text));
    QCOMPARE(visitor.client->creates, visitor.client->destroys);
    QVERIFY(visitor.client->context.isNull());
    QCOMPARE(m_headset->calls("xrDestroyInstance"), 1);
    QCOMPARE(m_headset->complaints(), QString());

    QVERIFY(visitor.enterAndRun());
    QVERIFY(visitor.leave());
}

void TestHeadsetThread::requestsMayBeRefused_data()
{
    QTest::addColumn<QString>("call");
    for (const char* call :
         {"xrGetVisibilityMaskKHR", "xrEnumerateDisplayRefreshRatesFB", "xrRequestDisplayRefreshRateFB"})
        QTest::newRow(call) << call;
}

/// Checks that VR is entered even if these optional calls are refused.
void TestHeadsetThread::requestsMayBeRefused()
{
    QFETCH(QString, call);
    m_headset->step(qPrintable(
        QStringLiteral("{'fail': {'call': '%1', 'result': 'XR_ERROR_RUNTIME_FAILURE', 'times': 9}}").arg(call)));
    QTest::ignoreMessage(QtInfoMsg, QRegularExpression(call + ": XR_ERROR_RUNTIME_FAILURE"));
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(m_headset->frames(3));
    QVERIFY(m_headset->calls(qPrintable(call)) > 0);
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
}

void TestHeadsetThread::aClientThatCannotDraw()
{
    Visitor visitor(*m_headset);
    visitor.client->canDraw = false;
    QVERIFY(visitor.enter());
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::CannotRender);
    QCOMPARE(visitor.client->destroys, 1);
    QCOMPARE(m_headset->report()["sessions"].toInt(), 0);
}

/// Tests a runtime that accepts the request to exit but continues the session.
void TestHeadsetThread::aRuntimeThatDoesNotReturn()
{
    m_headset->step("{'fail': {'call': 'xrRequestExitSession', 'result': 'XR_SUCCESS'}}");
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
    QCOMPARE(m_headset->calls("xrDestroySession"), 1);
}

/// Tests a runtime that has ended the session but does not report the final state: the thread must poll rarely
/// meanwhile.
void TestHeadsetThread::aRuntimeThatTakesItsTime()
{
    m_headset->step("{'fail': {'call': 'xrEndSession', 'result': 'XR_SUCCESS'}}");
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    visitor.thread.leave();
    QTRY_COMPARE(visitor.client->idleCalls, 1);
    QVERIFY(asksSeldom(*m_headset, 300));
    QVERIFY(visitor.thread.isActive());
    m_headset->step("{'lose_session': 0}");
    QVERIFY(visitor.waitForEnd());
}

Held TestHeadsetThread::heldAfterAVisit()
{
    Visitor visitor(*m_headset);
    [&] { QVERIFY(visitor.enterAndRun() && m_headset->frames(3) && visitor.leave()); }();
    return {};
}

void TestHeadsetThread::aFrozenRuntimeIsGivenUp_data()
{
    QTest::addColumn<QString>("call");
    QTest::addColumn<Moment>("moment");
    QTest::addColumn<QString>("wakes");
    const QString wakes = QStringLiteral("{'freeze': ''}");
    for (const char* call :
         {"xrCreateInstance", "xrGetSystem", "xrCreateSession", "xrCreateSwapchain", "xrBeginSession"})
        QTest::newRow(call) << call << Moment::OnTheWayIn << wakes;
    for (const char* call : {"xrPollEvent", "xrWaitFrame", "xrBeginFrame", "xrSyncActions", "xrLocateViews",
                             "xrWaitSwapchainImage", "xrEndFrame"})
        QTest::newRow(call) << call << Moment::During << wakes;
    for (const char* call :
         {"xrRequestExitSession", "xrEndSession", "xrDestroySwapchain", "xrDestroySession", "xrDestroyInstance"})
        QTest::newRow(call) << call << Moment::OnTheWayOut << wakes;
    QTest::newRow("it dies") << "xrWaitFrame" << Moment::During << "{'freeze': '', 'lose_instance': 0}";
}

/// Freezes the runtime in a given call. VR can be entered again after the thread has ended, which happens silently when
/// the runtime wakes.
void TestHeadsetThread::aFrozenRuntimeIsGivenUp()
{
    QFETCH(QString, call);
    QFETCH(Moment, moment);
    QFETCH(QString, wakes);
    const Held before = heldAfterAVisit();
    Visitor visitor(*m_headset, littlePatience);
    QVERIFY(moment == Moment::OnTheWayIn || (visitor.enterAndRun() && m_headset->frames(3)));
    m_headset->step(qPrintable("{'freeze': '" + call + "'}"));
    QVERIFY(moment != Moment::OnTheWayIn || visitor.enter());
    QTRY_VERIFY(moment == Moment::OnTheWayOut || isFrozen());
    QVERIFY(!visitor.thread.isStuck());
    visitor.thread.leave();
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::NotResponding);
    QVERIFY2(visitor.reports.last().text.contains("does not answer"), qPrintable(visitor.reports.last().text));
    QTRY_VERIFY(isFrozen());
    QVERIFY(!visitor.thread.isActive() && visitor.thread.isStuck());
    QVERIFY(!visitor.thread.enter(visitor.client));
    QCOMPARE(vr::OpenXrRuntime::probe().state, vr::HeadsetStatus::State::InUse);
    const auto told = visitor.reports.size();

    m_headset->step(qPrintable(wakes));
    QTRY_VERIFY(!visitor.thread.isStuck());
    QCOMPARE(visitor.reports.size(), told);
    QVERIFY(!visitor.thread.isActive());
    QCOMPARE(visitor.client->creates, visitor.client->destroys);
    QVERIFY(visitor.client->context.isNull());
    const Held after;
    QCOMPARE(after.threads, before.threads);
    QCOMPARE(after.files, before.files);
    QCOMPARE(m_headset->complaints(), QString());

    m_headset->load(small);
    QVERIFY(visitor.enterAndRun());
    m_headset->step("{'exit': true}");
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::EndedByRuntime);
}

/// Destroys the HeadsetThread before the frozen runtime wakes. Everything the visit holds is released when it wakes.
void TestHeadsetThread::aFrozenRuntimeIsLeftBehind()
{
    const Held before = heldAfterAVisit();
    const auto client = std::make_shared<RecordingClient>();
    auto thread = std::make_unique<vr::HeadsetThread>(littlePatience);
    QVERIFY(thread->enter(client));
    QTRY_VERIFY(client->frames > 3);
    m_headset->step("{'freeze': 'xrWaitFrame'}");
    QTRY_VERIFY(isFrozen());
    QVERIFY(!vr::RuntimeThread::hasAbandonedWork());
    thread.reset();
    QVERIFY(vr::RuntimeThread::hasAbandonedWork());
    QVERIFY(isFrozen());
    QCOMPARE(client->destroys, 0);

    m_headset->step("{'freeze': ''}");
    QTRY_COMPARE(client.use_count(), 1L);
    QCOMPARE(client->destroys, 1);
    QVERIFY(client->context.isNull());
    QTRY_COMPARE(Held().threads, before.threads);
    QTRY_COMPARE(Held().files, before.files);
    QCOMPARE(m_headset->calls("xrDestroyInstance"), 2);

    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
}

void TestHeadsetThread::aRuntimeThatAnswersLateIsWaitedFor()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    m_headset->step("{'freeze': 'xrWaitFrame'}");
    QTRY_VERIFY(isFrozen());
    const auto told = visitor.reports.size();
    visitor.thread.leave();
    QTest::qWait(500);
    QVERIFY(visitor.thread.isActive() && !visitor.thread.isStuck());
    QCOMPARE(visitor.reports.size(), told);
    m_headset->step("{'freeze': ''}");
    QVERIFY(visitor.waitForEnd());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
}

void TestHeadsetThread::whatIsDrawnIsDoneBeforeTheImagesGo_data()
{
    QTest::addColumn<QString>("step");
    QTest::newRow("left") << "'watch_drawing': true";
    for (const char* call : {"xrEndFrame", "xrPollEvent"})
        QTest::newRow(call) << QStringLiteral(
                                   "'watch_drawing': true, 'fail': {'call': '%1', 'result': 'XR_ERROR_INSTANCE_LOST'}")
                                   .arg(call);
}

/// Checks that drawing has finished before images are destroyed: a runtime may free them at once, and drawing into them
/// would crash. cleanup() checks the runtime's complaints.
void TestHeadsetThread::whatIsDrawnIsDoneBeforeTheImagesGo()
{
    QFETCH(QString, step);
    m_headset->load("{'start': {'size': [4000, 4000]}}");
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    QVERIFY(m_headset->frames(3));
    m_headset->step(qPrintable("{" + step + "}"));
    QVERIFY(step.contains("fail") || m_headset->frames(3));
    visitor.thread.leave();
    QVERIFY(visitor.waitForEnd());
    QVERIFY(m_headset->calls("xrDestroySwapchain") > 0);
}

/// Checks that without focus, actions are not synced and wands are at rest, while drawing continues.
void TestHeadsetThread::losesFocusAndGetsItBack()
{
    Visitor visitor(*m_headset);
    m_headset->step("{'right': {'trigger': 0.7, 'menu': true}}");
    QVERIFY(visitor.enterAndRun());
    QTRY_VERIFY(visitor.client->last().wands[1].menu);
    m_headset->step("{'focus': false}");
    QVERIFY(visitor.waitFor(HeadsetStage::Visible));
    const int syncs = m_headset->calls("xrSyncActions"), draws = visitor.client->draws;
    QVERIFY(m_headset->frames(10));
    QCOMPARE(m_headset->calls("xrSyncActions"), syncs);
    QVERIFY(visitor.client->draws >= draws + 18);
    const vr::WandState wand = visitor.client->last().wands[1];
    QVERIFY(!wand.isActive && !wand.menu && wand.trigger == 0);
    QVERIFY(!visitor.client->last().hasFocus);

    m_headset->step("{'focus': true}");
    QVERIFY(visitor.waitFor(HeadsetStage::Running));
    QTRY_VERIFY(visitor.client->last().wands[1].menu);
    QVERIFY(visitor.leave());
}

void TestHeadsetThread::isHidden()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    m_headset->step("{'visible': false}");
    QVERIFY(visitor.waitFor(HeadsetStage::Hidden));
    const int draws = visitor.client->draws, frames = visitor.client->frames;
    QVERIFY(m_headset->frames(10));
    QCOMPARE(visitor.client->draws, draws);
    QVERIFY(visitor.client->frames >= frames + 9);
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
}

/// Checks that taking the headset off ends the session, and that the thread then polls rarely.
void TestHeadsetThread::isTakenOffAndPutOnAgain()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    m_headset->step("{'worn': false}");
    QVERIFY(visitor.waitFor(HeadsetStage::TakenOff));
    QCOMPARE(m_headset->report()["is_running"].toBool(), false);
    const int frames = visitor.client->frames;
    QVERIFY(asksSeldom(*m_headset, 500));
    QCOMPARE(visitor.client->frames, frames);
    QCOMPARE(visitor.client->idleCalls, 1);

    m_headset->step("{'worn': true}");
    QVERIFY(visitor.waitFor(HeadsetStage::Running));
    QVERIFY(visitor.client->frames > frames);
    QCOMPARE(m_headset->calls("xrBeginSession"), 2);
    QCOMPARE(m_headset->report()["sessions"].toInt(), 1);
    QVERIFY(visitor.leave());
}

void TestHeadsetThread::isLeftWhileTakenOff()
{
    Visitor visitor(*m_headset);
    QVERIFY(visitor.enterAndRun());
    m_headset->step("{'worn': false}");
    QVERIFY(visitor.waitFor(HeadsetStage::TakenOff));
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, HeadsetEnd::Left);
}

FETTLE_TEST(TestHeadsetThread, vr::GlxTestApplication)
#include "tst_headset_thread.moc"
