#include "ui/input/pointer_input.h"

#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QTest>

#include <functional>
#include <numbers>

using core::Tool;
using Kind = ui::PointerEvent::Kind;
using Pixel = ui::OrbitCamera::Pixel;

namespace
{
const core::SurfaceHit somewhere{core::Vec3(0, 0, 50), core::Vec3(0, 0, 1), 100, 0};

/// Records the signals of the input, in order.
struct Recorder
{
    Recorder()
    {
        camera.setViewport(800, 600);
        camera.frame({});
        QObject::connect(&input, &ui::PointerInput::hoverRequested, &input,
                         [this](const core::Ray& ray, const std::optional<core::StrokeSettings>& footprintOf) {
                             ++questions;
                             asked = ray;
                             askedBrush = footprintOf;
                         });
        QObject::connect(&input, &ui::PointerInput::strokeBegan, &input, [this](const core::StrokeSettings& s) {
            log << QStringLiteral("began");
            settings = s;
        });
        QObject::connect(&input, &ui::PointerInput::strokeSampled, &input, [this](const core::StrokeSample& sample) {
            log << QStringLiteral("sample");
            samples.push_back(sample);
        });
        QObject::connect(&input, &ui::PointerInput::strokeEnded, &input, [this](core::StrokeEnd how) {
            log << (how == core::StrokeEnd::Kept ? QStringLiteral("ended") : QStringLiteral("taken back"));
        });
    }

    void send(Kind kind, Pixel at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {})
    {
        ui::PointerEvent event{kind, at, kind == Kind::Move ? Qt::NoButton : button, keys};
        event.time = clock += 0.01;
        input.handle(event);
    }
    /// Moves the pointer to `at` and answers its hover request.
    void rest(Pixel at, std::optional<core::SurfaceHit> hit)
    {
        send(Kind::Move, at);
        input.setHover(hit);
    }

    ui::BrushSettings brush;
    ui::OrbitCamera camera;
    ui::PointerInput input{&brush, &camera};
    QStringList log;
    core::StrokeSettings settings;
    std::vector<core::StrokeSample> samples;
    core::Ray asked;
    std::optional<core::StrokeSettings> askedBrush;
    int questions = 0;
    double clock = 0;
};

const QStringList strokeOf(int samples)
{
    return QStringList{QStringLiteral("began")} + QStringList(samples, QStringLiteral("sample")) +
           QStringList{QStringLiteral("ended")};
}
} // namespace

class TestPointerInput : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPressWhereTheAnswerIsKnownBeginsAtOnce()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Move, {410, 305});
        r.send(Kind::Release, {410, 305});
        QCOMPARE(r.log, strokeOf(2));
        QCOMPARE(r.settings.place, core::Placement::Ray);
        QVERIFY(r.samples[0].time < r.samples[1].time);
        QCOMPARE(r.samples[1].direction, r.camera.ray({410, 305}).direction);
        QCOMPARE(r.samples[1].position, r.camera.ray({410, 305}).origin);
    }

    /// The pointer zigzags across its path. A steady brush follows the path with little of the zigzag.
    void aSteadyStrokeIsDrawnOnAString()
    {
        const auto farthestAside = [](bool steady) {
            Recorder r;
            r.brush.setSteady(steady);
            r.brush.setStabilizerLength(40);
            r.rest({200, 300}, somewhere);
            r.send(Kind::Press, {200, 300});
            for (int x = 1; x <= 100; ++x)
                r.send(Kind::Move, {200 + 4 * x, 300 + (x % 2 ? 6 : -6)});
            r.send(Kind::Release, {600, 300});
            double aside = 0;
            for (std::size_t i = 1; i + 2 < r.samples.size(); ++i)
                aside = std::max(aside, std::abs(r.samples[i].direction.dot(r.camera.up()) /
                                                 r.samples[i].direction.dot(r.camera.viewDirection())));
            return aside;
        };
        QVERIFY(farthestAside(false) > 0);
        QVERIFY(farthestAside(true) < 0.4 * farthestAside(false));
    }

    void aSteadyStrokeEndsWhereTheHandEnds()
    {
        Recorder r;
        r.brush.setSteady(true);
        r.brush.setStabilizerLength(40);
        r.rest({400, 300}, somewhere);
        const auto stroke = [&](const Pixel& to, const std::function<void()>& end) {
            r.log.clear();
            r.samples.clear();
            r.send(Kind::Press, {400, 300});
            r.send(Kind::Move, to);
            // The brush lags behind the pointer
            QVERIFY((r.samples.back().direction - r.camera.ray(to).direction).norm() > 1e-3);
            end();
            QVERIFY((r.samples.back().direction - r.camera.ray(to).direction).norm() < 1e-12);
            QCOMPARE(r.log.back(), QStringLiteral("ended"));
            r.rest({400, 300}, somewhere);
            r.input.setHover(somewhere);
        };
        stroke({500, 330}, [&] { r.send(Kind::Release, {500, 330}); });
        stroke({410, 300}, [&] { r.send(Kind::Release, {410, 300}); }); // shorter than the stabilizer's length
        stroke({500, 330}, [&] { r.input.finish(); });

        r.log.clear();
        r.send(Kind::Press, {400, 300}); // a tap gives one sample
        r.send(Kind::Release, {400, 300});
        QCOMPARE(r.log, strokeOf(1));
    }

    void aPressPicksOnceInsteadOfSculpting()
    {
        for (const std::optional<core::SurfaceHit>& hit :
             {std::optional(somewhere), std::optional<core::SurfaceHit>()}) {
            Recorder r;
            QSignalSpy picked(&r.input, &ui::PointerInput::picked);
            r.input.setMode(ui::PointerMode::Pick);
            r.rest({400, 300}, somewhere);
            QVERIFY(!r.input.hover());       // no cursor, because a press would not sculpt
            r.send(Kind::Press, {450, 300}); // its answer is not known yet
            r.send(Kind::Move, {460, 300});
            r.send(Kind::Release, {460, 300});
            QCOMPARE(picked.count(), 0);
            r.input.setHover(hit);
            QCOMPARE(picked.count(), 1);
            QCOMPARE(picked[0][0].value<std::optional<core::SurfaceHit>>().has_value(), hit.has_value());
            QVERIFY(r.log.isEmpty() && r.input.mode() == ui::PointerMode::Sculpt);
        }
    }

    void aPressChoosesAPartOnceInsteadOfSculpting()
    {
        Recorder r;
        QSignalSpy chosen(&r.input, &ui::PointerInput::partPicked);
        r.input.setMode(ui::PointerMode::ChoosePart);
        r.rest({400, 300}, somewhere);
        QVERIFY(!r.input.hover());
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Release, {400, 300});
        QCOMPARE(chosen.count(), 1);
        QVERIFY(r.log.isEmpty() && r.input.mode() == ui::PointerMode::Sculpt);
    }

    /// Beside the model, an armed press requests one ball. It is in the plane parallel to the picture through the place
    /// of the last stroke, or through the view's centre if there was no stroke.
    void anArmedPressAsksForASphere()
    {
        Recorder r;
        QList<core::Vec3> places;
        QObject::connect(&r.input, &ui::PointerInput::sphereRequested, &r.input,
                         [&](const core::StrokeSettings& settings, const core::StrokeSample& sample) {
                             QVERIFY(settings.add && settings.tool == Tool::Pull &&
                                     settings.place == core::Placement::Point);
                             QCOMPARE(settings.radius, r.brush.stroke().radius);
                             places << sample.position;
                         });
        r.brush.setTool(Tool::Smooth);
        r.brush.setValue(core::Parameter::Strength, 0);
        const auto click = [&](const Pixel& at) {
            r.input.setMode(ui::PointerMode::Add);
            r.rest(at, std::nullopt);
            r.input.setHover(std::nullopt); // the previous answer may be for another pixel
            QVERIFY(r.input.hover());
            const core::Vec3 shown = r.input.hover()->position;
            r.send(Kind::Press, at);
            r.send(Kind::Move, at + Pixel(50, 0));
            r.send(Kind::Release, at + Pixel(50, 0));
            QVERIFY(r.input.mode() == ui::PointerMode::Sculpt && r.log.isEmpty());
            QCOMPARE(places.back(), shown);
            QVERIFY((r.camera.project(places.back()) - at).norm() < 1e-6);
        };
        const auto depth = [&](const core::Vec3& point) {
            return (point - r.camera.eye()).dot(r.camera.viewDirection());
        };
        const core::Vec3 eye = r.camera.eye();
        click({30, 40});
        QVERIFY(std::abs(depth(places.back()) - depth({0, 0, 0})) < 1e-9);
        r.camera.setPivot(somewhere.position);
        click({500, 200});
        QVERIFY(std::abs(depth(places.back()) - depth(somewhere.position)) < 1e-9);
        QCOMPARE(r.camera.eye(), eye); // the press did not turn the view

        r.input.setMode(ui::PointerMode::Add);
        r.send(Kind::Press, {400, 300}, Qt::MiddleButton); // the view may be turned while a press is armed
        r.send(Kind::Release, {400, 300}, Qt::MiddleButton);
        QVERIFY(r.input.mode() == ui::PointerMode::Add);
        QCOMPARE(places.size(), 2);
    }

    /// The request for the ball waits for the answer where the surface is.
    void anArmedPressOnTheModelAsksForASphereThere()
    {
        Recorder r;
        QList<core::Vec3> places;
        QObject::connect(&r.input, &ui::PointerInput::sphereRequested, &r.input,
                         [&](const core::StrokeSettings& settings, const core::StrokeSample& sample) {
                             QVERIFY(settings.add && settings.join);
                             places << sample.position;
                         });
        r.input.setMode(ui::PointerMode::Add);
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Release, {400, 300});
        QVERIFY(places.isEmpty() && r.input.mode() == ui::PointerMode::Add);
        r.input.setHover(somewhere);
        QCOMPARE(places, QList<core::Vec3>{somewhere.position});
        QVERIFY(r.input.mode() == ui::PointerMode::Sculpt && r.log.isEmpty());
    }

    /// A pointer that does not move stays fixed in the world, so it circles in the space of the turning model.
    void aRestingHandGoesRoundATurningModel()
    {
        Recorder r;
        r.rest({450, 280}, somewhere);
        r.send(Kind::Press, {450, 280});
        for (int i = 0; i < 36; ++i)
            r.input.turnModel(std::numbers::pi / 18, 0.02);
        r.send(Kind::Release, {450, 280});
        QCOMPARE(r.log, strokeOf(37));
        const core::StrokeSample& first = r.samples.front();
        for (std::size_t i = 0; i < r.samples.size(); ++i) {
            const core::StrokeSample& s = r.samples[i];
            QVERIFY((s.position - first.position).norm() < 1e-9 && (s.direction - first.direction).norm() < 1e-12);
            const double turn = static_cast<double>(i) * std::numbers::pi / 18;
            const Eigen::Quaterniond turned(Eigen::AngleAxisd(turn, core::Vec3::UnitY()));
            QVERIFY(s.rotation.angularDistance(turned) < 1e-6);
            QVERIFY(i == 0 || s.time > r.samples[i - 1].time);
        }
        QVERIFY((r.camera.ray({450, 280}).direction - first.direction).norm() < 1e-9); // a full turn
    }

    void theCursorStaysUnderThePointerOfATurningModel()
    {
        Recorder r;
        const Pixel at(450, 280);
        const auto surface = [&](const core::Ray& ray) { // a ball of radius 40 about the origin
            const double b = ray.origin.dot(ray.direction), c = ray.origin.squaredNorm() - 1600;
            const core::Vec3 p = ray.origin + (-b - std::sqrt(b * b - c)) * ray.direction;
            return core::SurfaceHit{p, p.normalized(), 0, 0};
        };
        r.rest(at, surface(r.camera.ray(at)));
        for (int i = 0; i < 20; ++i) {
            r.input.turnModel(0.05, 0.02);
            QVERIFY((r.camera.project(r.input.hover()->position) - at).norm() < 1e-6);
            if (i % 3 == 2) // answers arrive late
                r.input.setHover(surface(r.asked));
            QVERIFY((r.camera.project(r.input.hover()->position) - at).norm() < 1e-6);
        }
    }

    void samplesWaitForTheAnswer()
    {
        Recorder r;
        r.send(Kind::Press, {400, 300});
        QCOMPARE(r.asked.direction, r.camera.ray({400, 300}).direction);
        r.send(Kind::Move, {410, 300});
        r.send(Kind::Move, {420, 300});
        QVERIFY(r.log.isEmpty());
        r.input.setHover(somewhere);
        QVERIFY(r.input.strokeOpen());
        r.send(Kind::Release, {420, 300});
        QCOMPARE(r.log, strokeOf(3));
    }

    void aTapThatIsOverBeforeTheAnswerIsAStroke()
    {
        Recorder r;
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Release, {400, 300});
        r.input.setHover(somewhere);
        QCOMPARE(r.log, strokeOf(1));
    }

    void twoQuickTapsAreTwoStrokes()
    {
        Recorder r;
        for (const Pixel& at : {Pixel(400, 300), Pixel(500, 300)}) {
            r.send(Kind::Press, at);
            r.send(Kind::Move, at + Pixel(1, 1));
            r.send(Kind::Release, at + Pixel(1, 1));
        }
        r.input.setHover(somewhere);
        QCOMPARE(r.log, strokeOf(2));
        for (int i = 0; i < 3; ++i) // the request of a move may be answered before that of the second press
            r.input.setHover(somewhere);
        QCOMPARE(r.log, strokeOf(2) + strokeOf(2));
    }

    void aPressBesideTheModelTurnsTheView()
    {
        Recorder r;
        const core::Vec3 eye = r.camera.eye(), target = r.camera.target();
        r.send(Kind::Press, {20, 20});
        r.send(Kind::Move, {60, 40});
        QCOMPARE(r.camera.eye(), eye); // no motion before the answer
        r.input.setHover({});
        QVERIFY((r.camera.eye() - eye).norm() > 1);
        QCOMPARE(r.camera.target(), target);
        r.send(Kind::Release, {60, 40});
        QVERIFY(r.log.isEmpty());
    }

    void middleTurnsAndMovesWithoutAsking()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        const core::Vec3 eye = r.camera.eye(), target = r.camera.target();
        r.send(Kind::Press, {400, 300}, Qt::MiddleButton);
        r.send(Kind::Move, {450, 300});
        r.send(Kind::Release, {450, 300}, Qt::MiddleButton);
        QVERIFY((r.camera.eye() - eye).norm() > 1);
        QCOMPARE(r.camera.target(), target);

        r.send(Kind::Press, {400, 300}, Qt::MiddleButton, Qt::ShiftModifier);
        r.send(Kind::Move, {450, 300});
        r.send(Kind::Release, {450, 300}, Qt::MiddleButton);
        QVERIFY((r.camera.target() - target).norm() > 1);
        QVERIFY(r.log.isEmpty());
    }

    /// Buttons other than the left one move the view even on the model.
    void everyButtonHasItsView_data()
    {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<Qt::KeyboardModifiers>("keys");
        QTest::addColumn<QString>("expected");
        QTest::addColumn<ui::ShortcutPreset>("preset");
        ui::ShortcutPreset preset = ui::ShortcutPreset::Fettle;
        const auto row = [&preset](const char* name, Qt::MouseButton button, Qt::KeyboardModifiers keys,
                                   const char* expected) {
            QTest::newRow(name) << button << keys << QString::fromLatin1(expected) << preset;
        };
        row("middle", Qt::MiddleButton, Qt::NoModifier, "orbit");
        row("shift, middle", Qt::MiddleButton, Qt::ShiftModifier, "pan");
        row("ctrl, middle", Qt::MiddleButton, Qt::ControlModifier, "zoom");
        row("right", Qt::RightButton, Qt::NoModifier, "pan");
        row("alt, left", Qt::LeftButton, Qt::AltModifier, "orbit");
        row("alt, middle", Qt::MiddleButton, Qt::AltModifier, "pan");
        row("alt, right", Qt::RightButton, Qt::AltModifier, "zoom");
        row("back", Qt::BackButton, Qt::NoModifier, "nothing");
        preset = ui::ShortcutPreset::ZBrush;
        row("ZBrush: right", Qt::RightButton, Qt::NoModifier, "orbit");
        row("ZBrush: alt, right", Qt::RightButton, Qt::AltModifier, "pan");
        row("ZBrush: ctrl, right", Qt::RightButton, Qt::ControlModifier, "zoom");
        row("ZBrush: middle", Qt::MiddleButton, Qt::NoModifier, "orbit");
        row("ZBrush: shift, middle", Qt::MiddleButton, Qt::ShiftModifier, "pan");
    }

    void everyButtonHasItsView()
    {
        QFETCH(Qt::MouseButton, button);
        QFETCH(Qt::KeyboardModifiers, keys);
        QFETCH(QString, expected);
        QFETCH(ui::ShortcutPreset, preset);
        for (const bool isKnown : {false, true}) {
            Recorder r;
            r.input.setInputPreferences({.modifiers = ui::mouseModifiers(preset)});
            if (isKnown)
                r.rest({400, 300}, somewhere);
            const ui::OrbitCamera before = r.camera;
            r.send(Kind::Press, {400, 300}, button, keys);
            r.send(Kind::Move, {460, 290}, button, keys);
            r.send(Kind::Release, {460, 290}, button, keys);
            const bool turned = (r.camera.viewDirection() - before.viewDirection()).norm() > 0.01;
            const bool nearer =
                r.camera.pixelsPerMm(somewhere.position) > 1.05 * before.pixelsPerMm(somewhere.position);
            const bool moved = (r.camera.target() - before.target()).norm() > 1 && !turned && !nearer;
            QCOMPARE(turned   ? QStringLiteral("orbit")
                     : nearer ? QStringLiteral("zoom")
                     : moved  ? QStringLiteral("pan")
                              : QStringLiteral("nothing"),
                     expected);
            QVERIFY(r.log.isEmpty());
        }
    }

    void theViewTurnsAboutTheLastStroke()
    {
        Recorder r;
        const core::Vec3 first(10, 20, 30), last(-10, 5, 30);
        r.rest({400, 300}, core::SurfaceHit{first, core::Vec3(0, 0, 1), 100, 0});
        r.send(Kind::Press, {400, 300});
        QCOMPARE(r.camera.pivot(), first);
        r.send(Kind::Move, {300, 300});
        r.input.setHover(core::SurfaceHit{last, core::Vec3(0, 0, 1), 100, 0});
        r.send(Kind::Release, {300, 300});
        const Pixel place = r.camera.project(last);
        r.send(Kind::Press, {300, 300}, Qt::MiddleButton);
        r.send(Kind::Move, {390, 340});
        r.send(Kind::Release, {390, 340}, Qt::MiddleButton);
        QCOMPARE(r.camera.pivot(), last);
        QVERIFY((r.camera.project(last) - place).norm() < 1e-6);
        r.input.setHover(core::SurfaceHit{first, core::Vec3(0, 0, 1), 100, 0}); // a hover, not a stroke
        QCOMPARE(r.camera.pivot(), last);
    }

    void aTapIsTheLastStrokeToo()
    {
        Recorder r;
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Release, {400, 300});
        r.input.setHover(somewhere);
        QCOMPARE(r.camera.pivot(), somewhere.position);
    }

    void panningHoldsTheSurface()
    {
        Recorder r;
        const core::Ray ray = r.camera.ray({150, 420});
        const core::Vec3 grabbed = ray.origin + 0.6 * r.camera.distance() * ray.direction;
        r.rest({150, 420}, core::SurfaceHit{grabbed, -ray.direction, 100, 0});
        r.send(Kind::Press, {150, 420}, Qt::RightButton);
        r.send(Kind::Move, {250, 380});
        QVERIFY((r.camera.project(grabbed) - Pixel(250, 380)).norm() < 1e-6);
    }

    /// An airbrush samples a pointer that does not move, with increasing times.
    void restingPointer_isSampled()
    {
        for (const core::Tool tool : {core::Tool::Pull, core::Tool::Grab}) {
            Recorder r;
            r.brush.setTool(tool);
            r.rest({400, 300}, somewhere);
            r.send(Kind::Press, {400, 300});
            QCOMPARE(r.samples.size(), std::size_t(1));
            if (!r.brush.tools()->isAirbrush(tool)) {
                QTest::qWait(100);
                QCOMPARE(r.samples.size(), std::size_t(1));
                continue;
            }
            QTRY_VERIFY(r.samples.size() > 5);
            r.send(Kind::Move, {401, 300});
            r.send(Kind::Release, {401, 300});
            for (std::size_t i = 1; i < r.samples.size(); ++i)
                QVERIFY(r.samples[i].time >= r.samples[i - 1].time);
            const std::size_t count = r.samples.size();
            QTest::qWait(100);
            QCOMPARE(r.samples.size(), count);
            r.brush.tools()->setAirbrush(tool, false);
            r.rest({401, 300}, somewhere);
            r.send(Kind::Press, {401, 300});
            QCOMPARE(r.settings.airbrush, 0.0);
        }
    }

    /// A click of the right button requests the palette at its pixel. A drag, a click with a modifier key, and a click
    /// that cancels a stroke do not.
    void rightClick_asksForThePalette()
    {
        Recorder r;
        QSignalSpy asked(&r.input, &ui::PointerInput::paletteRequested);
        r.rest({400, 300}, somewhere);
        r.send(Kind::Press, {400, 300}, Qt::RightButton);
        r.send(Kind::Move, {402, 301}, Qt::RightButton);
        r.send(Kind::Release, {402, 301}, Qt::RightButton);
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].value<ui::OrbitCamera::Pixel>(), ui::OrbitCamera::Pixel(402, 301));
        r.send(Kind::Press, {400, 300}, Qt::RightButton);
        r.send(Kind::Move, {430, 300}, Qt::RightButton);
        r.send(Kind::Move, {400, 300}, Qt::RightButton);
        r.send(Kind::Release, {400, 300}, Qt::RightButton);
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Press, {400, 300}, Qt::RightButton);
        r.send(Kind::Release, {400, 300}, Qt::RightButton);
        r.send(Kind::Release, {400, 300});
        QCOMPARE(asked.size(), 1);
    }

    void rightButtonInAStroke_takesItBack()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Move, {410, 300});
        r.send(Kind::Press, {410, 300}, Qt::RightButton);
        const QStringList expected = strokeOf(2).mid(0, 3) + QStringList{QStringLiteral("taken back")};
        QCOMPARE(r.log, expected);
        r.send(Kind::Move, {420, 300});
        r.send(Kind::Release, {420, 300}, Qt::RightButton);
        r.send(Kind::Release, {420, 300});
        QCOMPARE(r.log, expected);
        r.rest({400, 300}, somewhere);
        r.input.setHover(somewhere); // answers an earlier request first
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Release, {400, 300});
        QCOMPARE(r.log, expected + strokeOf(1));
    }

    void altMeansNothingWhereItIsNotWanted()
    {
        Recorder r;
        r.input.setInputPreferences({.altMovesView = false});
        r.rest({400, 300}, somewhere);
        r.input.setModifiers(Qt::AltModifier);
        QVERIFY(r.input.hover());
        r.send(Kind::Press, {400, 300}, Qt::LeftButton, Qt::AltModifier);
        r.send(Kind::Release, {400, 300}, Qt::LeftButton, Qt::AltModifier);
        QCOMPARE(r.log, strokeOf(1));
    }

    void pressureIsWhatThePreferencesSay_data()
    {
        QTest::addColumn<bool>("strength");
        QTest::addColumn<bool>("radius");
        for (const bool strength : {false, true})
            for (const bool radius : {false, true})
                QTest::addRow("strength %d, radius %d", strength, radius) << strength << radius;
    }

    void pressureIsWhatThePreferencesSay()
    {
        QFETCH(bool, strength);
        QFETCH(bool, radius);
        Recorder r;
        r.input.setInputPreferences({.pressureToStrength = strength, .pressureToRadius = radius});
        r.rest({400, 300}, somewhere);
        for (const Kind kind : {Kind::Press, Kind::Release}) {
            ui::PointerEvent event{kind, {400, 300}, Qt::LeftButton, {}};
            event.pressure = 0.5;
            r.input.handle(event);
        }
        QVERIFY(!r.samples.empty());
        QCOMPARE(r.samples[0].pressure, strength ? 0.5 : 1.0);
        QCOMPARE(r.samples[0].radius.has_value(), radius);
        if (radius)
            QCOMPARE(*r.samples[0].radius, 0.5 * r.settings.radius);
    }

    void altHidesTheCursor()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        r.input.setModifiers(Qt::AltModifier);
        QVERIFY(!r.input.hover());
        r.input.setModifiers(Qt::NoModifier);
        QVERIFY(r.input.hover());
    }

    /// A lifted finger leaves the view at once, but its press, which still waits for an answer, is not lost.
    void leavingDoesNotLoseAPress()
    {
        Recorder r;
        r.send(Kind::Move, {100, 100}); // this request is in flight
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Release, {400, 300});
        r.input.pointerLeft();
        r.input.setHover({});
        r.input.setHover(somewhere);
        QCOMPARE(r.log, strokeOf(1));
        QVERIFY(!r.input.isPressPending());
    }

    void rightMoves()
    {
        Recorder r;
        const core::Vec3 target = r.camera.target();
        r.send(Kind::Press, {400, 300}, Qt::RightButton);
        r.send(Kind::Move, {450, 300});
        QVERIFY((r.camera.target() - target).norm() > 1);
    }

    void keysAreReadAtThePress_data()
    {
        QTest::addColumn<int>("tool");
        QTest::addColumn<Qt::KeyboardModifiers>("keys");
        QTest::addColumn<int>("expected");
        const auto row = [](const char* name, Tool tool, Qt::KeyboardModifiers keys, Tool expected) {
            QTest::newRow(name) << static_cast<int>(tool) << keys << static_cast<int>(expected);
        };
        row("pull", Tool::Pull, Qt::NoModifier, Tool::Pull);
        row("ctrl inverts pull", Tool::Pull, Qt::ControlModifier, Tool::Push);
        row("ctrl inverts push", Tool::Push, Qt::ControlModifier, Tool::Pull);
        row("shift smooths", Tool::Push, Qt::ShiftModifier, Tool::Smooth);
        row("ctrl leaves smooth", Tool::Smooth, Qt::ControlModifier, Tool::Smooth);
    }

    void keysAreReadAtThePress()
    {
        QFETCH(int, tool);
        QFETCH(Qt::KeyboardModifiers, keys);
        QFETCH(int, expected);
        Recorder r;
        r.brush.setTool(static_cast<Tool>(tool));
        r.send(Kind::Press, {400, 300}, Qt::LeftButton, keys);
        r.brush.setValue(core::Parameter::Radius, 77); // too late to affect this stroke
        r.send(Kind::Move, {401, 300}, Qt::LeftButton, Qt::NoModifier);
        r.input.setHover(somewhere);
        QCOMPARE(static_cast<int>(r.settings.tool), expected);
        QVERIFY(r.settings.radius != 77);
    }

    void shift_doesNotSmoothWhereSmoothIsNotOffered()
    {
        Recorder r;
        r.brush.offerTools({Tool::Push, Tool::Clay});
        r.send(Kind::Press, {400, 300}, Qt::LeftButton, Qt::ShiftModifier);
        r.input.setHover(somewhere);
        QCOMPARE(r.settings.tool, Tool::Push);
    }

    /// Alt inverts the brush on the model in the ZBrush preset. Beside the model, Alt and left pan the view; left alone
    /// orbits.
    void altInvertsAsInZBrush()
    {
        for (const bool isAlt : {true, false}) {
            Recorder r;
            r.input.setInputPreferences({.modifiers = ui::mouseModifiers(ui::ShortcutPreset::ZBrush)});
            const Qt::KeyboardModifiers keys = isAlt ? Qt::AltModifier : Qt::ControlModifier;
            r.send(Kind::Press, {400, 300}, Qt::LeftButton, keys);
            r.input.setHover(somewhere);
            QCOMPARE(r.settings.tool, isAlt ? Tool::Push : Tool::Pull);
            r.input.setModifiers(keys);
            QCOMPARE(r.input.stroke().tool, isAlt ? Tool::Push : Tool::Pull);
            r.send(Kind::Release, {400, 300}, Qt::LeftButton, keys);

            Recorder beside;
            beside.input.setInputPreferences({.modifiers = ui::mouseModifiers(ui::ShortcutPreset::ZBrush)});
            const ui::OrbitCamera before = beside.camera;
            beside.send(Kind::Press, {30, 30}, Qt::LeftButton, keys);
            beside.input.setHover({});
            beside.send(Kind::Move, {80, 30}, Qt::LeftButton, keys);
            const bool turned = (beside.camera.viewDirection() - before.viewDirection()).norm() > 0.01;
            QCOMPARE(turned, !isAlt);
            QCOMPARE((beside.camera.target() - before.target()).norm() > 1, isAlt);
        }
    }

    /// The footprint is shown only between strokes: a press needs a fast answer, and during a stroke the model must be
    /// visible.
    void theRayBrushShowsWhatItWouldTakeUntilItTakes()
    {
        Recorder r;
        const auto footprint = std::make_shared<const core::Footprint>();
        r.send(Kind::Move, {300, 300});
        QVERIFY(!r.askedBrush); // spherical brushes need no footprint
        r.input.setHover(somewhere);
        r.brush.set(&core::StrokeSettings::brush, core::BrushShape::Ray);
        r.brush.setValue(core::Parameter::Radius, 7);
        r.input.brushChanged();
        QVERIFY(r.askedBrush);
        QCOMPARE(r.askedBrush->radius, 7);
        r.input.setHover(somewhere, footprint);
        QCOMPARE(r.input.footprint(), footprint);

        r.send(Kind::Press, {400, 300});
        QVERIFY(!r.askedBrush);
        r.input.setHover(somewhere);
        QVERIFY(r.input.strokeOpen());
        QVERIFY(!r.input.footprint());
        r.send(Kind::Move, {410, 300});
        QVERIFY(!r.askedBrush);
        r.input.setHover(somewhere);
        r.send(Kind::Release, {410, 300});
        QVERIFY(r.askedBrush);
        QVERIFY(!r.input.footprint()); // the surface has changed
        r.input.setHover(somewhere, footprint);
        QCOMPARE(r.input.footprint(), footprint);

        r.input.setMode(ui::PointerMode::Pick);
        QVERIFY(!r.input.footprint());
        r.input.setMode(ui::PointerMode::Sculpt);
        r.input.setMode(ui::PointerMode::Add);
        QVERIFY(!r.input.footprint());
        r.input.setMode(ui::PointerMode::Sculpt);
        QCOMPARE(r.input.footprint(), footprint);
        r.input.pointerLeft();
        QVERIFY(!r.input.footprint());
    }

    void theEraserDoesTheOpposite()
    {
        const auto strokeOf = [](Tool tool, Qt::KeyboardModifiers keys, bool eraser) {
            Recorder r;
            r.brush.setTool(tool);
            r.rest({400, 300}, somewhere);
            ui::PointerEvent press{Kind::Press, {400, 300}, Qt::LeftButton, keys};
            press.isEraser = eraser;
            r.input.handle(press);
            return r.settings;
        };
        const auto toolOf = [&](Tool tool, Qt::KeyboardModifiers keys, bool eraser) {
            return strokeOf(tool, keys, eraser).tool;
        };
        QCOMPARE(toolOf(Tool::Pull, {}, false), Tool::Pull);
        QCOMPARE(toolOf(Tool::Pull, {}, true), Tool::Push);
        QCOMPARE(toolOf(Tool::Push, {}, true), Tool::Pull);
        QCOMPARE(toolOf(Tool::Pull, Qt::ControlModifier, true), Tool::Pull);
        QCOMPARE(toolOf(Tool::Pull, Qt::ShiftModifier, true), Tool::Smooth);
        QCOMPARE(toolOf(Tool::Flatten, {}, true), Tool::Flatten);
        QVERIFY(!strokeOf(Tool::Crease, {}, false).inverted);
        QVERIFY(strokeOf(Tool::Crease, {}, true).inverted &&
                strokeOf(Tool::Crease, Qt::ControlModifier, false).inverted);
        QVERIFY(!strokeOf(Tool::Crease, Qt::ControlModifier, true).inverted); // inverted twice
        QVERIFY(!strokeOf(Tool::Crease, Qt::ShiftModifier, true).inverted);
    }

    /// Drag tools have spacing 0, because spaced dabs would lag behind the pointer.
    void whatFollowsTheHandIsNotSpaced()
    {
        for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
            Recorder r;
            r.brush.setTool(static_cast<Tool>(i));
            r.rest({400, 300}, somewhere);
            r.send(Kind::Press, {400, 300});
            QCOMPARE(r.settings.spacing, core::isDragTool(r.settings.tool) ? 0.0 : r.brush.stroke().spacing);
            QCOMPARE(r.input.stroke().tool, r.settings.tool);
        }
        Recorder smoothing;
        smoothing.brush.setTool(Tool::Grab);
        smoothing.rest({400, 300}, somewhere);
        smoothing.send(Kind::Press, {400, 300}, Qt::LeftButton, Qt::ShiftModifier);
        QVERIFY(smoothing.settings.spacing > 0);
    }

    void pressureGoesThroughTheCurve()
    {
        const auto sampleOf = [](const ui::InputPreferences& preferences, double pressure) {
            Recorder r;
            r.input.setInputPreferences(preferences);
            r.rest({400, 300}, somewhere);
            ui::PointerEvent press{Kind::Press, {400, 300}, Qt::LeftButton, {}};
            press.pressure = pressure;
            r.input.handle(press);
            return r.samples.front();
        };
        ui::InputPreferences preferences;
        QCOMPARE(sampleOf(preferences, 0.3).pressure, 0.3);
        preferences.penExponent = 2;
        QCOMPARE(sampleOf(preferences, 0.5).pressure, 0.25);
        QCOMPARE(sampleOf(preferences, 1).pressure, 1.0); // pressure of a mouse
        preferences.pressureToRadius = true;
        QCOMPARE(*sampleOf(preferences, 0.5).radius, 0.25 * ui::BrushSettings().stroke().radius);
    }

    /// The line reaches from the brush to the pointer. It exists only during a stroke with a stabilizer.
    void aSteadyStrokeShowsItsString()
    {
        Recorder r;
        r.brush.setSteady(true);
        r.brush.setStabilizerLength(40);
        r.rest({400, 300}, somewhere);
        QVERIFY(!r.input.stabilizer());
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Move, {500, 300});
        QVERIFY(r.input.stabilizer());
        QCOMPARE(r.input.stabilizer()->pointer, Pixel(500, 300));
        QCOMPARE(r.input.stabilizer()->brush, Pixel(460, 300));
        r.send(Kind::Move, {470, 310}); // nearer than the stabilizer's length
        QCOMPARE(r.input.stabilizer()->pointer, Pixel(470, 310));
        QCOMPARE(r.input.stabilizer()->brush, Pixel(460, 300));
        r.send(Kind::Release, {470, 310});
        QVERIFY(!r.input.stabilizer());

        Recorder free;
        free.rest({400, 300}, somewhere);
        free.send(Kind::Press, {400, 300});
        free.send(Kind::Move, {500, 300});
        QVERIFY(free.input.stabilizer());
        QCOMPARE(free.input.stabilizer()->pointer, free.input.stabilizer()->brush);
    }

    /// The cursor of an anchored stroke stays at its beginning. Stabilizer and airbrush have no effect.
    void anAnchoredStrokeIsDraggedOutOfItsPlace()
    {
        Recorder r;
        r.brush.setTool(core::Tool::Inflate);
        r.brush.set(&core::StrokeSettings::anchored, true);
        r.brush.setSteady(true);
        r.rest({400, 300}, somewhere);
        r.send(Kind::Press, {400, 300});
        QVERIFY(r.settings.anchored && r.settings.airbrush == 0);
        r.send(Kind::Move, {401, 300});
        QCOMPARE(r.samples.size(), std::size_t(2)); // the stabilizer is off
        r.send(Kind::Move, {400, 380});
        QCOMPARE(r.input.stabilizer()->brush, Pixel(400, 300));
        QCOMPARE(r.input.stabilizer()->pointer, Pixel(400, 380));
        QCOMPARE(r.input.hover()->position, somewhere.position);
        r.send(Kind::Release, {400, 380});
    }

    void onlyOneQuestionIsInFlight()
    {
        Recorder r;
        for (int x = 100; x < 200; ++x)
            r.send(Kind::Move, Pixel(x, 300));
        QCOMPARE(r.questions, 1);
        r.input.setHover({});
        QCOMPARE(r.questions, 2);
        QCOMPARE(r.asked.direction, r.camera.ray({199, 300}).direction);
        r.input.setHover({});
        QCOMPARE(r.questions, 2);
    }

    void aPressIsAskedAboutNextWhateverElseWaits()
    {
        Recorder r;
        r.send(Kind::Move, {100, 100}); // this request is in flight
        r.send(Kind::Move, {110, 100}); // this request waits
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Move, {410, 300});
        r.input.setHover({});
        QCOMPARE(r.asked.direction, r.camera.ray({400, 300}).direction);
        QVERIFY(r.log.isEmpty());
        r.input.setHover(somewhere);
        QCOMPARE(r.log.first(3), QStringList({"began", "sample", "sample"}));
    }

    void anAnswerOfAnEarlierViewDecidesNothing()
    {
        Recorder r;
        r.send(Kind::Move, {400, 300});
        r.input.zoom(0.5, {10, 10});
        r.input.setHover(somewhere);
        QVERIFY(!r.input.hover());
        r.send(Kind::Press, {400, 300});
        QVERIFY(r.log.isEmpty());
    }

    void theCursorGoesWithThePointer()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        QVERIFY(r.input.hover());
        r.input.pointerLeft();
        QVERIFY(!r.input.hover());
    }

    void finishEndsTheStroke()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        r.send(Kind::Press, {400, 300});
        r.input.finish();
        QCOMPARE(r.log, strokeOf(1));
        r.send(Kind::Release, {400, 300});
        QCOMPARE(r.log, strokeOf(1));
    }

    void finishEndsAStrokeThatIsStillUndecided()
    {
        Recorder r;
        r.send(Kind::Press, {400, 300});
        r.input.finish();
        r.input.setHover(somewhere);
        QCOMPARE(r.log, strokeOf(1));
    }

    void aKeyAloneChangesTheTool()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        QSignalSpy changed(&r.input, &ui::PointerInput::hoverChanged);
        r.input.setModifiers(Qt::ControlModifier);
        QCOMPARE(r.input.stroke().tool, Tool::Push);
        QCOMPARE(changed.size(), 1);
        r.input.setModifiers(Qt::NoModifier);
        QCOMPARE(r.input.stroke().tool, Tool::Pull);
        QVERIFY(r.log.isEmpty());
    }

    void aSecondButtonMeansNothing()
    {
        Recorder r;
        r.rest({400, 300}, somewhere);
        r.send(Kind::Press, {400, 300});
        r.send(Kind::Press, {400, 300}, Qt::MiddleButton);
        r.send(Kind::Release, {400, 300}, Qt::MiddleButton);
        QVERIFY(r.input.strokeOpen());
        r.send(Kind::Release, {400, 300});
        QCOMPARE(r.log, strokeOf(1));
    }
};

FETTLE_TEST(TestPointerInput, QCoreApplication)
#include "tst_pointer_input.moc"
