#pragma once

#include "tests/support/program_driver.h"
#include "tests/vr/simulator/scripted_headset.h"

#include "app/headset/headset.h"
#include "app/headset/headset_settings_store.h"
#include "core/geometry/rotation.h"
#include "tests/support/waiting.h"
#include "vr/input/model_placement.h"
#include "vr/input/wand_mapping.h"
#include "vr/panels/panel_manager.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <future>
#include <map>

/// User actions in the headset, simulated with the scripted runtime. Frames advance one at a time, so that runs are
/// reproducible.
namespace app
{
class HeadsetHand
{
public:
    /// Sizes of an eye's picture, pixels: `few` for tests that ignore the picture, `enough` for tests that examine it.
    static constexpr QSize few{54, 60}, enough{216, 240};

    explicit HeadsetHand(Program& program, const QSize& pixels = few) : m_program(program)
    {
        load(pixels);
        auto* entrance = program.window.findChild<Headset*>();
        QObject::connect(
            entrance, &Headset::avatarChanged, entrance,
            [this](const std::optional<vr::AvatarState>& presence) { m_seen = presence.value_or(m_seen); });
    }
    ~HeadsetHand() { m_headset.step("{'pace': 'fast'}"); } // lets the session end after a failed test

    static inline const vr::Pose head{Eigen::Quaterniond::Identity(), {0, 1.6, 0}};

    /// Loads a new script with `size` pixels per eye. The controllers point straight ahead.
    void load(const QSize& size)
    {
        const QByteArray script =
            QStringLiteral("{'start': {'pace': 'stepped', 'size': [%1, %2], 'head': {'position': [0, 1.6, 0]},"
                           " 'aim': {'position': [0, 0, 0], 'rotation': [0, 0, 0, 1]}}}")
                .arg(size.width())
                .arg(size.height())
                .toUtf8();
        m_headset.load(script.constData());
        m_isDrawn = true;
        m_undrawn = 0;
    }
    ScriptedHeadset& headset() { return m_headset; }

    /// Enters VR and waits until the model is in front of the user. The controllers are at rest in front of the body.
    void enter()
    {
        put(vr::Side::Left, {-0.3, 1.1, -0.3});
        put(vr::Side::Right, {0.3, 1.1, -0.3});
        m_framesBefore = framesEnded();
        m_program.window.action(QStringLiteral("vr.enter"))->trigger();
        QTRY_VERIFY(m_headset.report()["is_running"].toBool());
        frames(8); // the session gets the focus with the fourth frame
        placeModelAgain();
    }
    void leave()
    {
        m_program.window.action(QStringLiteral("vr.enter"))->trigger();
        waitUntilOut();
    }
    /// Waits until the session has ended. Ending a session takes frames, so the runtime advances by itself meanwhile.
    void waitUntilOut()
    {
        setDrawn(true);
        m_undrawn = 0;
        m_headset.step("{'pace': 'fast'}");
        QTRY_VERIFY(!m_headset.report()["is_running"].toBool());
        QTRY_VERIFY(!m_program.window.findChild<Headset*>()->isActive());
        m_headset.step("{'pace': 'stepped'}");
    }

    bool isIn() const { return m_headset.report()["is_running"].toBool(); }

    /// Returns the state that the window received last.
    const vr::AvatarState& seen() const { return m_seen; }

    /// Returns the answer of the mesh thread after all its earlier jobs.
    template <class Ask> auto ask(const Ask& what)
    {
        std::promise<decltype(what(std::declval<core::Sculptor&>()))> answer;
        m_program.worker.post([&](core::Sculptor& sculptor) { answer.set_value(what(sculptor)); });
        return answer.get_future().get();
    }

    /// Advances frames. Between two frames, the window processes its events and the engine its jobs. The runtime asks
    /// for pictures of some frames only.
    void frames(int count = 1)
    {
        for (int i = 0; i < count; ++i) {
            setDrawn(m_undrawn == 0);
            m_undrawn = m_isDrawn ? m_undrawnBetween : m_undrawn - 1;
            QVERIFY(m_headset.frames(1));
            if (!m_isStalled)
                meetEngine();
        }
    }
    /// Stops the window from processing events between frames, as if it were blocked.
    void setStalled(bool isStalled) { m_isStalled = isStalled; }
    void frame() { frames(1); }
    /// Lets the runtime ask for the pictures of all frames, for tests of what changes from picture to picture.
    void drawAllFrames() { m_undrawn = m_undrawnBetween = 0; }
    /// Waits until all requested actions are done, or wait for the end of a preview.
    void settle()
    {
        Document& document = m_program.document;
        frames(isIn() ? 2 : 0);
        QTRY_VERIFY((document.queue().isSettled() && !document.job().isBusy()) || document.changer().isPreviewing());
        frames(isIn() ? 2 : 0);
    }

    /// Places the tip of a controller in the room and sets its pointing direction.
    void put(vr::Side side, const core::Vec3& tip, const core::Vec3& direction = -core::Vec3::UnitZ(), int over = 0)
    {
        const Eigen::Quaterniond turn = core::rotationBetween(-core::Vec3::UnitZ(), direction);
        const core::Vec3 grip = tip - vr::tipReach * direction.normalized();
        m_grips[static_cast<std::size_t>(side)] = {turn, grip};
        QJsonObject step{{nameOf(side), QJsonObject{{"position", QJsonArray{grip.x(), grip.y(), grip.z()}},
                                                    {"rotation", QJsonArray{turn.x(), turn.y(), turn.z(), turn.w()}}}}};
        if (over > 0)
            step["over"] = over;
        apply(step);
    }
    /// Puts the controllers down. From now on the bare hands are where these were: a pinch takes the place of the
    /// trigger, with the fingers at the controller's tip, and a fist that of the side button.
    void putWandsDown()
    {
        m_isBare = true;
        apply({{"profile", "/interaction_profiles/ext/hand_interaction_ext"},
               {"pinch_at", QJsonObject{{"position", QJsonArray{0, 0, -vr::tipReach}}}}});
        frames(4);
    }
    /// Turns the palm of a bare hand to the face for long enough, then away from it.
    void showPalm(vr::Side side)
    {
        const double right = side == vr::Side::Right ? 1 : -1;
        setSlow(true);
        put(side, {right * 0.016, 1.45, -0.4}, {-right, 0, 0});
        frames(10);
        put(side, {right * 0.35, 1.25, -0.3});
        frames(2);
        setSlow(false);
    }
    void set(vr::Side side, const char* input, const QJsonValue& value)
    {
        const QLatin1StringView name(input);
        const bool isTrigger = name == QLatin1StringView("trigger"), isSide = name == QLatin1StringView("squeeze");
        const QString ofHand = isTrigger ? QStringLiteral("pinch") : isSide ? QStringLiteral("grasp") : QString(name);
        apply({{nameOf(side), QJsonObject{{m_isBare ? ofHand : QString(name), value}}}});
    }
    /// Presses a button for `count` frames, then releases it for one.
    void press(vr::Side side, const char* input, int count = 2)
    {
        set(side, input, 1);
        frames(count);
        set(side, input, 0);
        frame();
    }
    /// Frame rate during long presses, and the number of such slow frames that count as a long press.
    static constexpr int slowHertz = 20, longPress = static_cast<int>(vr::holdSeconds * slowHertz) + 4;
    void setSlow(bool isSlow) { m_headset.step(isSlow ? "{'hz': 20}" : "{'hz': 90}"); }
    /// Presses a button long enough for a long press.
    void hold(vr::Side side, const char* input)
    {
        setSlow(true);
        press(side, input, longPress);
        setSlow(false);
    }
    void pressPad(vr::Side side, double x, double y, int count = 2)
    {
        set(side, "pad", QJsonArray{x, y});
        set(side, "pad_touch", 1);
        frame();
        press(side, "pad_press", count);
        set(side, "pad_touch", 0);
        frame();
    }
    void slide(vr::Side side, const Eigen::Vector2d& by)
    {
        constexpr int steps = 16;
        set(side, "pad", QJsonArray{-by.x() / 2, -by.y() / 2});
        set(side, "pad_touch", 1);
        for (int i = 0; i <= steps; ++i) {
            const Eigen::Vector2d at = by * (static_cast<double>(i) / steps - 0.5);
            set(side, "pad", QJsonArray{at.x(), at.y()});
            frame();
        }
        set(side, "pad_touch", 0);
        frames(2);
    }

    /// Computes the placement again, after the model was placed in front of the user.
    void placeModelAgain()
    {
        m_room = vr::ModelPlacement(m_program.document.modelInfo().box);
        m_room.place(head);
    }
    /// Returns the position in the room of a document point. Valid until the model is moved by hand.
    core::Vec3 place(const core::Vec3& point) const { return m_room.toRoom(point); }
    const vr::ModelPlacement& room() const { return m_room; }
    void hover(const core::Vec3& point)
    {
        put(vr::Side::Right, place(point));
        frames(2);
    }
    /// Presses the trigger and moves the brush from one point to another. Units: document space.
    void begin(const core::Vec3& from, const core::Vec3& to, int steps = 12, double trigger = 1)
    {
        put(vr::Side::Right, place(from));
        frame();
        set(vr::Side::Right, "trigger", trigger);
        for (int i = 0; i <= steps; ++i) {
            put(vr::Side::Right, place(from + (to - from) * i / std::max(steps, 1)));
            frame();
        }
    }
    void end()
    {
        set(vr::Side::Right, "trigger", 0);
        frames(isIn() ? 1 : 0);
    }
    void stroke(const core::Vec3& from, const core::Vec3& to, int steps = 12, double trigger = 1)
    {
        begin(from, to, steps, trigger);
        set(vr::Side::Right, "trigger", 0);
        settle();
    }

    /// Returns the pose of a panel in the room. Panels in front of the user keep their opening pose.
    vr::Pose placeOf(const vr::PanelLayout& layout)
    {
        const vr::Side carrier = layout.kind == vr::PanelKind::Tools ? other(sculpting()) : sculpting();
        const vr::Pose at = m_seen.head.value_or(head);
        const core::Box& box = m_program.document.modelInfo().box;
        const core::Sphere clay{m_room.middle(), m_room.lengthToRoom(box.sizes().maxCoeff()) / 2};
        if (layout.kind == vr::PanelKind::Tools || layout.kind == vr::PanelKind::Color)
            return vr::placeAtHand(m_grips[static_cast<std::size_t>(carrier)], at,
                                   {layout.metres(), clay, carrier == vr::Side::Left ? 1.0 : -1.0});
        const bool replacesTools = layout.kind == vr::PanelKind::Files || layout.kind == vr::PanelKind::Settings ||
                                   layout.kind == vr::PanelKind::Parts;
        const auto place = vr::PanelManager::placeOnOpening(layout.kind, {at, {}, sculpting(), clay}, layout,
                                                            replacesTools ? m_tools : std::nullopt);
        return m_ahead.emplace(layout.kind, place).first->second;
    }
    /// Opens a panel by its button on the tool panel. The panel replaces the tool panel.
    void openFromTools(const vr::ToolPanel& tools, vr::PanelKind kind)
    {
        click(tools, vr::ShowPanel{kind});
        m_tools = placeOf(vr::layoutOf(tools));
    }
    /// Returns the centre of an item, or the point of a slider for the requested value. Units: room space.
    core::Vec3 placeOf(const vr::PanelLayout& layout, const vr::PanelAction& item)
    {
        const vr::PanelItem* part = layout.itemFor(item);
        if (!part)
            return core::Vec3::Zero();
        QPointF point = part->area.center();
        if (const auto* slider = std::get_if<vr::SliderLook>(&part->look))
            point = vr::sliderTrack(part->area).pointAt(vr::sliderShare(*slider, std::get<vr::Slide>(item).value));
        point -= QPointF(layout.size.width(), layout.size.height()) / 2;
        return placeOf(layout) * (core::Vec3(point.x(), -point.y(), 0) * layout.distance / 1000);
    }
    /// Points a controller at an item and returns the controller. A panel held by one hand is pointed at by the other;
    /// other panels by the sculpting hand.
    vr::Side pointAt(const vr::PanelContent& content, const vr::PanelAction& item)
    {
        const vr::PanelLayout layout = vr::layoutOf(content);
        const vr::Side side = layout.kind == vr::PanelKind::Color ? other(sculpting()) : sculpting();
        const core::Vec3 towards = placeOf(layout).rotation * -core::Vec3::UnitZ();
        put(side, placeOf(layout, item) - reach * towards, towards);
        frame();
        if (side == sculpting())
            waitUntilBrushIsAway();
        return side;
    }
    void click(const vr::PanelContent& content, const vr::PanelAction& item, int count = 2)
    {
        press(pointAt(content, item), "trigger", count);
        settle();
    }
    /// Clicks an item until `happened` returns true. Repeats, because panels are painted on another thread and may not
    /// be ready.
    template <class Happened>
    bool choose(const vr::PanelContent& content, const vr::PanelAction& item, const Happened& happened, int count = 2)
    {
        if (!vr::layoutOf(content).itemFor(item))
            return false;
        for (int i = 0; i < 12 && isIn(); ++i) {
            click(content, item, count);
            if (happened())
                return true;
            QTest::qWait(20);
        }
        return happened();
    }

    /// Waits for panels, which are painted on another thread.
    void waitForPanels()
    {
        for (int i = 0; i < 20; ++i) {
            QTest::qWait(20);
            frame();
        }
    }

    QImage picture(const char* eye = "left")
    {
        m_headset.step("{'keep': true}");
        m_undrawn = 0;
        frame();
        return m_headset.picture(m_headset.report()["sessions"].toInt() - 1, framesEnded() - m_framesBefore - 1, eye);
    }

private:
    static constexpr double reach = 0.1; ///< distance from which a controller points at a panel, metres

    int framesEnded() const { return m_headset.report()["frames_ended"].toInt(); }
    static vr::Side sculpting() { return HeadsetSettingsStore().load().wands.sculpting; }
    static vr::Side other(vr::Side side) { return side == vr::Side::Left ? vr::Side::Right : vr::Side::Left; }
    static QString nameOf(vr::Side side)
    {
        return side == vr::Side::Left ? QStringLiteral("left") : QStringLiteral("right");
    }
    void apply(const QJsonObject& step)
    {
        m_headset.step(QJsonDocument(step).toJson(QJsonDocument::Compact).constData());
    }
    /// Waits until the brush is hidden, which happens when its controller points at a visible panel. Until then a
    /// trigger press would sculpt.
    void waitUntilBrushIsAway()
    {
        for (int i = 0; i < 200 && m_seen.brush && !m_isStalled; ++i) {
            QTest::qWait(10);
            frame();
        }
    }
    void setDrawn(bool isDrawn)
    {
        if (std::exchange(m_isDrawn, isDrawn) != isDrawn)
            m_headset.step(isDrawn ? "{'should_render': true}" : "{'should_render': false}");
    }
    void meetEngine()
    {
        ask([](core::Sculptor&) { return true; });
        QCoreApplication::processEvents();
    }

    Program& m_program;
    ScriptedHeadset m_headset;
    std::array<vr::Pose, vr::sideCount> m_grips; ///< poses of the grips; index: Side
    std::map<vr::PanelKind, vr::Pose> m_ahead;   ///< poses of panels in front of the user
    std::optional<vr::Pose> m_tools;             ///< last pose of the tool panel
    vr::ModelPlacement m_room;
    vr::AvatarState m_seen;
    bool m_isStalled = false;
    bool m_isDrawn = true; ///< the runtime asks for pictures
    /// Number of frames without a picture between two with one. A frame with a picture takes four times as long.
    int m_undrawnBetween = 3;
    int m_undrawn = 0;      ///< number of frames until the next picture
    bool m_isBare = false;  ///< the hands hold no controllers
    int m_framesBefore = 0; ///< number of frames before the current visit
};
} // namespace app
