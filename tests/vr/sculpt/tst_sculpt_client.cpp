// Tests how the client in the headset treats the document when frames stop. Runs without a runtime and without images.
#include "vr/sculpt/sculpt_client.h"
#include "vr/sculpt/wand_brush.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using vr::Side;

namespace
{
/// A document that accepts every stroke and records its calls.
class RecordingPort : public vr::DocumentPort
{
public:
    std::optional<core::MeshPatch> takePatch() override { return {}; }
    std::optional<vr::DocumentUpdate> takeUpdate() override { return {}; }
    bool beginStroke(const core::StrokeSettings&) override
    {
        ++begun;
        return true;
    }
    void addSample(const core::StrokeSample& sample) override
    {
        ++samples;
        last = sample;
    }
    void endStroke() override { ++ended; }
    vr::StrokeEffect takeEffect() override { return {}; }
    void querySurface(const vr::SurfaceQuery&) override {}
    std::optional<vr::SurfaceQueryResult> takeQueryResult() override { return {}; }
    void queryPart() override {}
    std::optional<vr::MovablePart> takePart() override { return {}; }
    void request(const vr::DocumentRequest&) override {}
    bool isSettled() override { return true; }
    void show(const vr::AvatarState& presence) override { seen = presence; }

    int begun = 0, samples = 0, ended = 0;
    core::StrokeSample last;
    vr::AvatarState seen;
};

/// A person with two wands, played frame by frame.
struct Person
{
    explicit Person(const vr::HeadsetSettings& settings = {}) : client(port, settings) {}

    void frame(double trigger)
    {
        vr::FrameInput input{{}, vr::Pose{Eigen::Quaterniond::Identity(), {0, 1.6, 0}}, time, true, false, timings};
        for (vr::WandState& wand : input.wands)
            wand.isTracked = wand.isActive = true;
        input.wands[static_cast<std::size_t>(Side::Right)].trigger = trigger;
        output = client.frame(input);
        time += 11'000'000;
    }

    std::shared_ptr<RecordingPort> port = std::make_shared<RecordingPort>();
    vr::SculptClient client;
    vr::FrameTimings timings;
    vr::FrameOutput output; ///< of the last frame
    std::int64_t time = 1'000'000'000;
};
} // namespace

class TestSculptClient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void idle_endsTheStroke();
    void times_areTheVisits();
    void aToolChosenHere_getsTheWindowsValues();
    void passthrough_isTheUsersChoice();
};

/// Checks that the open stroke ends when frames stop. The trigger stays pulled in all frames, and must be released
/// before it works again.
void TestSculptClient::idle_endsTheStroke()
{
    Person person;
    person.frame(0);
    person.frame(1);
    person.frame(1);
    QCOMPARE(person.port->begun, 1);
    QCOMPARE(person.port->samples, 2);
    QVERIFY(person.port->seen.head && person.port->seen.hands[0]);
    person.client.idle();
    QCOMPARE(person.port->ended, 1);
    QVERIFY(!person.port->seen.head && !person.port->seen.hands[0] && !person.port->seen.brush);

    person.frame(1);
    QCOMPARE(person.port->begun, 1);
    QVERIFY(person.port->seen.head);
    person.frame(0);
    person.frame(1);
    QCOMPARE(person.port->begun, 2);
}

/// Checks that stroke times count from the start of the visit: a runtime's clock may count from 1970, which does not
/// fit stroke files.
void TestSculptClient::times_areTheVisits()
{
    Person person;
    person.time = 1'700'000'000'000'000'000;
    person.frame(0);
    person.frame(1);
    QCOMPARE(person.port->last.time, 0.0);
    for (int i = 0; i < 100; ++i)
        person.frame(1);
    QVERIFY(std::abs(person.port->last.time - 1.1) < 1e-5);
    person.frame(0);
    person.frame(1);
    // seconds since the start of the visit, not of the stroke
    QVERIFY(std::abs(person.port->last.time - 1.122) < 1e-5);
}

void TestSculptClient::aToolChosenHere_getsTheWindowsValues()
{
    RecordingPort port;
    vr::WandBrush brush(&port, vr::ButtonPreset::Paper);
    vr::DocumentUpdate update;
    update.brushChange = 1;
    brush.take(update, vr::ModelPlacement());
    vr::BrushState chosen = brush.state();
    chosen.stroke.tool = core::Tool::Clay;
    brush.change(chosen);
    update.brush.strength = 3; // a value of the previous tool, sent before the change arrived
    brush.take(update, vr::ModelPlacement());
    QCOMPARE(brush.state().stroke.strength, 1.0);
    update.brush.tool = core::Tool::Clay;
    update.brush.strength = 0.5;
    update.brush.falloff = 9;
    update.smoothStrength = 0.25;
    const double radius = brush.state().radius;
    brush.take(update, vr::ModelPlacement()); // an answer, not a change made in the window
    QVERIFY(brush.state().stroke.tool == core::Tool::Clay && brush.state().stroke.strength == 0.5);
    QVERIFY(brush.state().stroke.falloff == 9 && brush.state().smoothStrength == 0.25);
    QCOMPARE(brush.state().radius, radius);
}

void TestSculptClient::passthrough_isTheUsersChoice()
{
    for (const bool isWanted : {false, true}) {
        vr::HeadsetSettings settings;
        settings.hasPassthrough = isWanted;
        Person person(settings);
        person.frame(0);
        QCOMPARE(person.output.passthrough, isWanted);
    }
}

FETTLE_TEST(TestSculptClient, QCoreApplication)
#include "tst_sculpt_client.moc"
