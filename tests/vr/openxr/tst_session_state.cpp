#include "vr/openxr/session_state.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <vector>

using vr::SessionStatus;
using vr::SessionStep;

namespace
{
/// All states that OpenXR defines, and an unknown one.
const XrSessionState states[] = {
    XR_SESSION_STATE_UNKNOWN,          XR_SESSION_STATE_IDLE,    XR_SESSION_STATE_READY,
    XR_SESSION_STATE_SYNCHRONIZED,     XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED,
    XR_SESSION_STATE_STOPPING,         XR_SESSION_STATE_EXITING, XR_SESSION_STATE_LOSS_PENDING,
    static_cast<XrSessionState>(1234),
};

/// States in which a session has frames.
const std::vector<XrSessionState> running{XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED,
                                          XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED};

std::vector<SessionStatus> statuses()
{
    std::vector<SessionStatus> all;
    for (const XrSessionState state : states)
        for (const bool isRunning : {false, true})
            for (const bool isExiting : {false, true})
                all.push_back({state, isRunning, isExiting});
    return all;
}

/// Returns the states that a runtime may report next, by the specification's state diagram. Loss may follow any state.
std::vector<XrSessionState> successors(XrSessionState state)
{
    switch (state) {
    case XR_SESSION_STATE_UNKNOWN:
        return {XR_SESSION_STATE_IDLE};
    case XR_SESSION_STATE_IDLE:
        return {XR_SESSION_STATE_READY, XR_SESSION_STATE_EXITING};
    case XR_SESSION_STATE_READY:
        return {XR_SESSION_STATE_SYNCHRONIZED};
    case XR_SESSION_STATE_SYNCHRONIZED:
        return {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_STOPPING};
    case XR_SESSION_STATE_VISIBLE:
        return {XR_SESSION_STATE_FOCUSED, XR_SESSION_STATE_SYNCHRONIZED};
    case XR_SESSION_STATE_FOCUSED:
        return {XR_SESSION_STATE_VISIBLE};
    case XR_SESSION_STATE_STOPPING:
        return {XR_SESSION_STATE_IDLE};
    default:
        return {};
    }
}
} // namespace

class TestSessionState : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stepsAreAllowedAsThingsStand();
    void whatWasToldIsRemembered();
    void aLifeAsInTheSpecification();
    void leavingComesToAnEnd();
    void onlyTheFocusedHaveInput();
};

void TestSessionState::stepsAreAllowedAsThingsStand()
{
    for (const SessionStatus& status : statuses()) {
        for (const XrSessionState told : states) {
            const SessionStep step = nextStep(status, told);
            QCOMPARE(step == SessionStep::Begin,
                     told == XR_SESSION_STATE_READY && !status.isRunning && !status.isExiting);
            QCOMPARE(step == SessionStep::End, told == XR_SESSION_STATE_STOPPING && status.isRunning);
            QCOMPARE(step == SessionStep::Lost, told == XR_SESSION_STATE_LOSS_PENDING);
            if (told == XR_SESSION_STATE_EXITING)
                QCOMPARE(step, SessionStep::Exit);
            else if (step == SessionStep::Exit)
                QVERIFY(status.isExiting && !status.isRunning);
        }
    }
}

void TestSessionState::whatWasToldIsRemembered()
{
    for (const SessionStatus& status : statuses()) {
        for (const XrSessionState told : states) {
            const SessionStatus after = afterStep(status, told);
            const SessionStep step = nextStep(status, told);
            QCOMPARE(after.state, told);
            QCOMPARE(after.isExiting, status.isExiting);
            QCOMPARE(after.isRunning, step == SessionStep::Begin || (status.isRunning && step != SessionStep::End));
        }
    }
}

/// Plays random state sequences that a runtime may report. The session must be begun and ended alternately, run exactly
/// in the states that have frames, and be left at the end but not before.
void TestSessionState::aLifeAsInTheSpecification()
{
    std::mt19937 random(6);
    int lives = 0;
    for (; lives < 1000; ++lives) {
        SessionStatus status;
        for (auto next = successors(status.state); !next.empty(); next = successors(status.state)) {
            const XrSessionState told = next[random() % next.size()];
            const SessionStep step = nextStep(status, told);
            QCOMPARE(step == SessionStep::Exit, told == XR_SESSION_STATE_EXITING);
            status = afterStep(status, told);
            QCOMPARE(status.isRunning, std::find(running.begin(), running.end(), told) != running.end());
        }
        QCOMPARE(status.state, XR_SESSION_STATE_EXITING);
    }
}

/// Checks, from every running state, that after a request to exit the runtime's final states are few and the session is
/// not begun again.
void TestSessionState::leavingComesToAnEnd()
{
    const std::vector<XrSessionState> wayOut{XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED,
                                             XR_SESSION_STATE_STOPPING, XR_SESSION_STATE_IDLE,
                                             XR_SESSION_STATE_EXITING};
    for (const XrSessionState from : running) {
        SessionStatus status{from, true, true};
        bool hasLeft = false;
        int ends = 0;
        for (const XrSessionState told : wayOut) {
            const SessionStep step = nextStep(status, told);
            QVERIFY(step != SessionStep::Begin);
            ends += step == SessionStep::End ? 1 : 0;
            hasLeft = hasLeft || step == SessionStep::Exit;
            status = afterStep(status, told);
        }
        QCOMPARE(ends, 1);
        QVERIFY(hasLeft);
    }
}

void TestSessionState::onlyTheFocusedHaveInput()
{
    for (const SessionStatus& status : statuses()) {
        QCOMPARE(status.hasInput(), status.isRunning && status.state == XR_SESSION_STATE_FOCUSED);
        QCOMPARE(status.isVisible(), status.isRunning && (status.state == XR_SESSION_STATE_FOCUSED ||
                                                          status.state == XR_SESSION_STATE_VISIBLE));
    }
}

FETTLE_TEST(TestSessionState, QCoreApplication)
#include "tst_session_state.moc"
