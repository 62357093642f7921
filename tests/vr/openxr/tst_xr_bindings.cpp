// Checks that every suggested binding is legal for its profile, by the tables of section 6.4 of the OpenXR
// specification and of the sections of its extensions.
#include "vr/openxr/xr_bindings.h"

#include "tests/support/test_main.h"

#include <QMap>
#include <QSet>
#include <QTest>

#include <cstring>

using vr::Binding;
using vr::Control;

namespace
{
/// Legal paths of a profile, relative to /user/hand/left or /user/hand/right. `both`: paths that exist for each hand;
/// `left`, `right`: paths of one hand only.
struct Legal
{
    QStringList both, left, right;
    int coreMinor = 0; ///< minor version of OpenXR 1 from which on the profile is in the core; -1: it is in no core
    QString extension = {}; ///< extension that defines the profile
};

const QStringList poses{"/input/grip/pose", "/input/aim/pose", "/output/haptic"};
const QStringList stick{"/input/thumbstick/x", "/input/thumbstick/y", "/input/thumbstick/click"};
const QStringList xAndY{"/input/x/click", "/input/y/click"}, aAndB{"/input/a/click", "/input/b/click"};

/// Legal paths of Meta's later Touch controllers, as far as those of the first ones have them.
Legal touchOf(int coreMinor, const QString& extension)
{
    return {poses + stick +
                QStringList{"/input/squeeze/value", "/input/trigger/value", "/input/trigger/touch",
                            "/input/thumbstick/touch", "/input/thumbrest/touch"},
            xAndY + QStringList{"/input/x/touch", "/input/y/touch", "/input/menu/click"},
            aAndB + QStringList{"/input/a/touch", "/input/b/touch", "/input/system/click"}, coreMinor, extension};
}

/// Legal paths of Pico's controllers. `menuOfBoth`: the right one has a menu button, too.
Legal picoOf(int coreMinor, const QString& extension, bool menuOfBoth)
{
    const QStringList menu{"/input/menu/click"};
    return {poses + stick + (menuOfBoth ? menu : QStringList()) +
                QStringList{"/input/squeeze/click", "/input/squeeze/value", "/input/trigger/click",
                            "/input/trigger/touch", "/input/trigger/value", "/input/thumbstick/touch",
                            "/input/system/click"},
            xAndY + QStringList{"/input/x/touch", "/input/y/touch"} + (menuOfBoth ? QStringList() : menu),
            aAndB + QStringList{"/input/a/touch", "/input/b/touch"}, coreMinor, extension};
}

const QMap<QString, Legal> legalPaths{
    {"/interaction_profiles/khr/simple_controller",
     {poses + QStringList{"/input/select/click", "/input/menu/click"}, {}, {}}},
    {"/interaction_profiles/htc/vive_controller",
     {poses + QStringList{"/input/system/click", "/input/squeeze/click", "/input/menu/click", "/input/trigger/click",
                          "/input/trigger/value", "/input/trackpad/x", "/input/trackpad/y", "/input/trackpad/click",
                          "/input/trackpad/touch"},
      {},
      {}}},
    {"/interaction_profiles/microsoft/motion_controller",
     {poses + QStringList{"/input/menu/click", "/input/squeeze/click", "/input/trigger/value", "/input/thumbstick/x",
                          "/input/thumbstick/y", "/input/thumbstick/click", "/input/trackpad/x", "/input/trackpad/y",
                          "/input/trackpad/click", "/input/trackpad/touch"},
      {},
      {}}},
    {"/interaction_profiles/oculus/touch_controller",
     {poses + QStringList{"/input/squeeze/value", "/input/trigger/value", "/input/trigger/touch", "/input/thumbstick/x",
                          "/input/thumbstick/y", "/input/thumbstick/click", "/input/thumbstick/touch",
                          "/input/thumbrest/touch"},
      {"/input/x/click", "/input/x/touch", "/input/y/click", "/input/y/touch", "/input/menu/click"},
      {"/input/a/click", "/input/a/touch", "/input/b/click", "/input/b/touch", "/input/system/click"}}},
    {"/interaction_profiles/valve/index_controller",
     {poses + QStringList{"/input/system/click", "/input/system/touch", "/input/a/click", "/input/a/touch",
                          "/input/b/click", "/input/b/touch", "/input/squeeze/value", "/input/squeeze/force",
                          "/input/trigger/click", "/input/trigger/value", "/input/trigger/touch", "/input/thumbstick/x",
                          "/input/thumbstick/y", "/input/thumbstick/click", "/input/thumbstick/touch",
                          "/input/trackpad/x", "/input/trackpad/y", "/input/trackpad/force", "/input/trackpad/touch"},
      {},
      {}}},
    {"/interaction_profiles/htc/vive_cosmos_controller",
     {poses + stick +
          QStringList{"/input/shoulder/click", "/input/squeeze/click", "/input/trigger/click", "/input/trigger/value",
                      "/input/thumbstick/touch"},
      xAndY + QStringList{"/input/menu/click"}, aAndB + QStringList{"/input/system/click"}, 1,
      "XR_HTC_vive_cosmos_controller_interaction"}},
    {"/interaction_profiles/htc/vive_focus3_controller",
     {poses + stick +
          QStringList{"/input/squeeze/click", "/input/squeeze/touch", "/input/squeeze/value", "/input/trigger/click",
                      "/input/trigger/touch", "/input/trigger/value", "/input/thumbstick/touch",
                      "/input/thumbrest/touch"},
      xAndY + QStringList{"/input/menu/click"}, aAndB + QStringList{"/input/system/click"}, 1,
      "XR_HTC_vive_focus3_controller_interaction"}},
    {"/interaction_profiles/valve/frame_controller_valve",
     {poses + stick +
          QStringList{"/input/squeeze/click", "/input/squeeze/touch", "/input/squeeze/value", "/input/bumper/click",
                      "/input/bumper/touch", "/input/trigger/touch", "/input/trigger/value", "/input/thumbstick/touch"},
      {"/input/dpad_up/click", "/input/dpad_right/click", "/input/dpad_down/click", "/input/dpad_left/click",
       "/input/view/click"},
      xAndY + aAndB + QStringList{"/input/menu/click"},
      -1,
      "XR_VALVE_frame_controller_interaction"}},
    {"/interaction_profiles/meta/touch_plus_controller", touchOf(1, {})},
    {"/interaction_profiles/meta/touch_controller_plus", touchOf(-1, "XR_META_touch_controller_plus")},
    {"/interaction_profiles/meta/touch_pro_controller", touchOf(1, {})},
    {"/interaction_profiles/facebook/touch_controller_pro", touchOf(-1, "XR_FB_touch_controller_pro")},
    {"/interaction_profiles/bytedance/pico_neo3_controller", picoOf(1, "XR_BD_controller_interaction", true)},
    {"/interaction_profiles/bytedance/pico4_controller", picoOf(1, "XR_BD_controller_interaction", false)},
    {"/interaction_profiles/bytedance/pico_ultra_controller_bd",
     picoOf(-1, "XR_BD_ultra_controller_interaction", false)},
    {"/interaction_profiles/hp/mixed_reality_controller",
     {poses + stick + QStringList{"/input/menu/click", "/input/squeeze/value", "/input/trigger/value"}, xAndY, aAndB, 1,
      "XR_EXT_hp_mixed_reality_controller"}},
    {"/interaction_profiles/khr/generic_controller",
     {poses + stick +
          QStringList{"/input/primary/click", "/input/secondary/click", "/input/squeeze/value", "/input/trigger/value"},
      {},
      {},
      -1,
      "XR_KHR_generic_controller"}},
    {"/interaction_profiles/ext/hand_interaction_ext",
     {{"/input/grip/pose", "/input/aim/pose", "/input/pinch_ext/pose", "/input/poke_ext/pose", "/input/pinch_ext/value",
       "/input/pinch_ext/ready_ext", "/input/grasp_ext/value", "/input/grasp_ext/ready_ext",
       "/input/aim_activate_ext/value", "/input/aim_activate_ext/ready_ext"},
      {},
      {},
      -1,
      "XR_EXT_hand_interaction"}},
};

bool isHand(const vr::WandProfile& profile)
{
    return QString(profile.path).contains("hand_interaction");
}

/// Returns true if an action of this type may be bound to the path. A two-dimensional action is bound to the parent of
/// x and y.
bool isLegal(const QStringList& paths, const QString& path, XrActionType type)
{
    if (type == XR_ACTION_TYPE_VECTOR2F_INPUT)
        return paths.contains(path + "/x") && paths.contains(path + "/y");
    return paths.contains(path) && path.endsWith("/pose") == (type == XR_ACTION_TYPE_POSE_INPUT) &&
           path.startsWith("/output/") == (type == XR_ACTION_TYPE_VIBRATION_OUTPUT);
}

QSet<Control> controlsOf(const vr::WandProfile& profile, bool ofLeft)
{
    QSet<Control> controls;
    for (const Binding& binding : profile.bindings)
        if (ofLeft ? binding.left : binding.right)
            controls << binding.control;
    return controls;
}
} // namespace

class TestXrBindings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void profiles_areKnown();
    void profiles_belongToTheirVersions();
    void paths_areLegal();
    void controls_haveOnePartEach();
    void wands_canSculpt();
    void hands_canSculpt();
    void sticks_areTold();
    void names_areLegal();
};

void TestXrBindings::profiles_areKnown()
{
    QStringList profiles;
    for (const vr::WandProfile& profile : vr::wandProfiles())
        profiles << profile.path;
    QCOMPARE(profiles.first(), QString("/interaction_profiles/htc/vive_controller"));
    profiles.sort();
    QCOMPARE(profiles, legalPaths.keys());
}

/// Checks by which version or extension of OpenXR a runtime knows each profile.
void TestXrBindings::profiles_belongToTheirVersions()
{
    for (const vr::WandProfile& profile : vr::wandProfiles()) {
        const Legal legal = legalPaths[profile.path];
        for (const int minor : {0, 1}) {
            const XrVersion version = XR_MAKE_VERSION(1, static_cast<XrVersion>(minor), 20);
            QCOMPARE(profile.isInCore(version), legal.coreMinor >= 0 && legal.coreMinor <= minor);
        }
        QCOMPARE(QString(profile.extension), legal.extension);
        QVERIFY(profile.core != 0 || profile.extension);
    }
}

void TestXrBindings::paths_areLegal()
{
    for (const vr::WandProfile& profile : vr::wandProfiles()) {
        const Legal legal = legalPaths[profile.path];
        for (const Binding& binding : profile.bindings) {
            const XrActionType type = vr::controlKinds[static_cast<std::size_t>(binding.control)].type;
            if (binding.left)
                QVERIFY2(isLegal(legal.both + legal.left, binding.left, type), binding.left);
            if (binding.right)
                QVERIFY2(isLegal(legal.both + legal.right, binding.right, type), binding.right);
            QVERIFY(binding.left || binding.right);
        }
    }
}

/// Checks that no control has two parts of a wand, and no part has two controls.
void TestXrBindings::controls_haveOnePartEach()
{
    for (const vr::WandProfile& profile : vr::wandProfiles()) {
        QSet<Control> controls;
        QSet<QString> left, right;
        for (const Binding& binding : profile.bindings) {
            controls << binding.control;
            left << binding.left;
            right << binding.right;
        }
        QCOMPARE(controls.size(), qsizetype(profile.bindings.size()));
        QCOMPARE(left.size(), controls.size());
        QCOMPARE(right.size(), controls.size());
    }
}

/// Checks that every wand can aim, press, open the menu and vibrate with either hand, and that all except the simplest
/// have every control. Only a pad must sense touches.
void TestXrBindings::wands_canSculpt()
{
    const QSet<Control> least{Control::Grip, Control::Aim, Control::Trigger, Control::Menu, Control::Pulse};
    for (const vr::WandProfile& profile : vr::wandProfiles()) {
        for (const bool ofLeft : {false, true}) {
            const QSet<Control> controls = controlsOf(profile, ofLeft);
            QCOMPARE(controls.contains(Control::Pinch), isHand(profile));
            if (isHand(profile))
                continue;
            QVERIFY(controls.contains(least));
            QSet<Control> all = least;
            all << Control::Pad << Control::PadPress << Control::Side;
            if (!profile.isStick)
                all << Control::PadTouch;
            QVERIFY(QString(profile.path).contains("simple") || controls.contains(all));
        }
    }
}

/// Checks that a bare hand has all its gestures, on either side.
void TestXrBindings::hands_canSculpt()
{
    const QSet<Control> gestures{Control::Grip, Control::Aim, Control::Trigger, Control::Side, Control::Pinch};
    for (const vr::WandProfile& profile : vr::wandProfiles())
        for (const bool ofLeft : {false, true})
            if (isHand(profile))
                QCOMPARE(controlsOf(profile, ofLeft), gestures);
}

void TestXrBindings::sticks_areTold()
{
    for (const vr::WandProfile& profile : vr::wandProfiles())
        for (const Binding& binding : profile.bindings)
            if (binding.control == Control::Pad)
                QCOMPARE(profile.isStick, std::strstr(binding.left, "thumbstick") != nullptr);
}

void TestXrBindings::names_areLegal()
{
    QSet<QString> names;
    for (const vr::ControlKind& kind : vr::controlKinds) {
        const QString name = kind.name;
        QVERIFY(!name.isEmpty() && name.size() < XR_MAX_ACTION_NAME_SIZE);
        for (const QChar letter : name)
            QVERIFY((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
                    QString("-_.").contains(letter));
        names << name;
    }
    QCOMPARE(names.size(), qsizetype(vr::controlCount));
}

FETTLE_TEST(TestXrBindings, QCoreApplication)
#include "tst_xr_bindings.moc"
