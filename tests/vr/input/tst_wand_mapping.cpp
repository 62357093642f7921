#include "vr/input/wand_mapping.h"

#include "tests/support/test_main.h"
#include "tests/vr/input/command_names.h"
#include "tests/vr/input/hand_motion.h"

#include "vr/input/model_placement.h"

#include <QTest>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

using core::Vec3;
using Eigen::Vector2d;
using vr::ButtonPreset;
using vr::Gesture;
using vr::HandRole;
using vr::InputFrame;
using vr::Pose;
using vr::Side;
using vr::WandCommand;
using vr::WandFunction;
using vr::WandMapping;
using vr::WandState;

namespace
{
constexpr ButtonPreset everyPreset[] = {ButtonPreset::Paper, ButtonPreset::Studio, ButtonPreset::OneHand};
constexpr Side sides[] = {Side::Left, Side::Right};
constexpr HandRole roles[] = {HandRole::Sculpting, HandRole::Support};
constexpr unsigned seed = 20261122;

std::size_t indexOf(Side side)
{
    return static_cast<std::size_t>(side);
}

Side opposite(Side side)
{
    return side == Side::Left ? Side::Right : Side::Left;
}

QStringList words(const std::vector<WandCommand>& commands)
{
    QStringList all;
    for (const WandCommand& command : commands)
        all << commandName(command);
    return all;
}

template <class T> std::vector<T> all(const std::vector<WandCommand>& commands)
{
    std::vector<T> found;
    for (const WandCommand& command : commands)
        if (const T* action = std::get_if<T>(&command.action))
            found.push_back(*action);
    return found;
}

/// A person with two resting wands, at 90 frames per second.
class Player
{
public:
    explicit Player(const vr::WandSettings& choice = {}) : m_hands(choice)
    {
        for (const Side side : sides)
            rest(side);
        play(frameLength);
    }

    WandMapping& hands() { return m_hands; }
    Side sculpting() const { return m_hands.settings().sculpting; }
    Side support() const { return opposite(sculpting()); }

    WandState& wand(Side side) { return m_frame.wands[indexOf(side)]; }
    void rest(Side side) { set(side, restingWand()); }
    /// Sets the buttons; the wand stays where it is.
    void set(Side side, const WandState& state)
    {
        const WandState before = wand(side);
        wand(side) = state;
        wand(side).grip = before.grip;
        wand(side).aim = before.aim;
    }
    void move(Side side, const Vec3& by)
    {
        wand(side).grip.position += by;
        wand(side).aim.position += by;
    }
    void pointAtPanel(Side side, bool points) { m_frame.pointsAtPanel[indexOf(side)] = points; }

    /// Plays one frame.
    std::vector<WandCommand> step()
    {
        m_frame.time += frameLength;
        return m_hands.step(m_frame);
    }

    /// Plays frames for this many seconds with unchanged wands.
    std::vector<WandCommand> play(double seconds)
    {
        std::vector<WandCommand> commands;
        for (double time = 0; time < seconds - 1e-9; time += frameLength)
            for (const WandCommand& command : step())
                commands.push_back(command);
        return commands;
    }

    /// Holds the button for this many seconds, then releases it.
    std::vector<WandCommand> press(Side side, const WandState& pressed, double seconds = 0.2)
    {
        set(side, pressed);
        std::vector<WandCommand> commands = play(seconds);
        rest(side);
        for (const WandCommand& command : play(2 * frameLength))
            commands.push_back(command);
        return commands;
    }

private:
    WandMapping m_hands;
    InputFrame m_frame;
};

/// A movement of the thumb or fingers on a wand, and its gestures.
struct Move
{
    const char* name;
    WandState from, to; ///< states at the beginning and the end, half a second apart
    double holdFor;
    std::vector<Gesture> gestures;
};

const Move moves[] = {
    {"trigger", pulling(1), pulling(1), 0.2, {Gesture::Trigger}},
    {"pad left", pressing({-0.8, 0}), pressing({-0.8, 0}), 0.2, {Gesture::PadLeft}},
    {"pad right", pressing({0.8, 0}), pressing({0.8, 0}), 0.2, {Gesture::PadRight}},
    {"pad top", pressing({0, 0.8}), pressing({0, 0.8}), 0.2, {Gesture::PadTop}},
    {"pad bottom", pressing({0, -0.8}), pressing({0, -0.8}), 0.2, {Gesture::PadBottom}},
    {"pad centre", pressing({0.1, 0}), pressing({0.1, 0}), 0.2, {}},
    {"thumb rests", touching({0.5, 0.5}), touching({0.52, 0.48}), 0.2, {}},
    {"slide up", touching({0.1, -0.5}), touching({0.1, 0.5}), 0.2, {Gesture::Slide, Gesture::SlideUpDown}},
    {"slide down", touching({0.1, 0.5}), touching({0.1, -0.5}), 0.2, {Gesture::Slide, Gesture::SlideUpDown}},
    {"slide right", touching({-0.5, 0.1}), touching({0.5, 0.1}), 0.2, {Gesture::Slide}},
    {"slide left", touching({0.5, 0.1}), touching({-0.5, 0.1}), 0.2, {Gesture::Slide}},
    {"menu", pressingMenu(), pressingMenu(), 0.2, {Gesture::Menu, Gesture::MenuTap}},
    {"menu, held", pressingMenu(), pressingMenu(), 1.0, {Gesture::Menu, Gesture::MenuHold}},
    {"squeeze", squeezing(), squeezing(), 0.2, {Gesture::Squeeze}},
    {"squeeze, held", squeezing(), squeezing(), 1.0, {Gesture::Squeeze, Gesture::SqueezeHold}},
};

/// Plays a movement while the hand itself moves.
std::vector<WandCommand> play(Player& player, Side side, const Move& move)
{
    std::vector<WandCommand> commands;
    const auto step = [&] {
        player.move(side, {0.001, 0, 0});
        for (const WandCommand& command : player.step())
            commands.push_back(command);
    };
    const int frames = static_cast<int>(std::lround(move.holdFor / frameLength));
    for (int i = 0; i <= frames; ++i) {
        WandState state = move.from;
        state.pad += double(i) / frames * (move.to.pad - move.from.pad);
        player.set(side, state);
        step();
    }
    player.rest(side);
    step();
    step();
    return commands;
}

/// Returns the names of the commands that a function sends for a movement.
std::set<QString> commandNames(WandFunction function, const Move& move, bool isOpen)
{
    const QString sign = (move.to.pad - move.from.pad).sum() > 0 ? QStringLiteral("+") : QStringLiteral("-");
    switch (function) {
    case WandFunction::Sculpt:
        return {QStringLiteral("begin smooth no"), QStringLiteral("point"), QStringLiteral("end")};
    case WandFunction::Smooth:
        return {};
    case WandFunction::UseTip:
        return {QStringLiteral("use tip")};
    case WandFunction::MovePart:
        return {QStringLiteral("move part"), QStringLiteral("release part")};
    case WandFunction::TurnClockwise:
        return {QStringLiteral("turn -")};
    case WandFunction::TurnAnticlockwise:
        return {QStringLiteral("turn +")};
    case WandFunction::MoveModel:
        return {QStringLiteral("move")};
    case WandFunction::ScaleModel:
        return {QStringLiteral("scale ") + sign};
    case WandFunction::SetRadius:
        return {QStringLiteral("radius ") + sign};
    case WandFunction::SetChannel:
        return {QStringLiteral("color 0 ") + sign};
    case WandFunction::Undo:
        return {QStringLiteral("undo")};
    case WandFunction::Redo:
        return {QStringLiteral("redo")};
    case WandFunction::SaveModel:
        return {QStringLiteral("save")};
    case WandFunction::RestoreModel:
        return {QStringLiteral("restore")};
    case WandFunction::ToggleTopology:
        return {QStringLiteral("topology")};
    case WandFunction::ToggleBrushShape:
        return {QStringLiteral("shape")};
    case WandFunction::ToggleSymmetry:
        return {QStringLiteral("symmetry")};
    case WandFunction::ToggleInverse:
        return {QStringLiteral("inverse")};
    case WandFunction::ToggleToolMenu:
        return {QStringLiteral("tool menu") + CommandNames::isOn(!isOpen)};
    case WandFunction::ToggleColorPanel:
        return {QStringLiteral("color panel") + CommandNames::isOn(!isOpen)};
    case WandFunction::PreviousTool:
        return {QStringLiteral("tool -1")};
    case WandFunction::NextTool:
        return {QStringLiteral("tool 1")};
    case WandFunction::PreviousChannel:
        return {QStringLiteral("channel 2")};
    case WandFunction::NextChannel:
        return {QStringLiteral("channel 1")};
    }
    return {};
}

/// Returns true if a command is sent once per press rather than in every frame.
bool isOnce(const QString& word)
{
    return !word.startsWith(QStringLiteral("turn")) && !word.startsWith(QStringLiteral("scale")) &&
           !word.startsWith(QStringLiteral("radius")) && !word.startsWith(QStringLiteral("color 0")) &&
           word != QStringLiteral("move") && word != QStringLiteral("point");
}

/// Opens the hand's panel by its menu button.
void openPanel(Player& player, Side side)
{
    player.press(side, pressingMenu());
    player.play(0.1);
}

/// Random states of both wands. A hand does several things at once, and sometimes no wand is tracked for a while.
class RandomWands
{
public:
    InputFrame next()
    {
        m_frame.time += 0.2 * share() * share();
        for (std::size_t i = 0; i < vr::sideCount; ++i) {
            toggleSometimes(m_frame.pointsAtPanel[i], 0.02);
            change(m_frame.wands[i]);
        }
        return m_frame;
    }

private:
    double share() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
    void toggleSometimes(bool& what, double often) { what = share() < often ? !what : what; }

    void change(WandState& wand)
    {
        toggleSometimes(wand.isActive, wand.isActive ? 0.003 : 0.3);
        toggleSometimes(wand.isTracked, wand.isTracked ? 0.01 : 0.3);
        toggleSometimes(wand.side, 0.03);
        toggleSometimes(wand.menu, 0.03);
        toggleSometimes(wand.padTouched, 0.05);
        toggleSometimes(wand.padPressed, 0.05);
        toggleSometimes(wand.isStick, 0.001);
        if (share() < 0.05)
            wand.trigger = share();
        if (share() < 0.3)
            wand.pad = 2 * Vector2d(share(), share()) - Vector2d(1, 1);
        wand.grip.position = Vec3(share(), share(), share());
        wand.grip.rotation = Eigen::AngleAxisd(share(), Vec3(share(), 1, share()).normalized());
        wand.aim = wand.grip;
    }

    std::mt19937 m_random{seed};
    InputFrame m_frame;
};

void apply(const vr::WandAction& action, vr::ModelPlacement& placement)
{
    if (const auto* turn = std::get_if<vr::TurnModel>(&action))
        placement.turn(turn->angle);
    else if (const auto* scale = std::get_if<vr::ScaleModel>(&action))
        placement.scale(scale->factor);
    else if (const auto* move = std::get_if<vr::MoveModel>(&action))
        placement.move(move->from, move->to);
    else if (const auto* stretch = std::get_if<vr::StretchModel>(&action))
        placement.stretch(stretch->from, stretch->to);
}

/// Counts of single commands, and sums of sliding commands.
struct Outcome
{
    std::map<QString, int> once;
    double scaled = 0, radius = 0, turned = 0;
    int color = 0;

    void add(const WandCommand& command)
    {
        if (const auto* scale = std::get_if<vr::ScaleModel>(&command.action))
            scaled += std::log2(scale->factor);
        else if (const auto* sized = std::get_if<vr::ScaleRadius>(&command.action))
            radius += std::log2(sized->factor);
        else if (const auto* turn = std::get_if<vr::TurnModel>(&command.action))
            turned += turn->angle;
        else if (const auto* change = std::get_if<vr::ChangeChannel>(&command.action))
            color += change->by;
        else if (isOnce(commandName(command)))
            ++once[commandName(command)];
    }
};

/// Returns the states of both wands for a session with the preset Paper that uses a little of everything. Nothing is
/// shorter than two frames at 5 Hz.
vr::Wands paperSession(double time)
{
    WandState left = restingWand(), right = restingWand();
    if (isWithin(time, 1, 3))
        left = pressing({-0.8, 0.1});
    else if (isWithin(time, 4, 6))
        left = touching(ThumbWay{4.5, 5.5, {0.1, -0.6}, {0.1, 0.5}}.at(time));
    else if (isWithin(time, 7, 7.5))
        left = pressingMenu();
    else if (isWithin(time, 8, 8.5) || isWithin(time, 9, 9.5))
        left = pressing({0.8, 0});
    else if (isWithin(time, 10, 11.2))
        left = squeezing();
    if (isWithin(time, 1.5, 2.5))
        right = pulling(0.9);
    else if (isWithin(time, 4, 6))
        right = touching(ThumbWay{4.5, 5.5, {0.6, 0.1}, {-0.5, 0.1}}.at(time));
    else if (isWithin(time, 7, 7.5) || isWithin(time, 8, 8.5))
        right = pressing({-0.7, 0.2});
    else if (isWithin(time, 9, 9.5))
        right = pressingMenu();
    else if (isWithin(time, 10, 10.5))
        right = pressing({0.9, 0});
    else if (isWithin(time, 11, 13))
        right = touching(ThumbWay{11.5, 12.5, {0, -0.5}, {0.1, 0.9}}.at(time));
    return {left, right};
}
} // namespace

class TestWandMapping : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRowDoesItsFunctionAndNothingElseDoesAnything_data();
    void everyRowDoesItsFunctionAndNothingElseDoesAnything();
    void theBrushIsAtTheWandsTip();
    void aStrokeIsFromThePullToTheRelease();
    void aPressThatBeganOnAPanelNeverSculpts();
    void aStrokeGoesOnOverAPanel();
    void aHandThatDrawsDoesNothingElse();
    void theOtherHandMayTurnMoveAndScaleMeanwhile();
    void theDocumentWaitsForTheStroke();
    void aLostWandEndsItsStroke();
    void aBlinkIsNoLoss();
    void whoIsNotSeenCannotBegin();
    void theOtherTriggerSmooths();
    void oneHandCarriesTheModel();
    void twoHandsStretchTheModel();
    void whoSculptsLetsGoOfTheModel();
    void aRingShowsWhatIsHeld();
    void channelsComeRoundAndOpenAndCloseWithThePanel();
    void thePadsHeightIsHalfAChannel();
    void whatGoesOnEndsWhenHandsAreChosenAnew();
    void whatIsPressedMeanwhileMustBeReleased();
    void aTaskTakesTheTrigger();
    void theGripMovesThePartOfATask();
    void bareHandsSculptAndGrab();
    void puttingAWandDownEndsWhatItDoes();
    void swappedHandsDoTheSame();
    void frameRatesDoTheSame();
    void atRandomNothingIsLeftOpen_data();
    void atRandomNothingIsLeftOpen();
};

void TestWandMapping::everyRowDoesItsFunctionAndNothingElseDoesAnything_data()
{
    QTest::addColumn<ButtonPreset>("preset");
    QTest::addColumn<Side>("sculpting");
    QTest::newRow("Paper") << ButtonPreset::Paper << Side::Right;
    QTest::newRow("Paper, left-handed") << ButtonPreset::Paper << Side::Left;
    QTest::newRow("Studio") << ButtonPreset::Studio << Side::Right;
    QTest::newRow("Studio, left-handed") << ButtonPreset::Studio << Side::Left;
}

void TestWandMapping::everyRowDoesItsFunctionAndNothingElseDoesAnything()
{
    QFETCH(ButtonPreset, preset);
    QFETCH(Side, sculpting);
    std::set<std::pair<WandFunction, Gesture>> done;
    for (const HandRole role : roles)
        for (const bool isOpen : {false, true})
            for (const Move& move : moves) {
                Player player({preset, sculpting});
                const Side side = role == HandRole::Sculpting ? sculpting : opposite(sculpting);
                if (isOpen)
                    openPanel(player, side);
                std::set<QString> expected;
                std::set<Gesture> gestures;
                for (const Gesture gesture : move.gestures)
                    if (const auto function = vr::functionOf(preset, {role, player.hands().modeOf(side), gesture})) {
                        expected.merge(commandNames(*function, move, isOpen));
                        gestures.insert(gesture);
                        done.insert({*function, gesture});
                    }
                std::map<QString, int> found;
                for (const WandCommand& command : play(player, side, move)) {
                    ++found[commandName(command)];
                    QCOMPARE(command.side, side);
                    QVERIFY(gestures.contains(command.gesture));
                }
                std::set<QString> said;
                for (const auto& [word, count] : found) {
                    said.insert(word);
                    QVERIFY2(!isOnce(word) || count == 1, move.name);
                }
                QVERIFY2(said == expected, move.name);
            }
    for (const vr::PresetRow& row : vr::presetRows(preset))
        QVERIFY(done.contains({row.function, row.gesture}));
}

/// Checks that the tip is in front of the palm in the wand's direction, independent of the origin of its aim pose.
void TestWandMapping::theBrushIsAtTheWandsTip()
{
    WandState wand = restingWand();
    wand.grip = {Eigen::Quaterniond(Eigen::AngleAxisd(1, Vec3::UnitX())), Vec3(0.3, 1.2, -0.4)};
    wand.aim = {Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3::UnitY())), Vec3(0.3, 1.1, -0.6)};
    const Pose tip = vr::tipOf(wand);
    QVERIFY((tip.position - wand.grip.position - vr::tipReach * wand.aim.forward()).norm() < 1e-12);
    QVERIFY((tip.forward() - wand.aim.forward()).norm() < 1e-12);

    Player player;
    player.wand(Side::Right) = wand;
    player.wand(Side::Right).trigger = 1;
    const auto points = all<vr::StrokePoint>(player.step());
    QCOMPARE(points.size(), std::size_t(1));
    QCOMPARE(points[0].tip.position, tip.position);
    QCOMPARE(points[0].pressure, 1.0);
}

void TestWandMapping::aStrokeIsFromThePullToTheRelease()
{
    Player player;
    for (int stroke = 0; stroke < 3; ++stroke) {
        player.wand(Side::Right).trigger = 0.8;
        QCOMPARE(words(player.step()), QStringList({QStringLiteral("begin smooth no"), QStringLiteral("point")}));
        QVERIFY(player.hands().isDrawing(Side::Right));
        for (const double trigger : {0.6, 0.5, 0.46, 1.0}) {
            player.wand(Side::Right).trigger = trigger;
            player.move(Side::Right, {0.01, 0, 0});
            const auto points = all<vr::StrokePoint>(player.step());
            QCOMPARE(points.size(), std::size_t(1));
            QCOMPARE(points[0].tip.position, vr::tipOf(player.wand(Side::Right)).position);
            QVERIFY(points[0].pressure > 0 && (points[0].pressure == 1) == (trigger == 1));
        }
        player.wand(Side::Right).trigger = 0.4;
        QCOMPARE(words(player.step()), QStringList(QStringLiteral("end")));
        QVERIFY(player.step().empty() && !player.hands().isDrawing(Side::Right));
    }
}

void TestWandMapping::aPressThatBeganOnAPanelNeverSculpts()
{
    for (const ButtonPreset preset : everyPreset)
        for (const Side side : sides) {
            Player player({preset, Side::Right});
            player.pointAtPanel(side, true);
            player.wand(side).trigger = 1;
            QCOMPARE(words(player.step()), QStringList(QStringLiteral("press panel")));
            player.pointAtPanel(side, false);
            player.move(side, {0.3, 0, 0});
            QVERIFY(player.play(2).empty());
            player.wand(side).trigger = 0;
            QCOMPARE(words(player.step()), QStringList(QStringLiteral("release panel yes")));

            player.pointAtPanel(side, true);
            player.wand(side).trigger = 1;
            player.step();
            player.wand(side).isActive = false;
            QCOMPARE(words(player.step()), QStringList(QStringLiteral("release panel no")));
            player.wand(side).isActive = true;
            player.pointAtPanel(side, false);
            QVERIFY(player.play(1).empty());
        }
}

void TestWandMapping::aStrokeGoesOnOverAPanel()
{
    Player player;
    player.wand(Side::Right).trigger = 1;
    player.step();
    player.pointAtPanel(Side::Right, true);
    QCOMPARE(words(player.step()), QStringList(QStringLiteral("point")));
    player.wand(Side::Right).trigger = 0;
    QCOMPARE(words(player.step()), QStringList(QStringLiteral("end")));
}

/// Checks that buttons pressed before, during and until after a stroke are ignored, because a firm grip presses them by
/// accident.
void TestWandMapping::aHandThatDrawsDoesNothingElse()
{
    for (const ButtonPreset preset : everyPreset)
        for (const Move& move : moves)
            for (const bool isBefore : {false, true}) {
                Player player({preset, Side::Right});
                if (isBefore) {
                    player.set(Side::Right, move.to);
                    player.step();
                }
                for (int i = 0; i < 200; ++i) {
                    WandState state = move.from;
                    state.trigger = 1;
                    state.pad += i % 50 / 50.0 * (move.to.pad - move.from.pad);
                    player.set(Side::Right, state);
                    for (const QString& word : words(player.step()))
                        QVERIFY2(word == QStringLiteral("point") ||
                                     (i == 0 && word == QStringLiteral("begin smooth no")),
                                 move.name);
                    QVERIFY(!player.hands().hold(Side::Right));
                }
                player.set(Side::Right, move.to);
                player.wand(Side::Right).trigger = 0;
                QCOMPARE(words(player.step()), QStringList(QStringLiteral("end")));
                QVERIFY2(player.play(2).empty(), move.name);
            }
}

/// Checks that the other hand can transform the model during a stroke. Its command comes before the stroke's point,
/// which uses the new placement.
void TestWandMapping::theOtherHandMayTurnMoveAndScaleMeanwhile()
{
    for (const WandState& other : {pressing({-0.8, 0}), pulling(1), touching({0, 0.2})}) {
        Player player;
        player.set(Side::Left, other.padTouched && !other.padPressed ? touching({0, -0.2}) : other);
        player.step();
        player.wand(Side::Right).trigger = 1;
        player.step();
        player.set(Side::Left, other);
        player.move(Side::Left, {0.01, 0, 0});
        const QStringList said = words(player.step());
        QCOMPARE(said.size(), 2);
        QVERIFY(said[0] == QStringLiteral("turn -") || said[0] == QStringLiteral("move") ||
                said[0] == QStringLiteral("scale +"));
        QCOMPARE(said[1], QStringLiteral("point"));
    }
}

void TestWandMapping::theDocumentWaitsForTheStroke()
{
    Player paper;
    paper.wand(Side::Right).trigger = 1;
    paper.step();
    const auto saving = paper.press(Side::Left, squeezing(), 1);
    QCOMPARE(all<vr::Refuse>(saving).size(), std::size_t(1));
    QVERIFY(all<vr::SaveModel>(saving).empty());
    paper.rest(Side::Right);
    paper.step();
    QCOMPARE(words(paper.press(Side::Left, squeezing(), 1)), QStringList(QStringLiteral("save")));

    Player studio({ButtonPreset::Studio, Side::Right});
    studio.wand(Side::Right).trigger = 1;
    studio.step();
    for (const double x : {-0.8, 0.8}) {
        const auto undoing = studio.press(Side::Left, pressing({x, 0}));
        QCOMPARE(all<vr::Refuse>(undoing).size(), std::size_t(1));
        QVERIFY(all<vr::Undo>(undoing).empty() && all<vr::Redo>(undoing).empty());
    }
}

void TestWandMapping::aLostWandEndsItsStroke()
{
    Player player;
    player.wand(Side::Right).trigger = 1;
    player.play(0.3);
    player.wand(Side::Right).isActive = false;
    QCOMPARE(words(player.step()), QStringList(QStringLiteral("end")));
    player.wand(Side::Right).isActive = true;
    QVERIFY(player.play(1).empty());
    player.press(Side::Right, restingWand());

    player.wand(Side::Right).trigger = 1;
    player.play(0.3);
    player.wand(Side::Right).isTracked = false;
    QCOMPARE(words(player.play(0.5)), QStringList(QStringLiteral("end")));
    player.wand(Side::Right).isTracked = true;
    QVERIFY(player.play(1).empty());
}

/// Checks that a short loss of tracking does not end a stroke. It leaves a gap between points, which core's path
/// bridges.
void TestWandMapping::aBlinkIsNoLoss()
{
    Player player;
    player.wand(Side::Right).trigger = 1;
    player.play(0.3);
    player.wand(Side::Right).isTracked = false;
    QVERIFY(player.play(5 * frameLength).empty());
    player.wand(Side::Right).isTracked = true;
    QCOMPARE(words(player.play(2 * frameLength)), QStringList({QStringLiteral("point"), QStringLiteral("point")}));
}

void TestWandMapping::whoIsNotSeenCannotBegin()
{
    Player player;
    player.wand(Side::Right).isTracked = false;
    player.wand(Side::Right).trigger = 1;
    QCOMPARE(words(player.step()), QStringList(QStringLiteral("refuse")));
    player.wand(Side::Right).isTracked = true;
    QVERIFY(player.play(1).empty());
}

void TestWandMapping::theOtherTriggerSmooths()
{
    const QString begin = QStringLiteral("begin smooth no"), smooth = QStringLiteral("begin smooth yes"),
                  point = QStringLiteral("point"), end = QStringLiteral("end");
    Player player({ButtonPreset::Studio, Side::Right});
    player.wand(Side::Left).trigger = 1;
    QVERIFY(player.play(0.2).empty());
    player.wand(Side::Right).trigger = 1;
    QCOMPARE(words(player.step()), QStringList({smooth, point}));
    QCOMPARE(words(player.step()), QStringList(point));
    player.wand(Side::Left).trigger = 0;
    QCOMPARE(words(player.step()), QStringList({end, begin, point}));
    QCOMPARE(words(player.step()), QStringList(point));
    player.wand(Side::Left).trigger = 1;
    QCOMPARE(words(player.step()), QStringList({end, smooth, point}));
    player.wand(Side::Right).trigger = 0;
    QCOMPARE(words(player.step()), QStringList(end));
}

/// Checks that carrying the model adds up to one step from where the hand grabbed it to where it let go. A hand that
/// was untracked for a while grabs again.
void TestWandMapping::oneHandCarriesTheModel()
{
    const struct
    {
        ButtonPreset preset = ButtonPreset::Paper;
        WandState grabbing;
    } ways[] = {{ButtonPreset::Paper, pulling(1)}, {ButtonPreset::Studio, squeezing()}};
    for (const auto& way : ways) {
        Player player({way.preset, Side::Right});
        vr::ModelPlacement placement;
        placement.place({Eigen::Quaterniond::Identity(), Vec3(0, 1.7, 0)});
        vr::ModelPlacement expected = placement;
        const auto carry = [&](int frames) {
            for (int i = 0; i < frames; ++i) {
                player.move(Side::Left, {0.003, 0.001, -0.002});
                player.wand(Side::Left).grip.rotation = Eigen::AngleAxisd(0.02 * i, Vec3(1, 2, 0).normalized());
                for (const WandCommand& command : player.step())
                    apply(command.action, placement);
            }
        };
        carry(5);
        QCOMPARE(placement.middle(), expected.middle());
        player.set(Side::Left, way.grabbing);
        player.step();
        const Pose from = player.wand(Side::Left).grip;
        carry(40);
        expected.move(from, player.wand(Side::Left).grip);
        QVERIFY((placement.middle() - expected.middle()).norm() < 1e-9 &&
                placement.rotation().angularDistance(expected.rotation()) < 1e-9);

        player.wand(Side::Left).isTracked = false;
        carry(40);
        player.wand(Side::Left).isTracked = true;
        for (const WandCommand& command : player.step())
            apply(command.action, placement);
        QVERIFY((placement.middle() - expected.middle()).norm() < 1e-9);
        player.rest(Side::Left);
        carry(5);
        QVERIFY((placement.middle() - expected.middle()).norm() < 1e-9);
    }
}

/// Checks that the model does not jump when the second hand joins or the first lets go.
void TestWandMapping::twoHandsStretchTheModel()
{
    Player player({ButtonPreset::Studio, Side::Right});
    vr::ModelPlacement placement;
    placement.place({Eigen::Quaterniond::Identity(), Vec3(0, 1.7, 0)});
    player.move(Side::Left, {-0.2, 1.4, -0.5});
    player.move(Side::Right, {0.2, 1.4, -0.5});
    player.step();
    const auto carry = [&](const Vec3& left, const Vec3& right) {
        QStringList said;
        for (int i = 0; i < 10; ++i) {
            player.move(Side::Left, 0.1 * left);
            player.move(Side::Right, 0.1 * right);
            const auto commands = player.step();
            said << words(commands);
            for (const WandCommand& command : commands)
                apply(command.action, placement);
        }
        said.removeDuplicates();
        return said;
    };
    player.set(Side::Left, squeezing());
    QCOMPARE(carry({0.1, 0, 0}, {0, 0.1, 0}), QStringList(QStringLiteral("move")));
    player.set(Side::Right, squeezing());
    QCOMPARE(carry({0, 0, 0}, {0, 0, 0}), QStringList(QStringLiteral("stretch")));
    const Vec3 atLeft = placement.toModel(player.wand(Side::Left).grip.position),
               atRight = placement.toModel(player.wand(Side::Right).grip.position);
    const double before = placement.lengthToRoom(1);
    QCOMPARE(carry({-0.1, 0.05, 0}, {0.1, 0, 0.1}), QStringList(QStringLiteral("stretch")));
    QVERIFY(placement.lengthToRoom(1) > 1.2 * before);
    QVERIFY((placement.toRoom(atLeft) - player.wand(Side::Left).grip.position).norm() < 1e-9);
    QVERIFY((placement.toRoom(atRight) - player.wand(Side::Right).grip.position).norm() < 1e-9);
    player.rest(Side::Left);
    QCOMPARE(carry({0.3, 0, 0}, {0, 0.1, 0}), QStringList(QStringLiteral("move")));
    QVERIFY((placement.toRoom(atRight) - player.wand(Side::Right).grip.position).norm() < 1e-9);
}

/// Checks that starting a stroke releases that hand's hold on the model; the other hand may keep holding it. The side
/// button, pressed before or after, counts again only after it was released.
void TestWandMapping::whoSculptsLetsGoOfTheModel()
{
    Player player({ButtonPreset::Studio, Side::Right});
    player.set(Side::Right, squeezing());
    player.step();
    player.move(Side::Right, {0.1, 0, 0});
    QCOMPARE(words(player.step()), QStringList(QStringLiteral("move")));
    player.wand(Side::Right).trigger = 1;
    player.move(Side::Right, {0.1, 0, 0});
    QCOMPARE(words(player.step()), QStringList({QStringLiteral("begin smooth no"), QStringLiteral("point")}));
    player.set(Side::Left, squeezing());
    player.step();
    player.move(Side::Left, {0.1, 0, 0});
    QCOMPARE(words(player.step()), QStringList({QStringLiteral("move"), QStringLiteral("point")}));
    player.rest(Side::Left);
    player.wand(Side::Right).trigger = 0;
    player.play(0.1);
    player.move(Side::Right, {0.1, 0, 0});
    QVERIFY(player.play(0.5).empty());
}

void TestWandMapping::aRingShowsWhatIsHeld()
{
    for (const ButtonPreset preset : everyPreset)
        for (const Side side : sides) {
            Player player({preset, Side::Right});
            const bool isPaper = preset == ButtonPreset::Paper, isSculpting = side == Side::Right;
            for (const bool squeezes : {true, false}) {
                player.set(side, squeezes ? squeezing() : pressingMenu());
                const bool isHold = squeezes ? isPaper : !isPaper && isSculpting;
                double before = 0;
                for (int i = 0; i < 100; ++i) {
                    player.step();
                    const auto hold = player.hands().hold(side);
                    QCOMPARE(hold.has_value(), isHold && i > 0);
                    if (!hold)
                        continue;
                    QCOMPARE(hold->gesture, squeezes ? Gesture::SqueezeHold : Gesture::MenuHold);
                    QVERIFY(hold->progress >= before && hold->progress <= 1);
                    before = hold->progress;
                }
                QCOMPARE(before, isHold ? 1.0 : 0.0);
                player.rest(side);
                player.step();
                QVERIFY(!player.hands().hold(side));
            }
        }
}

void TestWandMapping::channelsComeRoundAndOpenAndCloseWithThePanel()
{
    Player player;
    openPanel(player, Side::Right);
    for (const int channel : {1, 2, 0, 1}) {
        const auto selected = all<vr::SelectChannel>(player.press(Side::Right, pressing({0.8, 0})));
        QCOMPARE(selected.size(), std::size_t(1));
        QCOMPARE(selected[0].channel, channel);
        QCOMPARE(player.hands().channel(), channel);
    }
    for (const int channel : {0, 2, 1, 0})
        QCOMPARE(all<vr::SelectChannel>(player.press(Side::Right, pressing({-0.8, 0})))[0].channel, channel);
    QCOMPARE(words(player.press(Side::Right, pressingMenu())), QStringList(QStringLiteral("color panel no")));
    QCOMPARE(words(player.press(Side::Right, pressing({-0.8, 0}))), QStringList(QStringLiteral("undo")));
}

/// Checks that sliding over the pad's full height changes a channel by half its range, in steps of at least 1.
void TestWandMapping::thePadsHeightIsHalfAChannel()
{
    Player player;
    openPanel(player, Side::Right);
    int sum = 0, least = 255;
    for (int i = 0; i <= 2000; ++i) {
        player.set(Side::Right, touching({0.05, -1 + i / 1000.0}));
        for (const auto& change : all<vr::ChangeChannel>(player.step())) {
            sum += change.by;
            least = std::min(least, change.by);
        }
    }
    QCOMPARE(sum, static_cast<int>(255 / 2.0 * (1 - vr::slideThreshold / 2)));
    QCOMPARE(least, 1);
}

void TestWandMapping::whatGoesOnEndsWhenHandsAreChosenAnew()
{
    Player player;
    player.wand(Side::Right).trigger = 1;
    player.pointAtPanel(Side::Left, true);
    player.wand(Side::Left).trigger = 1;
    player.step();
    QStringList ended = words(player.hands().setSettings({ButtonPreset::Studio, Side::Left}));
    ended.sort();
    QCOMPARE(ended, QStringList({QStringLiteral("end"), QStringLiteral("release panel no")}));
    QVERIFY(player.hands().releaseAll().empty());
    QVERIFY(player.play(0.5).empty());
    player.rest(Side::Right);
    player.rest(Side::Left);
    player.pointAtPanel(Side::Left, false);
    QVERIFY(player.play(0.1).empty());
    player.wand(Side::Left).trigger = 1;
    QCOMPARE(words(player.step()), QStringList({QStringLiteral("begin smooth no"), QStringLiteral("point")}));
}

/// Checks that buttons held when everything was ended have no effect until they are released.
void TestWandMapping::whatIsPressedMeanwhileMustBeReleased()
{
    for (const ButtonPreset preset : everyPreset)
        for (const Side side : sides)
            for (const Move& move : moves) {
                if (move.from.padTouched && !move.from.padPressed)
                    continue; // a thumb may rest on the pad
                Player player({preset, Side::Right});
                player.set(side, move.from);
                player.step();
                player.hands().releaseAll();
                QVERIFY2(player.play(2).empty(), move.name);
                player.rest(side);
                player.play(0.1);
                const bool isBound = std::any_of(move.gestures.begin(), move.gestures.end(), [&](Gesture gesture) {
                    return vr::functionOf(preset, {player.hands().roleOf(side), player.hands().modeOf(side), gesture})
                               .value_or(WandFunction::Smooth) != WandFunction::Smooth;
                });
                QCOMPARE(!play(player, side, move).empty(), isBound);
            }
}

/// Checks that the trigger of the sculpting hand does its task at the tip, and that a stroke in progress goes on.
void TestWandMapping::aTaskTakesTheTrigger()
{
    for (const ButtonPreset preset : everyPreset) {
        Player player({preset, Side::Right});
        player.wand(Side::Right).trigger = 1;
        player.step();
        player.hands().setTask(vr::HandTask::ChoosePart);
        QCOMPARE(words(player.step()), QStringList(QStringLiteral("point")));
        player.wand(Side::Right).trigger = 0;
        QCOMPARE(words(player.step()), QStringList(QStringLiteral("end")));

        player.move(Side::Right, {0.1, 0.2, 0.3});
        player.wand(Side::Right).trigger = 1;
        const auto uses = all<vr::UseTip>(player.step());
        QCOMPARE(uses.size(), std::size_t(1));
        QCOMPARE(uses[0].tip.position, vr::tipOf(player.wand(Side::Right)).position);
        QVERIFY(player.play(0.5).empty() && !player.hands().isDrawing(Side::Right));
        player.wand(Side::Right).trigger = 0;
        QVERIFY(player.step().empty());
        player.pointAtPanel(Side::Right, true);
        player.wand(Side::Right).trigger = 1;
        QCOMPARE(words(player.step()), QStringList(QStringLiteral("press panel")));
        player.wand(Side::Right).trigger = 0;
        player.step();
        player.pointAtPanel(Side::Right, false);
        player.wand(Side::Right).isTracked = false;
        player.wand(Side::Right).trigger = 1;
        QCOMPARE(words(player.step()), QStringList(QStringLiteral("refuse")));
    }
}

/// Checks that while a task is set, the grip of the sculpting hand moves the part and nothing else, also if it is held
/// long. A hand that is lost lets go once.
void TestWandMapping::theGripMovesThePartOfATask()
{
    const QString move = QStringLiteral("move part"), release = QStringLiteral("release part");
    for (const ButtonPreset preset : everyPreset) {
        Player player({preset, Side::Right});
        player.hands().setTask(vr::HandTask::ChoosePart);
        player.wand(Side::Right).side = true;
        QVERIFY(player.step().empty());
        Vec3 way = Vec3::Zero();
        for (int i = 0; i < 200; ++i) {
            player.move(Side::Right, {0.001, 0, 0});
            const auto commands = player.step();
            QCOMPARE(words(commands), QStringList(move));
            const auto& part = std::get<vr::MovePart>(commands[0].action);
            way += part.to.position - part.from.position;
        }
        QVERIFY((way - Vec3(0.2, 0, 0)).norm() < 1e-9 && !player.hands().hold(Side::Right));
        player.wand(Side::Right).isTracked = false;
        QCOMPARE(words(player.step()), QStringList(release));
        QVERIFY(player.step().empty());
        player.wand(Side::Right).isTracked = true;
        player.step();
        QCOMPARE(words(player.step()), QStringList(move));
        player.hands().setTask(vr::HandTask::Sculpt); // the panel was closed
        QVERIFY(words(player.step()).contains(release));
    }
}

/// Checks bare hands with each preset: a pinch sculpts where the fingers meet, fists move and stretch the model, and a
/// palm opens the tools. With Paper, the same gestures of a wand would restore the model.
void TestWandMapping::bareHandsSculptAndGrab()
{
    for (const ButtonPreset preset : {ButtonPreset::Paper, ButtonPreset::Studio}) {
        Player player({preset, Side::Right});
        const auto bare = [&](WandState state) {
            state.isHand = true;
            state.pinch.position = {0.1, 1.2, -0.4};
            return state;
        };
        for (const Side side : sides)
            player.set(side, bare(restingWand()));
        player.play(0.1);
        player.set(Side::Right, bare(pulling(0.8)));
        const std::vector<WandCommand> drawn = player.step();
        const auto points = all<vr::StrokePoint>(drawn);
        QCOMPARE(points.size(), std::size_t(1));
        QVERIFY((points[0].tip.position - Vec3(0.1, 1.2, -0.4)).norm() < 1e-12);
        player.set(Side::Right, bare(restingWand()));
        player.play(0.1);

        player.set(Side::Right, bare(squeezing()));
        player.step();
        player.move(Side::Right, {0, 0.1, 0});
        const auto moves = all<vr::MoveModel>(player.step());
        QCOMPARE(moves.size(), std::size_t(1));
        QVERIFY((moves[0].to.position - moves[0].from.position - Vec3(0, 0.1, 0)).norm() < 1e-12);
        QVERIFY(all<vr::RestoreModel>(player.play(2 * vr::holdSeconds)).empty());
        player.set(Side::Left, bare(squeezing()));
        player.play(0.1);
        player.move(Side::Left, {-0.1, 0, 0});
        QCOMPARE(all<vr::StretchModel>(player.step()).size(), std::size_t(1));
        QVERIFY(all<vr::SaveModel>(player.play(2 * vr::holdSeconds)).empty());
        for (const Side side : sides)
            player.set(side, bare(restingWand()));
        player.play(0.1);
        player.set(Side::Left, bare(pressingMenu()));
        QCOMPARE(all<vr::OpenToolMenu>(player.step()).size(), std::size_t(1));
    }
}

/// Checks strokes, presses of panels and grabs during which a hand puts its wand down, or takes one up, without letting
/// go: all end, no panel is clicked, and nothing begins until the new device was released.
void TestWandMapping::puttingAWandDownEndsWhatItDoes()
{
    const auto as = [](WandState state, bool isHand) {
        state.isHand = isHand;
        return state;
    };
    for (const bool wasHand : {false, true}) {
        Player player({ButtonPreset::Studio, Side::Right});
        const auto rest = [&] {
            player.set(Side::Right, as(restingWand(), wasHand));
            player.play(0.1);
        };
        rest();
        player.set(Side::Right, as(pulling(0.8), wasHand));
        QCOMPARE(all<vr::BeginStroke>(player.play(0.1)).size(), std::size_t(1));
        player.set(Side::Right, as(pulling(0.8), !wasHand));
        const std::vector<WandCommand> swapped = player.play(0.3);
        QCOMPARE(all<vr::EndStroke>(swapped).size(), std::size_t(1));
        QVERIFY(all<vr::StrokePoint>(swapped).empty() && all<vr::BeginStroke>(swapped).empty());
        player.set(Side::Right, as(restingWand(), !wasHand));
        player.play(0.1);
        player.set(Side::Right, as(pulling(0.8), !wasHand));
        QCOMPARE(all<vr::BeginStroke>(player.play(0.1)).size(), std::size_t(1));

        rest();
        player.pointAtPanel(Side::Right, true);
        player.set(Side::Right, as(pulling(0.8), wasHand));
        QCOMPARE(all<vr::PressPanel>(player.play(0.1)).size(), std::size_t(1));
        player.set(Side::Right, as(restingWand(), !wasHand));
        const auto releases = all<vr::ReleasePanel>(player.play(0.1));
        QVERIFY(releases.size() == 1 && !releases[0].isClick);
        player.pointAtPanel(Side::Right, false);

        rest();
        player.set(Side::Right, as(squeezing(), wasHand));
        player.play(0.1);
        player.set(Side::Right, as(squeezing(), !wasHand));
        player.move(Side::Right, {0.1, 0, 0});
        QVERIFY(all<vr::MoveModel>(player.play(0.1)).empty());
    }
}

void TestWandMapping::swappedHandsDoTheSame()
{
    for (const ButtonPreset preset : everyPreset) {
        WandMapping rightHanded({preset, Side::Right}), leftHanded({preset, Side::Left});
        RandomWands wands;
        for (int i = 0; i < 20000; ++i) {
            InputFrame frame = wands.next();
            const auto ones = rightHanded.step(frame);
            std::swap(frame.wands[0], frame.wands[1]);
            std::swap(frame.pointsAtPanel[0], frame.pointsAtPanel[1]);
            const auto others = leftHanded.step(frame);
            bool isSame = words(ones) == words(others);
            for (std::size_t k = 0; isSame && k < ones.size(); ++k)
                isSame = ones[k].side == opposite(others[k].side) && ones[k].gesture == others[k].gesture;
            QVERIFY2(isSame, qPrintable(QStringLiteral("seed %1, frame %2").arg(seed).arg(i)));
        }
    }
}

void TestWandMapping::frameRatesDoTheSame()
{
    const std::map<QString, int> once{
        {QStringLiteral("begin smooth no"), 1}, {QStringLiteral("end"), 1},       {QStringLiteral("tool menu yes"), 1},
        {QStringLiteral("tool 1"), 2},          {QStringLiteral("save"), 1},      {QStringLiteral("undo"), 2},
        {QStringLiteral("color panel yes"), 1}, {QStringLiteral("channel 1"), 1},
    };
    for (const double rate : frameRates) {
        WandMapping hands;
        Outcome outcome;
        for (const double time : frameTimes(14, rate)) {
            InputFrame frame;
            frame.time = time;
            frame.wands = paperSession(time);
            for (const WandCommand& command : hands.step(frame))
                outcome.add(command);
        }
        QVERIFY(outcome.once == once);
        QVERIFY(std::abs(outcome.scaled - (1.1 - vr::slideThreshold)) < 1e-9);
        QVERIFY(std::abs(outcome.radius + (1.1 - vr::slideThreshold)) < 1e-9);
        QCOMPARE(outcome.color, static_cast<int>((1.4 - vr::slideThreshold) * 255 / 4));
        const double turn = vr::turnSpeed * std::numbers::pi / 180; // for two seconds, clockwise
        QVERIFY(std::abs(outcome.turned + 2 * turn) <= turn / rate + 1e-9);
    }
}

void TestWandMapping::atRandomNothingIsLeftOpen_data()
{
    everyRowDoesItsFunctionAndNothingElseDoesAnything_data();
}

void TestWandMapping::atRandomNothingIsLeftOpen()
{
    QFETCH(ButtonPreset, preset);
    QFETCH(Side, sculpting);
    WandMapping hands({preset, sculpting});
    RandomWands wands;
    const core::Box box(Vec3(-50, -50, -50), Vec3(50, 50, 50));
    vr::ModelPlacement placement(box);
    bool isOpen = false;
    std::array<bool, vr::sideCount> onPanel{};
    std::array<double, vr::sideCount> squeezed{};
    std::map<QString, int> told;
    double before = 0;
    for (int i = 0; i < 100000; ++i) {
        const InputFrame frame = wands.next();
        for (const Side side : sides) {
            const WandState& wand = frame.wands[indexOf(side)];
            squeezed[indexOf(side)] = wand.side && wand.isActive ? squeezed[indexOf(side)] + frame.time - before : 0;
        }
        before = frame.time;
        const QByteArray where = QStringLiteral("seed %1, frame %2").arg(seed).arg(i).toUtf8();
        for (const WandCommand& command : hands.step(frame)) {
            const QString word = commandName(command);
            bool& panel = onPanel[indexOf(command.side)];
            ++told[word];
            if (word.startsWith(QStringLiteral("begin"))) {
                QVERIFY2(!isOpen && !panel && command.side == sculpting, where);
                isOpen = true;
            } else if (word == QStringLiteral("point")) {
                QVERIFY2(isOpen && !panel, where);
                const double pressure = std::get<vr::StrokePoint>(command.action).pressure;
                QVERIFY2(pressure > 0 && pressure <= 1, where);
            } else if (word == QStringLiteral("end")) {
                QVERIFY2(isOpen, where);
                isOpen = false;
            } else if (word == QStringLiteral("press panel")) {
                QVERIFY2(!panel && frame.pointsAtPanel[indexOf(command.side)], where);
                panel = true;
            } else if (word.startsWith(QStringLiteral("release panel"))) {
                QVERIFY2(panel, where);
                panel = false;
            } else if (word == QStringLiteral("save") || word == QStringLiteral("restore")) {
                QVERIFY2(!isOpen && squeezed[indexOf(command.side)] >= vr::holdSeconds - 1e-6, where);
            } else if (word == QStringLiteral("undo") || word == QStringLiteral("redo")) {
                QVERIFY2(!isOpen, where);
            }
            apply(command.action, placement);
            const double shown = placement.lengthToRoom(100);
            QVERIFY2(shown >= vr::ModelPlacement::minSize * (1 - 1e-9) &&
                         shown <= vr::ModelPlacement::maxSize * (1 + 1e-9),
                     where);
            QVERIFY2(std::abs(placement.rotation().norm() - 1) < 1e-12, where);
        }
        const WandState& drawing = frame.wands[indexOf(sculpting)];
        QVERIFY2(isOpen == hands.isDrawing(sculpting), where);
        QVERIFY2(!isOpen || (drawing.isActive && drawing.trigger >= vr::triggerRelease), where);
        for (const Side side : sides) {
            const WandState& wand = frame.wands[indexOf(side)];
            QVERIFY2(!onPanel[indexOf(side)] || (wand.isActive && wand.trigger >= vr::triggerRelease), where);
        }
    }
    for (const char* word : {"begin smooth no", "point", "end", "undo", "redo", "press panel", "release panel yes",
                             "release panel no", "move", "refuse"})
        QVERIFY2(told[QLatin1String(word)] > 20, word);
    hands.releaseAll();
    QVERIFY(hands.releaseAll().empty());
}

FETTLE_TEST(TestWandMapping, QCoreApplication)
#include "tst_wand_mapping.moc"
