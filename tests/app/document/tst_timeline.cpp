#include "tests/support/ask_worker.h"
#include "tests/support/effort.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "app/recovery/recovery_store.h"
#include "app/worker/sculpt_worker.h"

#include "core/analysis/mesh_check.h"
#include "core/journal/journal_recovery.h"
#include "core/mesh/mesh_builder.h"
#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"
#include "core/sculpt/sculptor.h"
#include "core/stroke/stroke_edit.h"
#include "ui/brush/stroke_edit_bar.h"
#include "ui/history/history_panel.h"
#include "ui/util/thread_mailbox.h"
#include "ui/widgets/side_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>

#include <random>

using namespace app;

namespace
{
/// The program with a ball of clay, and strokes made without a mouse. The view is not painted, which saves half of the
/// time.
struct TimelineFixture
{
    TimelineFixture()
    {
        program.window.resize(1200, 800);
        program.window.viewport()->setUpdatesEnabled(false);
        program.window.show();
        program.document.opener().setDiscardPrompt({}); // no questions about unsaved changes
        program.document.opener().openBall();
        rest();
    }

    void rest()
    {
        QTRY_VERIFY(!program.document.job().isBusy() && program.document.queue().isSettled() &&
                    program.document.modelInfo().faces > 0);
    }

    /// Returns the hash of the mesh including slot numbers and free lists, or 0 if the mesh is not valid.
    std::uint64_t state()
    {
        rest();
        return ask(program.worker, [](core::Sculptor& sculptor) -> std::uint64_t {
            const bool isSound = core::checkMesh(core::extractMesh(sculptor.mesh())).printReady();
            return isSound ? sculptor.mesh().stateHash() : 0;
        });
    }

    void stroke(const core::Stroke& stroke)
    {
        program.document.strokes().beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples) // few enough that no sample is dropped
            program.document.strokes().addSample(sample);
        program.document.strokes().endStroke();
        rest();
    }

    int index() { return program.document.history().stack().index(); }
    int count() { return program.document.history().stack().count(); }
    template <class Widget> Widget* find(const char* name)
    {
        return program.window.findChild<Widget*>(QLatin1StringView(name));
    }
    ui::StrokeEditBar* bar() { return program.window.findChild<ui::StrokeEditBar*>(); }
    void showHistory()
    {
        find<ui::SidePanel>("historyPanel")->bringForward();
        QTRY_VERIFY(program.window.history()->isVisible());
    }
    QAction* edit() { return program.window.action(QStringLiteral("edit.lastStroke")); }
    void beginEdit()
    {
        edit()->trigger();
        QTRY_VERIFY(bar() && bar()->isVisible());
    }
    /// Sets a value as if it were typed.
    void set(const char* box, double value)
    {
        bar()->findChild<QDoubleSpinBox*>(QLatin1StringView(box))->setValue(value);
    }
    void choose(core::Tool tool)
    {
        auto* tools = bar()->findChild<QComboBox*>();
        tools->setCurrentIndex(tools->findData(static_cast<int>(tool)));
        Q_EMIT tools->activated(tools->currentIndex());
    }
    void press(const char* button)
    {
        QTest::mouseClick(bar()->findChild<QPushButton*>(QLatin1StringView(button)), Qt::LeftButton);
        rest();
        QTRY_VERIFY(!bar());
    }

    Program program;
};

core::StrokeSample sampleAt(const core::Vec3& position)
{
    core::StrokeSample sample;
    sample.position = position;
    sample.direction = -position.normalized();
    return sample;
}

/// Returns a stroke of a few dabs across the front of the ball.
core::Stroke across(core::Tool tool = core::Tool::Pull)
{
    core::Stroke stroke;
    stroke.settings.tool = tool;
    stroke.settings.radius = 9;
    stroke.settings.spacing = 0.25;
    for (int i = 0; i < 6; ++i)
        stroke.samples.push_back(sampleAt(50 * core::Vec3(-0.4 + 0.16 * i, 0.3, 1).normalized()));
    return stroke;
}

core::Stroke randomStroke(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> between(-1, 1);
    core::Stroke stroke = across(static_cast<core::Tool>(random() % 3));
    stroke.samples = {sampleAt(50 * core::Vec3(between(random), between(random), between(random)).normalized())};
    return stroke;
}
} // namespace

class TestTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scrub_eachStateIsWhatItWasWhenItWasMade();
    void scrub_keysGoByOneAndPlayToTheEnd();
    void edit_isAsIfTheStrokeHadBeenDoneSo_data();
    void edit_isAsIfTheStrokeHadBeenDoneSo();
    void edit_cancelGivesTheStrokeBackAsItWas();
    void edit_manyChangesEndAtTheNewest();
    void edit_theNextStrokeEndsIt();
    void edit_undoEndsIt();
    void edit_whatDoesNothingSaysSo();
    void edit_onlyOfAStrokeThatIsTheLastStep();
    void edit_offersTheToolsThatTheBrushOffers();
    void edit_theRecordIsOfWhatIsThere();
    void edit_survivesTheProgram();
};

void TestTimeline::scrub_eachStateIsWhatItWasWhenItWasMade()
{
    TimelineFixture fixture;
    std::mt19937_64 random(8);
    std::vector<std::uint64_t> states{fixture.state()};
    const int steps = byEffort(12, 30);
    while (static_cast<int>(states.size()) <= steps) {
        fixture.stroke(randomStroke(random));
        states.push_back(fixture.state());
        QCOMPARE(fixture.index(), static_cast<int>(states.size()) - 1);
    }
    auto* slider = fixture.find<QSlider>("timeline");
    fixture.showHistory();
    QTRY_COMPARE(slider->maximum(), steps);
    QCOMPARE(slider->minimum(), 0);
    for (int i = 0; i < byEffort(8, 25); ++i) {
        int wanted = 0;
        for (int burst = 0; burst < 4; ++burst) { // a drag through several states without waiting
            wanted = static_cast<int>(random() % states.size());
            slider->setValue(wanted);
            if (burst % 2 == 1)
                QCoreApplication::processEvents();
        }
        QTRY_COMPARE(fixture.index(), wanted);
        QCOMPARE(fixture.state(), states[static_cast<std::size_t>(wanted)]);
        QCOMPARE(slider->value(), wanted);
    }
    QCOMPARE(fixture.count(), steps);
}

void TestTimeline::scrub_keysGoByOneAndPlayToTheEnd()
{
    TimelineFixture fixture;
    std::mt19937_64 random(9);
    for (int i = 0; i < 3; ++i)
        fixture.stroke(randomStroke(random));
    const std::uint64_t last = fixture.state();
    auto* slider = fixture.find<QSlider>("timeline");
    fixture.showHistory();
    QTRY_COMPARE(slider->maximum(), 3);
    QTest::keyClick(slider, Qt::Key_Left);
    QTest::keyClick(slider, Qt::Key_Left);
    QTRY_COMPARE(fixture.index(), 1);
    QTest::keyClick(slider, Qt::Key_Right);
    QTRY_COMPARE(fixture.index(), 2);
    const QString text = fixture.find<QLabel>("timelineText")->text();
    QVERIFY2(text.contains(QStringLiteral("2")) && text.contains(QStringLiteral("3")) &&
                 text.contains(fixture.program.document.history().stack().text(1)),
             qPrintable(text));
    auto* play = fixture.find<QToolButton>("timelinePlay");
    QTest::mouseClick(play, Qt::LeftButton);
    QTRY_VERIFY(fixture.index() == 3 && !play->isChecked());
    QSignalSpy moved(&fixture.program.document.history().stack(), &QUndoStack::indexChanged);
    QTest::mouseClick(play, Qt::LeftButton); // starts from the first state
    QTRY_VERIFY(fixture.index() == 3 && !play->isChecked() && moved.size() >= 4);
    QCOMPARE(fixture.state(), last);
}

void TestTimeline::edit_isAsIfTheStrokeHadBeenDoneSo_data()
{
    QTest::addColumn<core::Stroke>("stroke");
    QTest::addColumn<core::BrushChange>("brush");
    const core::BrushChange twice{core::Tool::Pull, 18, 1};
    QTest::newRow("twice as large") << across() << twice;
    QTest::newRow("stronger") << across() << core::BrushChange{core::Tool::Pull, 9, 2};
    QTest::newRow("another tool") << across() << core::BrushChange{core::Tool::Crease, 9, 1};
    core::Stroke other = across();
    other.settings.symmetry = core::Symmetry::X;
    QTest::newRow("mirrored") << other << twice;
    other.settings.radial = 4;
    QTest::newRow("radial") << other << twice;
    other = across();
    for (std::size_t i = 0; i < other.samples.size(); ++i)
        other.samples[i].rotation =
            Eigen::Quaterniond(Eigen::AngleAxisd(0.3 * static_cast<double>(i), core::Vec3::UnitY()));
    QTest::newRow("turntable") << other << twice;
    other = across();
    other.settings.alpha = core::builtInAlpha(core::builtInAlphas().front());
    QTest::newRow("alpha") << other << twice;
    other = across();
    for (std::size_t i = 0; i < other.samples.size(); ++i) {
        other.samples[i].pressure = 0.2 + 0.1 * static_cast<double>(i);
        other.samples[i].radius = 6 + static_cast<double>(i);
        other.samples[i].strength = 0.5 + 0.1 * static_cast<double>(i);
    }
    QTest::newRow("a pen's own") << other << core::BrushChange{core::Tool::Clay, 18, 0.5};
    other = across(core::Tool::Stamp);
    other.samples.resize(2);
    QTest::newRow("stamp") << other << core::BrushChange{core::Tool::Stamp, 12, 1};
    other = across(core::Tool::Grab);
    QTest::newRow("grab") << other << core::BrushChange{core::Tool::Grab, 14, 1};
}

void TestTimeline::edit_isAsIfTheStrokeHadBeenDoneSo()
{
    QFETCH(core::Stroke, stroke);
    QFETCH(core::BrushChange, brush);
    TimelineFixture fixture;
    fixture.stroke(across(core::Tool::Flatten));
    const std::uint64_t before = fixture.state();
    fixture.stroke(stroke);
    QCOMPARE(fixture.count(), 2);
    const quint64 strokes = fixture.program.document.modelInfo().metadata.work->strokes;
    fixture.beginEdit();
    if (brush.tool != stroke.settings.tool)
        fixture.choose(brush.tool);
    fixture.set("radius.box", brush.radius);
    fixture.set("strength.box", brush.strength);
    fixture.press("keepStroke");
    const std::uint64_t edited = fixture.state();
    QCOMPARE(fixture.count(), 2);
    QCOMPARE(fixture.index(), 2);
    // the edited stroke still counts as one
    QCOMPARE(fixture.program.document.modelInfo().metadata.work->strokes, strokes);
    fixture.program.document.history().undo();
    QCOMPARE(fixture.state(), before);
    fixture.program.document.history().redo();
    QCOMPARE(fixture.state(), edited);

    TimelineFixture other;
    other.stroke(across(core::Tool::Flatten));
    core::Stroke done = stroke;
    done.settings.tool = brush.tool;
    done.settings.radius = brush.radius;
    done.settings.strength = brush.strength;
    for (core::StrokeSample& sample : done.samples) {
        if (sample.radius)
            *sample.radius *= brush.radius / stroke.settings.radius;
        if (sample.strength)
            *sample.strength *= brush.strength / stroke.settings.strength;
    }
    other.stroke(done);
    QCOMPARE(edited, other.state());
}

void TestTimeline::edit_cancelGivesTheStrokeBackAsItWas()
{
    const QTemporaryDir folder;
    TimelineFixture fixture;
    fixture.stroke(across());
    fixture.program.document.saver().save(folder.filePath(QStringLiteral("a.glb")));
    fixture.rest();
    const std::uint64_t was = fixture.state();
    QVERIFY(!fixture.program.document.savedState().isModified());
    for (const char* how : {"nothing", "once", "twice", "at once"}) {
        const QString word = QLatin1StringView(how);
        fixture.beginEdit();
        if (word != QLatin1String("nothing"))
            fixture.set("radius.box", 20);
        if (word != QLatin1String("at once"))
            fixture.rest();
        if (word == QLatin1String("twice")) {
            QVERIFY(fixture.state() != was && fixture.program.document.savedState().isModified());
            fixture.choose(core::Tool::Push);
            fixture.rest();
        }
        if (word == QLatin1String("once"))
            QTest::keyClick(fixture.bar(), Qt::Key_Escape);
        else
            fixture.press("cancelStroke");
        QTRY_VERIFY(!fixture.bar());
        QCOMPARE(fixture.state(), was);
        QCOMPARE(fixture.count(), 1);
        QVERIFY(!fixture.program.document.savedState().isModified());
        QCOMPARE(fixture.program.document.history().undoText(), fixture.program.document.history().stack().text(0));
    }
}

void TestTimeline::edit_manyChangesEndAtTheNewest()
{
    TimelineFixture fixture;
    fixture.stroke(across());
    fixture.beginEdit();
    QSignalSpy finished(&fixture.program.worker, &SculptWorker::strokeFinished);
    for (int i = 0; i < 60; ++i)
        fixture.set("radius.box", 10 + 0.1 * i);
    fixture.set("radius.box", 14);
    fixture.press("keepStroke");
    QVERIFY(finished.size() < 20);
    const std::uint64_t edited = fixture.state();
    TimelineFixture other;
    core::Stroke done = across();
    done.settings.radius = 14;
    other.stroke(done);
    QCOMPARE(edited, other.state());
}

/// Pending edits are applied before the next stroke.
void TestTimeline::edit_theNextStrokeEndsIt()
{
    TimelineFixture fixture;
    fixture.stroke(across());
    fixture.beginEdit();
    fixture.set("radius.box", 11);
    fixture.set("radius.box", 14); // the value is not applied yet
    Q_EMIT fixture.program.window.viewport()->input()->strokeBegan(across(core::Tool::Push).settings);
    for (const core::StrokeSample& sample : across().samples)
        Q_EMIT fixture.program.window.viewport()->input()->strokeSampled(sample);
    Q_EMIT fixture.program.window.viewport()->input()->strokeEnded(core::StrokeEnd::Kept);
    fixture.rest();
    QTRY_VERIFY(!fixture.bar());
    QCOMPARE(fixture.count(), 2);
    fixture.program.document.history().undo();
    TimelineFixture other;
    core::Stroke done = across();
    done.settings.radius = 14;
    other.stroke(done);
    QCOMPARE(fixture.state(), other.state());
}

void TestTimeline::edit_undoEndsIt()
{
    TimelineFixture fixture;
    const std::uint64_t start = fixture.state();
    fixture.stroke(across());
    fixture.beginEdit();
    fixture.set("radius.box", 14);
    fixture.rest();
    fixture.program.document.history().undo();
    QTRY_VERIFY(!fixture.bar());
    QCOMPARE(fixture.state(), start);
    QVERIFY(!fixture.edit()->isEnabled());
    fixture.program.document.history().redo();
    fixture.rest();
    QVERIFY(fixture.edit()->isEnabled());
}

void TestTimeline::edit_whatDoesNothingSaysSo()
{
    TimelineFixture fixture;
    const std::uint64_t start = fixture.state();
    fixture.stroke(across());
    const std::uint64_t was = fixture.state();
    fixture.beginEdit();
    fixture.set("strength.box", 0);
    fixture.rest();
    auto* hint = fixture.find<QLabel>("strokeHint");
    QTRY_VERIFY(!hint->text().isEmpty());
    QCOMPARE(fixture.state(), start);
    fixture.set("strength.box", 2);
    fixture.rest();
    QVERIFY(hint->text().isEmpty() && fixture.state() != start);
    fixture.set("strength.box", 0);
    fixture.press("cancelStroke");
    QCOMPARE(fixture.state(), was);
    QCOMPARE(fixture.count(), 1);
}

void TestTimeline::edit_onlyOfAStrokeThatIsTheLastStep()
{
    TimelineFixture fixture;
    QVERIFY(!fixture.edit()->isEnabled());
    fixture.stroke(across());
    QVERIFY(fixture.edit()->isEnabled());
    fixture.program.document.changer().apply(core::Fill{{1, 2, 3}});
    fixture.rest();
    QVERIFY(!fixture.edit()->isEnabled());
    fixture.program.document.history().undo();
    fixture.rest();
    QVERIFY(!fixture.edit()->isEnabled());
    fixture.program.document.opener().openStarter(core::Starter::Cube);
    fixture.rest();
    fixture.program.document.changer().apply(core::Fill{{1, 2, 3}});
    fixture.rest();
    QVERIFY(!fixture.edit()->isEnabled()); // another model with the same number of steps
}

void TestTimeline::edit_offersTheToolsThatTheBrushOffers()
{
    TimelineFixture fixture;
    fixture.stroke(across(core::Tool::Clay));
    fixture.program.window.brush()->offerTools({core::Tool::Pull, core::Tool::Smooth});
    fixture.beginEdit();
    auto* tools = fixture.bar()->findChild<QComboBox*>();
    QCOMPARE(tools->count(), 3); // two offered tools, and the tool of the stroke
    QCOMPARE(tools->currentData().toInt(), static_cast<int>(core::Tool::Clay));
    fixture.choose(core::Tool::Smooth);
    fixture.press("keepStroke");
    QVERIFY(fixture.program.document.history().stack().text(0) == fixture.program.document.history().undoText());
    QCOMPARE(fixture.program.document.lastStroke().step()->report.tool, core::Tool::Smooth);
    QCOMPARE(fixture.program.window.brush()->tool(), core::Tool::Pull); // the current tool of the brush is unchanged
}

/// The record that a class would keep of the turn must replay to the edited model.
void TestTimeline::edit_theRecordIsOfWhatIsThere()
{
    TimelineFixture fixture;
    fixture.stroke(across(core::Tool::Flatten));
    fixture.stroke(across());
    fixture.beginEdit();
    fixture.set("radius.box", 14);
    fixture.rest();
    fixture.set("radius.box", 16);
    fixture.press("keepStroke");
    std::optional<std::vector<core::FileEntry>> entries;
    bool isDone = false;
    const auto keep = [&entries](const ModelSaver::Present& present) {
        entries = present.steps;
        return true;
    };
    QVERIFY(fixture.program.document.saver().saveExternally({}, keep, [&isDone](bool) { isDone = true; }));
    QTRY_VERIFY(isDone);
    QVERIFY(entries && entries->size() == 2);
    TimelineFixture other;
    for (const core::FileEntry& entry : *entries)
        other.stroke(std::get<core::Stroke>(entry));
    QCOMPARE(other.state(), fixture.state());
}

void TestTimeline::edit_survivesTheProgram()
{
    const QTemporaryDir folder;
    RecoveryStore store(std::filesystem::path(folder.path().toStdString()) / "journals");
    TimelineFixture fixture;
    fixture.program.document.journaling().setRecoveryStore(&store);
    fixture.program.document.opener().openBall();
    fixture.rest();
    fixture.stroke(across(core::Tool::Flatten));
    const std::uint64_t before = fixture.state();
    fixture.stroke(across());
    const std::uint64_t was = fixture.state();
    const auto recovered = [&] {
        fixture.program.document.journaling().journal()->drain();
        return core::recoverJournal(fixture.program.document.journaling().journal()->folder());
    };
    const auto isRight = [&](std::uint64_t now) {
        auto found = recovered();
        if (!found || found->isDamaged || found->history.present != 2 || found->history.steps.size() != 2 ||
            found->mesh->stateHash() != now)
            return false;
        found->mesh->swap(*found->deltas[1]);
        return found->mesh->stateHash() == before;
    };
    QVERIFY(isRight(was));
    fixture.beginEdit();
    fixture.set("radius.box", 14);
    fixture.rest();
    const std::uint64_t edited = fixture.state();
    QVERIFY(edited != was && isRight(edited));
    fixture.choose(core::Tool::Push);
    fixture.rest();
    QVERIFY(isRight(fixture.state()));
    fixture.press("cancelStroke");
    QCOMPARE(fixture.state(), was);
    QVERIFY(isRight(was));
}

FETTLE_TEST(TestTimeline, app::OnScreen)
#include "tst_timeline.moc"
