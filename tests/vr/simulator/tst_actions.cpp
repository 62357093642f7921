// Tests of a client's button inputs and of the wands' vibration.
#include "tests/support/test_main.h"
#include "tests/vr/simulator/raw_player.h"
#include "tests/vr/simulator/scripted_runtime.h"
#include "tests/vr/vr_test.h"

#include <QJsonArray>

namespace
{
constexpr const char* simple = "/interaction_profiles/khr/simple_controller";
} // namespace

class TestActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void readsInputs();
    void convertsInputs();
    void tellsChanges();
    void isSilentWithoutFocus();
    void switchesAWandOff();
    void changesTheProfile();
    void knowsOnlySuggestedProfiles();
    void takesThePriority();
    void namesSources();
    void logsHaptics();
    void refusesBadBindings_data();
    void refusesBadBindings();
    void refusesWrongUse();
};

void TestActions::readsInputs()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 5, "over": 10, "right": {"trigger": 1, "pad": [0.5, -1]}},
        {"frame": 7, "left": {"menu": true, "pad_touch": true, "squeeze": 1}})"));
    RawPlayer player;
    const XrAction trigger = player.action("trigger", XR_ACTION_TYPE_FLOAT_INPUT);
    const XrAction pad = player.action("pad", XR_ACTION_TYPE_VECTOR2F_INPUT);
    const XrAction menu = player.action("menu", XR_ACTION_TYPE_BOOLEAN_INPUT);
    const XrAction touch = player.action("touch", XR_ACTION_TYPE_BOOLEAN_INPUT);
    const XrAction side = player.action("side", XR_ACTION_TYPE_BOOLEAN_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{trigger, "/input/trigger/value"},
                                        {pad, "/input/trackpad"},
                                        {menu, "/input/menu/click"},
                                        {touch, "/input/trackpad/touch"},
                                        {side, "/input/squeeze/click"}}));
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    for (int frame = 3; frame <= 10; ++frame) {
        QSUCCEEDS(player.play());
        const float expected = static_cast<float>(std::max(0, frame - 5)) / 10;
        QVERIFY(qAbs(player.number(trigger, player.hands[1]).currentState - expected) < 1e-5F);
        QVERIFY(qAbs(player.vector(pad, player.hands[1]).currentState.y + expected) < 1e-5F);
        QCOMPARE(player.number(trigger, player.hands[0]).currentState, 0.F);
        QVERIFY(qAbs(player.number(trigger).currentState - expected) < 1e-5F);
        const XrBool32 isPressed = frame >= 7 ? XR_TRUE : XR_FALSE;
        QCOMPARE(player.boolean(menu, player.hands[0]).currentState, isPressed);
        QCOMPARE(player.boolean(touch).currentState, isPressed);
        QCOMPARE(player.boolean(side, player.hands[0]).currentState, isPressed);
        QCOMPARE(player.boolean(side, player.hands[1]).currentState, XrBool32(XR_FALSE));
    }
    QCOMPARE(runtime.clientErrors() + runtime.clientWarnings(), QStringList());
}

void TestActions::convertsInputs()
{
    ScriptedRuntime runtime(
        fastWith(R"({"frame": 4, "right": {"trigger": 0.6, "menu": true}}, {"frame": 6, "right": {"trigger": 0.9}})"));
    RawPlayer player;
    const XrAction pressed = player.action("pressed", XR_ACTION_TYPE_BOOLEAN_INPUT);
    const XrAction amount = player.action("amount", XR_ACTION_TYPE_FLOAT_INPUT);
    const XrAction clicked = player.action("clicked", XR_ACTION_TYPE_BOOLEAN_INPUT);
    const XrAction never = player.action("never", XR_ACTION_TYPE_VECTOR2F_INPUT);
    const XrAction parent = player.action("parent", XR_ACTION_TYPE_BOOLEAN_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{pressed, "/input/trigger/value"},
                                        {amount, "/input/menu"},
                                        {clicked, "/input/trigger/click"},
                                        {never, "/input/trigger"},
                                        {parent, "/input/trigger"}}));
    QCOMPARE(runtime.clientWarnings().size(), 2); // the vector action cannot be bound, for either hand
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    for (int frame = 3; frame <= 5; ++frame)
        QSUCCEEDS(player.play());
    QCOMPARE(player.boolean(pressed).currentState, XrBool32(XR_TRUE));
    QCOMPARE(player.number(amount).currentState, 1.F);
    QCOMPARE(player.boolean(clicked).currentState, XrBool32(XR_FALSE));
    // the parent path is bound to the click, not to the value
    QCOMPARE(player.boolean(parent).currentState, XrBool32(XR_FALSE));
    QCOMPARE(player.vector(never).isActive, XrBool32(XR_FALSE));
    QSUCCEEDS(player.play());
    QCOMPARE(player.boolean(clicked).currentState, XrBool32(XR_TRUE));
}

void TestActions::tellsChanges()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 5, "right": {"trigger": 1}})"));
    RawPlayer player;
    const XrAction trigger = player.action("trigger", XR_ACTION_TYPE_FLOAT_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{trigger, "/input/trigger/value"}}));
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QList<bool> changes;
    XrTime changedAt = 0;
    for (int frame = 3; frame <= 7; ++frame) {
        QSUCCEEDS(player.play());
        const XrActionStateFloat state = player.number(trigger, player.hands[1]);
        changes << (state.changedSinceLastSync == XR_TRUE);
        changedAt = frame == 5 ? player.frameState.predictedDisplayTime : changedAt;
        QCOMPARE(player.number(trigger, player.hands[1]).changedSinceLastSync,
                 state.changedSinceLastSync); // reading does not change it
        if (frame >= 5)
            QCOMPARE(state.lastChangeTime, changedAt);
    }
    QCOMPARE(changes, QList<bool>({false, false, true, false, false}));
}

void TestActions::isSilentWithoutFocus()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 0, "right": {"trigger": 1}})"));
    RawPlayer player;
    const XrAction trigger = player.action("trigger", XR_ACTION_TYPE_FLOAT_INPUT);
    const XrAction grip = player.action("grip", XR_ACTION_TYPE_POSE_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{trigger, "/input/trigger/value"}, {grip, "/input/grip/pose"}}));
    QSUCCEEDS(player.attach());
    const XrSpace right = player.handSpace(grip, player.hands[1]);
    QCOMPARE(player.sync(), XR_SESSION_NOT_FOCUSED);
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QSUCCEEDS(player.play());
    QCOMPARE(player.number(trigger).currentState, 1.F);
    QCOMPARE(player.locate(right, player.local).locationFlags, locatedWholly);
    runtime.set(R"({"focus": false})");
    QCOMPARE(player.number(trigger).isActive, XrBool32(XR_FALSE));
    QCOMPARE(player.locate(right, player.local).locationFlags, XrSpaceLocationFlags(0));
    QCOMPARE(player.play(), XR_SESSION_NOT_FOCUSED);
    const XrActionStateFloat state = player.number(trigger);
    QCOMPARE(state.isActive, XrBool32(XR_FALSE));
    QCOMPARE(state.currentState, 0.F);
    QCOMPARE(state.lastChangeTime, XrTime(0));
}

void TestActions::switchesAWandOff()
{
    ScriptedRuntime runtime(fastWith({}));
    RawPlayer player;
    const XrAction trigger = player.action("trigger", XR_ACTION_TYPE_FLOAT_INPUT),
                   grip = player.action("grip", XR_ACTION_TYPE_POSE_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{trigger, "/input/trigger/value"}, {grip, "/input/grip/pose"}}));
    QSUCCEEDS(player.attach());
    const XrSpace left = player.handSpace(grip, player.hands[0]);
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QSUCCEEDS(player.play());
    QCOMPARE(player.number(trigger, player.hands[0]).isActive, XrBool32(XR_TRUE));
    runtime.set(R"({"left": {"on": false}})");
    QSUCCEEDS(player.play());
    QCOMPARE(player.number(trigger, player.hands[0]).isActive, XrBool32(XR_FALSE));
    QCOMPARE(player.number(trigger, player.hands[1]).isActive, XrBool32(XR_TRUE));
    QCOMPARE(player.locate(left, player.local).locationFlags, XrSpaceLocationFlags(0));
    runtime.set(R"({"left": {"on": true}})");
    QSUCCEEDS(player.play());
    QCOMPARE(player.number(trigger, player.hands[0]).isActive, XrBool32(XR_TRUE));
    QCOMPARE(player.locate(left, player.local).locationFlags, locatedWholly);
}

void TestActions::changesTheProfile()
{
    ScriptedRuntime runtime(fastWith({}));
    RawPlayer player;
    const XrAction press = player.action("press", XR_ACTION_TYPE_BOOLEAN_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{press, "/input/menu/click"}}));
    QSUCCEEDS(player.bind(simple, {{press, "/input/select/click"}}));
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    const auto current = [&] {
        XrInteractionProfileState state{XR_TYPE_INTERACTION_PROFILE_STATE, nullptr, 0};
        xrGetCurrentInteractionProfile(player.session, player.hands[1], &state);
        return state.interactionProfile;
    };
    QCOMPARE(current(), XrPath(XR_NULL_PATH));
    QSUCCEEDS(player.play());
    QCOMPARE(current(), player.path(viveProfile));
    runtime.set(QByteArray(R"({"profile": ")") + simple + R"(", "right": {"trigger": 1}})");
    QCOMPARE(current(), player.path(viveProfile));
    QSUCCEEDS(player.play());
    QCOMPARE(current(), player.path(simple));
    QCOMPARE(player.boolean(press).currentState, XrBool32(XR_TRUE));
    QSUCCEEDS(player.poll());
    QCOMPARE(player.otherEvents.size(), std::size_t(2));
    QCOMPARE(player.otherEvents[1].type, XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED);
}

void TestActions::knowsOnlySuggestedProfiles()
{
    ScriptedRuntime runtime(
        R"({"start": {"pace": "fast", "size": [16, 16], "profile": "/interaction_profiles/valve/index_controller"}})");
    RawPlayer player;
    const XrAction trigger = player.action("trigger", XR_ACTION_TYPE_FLOAT_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{trigger, "/input/trigger/value"}}));
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QSUCCEEDS(player.play());
    QCOMPARE(player.number(trigger).isActive, XrBool32(XR_FALSE));
    QVERIFY(player.otherEvents.empty());
}

void TestActions::takesThePriority()
{
    ScriptedRuntime runtime(fastWith(R"({"frame": 0, "right": {"trigger": 1}})"));
    RawPlayer player;
    XrActionSetCreateInfo info{};
    info.type = XR_TYPE_ACTION_SET_CREATE_INFO;
    info.priority = 1;
    std::strcpy(info.actionSetName, "first");
    std::strcpy(info.localizedActionSetName, "First");
    const XrActionSet lower = player.set;
    const XrAction below = player.action("below", XR_ACTION_TYPE_FLOAT_INPUT);
    QSUCCEEDS(xrCreateActionSet(player.instance, &info, &player.set));
    const XrAction above = player.action("above", XR_ACTION_TYPE_BOOLEAN_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{below, "/input/trigger/value"}, {above, "/input/trigger/value"}}));
    const XrActionSet sets[]{lower, player.set};
    const XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 2, sets};
    QSUCCEEDS(xrAttachSessionActionSets(player.session, &attach));
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    const XrActiveActionSet active[]{{lower, XR_NULL_PATH}, {player.set, player.hands[1]}};
    const XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 2, active};
    QSUCCEEDS(player.frame([&] { xrSyncActions(player.session, &sync); }));
    QCOMPARE(player.boolean(above, player.hands[1]).currentState, XrBool32(XR_TRUE));
    QCOMPARE(player.number(below, player.hands[1]).isActive, XrBool32(XR_FALSE));
    QCOMPARE(player.number(below, player.hands[0]).isActive, XrBool32(XR_TRUE));
    QCOMPARE(player.boolean(above, player.hands[0]).isActive, XrBool32(XR_FALSE));
}

void TestActions::namesSources()
{
    ScriptedRuntime runtime(fastWith({}));
    RawPlayer player;
    const XrAction pad = player.action("pad", XR_ACTION_TYPE_VECTOR2F_INPUT);
    QSUCCEEDS(player.bind(viveProfile, {{pad, "/input/trackpad"}}));
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QSUCCEEDS(player.play());
    const XrBoundSourcesForActionEnumerateInfo asked{XR_TYPE_BOUND_SOURCES_FOR_ACTION_ENUMERATE_INFO, nullptr, pad};
    std::uint32_t count = 0;
    QSUCCEEDS(xrEnumerateBoundSourcesForAction(player.session, &asked, 0, &count, nullptr));
    QCOMPARE(count, 2U);
    XrPath sources[2]{};
    QSUCCEEDS(xrEnumerateBoundSourcesForAction(player.session, &asked, 2, &count, sources));
    const auto name = [&](XrInputSourceLocalizedNameFlags parts) {
        const XrInputSourceLocalizedNameGetInfo info{XR_TYPE_INPUT_SOURCE_LOCALIZED_NAME_GET_INFO, nullptr, sources[1],
                                                     parts};
        char text[64]{};
        std::uint32_t length = 0;
        xrGetInputSourceLocalizedName(player.session, &info, 64, &length, text);
        return length == std::strlen(text) + 1 ? QByteArray(text) : QByteArray();
    };
    QCOMPARE(name(XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT), QByteArray("Trackpad"));
    QCOMPARE(name(7), QByteArray("Right Hand Vive Controller Trackpad"));
}

void TestActions::logsHaptics()
{
    ScriptedRuntime runtime(fastWith({}));
    RawPlayer player;
    const XrAction buzz = player.action("buzz", XR_ACTION_TYPE_VIBRATION_OUTPUT);
    QSUCCEEDS(player.bind(viveProfile, {{buzz, "/output/haptic"}}));
    QSUCCEEDS(player.attach());
    QSUCCEEDS(player.framesUntil(XR_SESSION_STATE_FOCUSED));
    QSUCCEEDS(player.play());
    const XrHapticActionInfo right{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, buzz, player.hands[1]};
    XrHapticVibration pulse{XR_TYPE_HAPTIC_VIBRATION, nullptr, 5'000'000, 160, 0.25F};
    QSUCCEEDS(xrApplyHapticFeedback(player.session, &right, reinterpret_cast<const XrHapticBaseHeader*>(&pulse)));
    QSUCCEEDS(xrStopHapticFeedback(player.session, &right));
    const QJsonArray haptics = runtime.report()["haptics"].toArray();
    QCOMPARE(haptics.size(), 2);
    const QJsonObject first = haptics[0].toObject();
    QCOMPARE(first["hand"].toString(), QString("right"));
    QCOMPARE(first["amplitude"].toDouble(), 0.25);
    QCOMPARE(first["frequency"].toDouble(), 160.0);
    QCOMPARE(first["duration_ns"].toInt(), 5'000'000);
    QVERIFY(haptics[1].toObject()["stop"].toBool());
    QCOMPARE(runtime.clientErrors(), QStringList());
    pulse.amplitude = 1.5F;
    QSUCCEEDS(xrApplyHapticFeedback(player.session, &right, reinterpret_cast<const XrHapticBaseHeader*>(&pulse)));
    QCOMPARE(runtime.clientErrors().size(), 1);
}

void TestActions::refusesBadBindings_data()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<bool>("isRight");
    const auto row = [](const char* profile, const char* input, bool isRight) {
        QTest::addRow("%s %s", profile, input) << QByteArray(profile) << QByteArray(input) << isRight;
    };
    row("htc/vive_controller", "/input/trackpad", true);
    row("htc/vive_controller", "/input/trackpad/press", false);
    row("htc/vive_controller", "/input/thumbstick", false);
    row("htc/vive_controller", "/input", false);
    row("htc/vive_controller", "", false);
    row("htc/vive_controller", "/output", false);
    row("khr/simple_controller", "/input/select/click", true);
    row("khr/simple_controller", "/input/trigger/value", false);
    row("valve/index_controller", "/input/squeeze/force", true);
    row("valve/index_controller", "/input/squeeze/click", false);
    row("oculus/touch_controller", "/input/squeeze/value", true);
    row("oculus/touch_controller", "/input/x/click", false); // only the left hand has it
    row("microsoft/motion_controller", "/input/thumbstick", true);
    row("microsoft/motion_controller", "/input/trigger/click", false);
    row("acme/stick", "/input/menu/click", false);
}

void TestActions::refusesBadBindings()
{
    QFETCH(QByteArray, profile);
    QFETCH(QByteArray, input);
    QFETCH(bool, isRight);
    ScriptedRuntime runtime(fastWith({}));
    RawPlayer player;
    const XrAction press = player.action("press", XR_ACTION_TYPE_BOOLEAN_INPUT);
    QCOMPARE(player.bind("/interaction_profiles/" + profile, {{press, input}}),
             isRight ? XR_SUCCESS : XR_ERROR_PATH_UNSUPPORTED);
    QCOMPARE(runtime.clientErrors().isEmpty(), isRight);
}

void TestActions::refusesWrongUse()
{
    ScriptedRuntime runtime(fastWith({}));
    RawPlayer player;
    const XrAction press = player.action("press", XR_ACTION_TYPE_BOOLEAN_INPUT);
    const XrActionStateGetInfo asked{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, press, XR_NULL_PATH};
    XrActionStateBoolean boolean{XR_TYPE_ACTION_STATE_BOOLEAN, nullptr, 0, 0, 0, 0};
    XrActionStateFloat number{XR_TYPE_ACTION_STATE_FLOAT, nullptr, 0, 0, 0, 0};
    QCOMPARE(xrGetActionStateBoolean(player.session, &asked, &boolean), XR_ERROR_ACTIONSET_NOT_ATTACHED);
    QCOMPARE(player.sync(), XR_ERROR_ACTIONSET_NOT_ATTACHED);
    QSUCCEEDS(player.attach());
    QCOMPARE(player.attach(), XR_ERROR_ACTIONSETS_ALREADY_ATTACHED);
    QCOMPARE(player.bind(viveProfile, {{press, "/input/menu/click"}}), XR_ERROR_ACTIONSETS_ALREADY_ATTACHED);
    QCOMPARE(player.action("late", XR_ACTION_TYPE_BOOLEAN_INPUT), XrAction(XR_NULL_HANDLE));
    QCOMPARE(xrGetActionStateFloat(player.session, &asked, &number), XR_ERROR_ACTION_TYPE_MISMATCH);
    const XrActionStateGetInfo elsewhere{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, press, player.path("/user/head")};
    QCOMPARE(xrGetActionStateBoolean(player.session, &elsewhere, &boolean), XR_ERROR_PATH_UNSUPPORTED);
    XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, nullptr, 0, {}};
    QCOMPARE(xrLocateSpace(player.view, player.local, 0, &location), XR_ERROR_TIME_INVALID);
    const XrPosef tooLong{{0, 0, 0, 2}, {0, 0, 0}};
    XrReferenceSpaceCreateInfo crooked{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, XR_REFERENCE_SPACE_TYPE_LOCAL,
                                       tooLong};
    XrSpace space = XR_NULL_HANDLE;
    QCOMPARE(xrCreateReferenceSpace(player.session, &crooked, &space), XR_ERROR_POSE_INVALID);
    QCOMPARE(runtime.clientErrors().size(), 9);
}

FETTLE_TEST(TestActions, vr::GlxTestApplication)
#include "tst_actions.moc"
