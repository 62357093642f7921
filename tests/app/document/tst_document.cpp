#include "app/analysis/model_analysis.h"
#include "app/document/document.h"
#include "app/document/history_list.h"
#include "app/worker/sculpt_worker.h"
#include "app/worker/stroke_step.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_hash.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/ask_worker.h"
#include "tests/support/test_main.h"
#include "ui/util/error_messages.h"
#include "ui/util/thread_mailbox.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace app;

namespace
{
/// A document with a ball of clay, with access to the mesh on its thread.
struct Session
{
    Session()
    {
        document.opener().openBall();
        wait();
    }

    /// Waits until no job or step is in progress.
    void wait()
    {
        QTRY_VERIFY(!document.job().isBusy() && document.queue().isSettled());
        settle();
    }

    void settle() { app::settle(worker); }

    std::uint64_t state()
    {
        settle();
        return stateHash(worker);
    }

    /// Returns the hash of the faces, independent of slots. Includes an open stroke.
    std::uint64_t surface()
    {
        settle();
        return ask(worker, [](core::Sculptor& sculptor) { return wholeHash(sculptor.mesh()); });
    }

    /// Checks that the whole mesh is a valid solid.
    void verifyWhole()
    {
        QVERIFY(ask(worker, [](core::Sculptor& sculptor) {
            return core::checkMesh(core::extractMesh(sculptor.mesh())).printReady();
        }));
    }

    void stroke(const core::Vec3& where, core::Tool tool = core::Tool::Pull, int samples = 1)
    {
        core::StrokeSettings settings;
        settings.tool = tool;
        settings.radius = 12;
        document.strokes().beginStroke(settings);
        core::StrokeSample sample;
        sample.position = where;
        for (int i = 0; i < samples; ++i)
            document.strokes().addSample(sample);
        document.strokes().endStroke();
    }

    void randomStroke(std::mt19937_64& random)
    {
        std::uniform_real_distribution<double> between(-1, 1);
        core::Vec3 p(between(random), between(random), between(random));
        stroke(50 * p.normalized(), static_cast<core::Tool>(random() % 3));
    }

    SculptWorker worker;
    Document document{&worker};
};
} // namespace

class TestDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void ball_isTheStarter();
    void undo_rightAfterAStrokeUndoesThatStroke();
    void undo_duringAStrokeWaitsForItsEnd();
    void history_hasANameForEveryTool();
    void history_namesStepsAndMarksThem();
    void analysis_isOfThePresentModelOnly();
    void stroke_rightAfterUndoComesAfterIt();
    void undoAll_andRedoAllComeBackByState();
    void jumps_goThere();
    void work_isCountedAndSaved();
    void stroke_thatDoesNothingIsNoStep();
    void strokeTakenBack_leavesTheModelAsItWas();
    void anchoredStroke_showsWhatItLeaves();
    void strokeThatFellShort_isSaidOnce_data();
    void strokeThatFellShort_isSaidOnce();
    void sphere_isAStepOrAWordWhyNot();
    void mirroredStroke_saysWhereTheModelIsNotSymmetric();
    void radialStroke_saysWhereTheSectorsAreNotAlike();
    void strokeThatDidAll_isNotTalkedAbout();
    void newStroke_forgetsWhatWasUndone();
    void modified_followsTheHistory();
    void spilledDeltas_comeBack();
    void expiry_whenNothingCanBeSpilled();
    void lostFile_losesOnlyTheHistory();
    void open_takesAModelAndCentresIt();
    void openStarter_beginsAnew();
    void open_refusalLeavesTheDocument_data();
    void open_refusalLeavesTheDocument();
    void open_asksBeforeChangesAreLost();
    void export_writesWhatIsThere();
    void saving_givesTheModelItsFile();
    void savingThatFails_losesNothing_data();
    void savingThatFails_losesNothing();
    void coloursThatAFormatDoesNotHold_areNamed();
    void export_intoNowhereIsRefused();
};

void TestDocument::ball_isTheStarter()
{
    Session session;
    QCOMPARE(session.document.modelInfo().vertices, quint64(10242));
    QCOMPARE(session.document.modelInfo().faces, quint64(20480));
    QVERIFY((session.document.modelInfo().size - core::Vec3(100, 100, 100)).norm() < 1e-3);
    QVERIFY(!session.document.savedState().isModified() && !session.document.history().canUndo() &&
            !session.document.history().canRedo());
}

void TestDocument::undo_rightAfterAStrokeUndoesThatStroke()
{
    Session session;
    const std::uint64_t start = session.state();
    for (int i = 0; i < 20; ++i) {
        session.stroke({50, 0, 0}, core::Tool::Pull, 3);
        QVERIFY(session.document.history().canUndo());
        session.document.history().undo(); // before the mesh thread has reported the stroke
        QCOMPARE(session.state(), start);
        QVERIFY(!session.document.history().canUndo() && session.document.history().canRedo());
    }
}

void TestDocument::history_hasANameForEveryTool()
{
    QStringList names;
    for (std::size_t i = 0; i < core::toolNames().size(); ++i)
        names << StrokeStep::textOf(static_cast<core::Tool>(i));
    QVERIFY(!names.contains(QString()));
    QCOMPARE(names.removeDuplicates(), 0);
}

void TestDocument::history_namesStepsAndMarksThem()
{
    Session session;
    session.stroke({50, 0, 0}, core::Tool::Push, 3);
    session.settle();
    session.document.changer().apply(core::Fill{{1, 2, 3}});
    session.wait();
    session.document.history().undo();
    session.settle();
    const ui::History history = historyOf(session.document);
    QCOMPARE(history.steps.size(), 2);
    QCOMPARE(history.steps[0].name, StrokeStep::textOf(core::Tool::Push));
    QCOMPARE(history.steps[0].icon, QStringLiteral("push"));
    QCOMPARE(history.steps[0].dabs, 3u);
    QCOMPARE(history.steps[1].icon, QStringLiteral("fill"));
    QCOMPARE(history.steps[1].dabs, 0u);
    QCOMPARE(history.present, 1);
    QCOMPARE(history.first, 0);
    QCOMPARE(history.last, 2);
    QVERIFY(history.bytes > 0);
}

void TestDocument::analysis_isOfThePresentModelOnly()
{
    Session session;
    auto* analysis = new ModelAnalysis(&session.document, &session.worker);
    quint64 faces = 0;
    int answers = 0;
    connect(analysis, &ModelAnalysis::finished, analysis, [&](const core::MeshReport& report) {
        faces = report.faces;
        ++answers;
        QVERIFY(report.printReady());
    });
    connect(analysis, &ModelAnalysis::outdated, analysis, [&] { faces = 0; });
    analysis->setActive(true);
    QTRY_COMPARE(faces, session.document.modelInfo().faces);
    session.stroke({50, 0, 0});
    QCOMPARE(faces, 0u); // the change outdates the answer at once
    session.settle();
    QTRY_COMPARE(faces, session.document.modelInfo().faces);
    QCOMPARE(answers, 2);
    analysis->setActive(false);
    session.stroke({0, 50, 0});
    session.settle();
    QTest::qWait(1500);
    QCOMPARE(answers, 2); // an inactive analysis does not start again
}

void TestDocument::undo_duringAStrokeWaitsForItsEnd()
{
    Session session;
    const std::uint64_t start = session.state();
    session.document.strokes().beginStroke({});
    core::StrokeSample sample;
    sample.position = {0, 50, 0};
    session.document.strokes().addSample(sample);
    session.document.history().undo();
    session.document.strokes().addSample(sample);
    session.settle();
    QVERIFY(session.worker.strokes().isOpen());
    session.document.strokes().endStroke();
    QCOMPARE(session.state(), start);
    QVERIFY(session.document.history().canRedo());
    QCOMPARE(session.worker.stats().samples, quint64(2));
}

void TestDocument::stroke_rightAfterUndoComesAfterIt()
{
    Session session;
    session.stroke({0, 0, 50});
    const std::uint64_t afterOne = session.state();
    session.document.history().undo();
    session.state();

    // Three steps in a row, before the mesh thread has reported any.
    session.stroke({50, 0, 0});
    session.document.history().undo();
    session.stroke({0, 0, 50});
    QCOMPARE(session.state(), afterOne);
    QCOMPARE(session.document.history().stack().count(), 1);
    QVERIFY(session.document.history().canUndo() && !session.document.history().canRedo());

    session.stroke({50, 0, 0});
    session.document.history().undo();
    session.document.history().undo();
    session.document.history().redo();
    QCOMPARE(session.state(), afterOne);
}

void TestDocument::undoAll_andRedoAllComeBackByState()
{
    Session session;
    std::mt19937_64 random(5);
    std::vector<std::uint64_t> states{session.state()};
    while (states.size() < 40) {
        session.randomStroke(random);
        const std::uint64_t now = session.state();
        if (session.document.history().stack().count() == static_cast<int>(states.size()))
            states.push_back(now);
    }
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        session.document.history().undo();
        QCOMPARE(session.state(), states[i - 1]);
    }
    QVERIFY(!session.document.history().canUndo());
    for (std::size_t i = 1; i < states.size(); ++i) {
        session.document.history().redo();
        QCOMPARE(session.state(), states[i]);
    }
    QVERIFY(!session.document.history().canRedo());
    for (std::size_t i = 1; i < states.size(); ++i)
        session.document.history().undo();
    QCOMPARE(session.state(), states.front());
}

/// The count of strokes includes undone ones, but not those that changed nothing. It is saved in the file and continues
/// after reopening.
void TestDocument::work_isCountedAndSaved()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.glb"));
    Session session;
    const auto strokes = [&session] {
        return session.document.modelInfo().metadata.work.value_or(core::WorkDone{99, 0}).strokes;
    };
    QCOMPARE(strokes(), 0U);
    for (int i = 0; i < 3; ++i)
        session.stroke({50, 0, 0});
    session.document.history().undo();
    session.stroke({500, 0, 0});
    session.wait();
    QCOMPARE(strokes(), 3U);
    const double seconds = session.document.modelInfo().metadata.work->seconds;
    QVERIFY(seconds > 0);
    session.document.saver().save(path);
    session.wait();
    QVERIFY(core::readMetadata(path.toStdString()).work == (core::WorkDone{3, seconds}));

    session.document.opener().openBall();
    session.wait();
    QCOMPARE(strokes(), 0U);
    session.document.opener().open(path);
    session.wait();
    QCOMPARE(strokes(), 3U);
    session.stroke({50, 0, 0});
    session.wait();
    QCOMPARE(strokes(), 4U);
    // the time between both sessions does not count
    QCOMPARE(session.document.modelInfo().metadata.work->seconds, seconds);
}

void TestDocument::jumps_goThere()
{
    Session session;
    std::vector<std::uint64_t> states{session.state()};
    for (const core::Vec3& where :
         {core::Vec3(50, 0, 0), core::Vec3(0, 50, 0), core::Vec3(0, 0, 50), core::Vec3(-50, 0, 0)}) {
        session.stroke(where);
        states.push_back(session.state());
    }
    for (const int index : {0, 3, 1, 4, 2, 99, -1}) {
        session.document.history().goTo(index);
        QCOMPARE(session.state(), states[static_cast<std::size_t>(std::clamp(index, 0, 4))]);
    }
}

void TestDocument::stroke_thatDoesNothingIsNoStep()
{
    Session session;
    session.stroke({0, 500, 0});
    session.settle();
    QCOMPARE(session.document.history().stack().count(), 0);
    QVERIFY(!session.document.savedState().isModified() && !session.document.history().canUndo());
}

/// A stroke that is cancelled leaves the model unchanged and keeps redo available.
void TestDocument::strokeTakenBack_leavesTheModelAsItWas()
{
    Session s;
    s.stroke({50, 0, 0});
    s.stroke({0, 50, 0});
    s.wait();
    s.document.history().undo();
    s.wait();
    const std::uint64_t before = s.state();
    const int steps = s.document.history().stack().count();
    core::StrokeSettings settings;
    settings.radius = 20;
    s.document.strokes().beginStroke(settings);
    core::StrokeSample sample;
    for (int i = 0; i < 5; ++i) {
        sample.position = {50, 2.0 * i, 0};
        s.document.strokes().addSample(sample);
    }
    s.settle();
    QVERIFY(s.state() != before);
    s.document.strokes().endStroke(core::StrokeEnd::TakenBack);
    s.wait();
    QCOMPARE(s.state(), before);
    QCOMPARE(s.document.history().stack().count(), steps);
    s.document.history().redo();
    s.wait();
    QVERIFY(s.state() != before);
    s.verifyWhole();
}

/// Each sample of an anchored stroke previews the final dab. The stroke becomes one step of one dab.
void TestDocument::anchoredStroke_showsWhatItLeaves()
{
    Session s;
    s.wait();
    const std::uint64_t before = s.surface();
    core::StrokeSettings settings;
    settings.tool = core::Tool::Stamp;
    settings.radius = 5;
    settings.anchored = true;
    const auto drag = [&](std::initializer_list<core::Vec3> hands, core::StrokeEnd how) {
        s.document.strokes().beginStroke(settings);
        std::vector<std::uint64_t> shown;
        for (const core::Vec3& hand : hands) {
            core::StrokeSample sample;
            sample.position = hand;
            s.document.strokes().addSample(sample);
            s.settle();
            shown.push_back(s.surface());
        }
        s.document.strokes().endStroke(how);
        s.wait();
        return shown;
    };
    const auto shown = drag({{50, 0, 0}, {50, 12, 0}, {50, 0, 8}}, core::StrokeEnd::Kept);
    QVERIFY(shown[0] != before && shown[1] != shown[0] && shown[2] != shown[1]);
    QCOMPARE(s.surface(), shown[2]);
    QCOMPARE(s.document.history().stack().count(), 1);
    s.verifyWhole();
    s.document.history().undo();
    s.wait();
    QCOMPARE(s.surface(), before);
    const auto again = drag({{50, 0, 0}, {50, 0, 8}}, core::StrokeEnd::Kept);
    QVERIFY(again == std::vector({shown[0], shown[2]}));
    s.document.history().undo();
    drag({{50, 0, 0}, {50, 12, 0}}, core::StrokeEnd::TakenBack);
    QCOMPARE(s.surface(), before);
}

void TestDocument::strokeThatFellShort_isSaidOnce_data()
{
    using core::Shortfall;
    QTest::addColumn<core::StrokeSettings>("settings");
    QTest::addColumn<QList<core::Vec3>>("samples");
    QTest::addColumn<Shortfall>("shortfall");
    core::StrokeSettings brush;
    brush.radius = 12;
    core::StrokeSettings fine = brush, apart = brush, strong = brush, sphere = brush;
    fine.detail = 0.05; // this detail needs tens of thousands of splits
    QTest::newRow("too much work") << fine << QList<core::Vec3>(3, {0, 50, 0}) << Shortfall::Capped;
    apart.tool = core::Tool::Push;
    apart.place = core::Placement::Ray;
    apart.strength = 10;
    apart.fusion = false;
    QTest::newRow("contact") << apart << QList<core::Vec3>(20, {1, 400, 1}) << Shortfall::Contact;
    strong.place = core::Placement::Ray;
    strong.radius = 45;
    strong.strength = 10;
    QTest::newRow("wall") << strong << QList<core::Vec3>(20, {1, 600, 1}) << Shortfall::Wall;
    sphere.add = true;
    QTest::newRow("inside") << sphere << QList<core::Vec3>{{0, 0, 0}, {1, 0, 0}} << Shortfall::Inside;
    QTest::newRow("too close") << sphere << QList<core::Vec3>{{0, 62.5, 0}} << Shortfall::TooClose;
    QTest::newRow("no room") << sphere << QList<core::Vec3>{{0, 505, 0}} << Shortfall::NoRoom;
}

void TestDocument::strokeThatFellShort_isSaidOnce()
{
    QFETCH(core::StrokeSettings, settings);
    QFETCH(QList<core::Vec3>, samples);
    QFETCH(core::Shortfall, shortfall);
    Session session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    session.document.strokes().beginStroke(settings);
    for (const core::Vec3& position : samples) {
        core::StrokeSample sample;
        sample.position = position;
        sample.direction = -core::Vec3::UnitY();
        session.document.strokes().addSample(sample);
    }
    session.settle();
    QVERIFY(noticed.isEmpty()); // no notice while the stroke is open
    session.document.strokes().endStroke();
    session.wait();
    QCOMPARE(noticed.size(), 1);
    QCOMPARE(noticed[0][0].toString(), ui::ErrorMessages::shortfall(shortfall));
    session.verifyWhole();
}

/// Sphere tool: an added sphere is one step, or a notice gives the reason why not. The clay has a radius of 50 mm, the
/// brush one of 12 mm.
void TestDocument::sphere_isAStepOrAWordWhyNot()
{
    using core::Shortfall;
    Session session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    core::StrokeSettings brush;
    brush.radius = 12;
    brush.add = true;
    brush.spacing = 0;
    const auto add = [&](const core::Vec3& position, core::Symmetry symmetry = core::Symmetry::None) {
        brush.symmetry = symmetry;
        core::StrokeSample sample;
        sample.position = position;
        session.document.strokes().addSphere(brush, sample);
        session.wait();
    };
    const std::uint64_t start = session.state();
    const auto refuses = [&](const core::Vec3& position, Shortfall why) {
        noticed.clear();
        add(position);
        return session.state() == start && !session.document.history().canUndo() && noticed.size() == 1 &&
               noticed[0][0].toString() == ui::ErrorMessages::shortfall(why);
    };
    QVERIFY(refuses({0, 0, 0}, Shortfall::Inside));
    QVERIFY(refuses({0, 45, 0}, Shortfall::TooClose)); // close enough for a pull, but too close to add a sphere
    QVERIFY(refuses({0, 55, 0}, Shortfall::TooClose));
    QVERIFY(refuses({0, 505, 0}, Shortfall::NoRoom));

    noticed.clear();
    const quint64 faces = session.document.modelInfo().faces;
    add({90, 0, 0});
    QVERIFY(noticed.isEmpty() && session.document.modelInfo().faces > faces && session.state() != start);
    QCOMPARE(session.document.history().undoText(), StrokeStep::textOfAdding(false));
    session.verifyWhole();
    const std::uint64_t one = session.state();
    add({-90, 0, 0}, core::Symmetry::X); // the mirror image would overlap the first sphere
    QCOMPARE(session.state(), one);
    QCOMPARE(noticed.size(), 1);
    session.document.history().undo();
    QCOMPARE(session.state(), start);

    noticed.clear();
    brush.join = true; // on the surface, the sphere is joined to the model
    add({0, 45, 0});
    QVERIFY(noticed.isEmpty() && session.state() != start);
    QCOMPARE(session.document.history().undoText(), StrokeStep::textOfAdding(false));
    session.verifyWhole();
}

void TestDocument::mirroredStroke_saysWhereTheModelIsNotSymmetric()
{
    Session session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    core::StrokeSettings brush;
    brush.radius = 12;
    const auto stroke = [&](core::Symmetry symmetry, const core::Vec3& position) {
        brush.symmetry = symmetry;
        core::StrokeSample sample;
        sample.position = position;
        session.document.strokes().beginStroke(brush);
        for (int i = 0; i < 3; ++i)
            session.document.strokes().addSample(sample);
        session.document.strokes().endStroke();
        session.wait();
    };
    stroke(core::Symmetry::X, {30, 40, 0});
    stroke(core::Symmetry::None, {30, -40, 0});
    QVERIFY(noticed.isEmpty());
    stroke(core::Symmetry::X, {30, -40, 0});
    QCOMPARE(noticed.size(), 1);
    QCOMPARE(noticed[0][0].toString(), ui::ErrorMessages::asymmetric());
}

void TestDocument::radialStroke_saysWhereTheSectorsAreNotAlike()
{
    Session session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    core::StrokeSettings brush;
    brush.radius = 8;
    const auto stroke = [&](int radial, const core::Vec3& position) {
        brush.radial = radial;
        core::StrokeSample sample;
        sample.position = position;
        session.document.strokes().beginStroke(brush);
        for (int i = 0; i < 3; ++i)
            session.document.strokes().addSample(sample);
        session.document.strokes().endStroke();
        session.wait();
    };
    stroke(2, {30, 0, 40});
    stroke(3, {30, 0, 40}); // three sectors are never exact, so no notice is due
    QVERIFY(noticed.isEmpty());
    stroke(2, {3, 50, 0}); // the brush crosses the axis
    QCOMPARE(noticed.size(), 1);
    QCOMPARE(noticed[0][0].toString(), ui::ErrorMessages::sequentialSectors());
}

void TestDocument::strokeThatDidAll_isNotTalkedAbout()
{
    Session session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    std::mt19937_64 random(7);
    for (int i = 0; i < 20; ++i)
        session.randomStroke(random);
    session.stroke({0, 500, 0}); // the stroke misses the model
    session.wait();
    QVERIFY2(noticed.isEmpty(), qPrintable(noticed.isEmpty() ? QString() : noticed[0][0].toString()));
}

void TestDocument::newStroke_forgetsWhatWasUndone()
{
    Session session;
    session.stroke({50, 0, 0});
    session.stroke({0, 50, 0});
    session.document.history().undo();
    session.stroke({0, 0, 50});
    session.settle();
    QCOMPARE(session.document.history().stack().count(), 2);
    QVERIFY(!session.document.history().canRedo());
    session.document.history().redo();
    session.document.history().undo();
    session.document.history().undo();
    session.document.history().undo();
    session.settle();
    QVERIFY(!session.document.history().canUndo());
}

void TestDocument::modified_followsTheHistory()
{
    Session session;
    QSignalSpy modified(&session.document.savedState(), &SavedState::modifiedChanged);
    session.stroke({50, 0, 0});
    QVERIFY(session.document.savedState().isModified());
    session.document.history().undo();
    session.settle();
    QVERIFY(!session.document.savedState().isModified());
    QVERIFY(modified.size() >= 2);
    QCOMPARE(modified.first().at(0).toBool(), true);
    QCOMPARE(modified.last().at(0).toBool(), false);
}

void TestDocument::spilledDeltas_comeBack()
{
    Session session;
    QTemporaryDir folder;
    session.document.history().store().setFolder(folder.path());
    session.document.history().store().setCap(1);
    std::mt19937_64 random(6);
    std::vector<std::uint64_t> states{session.state()};
    while (states.size() < 15) {
        session.randomStroke(random);
        const std::uint64_t now = session.state();
        if (session.document.history().stack().count() == static_cast<int>(states.size()))
            states.push_back(now);
    }
    // All but the last delta, which the next undo needs, are on disk.
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 13);
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = states.size() - 1; i > 0; --i) {
            QVERIFY(session.document.history().canUndo());
            session.document.history().undo();
            QCOMPARE(session.state(), states[i - 1]);
        }
        for (std::size_t i = 1; i < states.size(); ++i) {
            session.document.history().redo();
            QCOMPARE(session.state(), states[i]);
        }
    }
    session.document.history().goTo(0);
    session.stroke({50, 0, 0});
    session.settle();
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 0); // deltas of undone steps are removed
}

void TestDocument::expiry_whenNothingCanBeSpilled()
{
    Session session;
    session.document.history().store().setFolder(QStringLiteral("/proc/no such folder"));
    std::vector<std::uint64_t> states{session.state()};
    for (const core::Vec3& where : {core::Vec3(50, 0, 0), core::Vec3(0, 50, 0), core::Vec3(0, 0, 50)}) {
        session.stroke(where);
        states.push_back(session.state());
    }
    session.document.history().store().setCap(1);
    session.settle();
    QVERIFY(session.document.history().canUndo());
    session.document.history().undo();
    QCOMPARE(session.state(), states[2]);
    QVERIFY(!session.document.history().canUndo()); // QUndoStack still has steps, but their deltas have expired
    QVERIFY(session.document.history().undoText().isEmpty());
    QVERIFY(session.document.history().stack().canUndo());
    session.document.history().undo();
    session.document.history().goTo(0);
    QCOMPARE(session.state(), states[2]);
    session.document.history().redo();
    QCOMPARE(session.state(), states[3]);
}

void TestDocument::lostFile_losesOnlyTheHistory()
{
    Session session;
    QTemporaryDir folder;
    session.document.history().store().setFolder(folder.path());
    session.document.history().store().setCap(1);
    session.stroke({50, 0, 0});
    session.stroke({0, 50, 0});
    session.stroke({0, 0, 50});
    session.settle();
    for (const QString& name : QDir(folder.path()).entryList(QDir::Files))
        QVERIFY(QFile::resize(folder.filePath(name), 7));
    session.document.history().undo();
    const std::uint64_t state = session.state();
    QSignalSpy refused(&session.document, &Document::refused);
    session.document.history().undo();
    session.document.history().undo();
    session.stroke({-50, 0, 0}, core::Tool::Pull, 1);
    session.document.history().undo();
    QCOMPARE(session.state(), state);
    QCOMPARE(refused.size(), 1);
    QVERIFY(!session.document.history().canUndo() && session.document.savedState().isModified());
    session.stroke({-50, 0, 0});
    session.document.history().undo();
    QCOMPARE(session.state(), state);
}

void TestDocument::open_takesAModelAndCentresIt()
{
    QTemporaryDir folder;
    core::TriangleMesh model = core::icosphere(2, 10);
    for (core::Vec3f& p : model.points)
        p += core::Vec3f(30, 5, -7);
    const QString path = folder.filePath(QStringLiteral("ball.ply"));
    core::writeMesh(path.toStdString(), model);

    Session session;
    session.stroke({50, 0, 0});
    QSignalSpy opened(&session.document, &Document::opened);
    session.document.opener().open(path);
    session.wait();
    QCOMPARE(opened.size(), 1);
    const auto facts = opened.at(0).at(0).value<ui::ModelInfo>();
    QCOMPARE(facts.name, QStringLiteral("ball.ply"));
    QCOMPARE(facts.vertices, quint64(162));
    QVERIFY(facts.box.center().norm() < 1e-3);
    QVERIFY(!session.document.savedState().isModified() && !session.document.history().canUndo());
    QCOMPARE(session.document.modelInfo().path, path);
    const std::uint64_t start = session.state();
    session.stroke({10, 0, 0});
    session.document.history().undo();
    QCOMPARE(session.state(), start);
}

void TestDocument::openStarter_beginsAnew()
{
    Session session;
    session.stroke({50, 0, 0});
    bool mayLose = false;
    session.document.opener().setDiscardPrompt([&](const std::function<void()>&) { return mayLose; });
    session.document.opener().openStarter(core::Starter::Torus);
    session.wait();
    QVERIFY(session.document.savedState().isModified());
    mayLose = true;
    session.document.opener().openStarter(core::Starter::Torus);
    session.wait();
    QVERIFY(!session.document.savedState().isModified() && !session.document.history().canUndo());
    QVERIFY(session.document.modelInfo().path.isEmpty());
    QVERIFY(!session.document.modelInfo().name.isEmpty());
    QCOMPARE(session.document.modelInfo().faces,
             2 * session.document.modelInfo().vertices); // for a torus, V - E + F = 0
}

void TestDocument::open_refusalLeavesTheDocument_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("missing") << QStringLiteral("missing.stl") << QByteArray();
    QTest::newRow("empty") << QStringLiteral("empty.stl") << QByteArray("");
    QTest::newRow("not what its ending says")
        << QStringLiteral("picture.obj") << QByteArray("\x89PNG\r\n\x1a\n and so on");
    QTest::newRow("open") << QStringLiteral("open.obj") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("NaN") << QStringLiteral("nan.obj") << QByteArray("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("index") << QStringLiteral("index.obj") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    QTest::newRow("unknown") << QStringLiteral("part.step") << QByteArray("ISO-10303-21;");
}

void TestDocument::open_refusalLeavesTheDocument()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QTemporaryDir folder;
    const QString path = folder.filePath(name);
    if (!content.isNull()) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    Session session;
    session.stroke({50, 0, 0});
    const std::uint64_t state = session.state();
    QSignalSpy refused(&session.document, &Document::refused),
        repairable(&session.document.opener(), &ModelOpener::repairable);
    session.document.opener().open(path);
    session.wait();
    QTRY_COMPARE(refused.size() + repairable.size(), 1);
    QCOMPARE(repairable.size(), name == QStringLiteral("open.obj") ? 1 : 0);
    const QString sentence = refused.isEmpty() ? repairable.at(0).at(1).toString() : refused.at(0).at(0).toString();
    QVERIFY2(sentence.contains(name) && !sentence.contains(QLatin1Char('\n')), qPrintable(sentence));
    QCOMPARE(session.state(), state);
    QVERIFY(session.document.savedState().isModified() && session.document.history().canUndo());
    QCOMPARE(session.document.modelInfo().name.isEmpty(), false);
    QVERIFY(session.document.modelInfo().path.isEmpty());
}

void TestDocument::open_asksBeforeChangesAreLost()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("ball.stl"));
    core::writeMesh(path.toStdString(), core::icosphere(1, 10));
    Session session;
    int asked = 0;
    bool answer = false;
    session.document.opener().setDiscardPrompt([&](const std::function<void()>&) {
        ++asked;
        return answer;
    });
    session.document.opener().openBall(); // no question, because nothing is unsaved
    session.wait();
    QCOMPARE(asked, 0);
    session.stroke({50, 0, 0});
    session.document.opener().open(path);
    session.wait();
    QCOMPARE(asked, 1);
    QCOMPARE(session.document.modelInfo().vertices > 1000, true);
    answer = true;
    session.document.opener().open(path);
    session.wait();
    QCOMPARE(asked, 2);
    QCOMPARE(session.document.modelInfo().vertices, quint64(42));
}

void TestDocument::export_writesWhatIsThere()
{
    QTemporaryDir folder;
    for (const char* ending : {"stl", "obj", "ply"}) {
        Session session;
        session.stroke({50, 0, 0});
        const QString path = folder.filePath(QStringLiteral("model.") + QLatin1String(ending));
        QSignalSpy exported(&session.document.saver(), &ModelSaver::exported);
        session.document.saver().exportTo(path);
        QTRY_COMPARE(exported.size(), 1);
        QVERIFY(session.document.savedState().isModified() && session.document.modelInfo().path.isEmpty());
        const core::TriangleMesh mesh = core::readMesh(path.toStdString());
        QCOMPARE(mesh.triangles.size(), std::size_t(session.document.modelInfo().faces));
        QVERIFY(core::checkMesh(mesh).printReady());
    }
}

void TestDocument::saving_givesTheModelItsFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.ply"));
    Session session;
    session.stroke({50, 0, 0});
    QSignalSpy saved(&session.document.saver(), &ModelSaver::saved);
    session.document.saver().save(path);
    QTRY_COMPARE(saved.size(), 1);
    QVERIFY(!session.document.savedState().isModified());
    QCOMPARE(session.document.modelInfo().path, path);
    QCOMPARE(session.document.modelInfo().name, QStringLiteral("mine.ply"));
    QVERIFY(core::checkMesh(core::readMesh(path.toStdString())).printReady());
    session.document.history().undo();
    session.settle();
    QVERIFY(session.document.savedState().isModified()); // the file contains the undone stroke
    session.document.history().redo();
    session.settle();
    QVERIFY(!session.document.savedState().isModified());
}

/// If the folder is not writable or the disk is full, file and model must stay unchanged.
void TestDocument::savingThatFails_losesNothing_data()
{
    QTest::addColumn<QString>("path");
    QTest::newRow("no folder") << QStringLiteral("/no such folder/mine.ply");
    QTest::newRow("a folder") << QDir::tempPath();
    QTest::newRow("not permitted") << QStringLiteral("/proc/mine.ply");
}

void TestDocument::savingThatFails_losesNothing()
{
    QFETCH(QString, path);
    Session session;
    session.stroke({50, 0, 0});
    const QString name = session.document.modelInfo().name;
    QSignalSpy refused(&session.document, &Document::refused), saved(&session.document.saver(), &ModelSaver::saved);
    session.document.saver().save(path);
    QTRY_COMPARE(refused.size(), 1);
    QVERIFY(refused.at(0).at(0).toString().contains(QDir::toNativeSeparators(path)));
    QVERIFY(saved.isEmpty() && session.document.savedState().isModified() && !session.document.job().isBusy());
    QVERIFY(session.document.modelInfo().path.isEmpty());
    QCOMPARE(session.document.modelInfo().name, name);
    QVERIFY(session.document.history().canUndo());
}

void TestDocument::coloursThatAFormatDoesNotHold_areNamed()
{
    QTemporaryDir folder;
    Session session;
    session.document.changer().apply(core::Fill{{1, 2, 3}});
    session.wait();
    QSignalSpy noticed(&session.document, &Document::noticed),
        exported(&session.document.saver(), &ModelSaver::exported);
    session.document.saver().exportTo(folder.filePath(QStringLiteral("a.ply")));
    QTRY_COMPARE(exported.size(), 1);
    QVERIFY(!exported.at(0).at(1).toString().contains(QStringLiteral("colours")));
    session.document.saver().exportTo(folder.filePath(QStringLiteral("a.stl")));
    QTRY_COMPARE(exported.size(), 2);
    QVERIFY(exported.at(1).at(1).toString().contains(QStringLiteral("a.stl")) &&
            exported.at(1).at(1).toString().contains(QStringLiteral("colours")));
    QVERIFY(noticed.isEmpty());
    session.document.saver().save(folder.filePath(QStringLiteral("b.stl")));
    QTRY_COMPARE(noticed.size(), 1);
    QVERIFY(noticed.at(0).at(0).toString().contains(QStringLiteral("b.stl")));
}

void TestDocument::export_intoNowhereIsRefused()
{
    Session session;
    QSignalSpy refused(&session.document, &Document::refused);
    session.document.saver().exportTo(QStringLiteral("/no such folder/model.stl"));
    QTRY_COMPARE(refused.size(), 1);
    QVERIFY(refused.at(0).at(0).toString().contains(QStringLiteral("model.stl")));
    QVERIFY(!session.document.job().isBusy());
}

FETTLE_TEST(TestDocument, QCoreApplication)
#include "tst_document.moc"
