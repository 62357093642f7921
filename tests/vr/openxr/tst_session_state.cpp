#include "vr/openxr/session_state.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <vector>

using vr::SessionStanding;
using vr::SessionStep;

namespace
{
/// All that OpenXR knows, and one that it may know some day.
const XrSessionState states[] = {
    XR_SESSION_STATE_UNKNOWN,      XR_SESSION_STATE_IDLE,    XR_SESSION_STATE_READY,
    XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED,
    XR_SESSION_STATE_STOPPING,     XR_SESSION_STATE_EXITING, XR_SESSION_STATE_LOSS_PENDING,
    static_cast<XrSessionState>(1234),
};

/// In which a session has frames.
const std::vector<XrSessionState> running{XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE,
                                          XR_SESSION_STATE_FOCUSED};

std::vector<SessionStanding> standings()
{
    std::vector<SessionStanding> all;
    for (const XrSessionState state : states)
        for (const bool isRunning : {false, true})
            for (const bool isLeaving : {false, true})
                all.push_back({state, isRunning, isLeaving});
    return all;
}

/// What a runtime may tell next, by the specification's figure of a session's life. Losing may come at any time.
std::vector<XrSessionState> successors(XrSessionState state)
{
    switch (state) {
    case XR_SESSION_STATE_UNKNOWN: return {XR_SESSION_STATE_IDLE};
    case XR_SESSION_STATE_IDLE: return {XR_SESSION_STATE_READY, XR_SESSION_STATE_EXITING};
    case XR_SESSION_STATE_READY: return {XR_SESSION_STATE_SYNCHRONIZED};
    case XR_SESSION_STATE_SYNCHRONIZED: return {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_STOPPING};
    case XR_SESSION_STATE_VISIBLE: return {XR_SESSION_STATE_FOCUSED, XR_SESSION_STATE_SYNCHRONIZED};
    case XR_SESSION_STATE_FOCUSED: return {XR_SESSION_STATE_VISIBLE};
    case XR_SESSION_STATE_STOPPING: return {XR_SESSION_STATE_IDLE};
    default: return {};
    }
}
} // namespace

class TestSessionSteps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stepsAreAllowedAsThingsStand();
    void whatWasToldIsRemembered();
    void aLifeAsInTheSpecification();
    void leavingComesToAnEnd();
    void onlyTheFocusedHaveInput();
};

void TestSessionSteps::stepsAreAllowedAsThingsStand()
{
    for (const SessionStanding& standing : standings()) {
        for (const XrSessionState told : states) {
            const SessionStep step = nextStep(standing, told);
            QCOMPARE(step == SessionStep::Begin, told == XR_SESSION_STATE_READY && !standing.isRunning && !standing.isLeaving);
            QCOMPARE(step == SessionStep::End, told == XR_SESSION_STATE_STOPPING && standing.isRunning);
            QCOMPARE(step == SessionStep::Lost, told == XR_SESSION_STATE_LOSS_PENDING);
            if (told == XR_SESSION_STATE_EXITING)
                QCOMPARE(step, SessionStep::Leave);
            else if (step == SessionStep::Leave)
                QVERIFY(standing.isLeaving && !standing.isRunning);
        }
    }
}

void TestSessionSteps::whatWasToldIsRemembered()
{
    for (const SessionStanding& standing : standings()) {
        for (const XrSessionState told : states) {
            const SessionStanding after = afterStep(standing, told);
            const SessionStep step = nextStep(standing, told);
            QCOMPARE(after.state, told);
            QCOMPARE(after.isLeaving, standing.isLeaving);
            QCOMPARE(after.isRunning, step == SessionStep::Begin || (standing.isRunning && step != SessionStep::End));
        }
    }
}

/// Random lives that a runtime may give a session: it is begun and ended in turns, is run in exactly those states that have frames, and is
/// left at its end and not before.
void TestSessionSteps::aLifeAsInTheSpecification()
{
    std::mt19937 random(6);
    int lives = 0;
    for (; lives < 1000; ++lives) {
        SessionStanding standing;
        for (auto next = successors(standing.state); !next.empty(); next = successors(standing.state)) {
            const XrSessionState told = next[random() % next.size()];
            const SessionStep step = nextStep(standing, told);
            QCOMPARE(step == SessionStep::Leave, told == XR_SESSION_STATE_EXITING);
            standing = afterStep(standing, told);
            QCOMPARE(standing.isRunning, std::find(running.begin(), running.end(), told) != running.end());
        }
        QCOMPARE(standing.state, XR_SESSION_STATE_EXITING);
    }
}

/// From everywhere in such a life, once we have asked to leave, the runtime's way out is short, and we do not begin again on it.
void TestSessionSteps::leavingComesToAnEnd()
{
    const std::vector<XrSessionState> wayOut{XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_STOPPING,
                                             XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING};
    for (const XrSessionState from : running) {
        SessionStanding standing{from, true, true};
        bool hasLeft = false;
        int ends = 0;
        for (const XrSessionState told : wayOut) {
            const SessionStep step = nextStep(standing, told);
            QVERIFY(step != SessionStep::Begin);
            ends += step == SessionStep::End ? 1 : 0;
            hasLeft = hasLeft || step == SessionStep::Leave;
            standing = afterStep(standing, told);
        }
        QCOMPARE(ends, 1);
        QVERIFY(hasLeft);
    }
}

void TestSessionSteps::onlyTheFocusedHaveInput()
{
    for (const SessionStanding& standing : standings()) {
        QCOMPARE(standing.hasInput(), standing.isRunning && standing.state == XR_SESSION_STATE_FOCUSED);
        QCOMPARE(standing.isVisible(),
                 standing.isRunning && (standing.state == XR_SESSION_STATE_FOCUSED || standing.state == XR_SESSION_STATE_VISIBLE));
    }
}

QTEST_GUILESS_MAIN(TestSessionSteps)
#include "tst_session_state.moc"
