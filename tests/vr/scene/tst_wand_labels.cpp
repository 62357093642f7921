#include "vr/scene/wand_labels.h"

#include "core/geometry/rotation.h"
#include "tests/support/test_main.h"
#include "tests/vr/input/command_names.h"
#include "tests/vr/input/hand_motion.h"
#include "tests/vr/scene/counted_allocations.h"

#include <QTest>

#include <numbers>
#include <set>
#include <utility>

using vr::ButtonPreset;
using vr::Gesture;
using vr::HandRole;
using vr::Side;
using vr::WandSpot;

namespace
{
constexpr Side sides[] = {Side::Left, Side::Right};
constexpr double degree = std::numbers::pi / 180;
/// seconds after which labels have appeared or disappeared, with a frame to spare at 5 frames per second
constexpr double appears = vr::labelFadeIn + 0.3, goes = vr::labelFadeOut + 0.3;
const Eigen::Vector2d padLeft(-0.8, 0), padTop(0, 0.8), padMiddle(0, 0);

/// A person whose head looks ahead, with wands held low outside the view direction, and time that passes in frames.
class Player
{
public:
    explicit Player(const vr::WandSettings& choice = {}, double rate = 90) : m_hands(choice), m_period(1 / rate)
    {
        m_head.position = {0, 1.6, 0};
        for (const Side side : sides)
            set(side, restingWand());
    }

    void set(Side side, vr::WandState wand)
    {
        wand.grip.position = {side == Side::Left ? -0.3 : 0.3, 1.1, -0.4};
        m_frame.wands[static_cast<std::size_t>(side)] = wand;
    }
    vr::WandState& wand(Side side) { return m_frame.wands[static_cast<std::size_t>(side)]; }
    vr::WandMapping& hands() { return m_hands; }
    void pointAtPanel(Side side, bool points = true) { m_frame.pointsAtPanel[static_cast<std::size_t>(side)] = points; }

    /// Looks in a direction at this angle, in degrees, from the wand's buttons.
    void look(Side side, double degrees)
    {
        const core::Vec3 to = wand(side).grip * vr::placeOf(WandSpot::PadMiddle) - m_head.position;
        m_head.rotation =
            Eigen::AngleAxisd(degrees * degree, to.unitOrthogonal()) * core::rotationBetween(-core::Vec3::UnitZ(), to);
    }
    void lookAhead() { m_head.rotation = Eigen::Quaterniond::Identity(); }

    /// Plays frames for this many seconds, at least one.
    void play(double seconds)
    {
        const double end = m_frame.time + seconds;
        do {
            m_frame.time += m_period;
            const std::vector<vr::WandCommand> commands = m_hands.step(m_frame);
            m_commands.insert(m_commands.end(), commands.begin(), commands.end());
            m_labels.step(m_frame, m_head, m_hands, commands);
        } while (m_frame.time < end - 1e-9);
    }
    void doOnce(Side side, const vr::WandState& wand, double seconds = 0.1)
    {
        set(side, wand);
        play(seconds);
        set(side, restingWand());
        play(0.05);
    }

    std::vector<vr::WandCommand> takeCommands() { return std::exchange(m_commands, {}); }
    auto labels(Side side) const { return m_labels.labels(side); }
    vr::WandLabel label(Side side, WandSpot spot) const { return labels(side)[static_cast<std::size_t>(spot)]; }
    QString text(Side side, WandSpot spot) const { return label(side, spot).text; }
    float opacity(Side side, WandSpot spot) const { return label(side, spot).opacity; }
    /// Returns true if all labels with a text have this opacity.
    bool allAre(float opacity) const
    {
        for (const Side side : sides)
            for (const vr::WandLabel& label : m_labels.labels(side))
                if (!label.text.isEmpty() && label.opacity != opacity)
                    return false;
        return true;
    }
    double period() const { return m_period; }

private:
    vr::WandMapping m_hands;
    vr::WandLabels m_labels;
    vr::InputFrame m_frame;
    std::vector<vr::WandCommand> m_commands; ///< commands since the last call of takeCommands()
    vr::Pose m_head;
    double m_period;
};

/// Kinds of wands, by their parts.
enum class Kind { Pad, Stick, Simple };
constexpr Kind kinds[] = {Kind::Pad, Kind::Stick, Kind::Simple};
constexpr ButtonPreset presets[] = {ButtonPreset::Paper, ButtonPreset::Studio, ButtonPreset::OneHand};

vr::WandState ofKind(vr::WandState wand, Kind kind)
{
    wand.isStick = kind == Kind::Stick;
    wand.isSimple = kind == Kind::Simple;
    if (wand.isStick && wand.padPressed)
        wand.padPressed = wand.padTouched = false; // pushing the stick is the press
    return wand;
}

/// Finds the effects of a wand's parts by trying them, like a user who does not know the preset.
class Trial
{
public:
    Trial(const vr::WandSettings& choice, Kind kind, const std::vector<std::pair<Side, double>>& menuPresses)
        : m_player(choice, 20)
        , m_kind(kind)
    {
        rest();
        for (const auto& [side, seconds] : menuPresses)
            show(side, pressingMenu(), seconds);
        m_player.play(appears);
        m_player.takeCommands();
    }

    std::set<QString> labels(Side side, WandSpot spot) const
    {
        const QStringList parts = m_player.text(side, spot).split(QStringLiteral(" \u00B7 "), Qt::SkipEmptyParts);
        return {parts.begin(), parts.end()};
    }
    std::set<QString> tried(Side side, WandSpot spot)
    {
        switch (spot) {
        case WandSpot::Trigger:
            return withOther(side, words(side, pulling(1), 0.2));
        case WandSpot::PadLeft:
            return pressed(side, {-0.8, 0});
        case WandSpot::PadRight:
            return pressed(side, {0.8, 0});
        case WandSpot::PadUp:
            return pressed(side, {0, 0.8});
        case WandSpot::PadDown:
            return pressed(side, {0, -0.8});
        case WandSpot::PadMiddle:
            return slid(side);
        case WandSpot::Menu:
            return held(side, pressingMenu());
        case WandSpot::Side:
            return m_kind == Kind::Simple ? std::set<QString>() : held(side, squeezing());
        }
        return {};
    }

private:
    void rest()
    {
        for (const Side side : sides)
            m_player.set(side, ofKind(restingWand(), m_kind));
        m_player.play(0.3);
    }
    /// Shows a state of the wand for this many seconds while the hand moves.
    void show(Side side, const vr::WandState& wand, double seconds)
    {
        m_player.set(side, ofKind(wand, m_kind));
        for (int i = 0; i < 4; ++i) {
            m_player.play(seconds / 4);
            m_player.wand(side).grip.position.x() += 0.01;
        }
        rest();
    }
    std::set<QString> words(Side side, const vr::WandState& wand, double seconds)
    {
        m_player.takeCommands();
        show(side, wand, seconds);
        std::set<QString> done;
        for (const vr::WandCommand& command : m_player.takeCommands())
            if (const QString word = wordOf(commandName(command)); !word.isEmpty())
                done.insert(word);
        return done;
    }
    std::set<QString> pressed(Side side, const Eigen::Vector2d& pad)
    {
        return m_kind == Kind::Simple ? std::set<QString>() : words(side, pressing(pad), 0.2);
    }
    /// Returns the effects of a short press, and those of a long press marked with "Hold:" if a short press does not
    /// have them.
    std::set<QString> held(Side side, const vr::WandState& wand)
    {
        std::set<QString> done = words(side, wand, 0.2);
        const bool opened = done.contains(QStringLiteral("Tools")) || done.contains(QStringLiteral("Colour"));
        if (opened)
            show(side, wand, 0.2); // closes it again
        for (const QString& word : words(side, wand, vr::holdSeconds + 0.3))
            if (!done.contains(word))
                done.insert(QStringLiteral("Hold: ") + word.toLower());
        return done;
    }
    std::set<QString> slid(Side side)
    {
        std::set<QString> done;
        if (m_kind == Kind::Simple)
            return done;
        m_player.takeCommands();
        for (double y = -0.6; y < 0.6; y += 0.1) {
            vr::WandState wand = m_kind == Kind::Stick ? pushing({0, 0.8}) : touching({0, y});
            wand.padPressed = m_kind == Kind::Stick;
            m_player.set(side, wand);
            m_player.play(0.05);
        }
        rest();
        const QString how = m_kind == Kind::Stick ? QStringLiteral("Press, push: ") : QStringLiteral("Slide: ");
        for (const vr::WandCommand& command : m_player.takeCommands())
            done.insert(how + wordOf(commandName(command)));
        return done;
    }
    /// Returns `done`. If it is empty, adds "Smooth" if holding this trigger makes the other hand's trigger smooth.
    std::set<QString> withOther(Side side, std::set<QString> done)
    {
        const Side other = side == Side::Left ? Side::Right : Side::Left;
        if (!done.empty())
            return done;
        m_player.set(side, ofKind(pulling(1), m_kind));
        m_player.play(0.1);
        for (const QString& word : words(other, pulling(1), 0.2))
            if (word == QStringLiteral("Smooth"))
                done.insert(word);
        return done;
    }
    static QString wordOf(const QString& command)
    {
        static const std::pair<const char*, const char*> all[] = {{"begin smooth no", "Sculpt"},
                                                                  {"begin smooth yes", "Smooth"},
                                                                  {"undo", "Undo"},
                                                                  {"redo", "Redo"},
                                                                  {"save", "Save"},
                                                                  {"restore", "Restore"},
                                                                  {"topology", "Uniform or not"},
                                                                  {"shape", "Sphere or ray"},
                                                                  {"symmetry", "Symmetry"},
                                                                  {"inverse", "Invert"},
                                                                  {"tool -1", "Previous tool"},
                                                                  {"tool 1", "Next tool"},
                                                                  {"channel 2", "Previous channel"},
                                                                  {"channel 1", "Next channel"},
                                                                  {"turn -", "Turn clockwise"},
                                                                  {"turn +", "Turn anticlockwise"},
                                                                  {"move", "Move model"},
                                                                  {"tool menu", "Tools"},
                                                                  {"color panel", "Colour"},
                                                                  {"radius", "radius"},
                                                                  {"scale", "scale"},
                                                                  {"color 0", "value"}};
        for (const auto& [name, word] : all)
            if (command.startsWith(QLatin1StringView(name)))
                return QString::fromLatin1(word);
        return {};
    }

    Player m_player;
    Kind m_kind;
};
} // namespace

class TestWandLabels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void labels_sayWhatButtonsDo();
    void labels_areTrueInEveryMode_data();
    void labels_areTrueInEveryMode();
    void labels_ofBareHandsSayTheirGestures();
    void labels_ofOneSpotShareALine();
    void labels_changeWithTheHandsMode();
    void labels_changeWithTheTask();
    void labels_fadeIn();
    void labels_stayUntilTheyAreUsed_data() { rates(); }
    void labels_stayUntilTheyAreUsed();
    void useInOneMode_isNoUseInTheOther();
    void sharedLine_staysUntilAllOfItIsUsed();
    void whatTwoHandsDo_isUsedByBoth();
    void pressedPanels_areNoUse();
    void wandAtAPanel_hasNoLabels();
    void fartherOfTwoCloseWands_hasNoLabels();
    void refusedPresses_areNoUse();
    void lookedAtWand_hasItsLabelsBack_data() { rates(); }
    void lookedAtWand_hasItsLabelsBack();
    void look_hasHysteresis();
    void drawingWand_isNotLookedAt();
    void otherChoice_hasNewLabels();
    void fades_areTheSameAtAnyRate();
    void steps_allocateNothing();

private:
    static void rates();
};

void TestWandLabels::rates()
{
    QTest::addColumn<double>("rate");
    for (const double rate : frameRates)
        QTest::addRow("%g a second", rate) << rate;
}

void TestWandLabels::labels_sayWhatButtonsDo()
{
    Player player;
    player.play(appears);
    QCOMPARE(player.text(Side::Left, WandSpot::PadLeft), QStringLiteral("Turn clockwise"));
    QCOMPARE(player.text(Side::Left, WandSpot::PadRight), QStringLiteral("Turn anticlockwise"));
    QCOMPARE(player.text(Side::Left, WandSpot::PadUp), QStringLiteral("Uniform or not"));
    QCOMPARE(player.text(Side::Left, WandSpot::PadDown), QStringLiteral("Uniform or not"));
    QCOMPARE(player.text(Side::Left, WandSpot::PadMiddle), QStringLiteral("Slide: scale"));
    QCOMPARE(player.text(Side::Left, WandSpot::Menu), QStringLiteral("Tools"));
    QCOMPARE(player.text(Side::Left, WandSpot::Trigger), QStringLiteral("Move model"));
    QCOMPARE(player.text(Side::Left, WandSpot::Side), QStringLiteral("Hold: save"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadUp), QStringLiteral("Sphere or ray"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadDown), QStringLiteral("Symmetry"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadLeft), QStringLiteral("Undo"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadRight), QStringLiteral("Redo"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadMiddle), QStringLiteral("Slide: radius"));
    QCOMPARE(player.text(Side::Right, WandSpot::Menu), QStringLiteral("Colour"));
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Sculpt"));
    QCOMPARE(player.text(Side::Right, WandSpot::Side), QStringLiteral("Hold: restore"));
}

void TestWandLabels::labels_areTrueInEveryMode_data()
{
    QTest::addColumn<ButtonPreset>("preset");
    QTest::addColumn<Side>("sculpting");
    QTest::addColumn<Kind>("kind");
    const char* presetNames[] = {"Paper", "Studio", "One hand"};
    const char* kindNames[] = {"pad", "stick", "simple"};
    for (const ButtonPreset preset : presets)
        for (const Side sculpting : sides)
            for (const Kind kind : kinds)
                QTest::addRow("%s, %s hand, %s", presetNames[int(preset)], sculpting == Side::Left ? "left" : "right",
                              kindNames[int(kind)])
                    << preset << sculpting << kind;
}

/// Checks that each part with an effect has a label with exactly that effect, whichever panels are open.
void TestWandLabels::labels_areTrueInEveryMode()
{
    QFETCH(ButtonPreset, preset);
    QFETCH(Side, sculpting);
    QFETCH(Kind, kind);
    const Side other = sculpting == Side::Left ? Side::Right : Side::Left;
    constexpr double tap = 0.2, hold = vr::holdSeconds + 0.3;
    const std::vector<std::pair<Side, double>> ways[] = {{},
                                                         {{sculpting, tap}},
                                                         {{sculpting, hold}},
                                                         {{other, tap}},
                                                         {{sculpting, tap}, {sculpting, hold}},
                                                         {{other, tap}, {sculpting, tap}}};
    for (const auto& way : ways)
        for (const Side side : sides)
            for (std::size_t spot = 0; spot < vr::wandSpotCount; ++spot) {
                Trial trial({preset, sculpting}, kind, way);
                const std::set<QString> said = trial.labels(side, WandSpot(spot)),
                                        done = trial.tried(side, WandSpot(spot));
                const auto text = [](const std::set<QString>& words) {
                    return QStringList(words.begin(), words.end()).join(QStringLiteral(", "));
                };
                QVERIFY2(said == done, qPrintable(QStringLiteral("%1 wand, spot %2, %3 presses: says %4; does %5")
                                                      .arg(side == sculpting ? "sculpting" : "other")
                                                      .arg(spot)
                                                      .arg(way.size())
                                                      .arg(text(said), text(done))));
            }
}

/// Checks the labels of bare hands, which have no buttons, and that they return when a wand is taken up.
void TestWandLabels::labels_ofBareHandsSayTheirGestures()
{
    Player player;
    const auto hold = [&](bool isHand) {
        for (const Side side : sides) {
            vr::WandState wand = restingWand();
            wand.isHand = isHand;
            player.set(side, wand);
        }
        player.play(appears);
    };
    hold(true);
    QCOMPARE(player.text(Side::Left, WandSpot::Trigger), QStringLiteral("Pinch: smooth"));
    QCOMPARE(player.text(Side::Left, WandSpot::Side), QStringLiteral("Fist: move model"));
    QCOMPARE(player.text(Side::Left, WandSpot::Menu), QStringLiteral("Palm: tools"));
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Pinch: sculpt"));
    QCOMPARE(player.text(Side::Right, WandSpot::Side), QStringLiteral("Fist: move model"));
    QCOMPARE(player.text(Side::Right, WandSpot::Menu), QStringLiteral("Palm: colour"));
    for (const Side side : sides)
        for (const WandSpot spot :
             {WandSpot::PadUp, WandSpot::PadDown, WandSpot::PadLeft, WandSpot::PadRight, WandSpot::PadMiddle})
            QCOMPARE(player.text(side, spot), QString());
    hold(false);
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Sculpt"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadLeft), QStringLiteral("Undo"));
}

void TestWandLabels::labels_ofOneSpotShareALine()
{
    Player player({ButtonPreset::Studio, Side::Right});
    player.play(appears);
    QCOMPARE(player.text(Side::Right, WandSpot::Menu), QStringLiteral("Colour \u00B7 Hold: invert"));
    QCOMPARE(player.text(Side::Left, WandSpot::PadMiddle), QString());
}

void TestWandLabels::labels_changeWithTheHandsMode()
{
    Player player;
    player.play(appears);
    player.doOnce(Side::Right, pressingMenu());
    QCOMPARE(player.text(Side::Right, WandSpot::PadLeft), QStringLiteral("Previous channel"));
    QCOMPARE(player.text(Side::Right, WandSpot::PadUp), QString());
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Sculpt"));
    QVERIFY(player.opacity(Side::Right, WandSpot::PadLeft) < 1); // a changed text fades in
    QCOMPARE(player.opacity(Side::Right, WandSpot::Trigger), 1.0F);
    QCOMPARE(player.text(Side::Left, WandSpot::PadLeft), QStringLiteral("Turn clockwise"));
    player.play(appears);
    QCOMPARE(player.opacity(Side::Right, WandSpot::PadLeft), 1.0F);
    player.doOnce(Side::Right, pressingMenu());
    QCOMPARE(player.text(Side::Right, WandSpot::PadLeft), QStringLiteral("Undo"));
}

/// Checks that the labels name a task's functions, which are new and fade in, and then the preset's again.
void TestWandLabels::labels_changeWithTheTask()
{
    Player player;
    player.play(appears);
    player.doOnce(Side::Right, pulling(1));
    player.play(goes);
    QCOMPARE(player.label(Side::Right, WandSpot::Trigger).opacity, 0.0F);
    player.hands().setTask(vr::HandTask::ChoosePart);
    player.play(0.01);
    QVERIFY(player.label(Side::Right, WandSpot::Trigger).opacity < 0.1F);
    player.play(appears);
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Choose part"));
    QCOMPARE(player.label(Side::Right, WandSpot::Trigger).opacity, 1.0F);
    QCOMPARE(player.text(Side::Left, WandSpot::Trigger), QStringLiteral("Move model"));
    player.doOnce(Side::Right, pulling(1));
    player.play(goes);
    QCOMPARE(player.label(Side::Right, WandSpot::Trigger).opacity, 0.0F);
    player.hands().setTask(vr::HandTask::Sculpt);
    player.play(appears);
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Sculpt"));
    QCOMPARE(player.label(Side::Right, WandSpot::Trigger).opacity, 0.0F);
}

void TestWandLabels::labels_fadeIn()
{
    Player player;
    player.play(0);
    QVERIFY(player.allAre(0));
    player.play(vr::labelFadeIn / 2);
    QVERIFY(player.opacity(Side::Left, WandSpot::Menu) > 0.4F && player.opacity(Side::Left, WandSpot::Menu) < 0.6F);
    player.play(appears);
    QVERIFY(player.allAre(1));
}

/// Checks that a label disappears after its own gesture is used, and that no other label does.
void TestWandLabels::labels_stayUntilTheyAreUsed()
{
    QFETCH(double, rate);
    struct Use
    {
        Side side;
        WandSpot spot;
        vr::WandState wand;
    };
    const Use uses[] = {
        {Side::Left, WandSpot::PadLeft, pressing(padLeft)}, {Side::Right, WandSpot::PadLeft, pressing(padLeft)},
        {Side::Right, WandSpot::PadUp, pressing(padTop)},   {Side::Left, WandSpot::Side, squeezing()},
        {Side::Right, WandSpot::Trigger, pulling(1)},       {Side::Right, WandSpot::Menu, pressingMenu()},
        {Side::Left, WandSpot::Menu, pressingMenu()}};
    for (const Use& use : uses) {
        Player player({}, rate);
        player.play(30);
        QVERIFY(player.allAre(1));
        player.doOnce(use.side, use.wand, vr::holdSeconds + 0.25);
        player.play(goes + appears);
        for (const Side side : sides)
            for (std::size_t spot = 0; spot < vr::wandSpotCount; ++spot)
                if (!player.text(side, WandSpot(spot)).isEmpty())
                    QCOMPARE(player.opacity(side, WandSpot(spot)),
                             side == use.side && WandSpot(spot) == use.spot ? 0.0F : 1.0F);
    }
}

void TestWandLabels::useInOneMode_isNoUseInTheOther()
{
    Player player;
    player.doOnce(Side::Right, pressing(padLeft));
    player.play(goes);
    QCOMPARE(player.opacity(Side::Right, WandSpot::PadLeft), 0.0F);
    player.doOnce(Side::Right, pressingMenu());
    player.play(goes);
    QCOMPARE(player.opacity(Side::Right, WandSpot::PadLeft), 1.0F);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Menu), 0.0F);
    player.doOnce(Side::Right, pressingMenu());
    player.play(goes);
    QCOMPARE(player.opacity(Side::Right, WandSpot::PadLeft), 0.0F);
}

void TestWandLabels::sharedLine_staysUntilAllOfItIsUsed()
{
    Player player({ButtonPreset::Studio, Side::Right});
    player.doOnce(Side::Right, pressingMenu());
    player.play(goes);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Menu), 1.0F);
    player.doOnce(Side::Right, pressingMenu(), vr::holdSeconds + 0.1);
    player.play(goes);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Menu), 0.0F);
}

void TestWandLabels::whatTwoHandsDo_isUsedByBoth()
{
    Player player({ButtonPreset::Studio, Side::Right});
    player.play(appears);
    for (const Side side : sides)
        player.set(side, squeezing());
    player.play(0.2);
    for (const Side side : sides)
        player.set(side, restingWand());
    player.play(goes);
    QCOMPARE(player.opacity(Side::Left, WandSpot::Side), 0.0F);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Side), 0.0F);
    for (const Side side : sides)
        player.set(side, pulling(1));
    player.play(0.2);
    player.play(goes);
    QCOMPARE(player.opacity(Side::Left, WandSpot::Trigger), 0.0F);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Trigger), 0.0F);
}

void TestWandLabels::pressedPanels_areNoUse()
{
    Player player;
    player.pointAtPanel(Side::Right);
    player.doOnce(Side::Right, pulling(1));
    player.pointAtPanel(Side::Right, false);
    player.play(goes);
    QVERIFY(player.allAre(1));
}

/// Checks that a wand pointing at a panel shows no labels, even when looked at.
void TestWandLabels::wandAtAPanel_hasNoLabels()
{
    Player player;
    player.look(Side::Right, 0);
    player.play(vr::labelLookSeconds + appears);
    player.pointAtPanel(Side::Right);
    player.play(appears);
    for (const vr::WandLabel& label : player.labels(Side::Right))
        QCOMPARE(label.opacity, 0.0F);
    QCOMPARE(player.opacity(Side::Left, WandSpot::Trigger), 1.0F);
    player.pointAtPanel(Side::Right, false);
    player.play(appears);
    QVERIFY(player.allAre(1));
}

/// Checks wands 20 cm apart, where there is room for only one wand's labels.
void TestWandLabels::fartherOfTwoCloseWands_hasNoLabels()
{
    Player player;
    const auto hold = [&](const core::Vec3& left, const core::Vec3& right) {
        player.wand(Side::Left).grip.position = left;
        player.wand(Side::Right).grip.position = right;
        player.play(appears);
    };
    const auto allOf = [&](Side side, float opacity) {
        return std::ranges::all_of(player.labels(side), [&](const vr::WandLabel& label) {
            return label.text.isEmpty() || label.opacity == opacity;
        });
    };
    hold({-0.1, 1.4, -0.5}, {0.1, 1.4, -0.4});
    QVERIFY(allOf(Side::Left, 0) && allOf(Side::Right, 1));
    hold({-0.1, 1.4, -0.4}, {0.1, 1.4, -0.41}); // trembling hands
    QVERIFY(allOf(Side::Left, 0) && allOf(Side::Right, 1));
    hold({-0.1, 1.4, -0.4}, {0.1, 1.4, -0.5});
    QVERIFY(allOf(Side::Left, 1) && allOf(Side::Right, 0));
    hold({-0.1, 1.4, -0.4}, {0.1, 1.6, -0.5}); // one above the other
    QVERIFY(player.allAre(1));
    hold({-0.1, 1.4, -0.4}, {0.1, 1.4, -0.5});
    QVERIFY(allOf(Side::Right, 0));
    hold({-0.2, 1.4, -0.4}, {0.2, 1.4, -0.5});
    QVERIFY(player.allAre(1));
    hold({-0.1, 1.4, -0.4}, {0.1, 1.4, -0.5});
    player.wand(Side::Left).isTracked = false;
    player.play(appears);
    QVERIFY(allOf(Side::Right, 1));
}

void TestWandLabels::refusedPresses_areNoUse()
{
    Player player;
    player.hands().setSettings({ButtonPreset::Studio, Side::Right});
    player.play(appears);
    player.set(Side::Right, pulling(1));
    player.play(0.1);
    player.doOnce(Side::Left, pressing(padLeft)); // undo has no effect while a stroke is open
    player.play(goes);
    QCOMPARE(player.opacity(Side::Left, WandSpot::PadLeft), 1.0F);
    player.set(Side::Right, restingWand());
    player.play(0.1);
    player.doOnce(Side::Left, pressing(padLeft));
    player.play(goes);
    QCOMPARE(player.opacity(Side::Left, WandSpot::PadLeft), 0.0F);
}

void TestWandLabels::lookedAtWand_hasItsLabelsBack()
{
    QFETCH(double, rate);
    Player player({}, rate);
    for (const Side side : sides)
        player.doOnce(side, pulling(1), 0.5);
    player.play(goes);
    const auto seen = [&](Side side) { return player.opacity(side, WandSpot::Trigger); };
    QCOMPARE(seen(Side::Left), 0.0F);
    player.look(Side::Left, 10);
    player.play(vr::labelLookSeconds - player.period());
    QCOMPARE(seen(Side::Left), 0.0F);
    player.play(appears + player.period());
    QCOMPARE(seen(Side::Left), 1.0F);
    QCOMPARE(seen(Side::Right), 0.0F);
    player.lookAhead();
    player.play(player.period());
    QVERIFY(seen(Side::Left) > 0.7F);
    player.play(goes);
    QCOMPARE(seen(Side::Left), 0.0F);
    player.look(Side::Left, 0); // a glance
    player.play(0.3);
    player.lookAhead();
    player.play(0.3);
    player.look(Side::Left, 0);
    player.play(0.3);
    QCOMPARE(seen(Side::Left), 0.0F);
    player.wand(Side::Left).isTracked = false;
    player.play(3);
    QCOMPARE(seen(Side::Left), 0.0F);
}

void TestWandLabels::look_hasHysteresis()
{
    Player player;
    player.doOnce(Side::Right, pulling(1));
    player.play(goes);
    const auto opacityAt = [&](double degrees) {
        player.look(Side::Right, degrees);
        player.play(3);
        return player.opacity(Side::Right, WandSpot::Trigger);
    };
    QCOMPARE(opacityAt(14), 0.0F);
    QCOMPARE(opacityAt(11), 1.0F);
    QCOMPARE(opacityAt(14), 1.0F);
    QCOMPARE(opacityAt(17), 0.0F);
    QCOMPARE(opacityAt(14), 0.0F);
}

void TestWandLabels::drawingWand_isNotLookedAt()
{
    Player player;
    player.doOnce(Side::Right, pulling(1));
    player.play(goes);
    player.look(Side::Right, 0);
    player.set(Side::Right, pulling(1));
    player.play(5);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Trigger), 0.0F);
    player.set(Side::Right, restingWand());
    player.play(vr::labelLookSeconds + appears);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Trigger), 1.0F);
}

void TestWandLabels::otherChoice_hasNewLabels()
{
    Player player;
    player.doOnce(Side::Right, pulling(1));
    player.play(goes);
    QCOMPARE(player.opacity(Side::Right, WandSpot::Trigger), 0.0F);
    player.hands().setSettings({ButtonPreset::Paper, Side::Left});
    player.play(appears);
    QCOMPARE(player.text(Side::Left, WandSpot::Trigger), QStringLiteral("Sculpt"));
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Move model"));
    QVERIFY(player.allAre(1));
    player.hands().setSettings({ButtonPreset::Studio, Side::Left});
    player.play(appears);
    QCOMPARE(player.text(Side::Right, WandSpot::Trigger), QStringLiteral("Smooth"));
    QVERIFY(player.allAre(1));
}

/// Compares fades at several frame rates. They may differ only by the fraction of a frame in which the press is noticed
/// later.
void TestWandLabels::fades_areTheSameAtAnyRate()
{
    for (const double after : {0.2, 0.4, 0.6, 0.8, 1.0}) {
        for (const double rate : frameRates) {
            Player player({}, rate);
            player.play(2);
            player.set(Side::Right, pressing(padLeft));
            player.play(after);
            const double wanted = 1 - after / vr::labelFadeOut,
                         slack = 1 / rate / vr::labelFadeOut + 0.05; // time to distinguish a press from a slide
            QVERIFY(std::abs(player.opacity(Side::Right, WandSpot::PadLeft) - wanted) < slack);
        }
    }
}

void TestWandLabels::steps_allocateNothing()
{
    vr::WandMapping hands;
    vr::WandLabels labels;
    vr::InputFrame frame{.wands = {restingWand(), restingWand()}};
    const std::vector<vr::WandCommand> commands{{Side::Right, Gesture::PadLeft, vr::Undo{}},
                                                {Side::Left, Gesture::Menu, vr::OpenToolMenu{}}};
    labels.step(frame, {}, hands, commands);
    const long before = allocations;
    for (int i = 1; i < 200; ++i) {
        frame.time = i / 90.0;
        labels.step(frame, {}, hands, commands);
        for (const Side side : sides)
            QCOMPARE(labels.labels(side).size(), vr::wandSpotCount);
    }
    QCOMPARE(allocations - before, 0L);
}

FETTLE_TEST(TestWandLabels, QCoreApplication)
#include "tst_wand_labels.moc"
