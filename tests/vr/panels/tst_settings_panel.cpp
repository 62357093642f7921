#include "vr/panels/panel_content.h"

#include <QTest>

#include <limits>

using vr::HeadsetChoice;
using vr::PanelAction;
using vr::PanelSlider;
using vr::SettingsPage;
using vr::SettingsPanel;
using vr::Slide;

namespace
{
/// All that the page's items offer for that choice; sliders both their ends.
std::vector<PanelAction> offers(const HeadsetChoice& choice, SettingsPage page)
{
    std::vector<PanelAction> all;
    const vr::PanelLayout layout = SettingsPanel::of(choice, page).layout();
    for (const vr::PanelPart& part : layout.parts) {
        if (!part.answers())
            continue;
        all.push_back(vr::actionAt(part, part.area.topLeft()));
        if (part.isSlider())
            all.push_back(vr::actionAt(part, part.area.bottomRight()));
    }
    return all;
}

HeadsetChoice after(const PanelAction& action)
{
    return SettingsPanel::after(HeadsetChoice(), action);
}

double valueOf(const HeadsetChoice& choice, PanelSlider slider)
{
    if (slider == PanelSlider::Height)
        return choice.raised;
    if (slider == PanelSlider::TurnSpeed)
        return choice.turnsBy;
    return choice.feel.of[static_cast<std::size_t>(slider) - static_cast<std::size_t>(PanelSlider::Contact)];
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
};

void TestSettingsPanel::itHoldsTheChoice()
{
    const HeadsetChoice choice{
        .hands = {vr::Preset::Studio, vr::Side::Left}, .raised = -0.1, .turnsBy = 35, .showsFloor = false, .feel = {}};
    const SettingsPanel panel = SettingsPanel::of(choice, SettingsPage::Feel);
    QVERIFY(panel.choice == choice && panel.page == SettingsPage::Feel);
}

void TestSettingsPanel::anItem_changesWhatItSays()
{
    HeadsetChoice studio, left, bare, numbers;
    studio.hands.preset = vr::Preset::Studio;
    left.hands.sculpting = vr::Side::Left;
    bare.showsFloor = false;
    numbers.showsPerformance = true;
    QVERIFY(after(vr::Preset::Studio) == studio);
    QVERIFY(after(vr::ChooseHand{vr::Side::Left}) == left);
    QVERIFY(after(vr::ShowFloor{false}) == bare);
    QVERIFY(after(vr::ShowPerformance{true}) == numbers);
}

void TestSettingsPanel::aSlider_changesItsValueOnly()
{
    for (const PanelSlider moved : sliders) {
        const double wanted = moved == PanelSlider::TurnSpeed ? 45 : 0.25;
        const HeadsetChoice choice = after(Slide{moved, wanted});
        for (const PanelSlider slider : sliders)
            QCOMPARE(valueOf(choice, slider), slider == moved ? wanted : valueOf({}, slider));
        QVERIFY(choice.hands == HeadsetChoice().hands && choice.showsFloor && !choice.showsPerformance);
    }
}

void TestSettingsPanel::aValue_staysInItsRange()
{
    const double most = std::numeric_limits<double>::infinity();
    for (const PanelSlider slider : sliders) {
        const bool isHeight = slider == PanelSlider::Height, isTurn = slider == PanelSlider::TurnSpeed;
        const double low = isHeight ? -SettingsPanel::mostRaised : isTurn ? SettingsPanel::slowestTurn : 0;
        const double high = isHeight ? SettingsPanel::mostRaised : isTurn ? SettingsPanel::fastestTurn : 1;
        for (const double wild : {-1000.0, -most, std::numeric_limits<double>::quiet_NaN()})
            QCOMPARE(valueOf(after(Slide{slider, wild}), slider), low);
        for (const double wild : {1000.0, most})
            QCOMPARE(valueOf(after(Slide{slider, wild}), slider), high);
    }
}

void TestSettingsPanel::whatIsNoSetting_changesNothing()
{
    const PanelAction others[] = {vr::PanelCommand::LeaveVr, core::Tool::Paint,          core::BrushShape::Ray,
                                  core::Topology::Uniform,   SettingsPage::Feel,         vr::ShowPanel{},
                                  vr::ShowPage{2},           vr::ChooseChannel{2},       vr::ChooseColor{{1, 2, 3}},
                                  vr::ChooseSymmetry{},      vr::ChooseRadial{6},       Slide{PanelSlider::Red, 7}, vr::OpenFile{},
                                  vr::ChooseFile{}};
    for (const PanelAction& action : others)
        QVERIFY(after(action) == HeadsetChoice());
}

/// By what the pages offer.
void TestSettingsPanel::everySetting_canBeReached()
{
    const auto canBecome = [](const auto& isSo) {
        for (const SettingsPage page : {SettingsPage::General, SettingsPage::Feel})
            for (const PanelAction& action : offers({}, page))
                if (isSo(after(action)))
                    return true;
        return false;
    };
    for (const vr::Preset preset : {vr::Preset::Studio, vr::Preset::OneHand})
        QVERIFY(canBecome([&](const HeadsetChoice& c) { return c.hands.preset == preset; }));
    QVERIFY(canBecome([](const HeadsetChoice& c) { return c.hands.sculpting == vr::Side::Left; }));
    QVERIFY(canBecome([](const HeadsetChoice& c) { return !c.showsFloor; }));
    QVERIFY(canBecome([](const HeadsetChoice& c) { return c.showsPerformance; }));
    for (const double raised : {-SettingsPanel::mostRaised, SettingsPanel::mostRaised})
        QVERIFY(canBecome([&](const HeadsetChoice& c) { return c.raised == raised; }));
    for (const double speed : {SettingsPanel::slowestTurn, SettingsPanel::fastestTurn})
        QVERIFY(canBecome([&](const HeadsetChoice& c) { return c.turnsBy == speed; }));
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        QVERIFY(canBecome([&](const HeadsetChoice& c) { return c.feel.of[i] == 0; }));
}

void TestSettingsPanel::whatWasChosen_isShownAsChosen()
{
    for (const PanelAction& action : offers({}, SettingsPage::General)) {
        const vr::PanelLayout layout = SettingsPanel::of(after(action), SettingsPage::General).layout();
        const vr::PanelPart* part = layout.partFor(action);
        if (std::holds_alternative<vr::Preset>(action) || std::holds_alternative<vr::ChooseHand>(action))
            QVERIFY(std::get<vr::ButtonLook>(part->look).isChosen);
        if (const auto* slide = std::get_if<Slide>(&action))
            QCOMPARE(std::get<Slide>(*part->action).value, slide->value);
        if (const auto* ground = std::get_if<vr::ShowFloor>(&action)) // its item wants the other from now on
            QVERIFY(!part && layout.partFor(vr::ShowFloor{!ground->isShown}));
    }
}

QTEST_GUILESS_MAIN(TestSettingsPanel)
#include "tst_settings_panel.moc"
