#include "vr/panels/panel_content.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <limits>

using vr::HeadsetSettings;
using vr::PanelAction;
using vr::PanelSlider;
using vr::SettingsPage;
using vr::SettingsPanel;
using vr::Slide;

namespace
{
/// Returns all actions that the page's items offer for these settings, with both ends of each slider.
std::vector<PanelAction> offers(const HeadsetSettings& choice, SettingsPage page)
{
    std::vector<PanelAction> all;
    const vr::PanelLayout layout = SettingsPanel::of(choice, page).layout();
    for (const vr::PanelItem& item : layout.items) {
        if (!item.isInteractive())
            continue;
        all.push_back(vr::actionAt(item, item.area.topLeft()));
        if (item.isSlider())
            all.push_back(vr::actionAt(item, item.area.bottomRight()));
    }
    return all;
}

HeadsetSettings after(const PanelAction& action)
{
    return SettingsPanel::after(HeadsetSettings(), action);
}

double valueOf(const HeadsetSettings& choice, PanelSlider slider)
{
    if (slider == PanelSlider::Height)
        return choice.heightOffset;
    if (slider == PanelSlider::TurnSpeed)
        return choice.turnRate;
    return choice.hapticLevels.of[static_cast<std::size_t>(slider) - static_cast<std::size_t>(PanelSlider::Contact)];
}

constexpr std::array sliders{PanelSlider::Height, PanelSlider::TurnSpeed, PanelSlider::Contact,  PanelSlider::Texture,
                             PanelSlider::Fusion, PanelSlider::Refusal,   PanelSlider::MenuStep, PanelSlider::Hold};
} // namespace

class TestSettingsPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itHoldsTheChoice();
    void anItem_changesWhatItSays();
    void aSlider_changesItsValueOnly();
    void aValue_staysInItsRange();
    void whatIsNoSetting_changesNothing();
    void everySetting_canBeReached();
    void whatWasChosen_isShownAsChosen();
    void passthrough_isOfferedIfTheHeadsetHasIt();
};

void TestSettingsPanel::itHoldsTheChoice()
{
    const HeadsetSettings choice{.wands = {vr::ButtonPreset::Studio, vr::Side::Left},
                                 .heightOffset = -0.1,
                                 .turnRate = 35,
                                 .showsFloor = false,
                                 .hapticLevels = {}};
    const SettingsPanel panel = SettingsPanel::of(choice, SettingsPage::Haptics);
    QVERIFY(panel.settings == choice && panel.page == SettingsPage::Haptics);
}

void TestSettingsPanel::anItem_changesWhatItSays()
{
    HeadsetSettings studio, left, bare, numbers, room;
    studio.wands.preset = vr::ButtonPreset::Studio;
    left.wands.sculpting = vr::Side::Left;
    bare.showsFloor = false;
    numbers.showsPerformance = true;
    room.hasPassthrough = true;
    QVERIFY(after(vr::ButtonPreset::Studio) == studio);
    QVERIFY(after(vr::ChooseHand{vr::Side::Left}) == left);
    QVERIFY(after(vr::ShowFloor{false}) == bare);
    QVERIFY(after(vr::ShowPerformance{true}) == numbers);
    QVERIFY(after(vr::ShowPassthrough{true}) == room);
}

void TestSettingsPanel::aSlider_changesItsValueOnly()
{
    for (const PanelSlider moved : sliders) {
        const double wanted = moved == PanelSlider::TurnSpeed ? 45 : 0.25;
        const HeadsetSettings choice = after(Slide{moved, wanted});
        for (const PanelSlider slider : sliders)
            QCOMPARE(valueOf(choice, slider), slider == moved ? wanted : valueOf({}, slider));
        QVERIFY(choice.wands == HeadsetSettings().wands && choice.showsFloor && !choice.showsPerformance);
    }
}

void TestSettingsPanel::aValue_staysInItsRange()
{
    const double max = std::numeric_limits<double>::infinity();
    for (const PanelSlider slider : sliders) {
        const bool isHeight = slider == PanelSlider::Height, isTurn = slider == PanelSlider::TurnSpeed;
        const double low = isHeight ? -SettingsPanel::maxHeightOffset : isTurn ? SettingsPanel::minTurnRate : 0;
        const double high = isHeight ? SettingsPanel::maxHeightOffset : isTurn ? SettingsPanel::maxTurnRate : 1;
        for (const double wild : {-1000.0, -max, std::numeric_limits<double>::quiet_NaN()})
            QCOMPARE(valueOf(after(Slide{slider, wild}), slider), low);
        for (const double wild : {1000.0, max})
            QCOMPARE(valueOf(after(Slide{slider, wild}), slider), high);
    }
}

void TestSettingsPanel::whatIsNoSetting_changesNothing()
{
    const PanelAction others[] = {vr::PanelCommand::LeaveVr,
                                  core::Tool::Paint,
                                  core::BrushShape::Ray,
                                  core::Topology::Uniform,
                                  SettingsPage::Haptics,
                                  vr::ShowPanel{},
                                  vr::ShowPage{2},
                                  vr::ChooseChannel{2},
                                  vr::ChooseColor{{1, 2, 3}},
                                  vr::ChooseSymmetry{},
                                  vr::ChooseRadial{6},
                                  Slide{PanelSlider::Red, 7},
                                  vr::OpenFile{},
                                  vr::ChooseFile{}};
    for (const PanelAction& action : others)
        QVERIFY(after(action) == HeadsetSettings());
}

/// Checks that each setting can be reached by the actions that the pages offer.
void TestSettingsPanel::everySetting_canBeReached()
{
    const auto canBecome = [](const auto& isSo) {
        for (const SettingsPage page : {SettingsPage::General, SettingsPage::Haptics})
            for (const PanelAction& action : offers({}, page))
                if (isSo(after(action)))
                    return true;
        return false;
    };
    for (const vr::ButtonPreset preset : {vr::ButtonPreset::Studio, vr::ButtonPreset::OneHand})
        QVERIFY(canBecome([&](const HeadsetSettings& c) { return c.wands.preset == preset; }));
    QVERIFY(canBecome([](const HeadsetSettings& c) { return c.wands.sculpting == vr::Side::Left; }));
    QVERIFY(canBecome([](const HeadsetSettings& c) { return !c.showsFloor; }));
    QVERIFY(canBecome([](const HeadsetSettings& c) { return c.showsPerformance; }));
    QVERIFY(canBecome([](const HeadsetSettings& c) { return c.hasPassthrough; }));
    for (const double heightOffset : {-SettingsPanel::maxHeightOffset, SettingsPanel::maxHeightOffset})
        QVERIFY(canBecome([&](const HeadsetSettings& c) { return c.heightOffset == heightOffset; }));
    for (const double speed : {SettingsPanel::minTurnRate, SettingsPanel::maxTurnRate})
        QVERIFY(canBecome([&](const HeadsetSettings& c) { return c.turnRate == speed; }));
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        QVERIFY(canBecome([&](const HeadsetSettings& c) { return c.hapticLevels.of[i] == 0; }));
}

void TestSettingsPanel::whatWasChosen_isShownAsChosen()
{
    for (const PanelAction& action : offers({}, SettingsPage::General)) {
        const vr::PanelLayout layout = SettingsPanel::of(after(action), SettingsPage::General).layout();
        const vr::PanelItem* item = layout.itemFor(action);
        if (std::holds_alternative<vr::ButtonPreset>(action) || std::holds_alternative<vr::ChooseHand>(action))
            QVERIFY(std::get<vr::ButtonLook>(item->look).isChosen);
        if (const auto* slide = std::get_if<Slide>(&action))
            QCOMPARE(std::get<Slide>(*item->action).value, slide->value);
        if (const auto* ground = std::get_if<vr::ShowFloor>(&action)) // the item then offers the opposite action
            QVERIFY(!item && layout.itemFor(vr::ShowFloor{!ground->isShown}));
    }
}

void TestSettingsPanel::passthrough_isOfferedIfTheHeadsetHasIt()
{
    for (const bool isOffered : {true, false}) {
        const vr::PanelLayout layout = SettingsPanel{SettingsPage::General, {}, isOffered}.layout();
        QCOMPARE(layout.itemFor(vr::ShowPassthrough{true}) != nullptr, isOffered);
        const auto item = std::ranges::find_if(layout.items, [](const vr::PanelItem& i) {
            return i.action && std::holds_alternative<vr::ShowPassthrough>(*i.action);
        });
        QVERIFY(item != layout.items.end());
        QCOMPARE(std::get<vr::SwitchLook>(item->look).text,
                 isOffered ? QString("Off") : QString("Not on this headset"));
    }
}

FETTLE_TEST(TestSettingsPanel, QCoreApplication)
#include "tst_settings_panel.moc"
