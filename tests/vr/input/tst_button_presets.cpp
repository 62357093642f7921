#include "tests/support/test_main.h"
#include "vr/input/button_presets.h"
#include "vr/input/wand_mapping.h"

#include <QCoreApplication>
#include <QTest>
#include <QTranslator>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

using vr::ButtonPreset;
using vr::Gesture;
using vr::HandMode;
using vr::HandRole;
using vr::PresetRow;
using vr::WandFunction;

namespace
{
constexpr ButtonPreset presets[] = {ButtonPreset::Paper, ButtonPreset::Studio, ButtonPreset::OneHand};

/// Expected functions of one gesture, with the hand's panel closed and open.
struct Place
{
    HandRole hand;
    Gesture gesture;
    std::optional<WandFunction> closed, open;
};

constexpr HandRole support = HandRole::Support, dominant = HandRole::Sculpting; // left and right in the paper
constexpr std::optional<WandFunction> nothing;
using F = WandFunction;

/// The bindings of the paper, section 4.1. Gestures that the paper does not mention do nothing. Gesture::Slide is any
/// slide except up and down.
const Place paper[] = {
    {support, Gesture::PadLeft, F::TurnClockwise, F::PreviousTool},
    {support, Gesture::PadRight, F::TurnAnticlockwise, F::NextTool},
    {support, Gesture::PadTop, F::ToggleTopology, nothing},
    {support, Gesture::PadBottom, F::ToggleTopology, nothing},
    {support, Gesture::Slide, F::ScaleModel, F::ScaleModel},
    {support, Gesture::SlideUpDown, nothing, nothing},
    {support, Gesture::Menu, F::ToggleToolMenu, F::ToggleToolMenu},
    {support, Gesture::MenuTap, nothing, nothing},
    {support, Gesture::MenuHold, nothing, nothing},
    {support, Gesture::Trigger, F::MoveModel, F::MoveModel},
    {support, Gesture::Squeeze, nothing, nothing},
    {support, Gesture::SqueezeHold, F::SaveModel, F::SaveModel},
    {dominant, Gesture::PadTop, F::ToggleBrushShape, nothing},
    {dominant, Gesture::PadBottom, F::ToggleSymmetry, nothing},
    {dominant, Gesture::PadLeft, F::Undo, F::PreviousChannel},
    {dominant, Gesture::PadRight, F::Redo, F::NextChannel},
    {dominant, Gesture::Slide, F::SetRadius, nothing},
    {dominant, Gesture::SlideUpDown, nothing, F::SetChannel},
    {dominant, Gesture::Menu, F::ToggleColorPanel, F::ToggleColorPanel},
    {dominant, Gesture::MenuTap, nothing, nothing},
    {dominant, Gesture::MenuHold, nothing, nothing},
    {dominant, Gesture::Trigger, F::Sculpt, F::Sculpt},
    {dominant, Gesture::Squeeze, nothing, nothing},
    {dominant, Gesture::SqueezeHold, F::RestoreModel, F::RestoreModel},
};

/// The bindings common in other programs. Saving and restoring are on panels.
const Place studio[] = {
    {support, Gesture::PadLeft, F::Undo, F::Undo},
    {support, Gesture::PadRight, F::Redo, F::Redo},
    {support, Gesture::PadTop, F::ToggleTopology, F::ToggleTopology},
    {support, Gesture::PadBottom, F::ToggleTopology, F::ToggleTopology},
    {support, Gesture::Slide, nothing, nothing},
    {support, Gesture::SlideUpDown, nothing, nothing},
    {support, Gesture::Menu, F::ToggleToolMenu, F::ToggleToolMenu},
    {support, Gesture::MenuTap, nothing, nothing},
    {support, Gesture::MenuHold, nothing, nothing},
    {support, Gesture::Trigger, F::Smooth, F::Smooth},
    {support, Gesture::Squeeze, F::MoveModel, F::MoveModel},
    {support, Gesture::SqueezeHold, nothing, nothing},
    {dominant, Gesture::PadTop, F::ToggleBrushShape, nothing},
    {dominant, Gesture::PadBottom, F::ToggleSymmetry, nothing},
    {dominant, Gesture::PadLeft, F::PreviousTool, F::PreviousChannel},
    {dominant, Gesture::PadRight, F::NextTool, F::NextChannel},
    {dominant, Gesture::Slide, nothing, nothing},
    {dominant, Gesture::SlideUpDown, F::SetRadius, F::SetChannel},
    {dominant, Gesture::Menu, nothing, nothing},
    {dominant, Gesture::MenuTap, F::ToggleColorPanel, F::ToggleColorPanel},
    {dominant, Gesture::MenuHold, F::ToggleInverse, F::ToggleInverse},
    {dominant, Gesture::Trigger, F::Sculpt, F::Sculpt},
    {dominant, Gesture::Squeeze, F::MoveModel, F::MoveModel},
    {dominant, Gesture::SqueezeHold, nothing, nothing},
};

/// Bindings for one hand. The column `open` is for the colour panel, which takes precedence over the tools.
const Place oneHand[] = {
    {support, Gesture::PadLeft, nothing, nothing},
    {support, Gesture::PadRight, nothing, nothing},
    {support, Gesture::PadTop, nothing, nothing},
    {support, Gesture::PadBottom, nothing, nothing},
    {support, Gesture::Slide, nothing, nothing},
    {support, Gesture::SlideUpDown, nothing, nothing},
    {support, Gesture::Menu, nothing, nothing},
    {support, Gesture::MenuTap, nothing, nothing},
    {support, Gesture::MenuHold, nothing, nothing},
    {support, Gesture::Trigger, nothing, nothing},
    {support, Gesture::Squeeze, nothing, nothing},
    {support, Gesture::SqueezeHold, nothing, nothing},
    {dominant, Gesture::PadTop, F::ToggleInverse, nothing},
    {dominant, Gesture::PadBottom, F::ToggleSymmetry, nothing},
    {dominant, Gesture::PadLeft, F::Undo, F::PreviousChannel},
    {dominant, Gesture::PadRight, F::Redo, F::NextChannel},
    {dominant, Gesture::Slide, nothing, nothing},
    {dominant, Gesture::SlideUpDown, F::SetRadius, F::SetChannel},
    {dominant, Gesture::Menu, nothing, nothing},
    {dominant, Gesture::MenuTap, F::ToggleToolMenu, F::ToggleToolMenu},
    {dominant, Gesture::MenuHold, F::ToggleColorPanel, F::ToggleColorPanel},
    {dominant, Gesture::Trigger, F::Sculpt, F::Sculpt},
    {dominant, Gesture::Squeeze, F::MoveModel, F::MoveModel},
    {dominant, Gesture::SqueezeHold, nothing, nothing},
};

HandMode openMode(HandRole hand)
{
    return hand == HandRole::Support ? HandMode::ToolMenu : HandMode::ColorPanel;
}

bool isHeld(Gesture gesture)
{
    return gesture == Gesture::SqueezeHold || gesture == Gesture::MenuHold;
}

/// A translator that returns each text with its context, to show which context was used.
class ContextCollector : public QTranslator
{
public:
    using QTranslator::QTranslator;
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char*, int) const override
    {
        return QLatin1String(context) + QLatin1String(": ") + QLatin1String(text);
    }
};
} // namespace

class TestButtonPresets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachFunctionIsWhereItBelongs_data()
    {
        QTest::addColumn<ButtonPreset>("preset");
        QTest::addColumn<std::vector<Place>>("places");
        QTest::newRow("Paper") << ButtonPreset::Paper << std::vector<Place>(std::begin(paper), std::end(paper));
        QTest::newRow("Studio") << ButtonPreset::Studio << std::vector<Place>(std::begin(studio), std::end(studio));
        QTest::newRow("OneHand") << ButtonPreset::OneHand << std::vector<Place>(std::begin(oneHand), std::end(oneHand));
    }

    void eachFunctionIsWhereItBelongs()
    {
        QFETCH(ButtonPreset, preset);
        QFETCH(std::vector<Place>, places);
        QCOMPARE(places.size(), std::size_t(2 * (int(Gesture::SqueezeHold) + 1)));
        for (const Place& place : places) {
            QCOMPARE(vr::functionOf(preset, {place.hand, HandMode::Plain, place.gesture}), place.closed);
            QCOMPARE(vr::functionOf(preset, {place.hand, openMode(place.hand), place.gesture}), place.open);
        }
    }

    /// Checks the bindings of one hand with the tool menu open: it steps through tools and scales the model.
    void oneHandHasTheToolMenuToo()
    {
        const auto withTools = [](Gesture gesture) {
            return vr::functionOf(ButtonPreset::OneHand, {dominant, HandMode::ToolMenu, gesture});
        };
        QCOMPARE(withTools(Gesture::PadLeft), F::PreviousTool);
        QCOMPARE(withTools(Gesture::PadRight), F::NextTool);
        QCOMPARE(withTools(Gesture::SlideUpDown), F::ScaleModel);
        QCOMPARE(withTools(Gesture::MenuTap), F::ToggleToolMenu);
        QCOMPARE(withTools(Gesture::Trigger), F::Sculpt);
        vr::WandMapping hands({ButtonPreset::OneHand, vr::Side::Right});
        QVERIFY(hands.modeOf(vr::Side::Right) == HandMode::Plain && hands.modeOf(vr::Side::Left) == HandMode::Plain);
    }

    /// Checks that saving and restoring need a long press, because they write files or discard work.
    void savingAndRestoringAreHeld()
    {
        for (const ButtonPreset preset : presets)
            for (const PresetRow& row : vr::presetRows(preset))
                if (row.function == F::SaveModel || row.function == F::RestoreModel)
                    QVERIFY(isHeld(row.gesture));
    }

    /// Checks that a task replaces the functions of its own buttons of the sculpting hand, also their long presses, and
    /// no others.
    void tasksReplaceTheirButtonsOnly()
    {
        const auto isSideButton = [](Gesture gesture) {
            return gesture == Gesture::Squeeze || gesture == Gesture::SqueezeHold;
        };
        for (const auto task :
             {vr::HandTask::ChoosePart, vr::HandTask::PlaceShape, vr::HandTask::DrawTube, vr::HandTask::Cut}) {
            std::set<Gesture> own;
            for (const PresetRow& row : vr::taskRows(task)) {
                QVERIFY(row.hand == HandRole::Sculpting && row.mode == HandMode::Any);
                own.insert(row.gesture);
            }
            QVERIFY(!own.empty() && own.size() <= vr::maxTaskRows);
            for (const ButtonPreset preset : presets)
                for (const PresetRow& row : vr::presetRows(preset)) {
                    const bool isOwn =
                        row.hand == HandRole::Sculpting &&
                        (own.contains(row.gesture) || (isSideButton(row.gesture) && own.contains(Gesture::Squeeze)));
                    QCOMPARE(vr::isReplaced(row, task), isOwn);
                }
        }
    }

    /// Checks that each hand's bindings use only the modes of its own panel. For one hand there are both panels.
    void rowsAreOfTheHandsOwnModes()
    {
        for (const ButtonPreset preset : presets)
            for (const PresetRow& row : vr::presetRows(preset))
                QVERIFY(row.mode == HandMode::Any || row.mode == HandMode::Plain || row.mode == openMode(row.hand) ||
                        (preset == ButtonPreset::OneHand && row.hand == HandRole::Sculpting));
    }

    void labelsAreShortAndTheSameForTheSame()
    {
        std::map<WandFunction, std::set<QString>> labels;
        for (const ButtonPreset preset : presets)
            for (const PresetRow& row : vr::presetRows(preset)) {
                for (const bool isStick : {false, true}) {
                    const QString text = vr::labelOf(row, isStick);
                    QVERIFY(!text.isEmpty() && text.size() <= 20 && text.split(u' ').size() <= 3);
                }
                const QString label = vr::labelOf(row, false);
                QCOMPARE(label.startsWith(QStringLiteral("Hold: ")), isHeld(row.gesture));
                labels[row.function].insert(QString(label).remove(QStringLiteral("Hold: ")).toLower());
            }
        for (const auto& [function, texts] : labels)
            QVERIFY(texts.size() == 1);
    }

    /// Checks the functions of bare hands, which have three gestures, and that no fist of theirs saves or restores.
    void bareHandsHaveThreeGestures()
    {
        const auto functionOf = [](ButtonPreset preset, HandRole hand, Gesture gesture) {
            return vr::functionOf(preset, {.hand = hand, .mode = HandMode::Plain, .gesture = gesture, .isBare = true});
        };
        for (const ButtonPreset preset : presets) {
            const bool isOneHand = preset == ButtonPreset::OneHand;
            QVERIFY(vr::handRows(preset).size() <= vr::maxHandRows);
            QCOMPARE(functionOf(preset, dominant, Gesture::Trigger), F::Sculpt);
            QCOMPARE(functionOf(preset, dominant, Gesture::Squeeze), F::MoveModel);
            QCOMPARE(functionOf(preset, dominant, Gesture::Menu), isOneHand ? F::ToggleToolMenu : F::ToggleColorPanel);
            QCOMPARE(functionOf(preset, support, Gesture::Trigger), isOneHand ? nothing : F::Smooth);
            QCOMPARE(functionOf(preset, support, Gesture::Squeeze), isOneHand ? nothing : F::MoveModel);
            QCOMPARE(functionOf(preset, support, Gesture::Menu), isOneHand ? nothing : F::ToggleToolMenu);
            for (const PresetRow& row : vr::handRows(preset)) {
                QVERIFY(row.gesture == Gesture::Trigger || row.gesture == Gesture::Squeeze ||
                        row.gesture == Gesture::Menu);
                const QString label = vr::labelOf(row, false);
                QVERIFY(!label.isEmpty() && label.size() <= 20 && label.split(u' ').size() <= 3);
            }
        }
        const vr::WandControl cut{dominant, HandMode::Plain, Gesture::Trigger, vr::HandTask::Cut, true};
        QCOMPARE(vr::functionOf(ButtonPreset::Paper, cut), F::UseTip);
    }

    void labelsAreTranslated()
    {
        ContextCollector teller;
        QVERIFY(QCoreApplication::installTranslator(&teller));
        const QString label = vr::labelOf(vr::presetRows(ButtonPreset::Paper)[0], false);
        QCOMPARE(label, QStringLiteral("vr::Presets: Turn clockwise"));
        QCoreApplication::removeTranslator(&teller);
    }
};

FETTLE_TEST(TestButtonPresets, QCoreApplication)
#include "tst_button_presets.moc"
