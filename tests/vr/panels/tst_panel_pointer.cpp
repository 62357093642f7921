#include "vr/panels/panel_pointer.h"

#include "tests/support/test_main.h"
#include "vr/input/wand_gestures.h"
#include "vr/panels/panel_content.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using core::Vec3;
using vr::PanelAction;
using vr::PanelCommand;
using vr::PanelItem;
using vr::PlacedPanel;

namespace
{
PlacedPanel placed(const vr::PanelContent& content, const Vec3& middle)
{
    return {{Eigen::Quaterniond::Identity(), middle}, std::make_shared<const vr::PanelLayout>(vr::layoutOf(content))};
}

/// A wand in front of panels that face +Z.
class Wand
{
public:
    explicit Wand(std::vector<PlacedPanel> panels) : m_panels(std::move(panels)) {}

    /// Aims at a place of a panel's item. `share`: (0, 0) is its upper left corner, (1, 1) its lower right corner.
    std::optional<PanelAction> at(std::size_t panel, const PanelAction& item, const QPointF& share = {0.5, 0.5})
    {
        return to(placeOf(panel, item, share));
    }
    Vec3 placeOf(std::size_t panel, const PanelAction& item, const QPointF& share = {0.5, 0.5}) const
    {
        const vr::PanelLayout& layout = *m_panels[panel].layout;
        const PanelItem* panelItem = layout.itemFor(item);
        const QPointF point = panelItem->area.topLeft() +
                              QPointF(share.x() * panelItem->area.width(), share.y() * panelItem->area.height());
        const Vec3 offset =
            Vec3(point.x() - layout.size.width() / 2, layout.size.height() / 2 - point.y(), 0) * layout.distance / 1000;
        return m_panels[panel].pose.position + offset;
    }
    std::optional<PanelAction> to(const Vec3& target) { return aim(ahead(core::Ray{from, target - from})); }
    std::optional<PanelAction> away() { return aim(ahead(core::Ray{from, Vec3::UnitZ()})); }
    /// Puts the tip `depth` metres behind the panel at the item, pointing straight at the panel.
    std::optional<PanelAction> poke(std::size_t panel, const PanelAction& item, double depth, bool mayPoke = true)
    {
        constexpr double length = 0.13;
        const Vec3 palm = placeOf(panel, item) + Vec3(0, 0, length - depth);
        return aim(vr::PanelPointer::Aim{{palm, -Vec3::UnitZ()}, length, mayPoke});
    }
    std::optional<PanelAction> lost() { return aim(std::nullopt); }
    /// Keeps the wand still for this many seconds. Returns the last action of any frame.
    std::optional<PanelAction> wait(double seconds)
    {
        std::optional<PanelAction> wanted;
        for (; seconds > 0; seconds -= vr::maxFrameSeconds)
            if (const std::optional<PanelAction> action = stall(std::min(seconds, vr::maxFrameSeconds)))
                wanted = action;
        return wanted;
    }
    /// Delivers one frame, this many seconds after the last one.
    std::optional<PanelAction> stall(double seconds)
    {
        m_time += seconds - frame;
        return aim(m_aim);
    }
    void replace(std::vector<PlacedPanel> panels) { m_panels = std::move(panels); }

    vr::PanelPointer pointer;
    const Vec3 from{0.1, 1.3, 0.5};

private:
    static constexpr double frame = 1.0 / 90;

    static vr::PanelPointer::Aim ahead(const core::Ray& ray) { return {ray, 0, true}; }
    std::optional<PanelAction> aim(const std::optional<vr::PanelPointer::Aim>& aim)
    {
        m_aim = aim;
        m_time += frame;
        return pointer.aim(aim, m_time, m_panels);
    }

    std::vector<PlacedPanel> m_panels;
    std::optional<vr::PanelPointer::Aim> m_aim;
    double m_time = 0;
};

vr::ToolPanel tools()
{
    vr::ToolPanel panel;
    panel.canUndo = true;
    return panel;
}

Wand beforeTools()
{
    return Wand({placed(tools(), {0, 1.3, 0})});
}

Wand beforeColors()
{
    return Wand({placed(vr::ColorPanel{.color = {100, 100, 100}, .swatches = {{1, 2, 3}}}, {0, 1.3, 0})});
}

const PanelAction undo = PanelCommand::Undo, restore = PanelCommand::RestoreModel, paint = core::Tool::Paint,
                  push = core::Tool::Push;
const PanelAction green = vr::Slide{vr::PanelSlider::Green, 0};
constexpr bool isClick = true;

int slidTo(const std::optional<PanelAction>& action)
{
    return action && std::holds_alternative<vr::Slide>(*action) ? static_cast<int>(std::get<vr::Slide>(*action).value)
                                                                : -1;
}
} // namespace

class TestPanelPointer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClick_actsWhenReleased();
    void aPressThatLeaves_doesNothing();
    void aPressThatComesBack_acts();
    void aPressThatBeganElsewhere_doesNothing();
    void aLostWand_clicksNothing();
    void whatIsDisabled_isNotPressed();
    void aSlider_actsWhileItIsHeld();
    void aSlider_followsBeyondThePanel();
    void aSlider_keepsItsValueWhenTheWandIsLost();
    void aHold_actsOnceAndInTime();
    void aHold_endsWhenItIsLeft();
    void aHold_isNoClick();
    void aHold_isNotHeldByAStall();
    void theNearestPanel_isMeant();
    void aPress_staysOnItsPanel();
    void aPanelThatGoes_takesThePressAlong();
    void anItemThatChanges_isStillTheSame();
    void anItemThatMustBeHeldByNow_isNotClicked();
    void aPoke_actsWhenItIsDrawnBack();
    void aPoke_fromElsewhereDoesNothing();
    void aPoke_setsASlider();
    void aTriggerWithinAPoke_actsOnce();
    void aHandElsewhere_pointsAtNothing();
    void whereItPoints_isOnThePanel();
    void aTouch_isWhatThePictureShows();
};

void TestPanelPointer::aClick_actsWhenReleased()
{
    Wand wand = beforeTools();
    QVERIFY(!wand.at(0, paint));
    QVERIFY(!wand.pointer.press());
    QVERIFY(!wand.at(0, paint, {0.1, 0.9}));
    QVERIFY(!wand.wait(3));
    QVERIFY(wand.pointer.release(isClick) == paint);
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::aPressThatLeaves_doesNothing()
{
    Wand wand = beforeTools();
    for (const bool toAnother : {true, false}) {
        wand.at(0, paint);
        wand.pointer.press();
        QVERIFY(!(toAnother ? wand.at(0, push) : wand.away()));
        QVERIFY(!wand.pointer.release(isClick));
    }
}

void TestPanelPointer::aPressThatComesBack_acts()
{
    Wand wand = beforeTools();
    wand.at(0, paint);
    wand.pointer.press();
    wand.at(0, push);
    wand.lost();
    wand.at(0, paint);
    QVERIFY(wand.pointer.release(isClick) == paint);
}

void TestPanelPointer::aPressThatBeganElsewhere_doesNothing()
{
    Wand wand = beforeTools();
    wand.away();
    QVERIFY(!wand.pointer.press());
    wand.at(0, paint);
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::aLostWand_clicksNothing()
{
    Wand wand = beforeTools();
    wand.at(0, paint);
    wand.pointer.press();
    QVERIFY(!wand.pointer.release(!isClick));
    wand.pointer.press();
    wand.lost();
    QVERIFY(!wand.pointer.spot());
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::whatIsDisabled_isNotPressed()
{
    const PlacedPanel able = placed(tools(), {0, 1.3, 0}), unable = placed(vr::ToolPanel(), {0, 1.3, 0});
    Wand wand({able});
    wand.at(0, undo);
    wand.replace({unable});
    wand.wait(0.1);
    QVERIFY(!wand.pointer.touch(vr::PanelKind::Tools));
    wand.pointer.press();
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::aSlider_actsWhileItIsHeld()
{
    Wand wand = beforeColors();
    QVERIFY(!wand.at(0, green, {0.2, 0.5}));
    const int first = slidTo(wand.pointer.press());
    QVERIFY(first > 20 && first < 80);
    QVERIFY(!wand.wait(0.1));
    int before = first;
    for (double share = 0.3; share < 0.95; share += 0.1) {
        const int value = slidTo(wand.at(0, green, {share, 0.2}));
        QVERIFY(value > before);
        before = value;
    }
    QVERIFY(!wand.pointer.release(isClick));
    QVERIFY(!wand.at(0, green, {0.3, 0.5}));
}

void TestPanelPointer::aSlider_followsBeyondThePanel()
{
    Wand wand = beforeColors();
    wand.at(0, green);
    wand.pointer.press();
    QCOMPARE(slidTo(wand.at(0, green, {4, 3})), 255);
    QVERIFY(wand.pointer.spot());
    QCOMPARE(slidTo(wand.at(0, green, {-4, -3})), 0);
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::aSlider_keepsItsValueWhenTheWandIsLost()
{
    Wand wand = beforeColors();
    wand.at(0, green, {0.7, 0.5});
    wand.pointer.press();
    QVERIFY(!wand.lost());
    QVERIFY(!wand.away());
    QVERIFY(slidTo(wand.at(0, green, {0.8, 0.5})) > 0);
}

void TestPanelPointer::aHold_actsOnceAndInTime()
{
    Wand wand = beforeTools();
    wand.at(0, restore);
    QVERIFY(!wand.pointer.press());
    QVERIFY(!wand.wait(vr::holdSeconds - 0.05));
    QVERIFY(wand.wait(0.1) == restore);
    QVERIFY(!wand.wait(2));
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::aHold_endsWhenItIsLeft()
{
    for (const bool isLost : {true, false}) {
        Wand wand = beforeTools();
        wand.at(0, restore);
        wand.pointer.press();
        wand.wait(0.5);
        if (isLost)
            wand.lost();
        else
            wand.at(0, paint);
        QVERIFY(!wand.at(0, restore));
        QVERIFY(!wand.wait(3));
        QVERIFY(!wand.pointer.release(isClick));
    }
}

void TestPanelPointer::aHold_isNoClick()
{
    Wand wand = beforeTools();
    wand.at(0, restore);
    wand.pointer.press();
    wand.wait(0.4);
    QVERIFY(!wand.pointer.release(isClick));
}

/// Checks that a long gap between frames does not count as holding: a release during the gap is only seen in the next
/// frame.
void TestPanelPointer::aHold_isNotHeldByAStall()
{
    Wand wand = beforeTools();
    wand.at(0, restore);
    wand.pointer.press();
    wand.wait(0.3);
    QVERIFY(!wand.stall(5));
    QVERIFY(wand.wait(vr::holdSeconds - 0.3) == restore);
}

void TestPanelPointer::theNearestPanel_isMeant()
{
    const PlacedPanel near = placed(vr::ColorPanel{.color = {}, .swatches = {{1, 2, 3}}}, {0, 1.3, 0.1}),
                      far = placed(tools(), {0, 1.3, 0});
    PlacedPanel turned = near;
    turned.pose.rotation = Eigen::AngleAxisd(3.14159, Vec3::UnitY());
    for (const auto& panels : {std::vector{near, far}, std::vector{far, near}}) {
        Wand wand(panels);
        wand.to({0, 1.3, 0});
        QVERIFY(wand.pointer.spot()->kind == vr::PanelKind::Color);
    }
    Wand wand({turned, far});
    wand.to({0, 1.3, 0});
    QVERIFY(wand.pointer.spot()->kind == vr::PanelKind::Tools);
}

void TestPanelPointer::aPress_staysOnItsPanel()
{
    Wand wand(
        {placed(tools(), {0, 1.3, 0}), placed(vr::ColorPanel{.color = {}, .swatches = {{1, 2, 3}}}, {0.6, 1.3, 0})});
    wand.at(0, paint);
    wand.pointer.press();
    wand.at(1, vr::ChooseColor{{1, 2, 3}});
    QVERIFY(!wand.pointer.touch(vr::PanelKind::Color));
    QVERIFY(!wand.pointer.spot());
    QVERIFY(!wand.pointer.release(isClick));
    wand.wait(0.1);
    QVERIFY(wand.pointer.spot()->kind == vr::PanelKind::Color);
}

void TestPanelPointer::aPanelThatGoes_takesThePressAlong()
{
    Wand wand = beforeTools();
    wand.at(0, paint);
    wand.pointer.press();
    wand.replace({});
    wand.wait(0.1);
    wand.replace({placed(tools(), {0, 1.3, 0})});
    wand.wait(0.1);
    QVERIFY(!wand.pointer.release(isClick));
}

/// Checks that a press continues on an item whose contents change meanwhile.
void TestPanelPointer::anItemThatChanges_isStillTheSame()
{
    Wand wand = beforeTools();
    wand.at(0, paint);
    wand.pointer.press();
    vr::ToolPanel other = tools();
    other.tool = core::Tool::Smooth;
    wand.replace({placed(other, {0, 1.3, 0})});
    wand.wait(0.1);
    QVERIFY(wand.pointer.release(isClick) == paint);
    wand.pointer.press();
    wand.replace({placed(other, {0.1, 1.3, 0})}); // moved by more than an item's width
    wand.wait(0.1);
    QVERIFY(!wand.pointer.release(isClick));
}

/// Checks an item that must be held instead of clicked after somebody at the window sculpts between press and release.
void TestPanelPointer::anItemThatMustBeHeldByNow_isNotClicked()
{
    vr::FilesPanel files;
    files.files << vr::FileTile{QStringLiteral("a"), QStringLiteral("a"), {}, false};
    files.chosen = QStringLiteral("a");
    const Vec3 middle(0, 1.3, 0);
    Wand wand({placed(files, middle)});
    const PanelAction open = vr::OpenFile{QStringLiteral("a")};
    wand.at(0, open);
    wand.pointer.press();
    wand.wait(0.1);
    QVERIFY(wand.pointer.release(isClick) == open);

    wand.pointer.press();
    files.hasUnsavedChanges = true;
    wand.replace({placed(files, middle)});
    wand.wait(0.1);
    QVERIFY(!wand.pointer.release(isClick));
}

void TestPanelPointer::aPoke_actsWhenItIsDrawnBack()
{
    Wand wand = beforeTools();
    for (const double depth : {0.001, 0.03, 0.1}) {
        QVERIFY(!wand.poke(0, paint, -0.03));
        QVERIFY(!wand.poke(0, paint, depth));
        QVERIFY((wand.pointer.touch(vr::PanelKind::Tools) == vr::PanelTouch{paint, true, 0}));
        QVERIFY(wand.pointer.spot()); // while there is a spot, the trigger presses instead of sculpting
        QVERIFY(wand.poke(0, paint, -0.01) == paint);
        QVERIFY(!wand.poke(0, paint, -0.03));
    }
}

/// Moves the tip through an item from behind, from the side, out at the side, over another item, and with a hand that
/// is busy.
void TestPanelPointer::aPoke_fromElsewhereDoesNothing()
{
    Wand wand = beforeTools();
    wand.lost();
    QVERIFY(!wand.poke(0, paint, 0.03));
    QVERIFY(!wand.poke(0, paint, -0.03));
    QVERIFY(!wand.poke(0, paint, 0.03));
    QVERIFY(!wand.poke(0, push, -0.03));
    QVERIFY(!wand.poke(0, paint, 0.03));
    QVERIFY(!wand.lost());
    QVERIFY(!wand.poke(0, paint, -0.03));
    QVERIFY(!wand.poke(0, paint, 0.03, false));
    QVERIFY(!wand.poke(0, paint, 0.03));
    QVERIFY(!wand.poke(0, paint, -0.03));
}

void TestPanelPointer::aPoke_setsASlider()
{
    Wand wand = beforeColors();
    wand.poke(0, green, -0.03);
    QVERIFY(slidTo(wand.poke(0, green, 0.01)) > 0);
    QVERIFY(!wand.poke(0, green, -0.03));
}

void TestPanelPointer::aTriggerWithinAPoke_actsOnce()
{
    Wand wand = beforeTools();
    wand.poke(0, paint, -0.03);
    wand.poke(0, paint, 0.03);
    QVERIFY(!wand.pointer.press());
    QVERIFY(!wand.wait(0.2));
    QVERIFY(wand.pointer.release(isClick) == paint);
    QVERIFY(!wand.poke(0, paint, -0.03));
}

/// Checks that a hand that sculpts does not highlight items of a panel behind.
void TestPanelPointer::aHandElsewhere_pointsAtNothing()
{
    Wand wand = beforeTools();
    wand.at(0, paint);
    wand.pointer.lookAway();
    QVERIFY(!wand.pointer.touch(vr::PanelKind::Tools) && !wand.pointer.spot());
    wand.at(0, paint);
    wand.pointer.press();
    wand.pointer.lookAway(); // a pressed item stays pressed
    QVERIFY(wand.pointer.release(isClick) == paint);
}

void TestPanelPointer::whereItPoints_isOnThePanel()
{
    Wand wand = beforeTools();
    wand.to({0.05, 1.25, 0});
    QVERIFY((wand.pointer.spot()->point - Vec3(0.05, 1.25, 0)).norm() < 1e-9);
    wand.to({2, 1.25, 0});
    QVERIFY(!wand.pointer.spot());
    wand.away();
    QVERIFY(!wand.pointer.spot());
}

void TestPanelPointer::aTouch_isWhatThePictureShows()
{
    const auto kind = vr::PanelKind::Tools;
    Wand wand = beforeTools();
    wand.at(0, paint);
    QVERIFY(wand.pointer.touch(kind) == vr::PanelTouch{paint});
    QVERIFY(!wand.pointer.touch(vr::PanelKind::Color));
    wand.pointer.press();
    QVERIFY((wand.pointer.touch(kind) == vr::PanelTouch{paint, true, 0}));
    wand.at(0, push);
    QVERIFY(!wand.pointer.touch(kind));
    wand.pointer.release(isClick);
    QVERIFY(wand.pointer.touch(kind) == vr::PanelTouch{push});

    wand.at(0, restore);
    wand.pointer.press();
    wand.wait(vr::holdSeconds / 2);
    QVERIFY(std::abs(wand.pointer.touch(kind)->held - 0.5) < 0.05);
    wand.wait(1);
    QVERIFY(!wand.pointer.touch(kind));
    wand.pointer.release(isClick);
    QVERIFY(wand.pointer.touch(kind) == vr::PanelTouch{restore});
}

FETTLE_TEST(TestPanelPointer, QCoreApplication)
#include "tst_panel_pointer.moc"
