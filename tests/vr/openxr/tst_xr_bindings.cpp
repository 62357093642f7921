// Checks that every suggested binding is legal for its profile, by the tables of section 6.4 of the OpenXR
// specification.
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
};

const QStringList poses{"/input/grip/pose", "/input/aim/pose", "/output/haptic"};

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
};

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
    void paths_areLegal();
    void controls_haveOnePartEach();
    void wands_canSculpt();
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
/// have every control.
void TestXrBindings::wands_canSculpt()
{
    const QSet<Control> least{Control::Grip, Control::Aim, Control::Trigger, Control::Menu, Control::Pulse};
    for (const vr::WandProfile& profile : vr::wandProfiles()) {
        for (const bool ofLeft : {false, true}) {
            const QSet<Control> controls = controlsOf(profile, ofLeft);
            QVERIFY(controls.contains(least));
            if (!QString(profile.path).contains("simple"))
                QCOMPARE(controls.size(), qsizetype(vr::controlCount));
        }
    }
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
