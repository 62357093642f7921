// Tests of the poses of head, eyes and wands that a client locates, and of when they are unavailable.
#include "tests/support/test_main.h"
#include "tests/vr/simulator/raw_player.h"
#include "tests/vr/simulator/scripted_runtime.h"
#include "tests/vr/vr_test.h"

#include <QJsonArray>
#include <QtMath>

namespace
{
bool isNear(const XrVector3f& a, double x, double y, double z)
{
    return std::abs(a.x - x) < 1e-5 && std::abs(a.y - y) < 1e-5 && std::abs(a.z - z) < 1e-5;
}
} // namespace

class TestSpaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void movesTheHead();
    void placesTheEyes();
    void movesAWand();
    void losesTracking();
    void recentres();
    void hasNoStage();
};

void TestSpaces::movesTheHead()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 0, "head": {"position": [0, 1.6, 0]}},
        {"frame": 10, "over": 90, "head": {"position": [0.9, 1.6, 0], "yaw_pitch_roll": [90, 0, 0]}})"));
    RawPlayer player;
    const XrSpace stage = player.reference(XR_REFERENCE_SPACE_TYPE_STAGE);
    while (player.frameState.predictedDisplayTime < 2'000'000'000) // frames 0 to 89
        QSUCCEEDS(player.frame());
    XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY, nullptr, 0, {}, {}};
    const XrSpaceLocation head = player.locate(player.view, stage, &velocity);
    QCOMPARE(head.locationFlags, locatedWholly);
    const double done = static_cast<double>(player.frameState.predictedDisplayTime - 1'000'000'000) / 11'111'111 - 11;
    QVERIFY(done > 70 && done < 90);
    QVERIFY(isNear(head.pose.position, 0.01 * done, 1.6, 0));
    QVERIFY(qAbs(head.pose.orientation.y - qSin(qDegreesToRadians(done / 2))) < 1e-5);
    QVERIFY(qAbs(velocity.linearVelocity.x - 0.9F) < 1e-4F);
    QVERIFY(qAbs(velocity.angularVelocity.y - qDegreesToRadians(90.F)) < 1e-3F);
    QCOMPARE(velocity.velocityFlags,
             XrSpaceVelocityFlags(XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT));
    // A fixed space moves relative to a moving one, and vice versa.
    player.locate(stage, player.view, &velocity);
    QVERIFY(qAbs(velocity.angularVelocity.y + qDegreesToRadians(90.F)) < 1e-3F);
    QVERIFY(isNear(player.locate(player.local, stage).pose.position, 0, 1.6, 0));
}

void TestSpaces::placesTheEyes()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 0, "eye_distance": 0.06,
        "head": {"position": [1, 1.6, 2], "yaw_pitch_roll": [90, 0, 0]}})"));
    RawPlayer player;
    QSUCCEEDS(player.frame());
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, player.views, player.frameState.predictedDisplayTime,
                                player.local};
    XrViewState state{XR_TYPE_VIEW_STATE, nullptr, 0};
    XrView views[2]{{XR_TYPE_VIEW, nullptr, {}, {}}, {XR_TYPE_VIEW, nullptr, {}, {}}};
    std::uint32_t count = 0;
    QCOMPARE(xrLocateViews(player.session, &info, &state, 1, &count, views), XR_ERROR_SIZE_INSUFFICIENT);
    QSUCCEEDS(xrLocateViews(player.session, &info, &state, 2, &count, views));
    QVERIFY(isNear(views[0].pose.position, 1, 0, 2.03)); // looking to the left, the left eye is behind
    QVERIFY(isNear(views[1].pose.position, 1, 0, 1.97));
    QCOMPARE(views[0].fov.angleLeft, -views[1].fov.angleRight);
    QVERIFY(views[0].fov.angleLeft < -views[0].fov.angleRight); // asymmetric: wider outwards than towards the nose
    QVERIFY(views[0].fov.angleUp != -views[0].fov.angleDown);
}

void TestSpaces::movesAWand()
{
    ScriptedRuntime runtime(
        fastWith(R"({"frame": 0, "left": {"position": [-0.1, 1, -0.5]}, "right": {"position": [0.1, 1, -0.5]}},
        {"frame": 0, "aim": {"position": [0, 0, -0.1], "yaw_pitch_roll": [0, -45, 0]}},
        {"frame": 5, "right": {"position": [0.3, 1, -0.5], "yaw_pitch_roll": [90, 0, 0]}})"));
    RawPlayer player;
    const XrAction grip = player.action("grip", XR_ACTION_TYPE_POSE_INPUT),
                   aim = player.action("aim", XR_ACTION_TYPE_POSE_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{grip, "/input/grip/pose"}, {aim, "/input/aim/pose"}}));
    QSUCCEEDS(player.attach());
    const XrSpace stage = player.reference(XR_REFERENCE_SPACE_TYPE_STAGE);
    const XrSpace right = player.handSpace(grip, player.hands[1]), tip = player.handSpace(aim, player.hands[1]);
    const XrSpace left = player.handSpace(grip, player.hands[0]);
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QCOMPARE(player.locate(right, stage).locationFlags, XrSpaceLocationFlags(0)); // not synced yet
    QSUCCEEDS(player.play());
    QCOMPARE(player.locate(right, stage).locationFlags, locatedWholly);
    QVERIFY(isNear(player.locate(right, stage).pose.position, 0.1, 1, -0.5));
    QVERIFY(isNear(player.locate(left, stage).pose.position, -0.1, 1, -0.5));
    QSUCCEEDS(player.play());
    QSUCCEEDS(player.play());
    QVERIFY(isNear(player.locate(right, stage).pose.position, 0.3, 1, -0.5));
    const XrSpaceLocation aimed = player.locate(tip, right);
    QVERIFY(isNear(aimed.pose.position, 0, 0, -0.1));
    QVERIFY(qAbs(aimed.pose.orientation.x + qSin(qDegreesToRadians(22.5))) < 1e-5);
    QVERIFY(isNear(player.locate(tip, stage).pose.position, 0.2, 1, -0.5));
    QCOMPARE(runtime.clientErrors(), QStringList());
}

void TestSpaces::losesTracking()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 6, "left": {"tracked": "rotation"}, "head": {"tracked": false}})"));
    RawPlayer player;
    const XrAction grip = player.action("grip", XR_ACTION_TYPE_POSE_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{grip, "/input/grip"}}));
    QSUCCEEDS(player.attach());
    const XrSpace left = player.handSpace(grip, player.hands[0]);
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QSUCCEEDS(player.play());
    QCOMPARE(player.locate(left, player.local).locationFlags, locatedWholly);
    for (int i = 0; i < 3; ++i)
        QSUCCEEDS(player.play());
    QCOMPARE(player.locate(left, player.local).locationFlags,
             locatedWholly & ~XrSpaceLocationFlags(XR_SPACE_LOCATION_POSITION_TRACKED_BIT));
    QCOMPARE(player.locate(player.view, player.local).locationFlags, XrSpaceLocationFlags(0));
    QCOMPARE(player.locate(left, player.view).locationFlags, XrSpaceLocationFlags(0));
    QCOMPARE(runtime.report()["last_frame"].toObject()["layers"].toArray().size(),
             0); // the client cannot draw without a head pose
    runtime.set(R"({"left": {"tracked": "no_position"}})");
    const XrSpaceLocation turned = player.locate(left, player.local);
    QCOMPARE(turned.locationFlags, XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT);
    QVERIFY(isNear(turned.pose.position, 0, 0, 0) && turned.pose.orientation.w == 1);
}

void TestSpaces::recentres()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 4,
        "recentre": {"space": "local", "position": [1, 1.5, 0], "yaw_pitch_roll": [90, 0, 0], "after": 3}})"));
    RawPlayer player;
    const XrSpace stage = player.reference(XR_REFERENCE_SPACE_TYPE_STAGE);
    for (int i = 0; i < 5; ++i)
        QSUCCEEDS(player.frame());
    const XrTime announced = player.frameState.predictedDisplayTime;
    QVERIFY(isNear(player.locate(player.local, stage).pose.position, 0, 1.6, 0));
    QSUCCEEDS(player.poll());
    QCOMPARE(player.otherEvents.size(), std::size_t(1));
    const auto& pending = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(player.otherEvents[0]);
    QCOMPARE(pending.type, XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING);
    QCOMPARE(pending.changeTime, announced + 3 * player.frameState.predictedDisplayPeriod);
    QVERIFY(pending.poseValid);
    QVERIFY(isNear(pending.poseInPreviousSpace.position, 1, -0.1, 0));
    while (player.frameState.predictedDisplayTime < pending.changeTime) {
        QVERIFY(isNear(player.locate(player.local, stage).pose.position, 0, 1.6, 0));
        QSUCCEEDS(player.frame());
    }
    QVERIFY(isNear(player.locate(player.local, stage).pose.position, 1, 1.5, 0));
}

void TestSpaces::hasNoStage()
{
    ScriptedRuntime runtime(R"({"start": {"stage": false}})");
    RawPlayer player;
    std::uint32_t count = 0;
    XrReferenceSpaceType types[3]{};
    QSUCCEEDS(xrEnumerateReferenceSpaces(player.session, 3, &count, types));
    QCOMPARE(count, 2U);
    XrExtent2Df bounds{1, 1};
    QCOMPARE(xrGetReferenceSpaceBoundsRect(player.session, XR_REFERENCE_SPACE_TYPE_STAGE, &bounds),
             XR_ERROR_REFERENCE_SPACE_UNSUPPORTED);
    runtime.set(R"({"stage": true, "bounds": [4, 3]})");
    QSUCCEEDS(xrGetReferenceSpaceBoundsRect(player.session, XR_REFERENCE_SPACE_TYPE_STAGE, &bounds));
    QCOMPARE(bounds.width, 4.F);
    QCOMPARE(bounds.height, 3.F);
    runtime.set(R"({"bounds": null})");
    QCOMPARE(xrGetReferenceSpaceBoundsRect(player.session, XR_REFERENCE_SPACE_TYPE_STAGE, &bounds),
             XR_SPACE_BOUNDS_UNAVAILABLE);
}

FETTLE_TEST(TestSpaces, vr::GlxTestApplication)
#include "tst_spaces.moc"
