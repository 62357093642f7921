#include "app/commands/stroke_assets.h"
#include "app/document/document.h"
#include "app/model/brush_export.h"
#include "app/worker/sculpt_worker.h"

#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/ask_worker.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/support/viewer.h"
#include "ui/brush/brush_files.h"
#include "ui/util/thread_mailbox.h"

#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <random>
#include <sstream>

using namespace app;

namespace
{
/// Returns the path of the file to which the document exports its model as a brush, or an empty text.
QString exportedBrush(Document& document)
{
    QSignalSpy kept(&document.saver(), &ModelSaver::brushExported);
    document.saver().exportBrush();
    [&] { QTRY_COMPARE(kept.count(), 1); }();
    return kept.isEmpty() ? QString() : kept[0][0].toString();
}

/// A document with a ball of clay and a viewer that receives its patches.
struct ViewedSession
{
    ViewedSession()
    {
        worker.setInbox(Source::Desktop, inbox);
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

    /// Returns the hash of the mesh. Checks that the viewer shows the same mesh.
    std::uint64_t state()
    {
        settle();
        const auto [whole, hash] = ask(worker, [](core::Sculptor& sculptor) {
            return std::pair(sculptor.wholePatch(), sculptor.mesh().stateHash());
        });
        if (const auto patch = inbox->take())
            seen.apply(*patch);
        [&, &whole = whole] { QVERIFY(seen.drawsLike(viewerOf(whole))); }();
        return hash;
    }

    void apply(const core::ModelCommand& command)
    {
        document.changer().apply(command);
        wait();
    }

    void stroke(const core::Vec3& where)
    {
        core::StrokeSettings settings;
        settings.radius = 12;
        document.strokes().beginStroke(settings);
        core::StrokeSample sample;
        sample.position = where;
        document.strokes().addSample(sample);
        document.strokes().endStroke();
    }

    SculptWorker worker;
    Document document{&worker};
    std::shared_ptr<PatchInbox> inbox = std::make_shared<PatchInbox>();
    Viewer seen;
};
} // namespace

/// Tests commands for the whole model in the document: they run in the background, in order, each as one step.
class TestDocumentModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void command_isOneStep();
    void brush_isKeptAsItIs();
    void brush_ofALargeModelHasFewerTriangles();
    void brush_withoutAPlaceIsRefused();
    void strokesBeforeAndAfter_areUndoneAndRedone();
    void undo_rightAfterACommandUndoesThatCommand();
    void strokesMeanwhile_areRefusedWithAWord();
    void nothing_isNoStepAndIsSaid();
    void refusal_leavesAllAsItIsAndSaysWhy();
    void stop_leavesAllAsItIs();
    void change_isToldOnceItIsMade();
    void undo_isToldOnceItIsMade();
    void insert_fromAFile();
    void insert_refusalsNameTheFile();
    void insert_combinesAsOneStep();
    void insert_brokenIsRepairedAsOneStep();
    void insert_tellsWhatWasLeftOut();
    void insert_takesTheUnit();
    void facts_followTheModel();
    void progress_grows();
    void reset_isTheStartAndOneStep();
    void spilledCommands_comeBack();
    void end_whileAChangeGoesOn();
    void opening_canBeStopped();
};

void TestDocumentModel::command_isOneStep()
{
    ViewedSession session;
    const std::uint64_t start = session.state();
    QSignalSpy idle(&session.document.job(), &BackgroundJob::idle);
    session.apply(core::Scale{2});
    QCOMPARE(idle.size(), 1);
    const std::uint64_t scaled = session.state();
    QVERIFY(scaled != start && session.document.savedState().isModified());
    QCOMPARE(session.document.history().stack().count(), 1);
    QVERIFY(!session.document.history().undoText().isEmpty());
    session.document.history().undo();
    QCOMPARE(session.state(), start);
    session.document.history().redo();
    QCOMPARE(session.state(), scaled);
}

/// Each model has a file in a folder named by its fingerprint. Strokes that name the fingerprint find the file again.
void TestDocumentModel::brush_isKeptAsItIs()
{
    QDir(BrushExport::folder()).removeRecursively();
    ViewedSession session;
    const std::uint64_t state = session.state();
    const QString ball = exportedBrush(session.document);
    QCOMPARE(exportedBrush(session.document), ball);
    session.stroke({50, 0, 0});
    const QString dented = exportedBrush(session.document);
    QVERIFY(dented != ball && QFileInfo(dented).fileName() == QFileInfo(ball).fileName());
    session.document.history().undo();
    QCOMPARE(session.state(), state);
    QVERIFY(!session.document.savedState().isModified() && session.document.modelInfo().path.isEmpty());
    for (const QString& path : {ball, dented}) {
        const auto brush = ui::readBrushModel(path);
        QVERIFY2(brush.what, qPrintable(brush.problem));
        const QString print = QFileInfo(path).dir().dirName();
        QCOMPARE(QString::fromStdString(brush.what->fingerprint()), print);
        core::Stroke stroke;
        stroke.settings.tool = core::Tool::Stamp;
        stroke.settings.model = brush.what;
        stroke.samples.resize(1);
        std::ostringstream written;
        core::writeStrokes(written, {stroke});
        auto entries = core::parseStrokes(written.str());
        QVERIFY(!std::get<core::Stroke>(entries[0]).settings.model);
        readStrokeAssets(entries, QDir::temp().filePath(QStringLiteral("strokes.json")));
        QCOMPARE(std::get<core::Stroke>(entries[0]).settings.model->fingerprint(), print.toStdString());
    }
}

void TestDocumentModel::brush_ofALargeModelHasFewerTriangles()
{
    const core::BuildResult built = core::buildMesh(core::icosphere(7, 50));
    const ExportedBrush kept =
        BrushExport::run(std::make_shared<core::Mesh>(*built.mesh), QStringLiteral("large.stl"), {});
    QVERIFY2(kept.problem.isEmpty(), qPrintable(kept.problem));
    const auto brush = ui::readBrushModel(kept.path);
    QVERIFY2(brush.what, qPrintable(brush.problem));
    QVERIFY(brush.what->surface().triangles.size() <= core::BrushModel::maxFaces);
    QCOMPARE(QFileInfo(kept.path).fileName(), QStringLiteral("large.glb"));
}

/// A file with the name of the brushes' folder is in the way.
void TestDocumentModel::brush_withoutAPlaceIsRefused()
{
    QDir(BrushExport::folder()).removeRecursively();
    QVERIFY(QDir().mkpath(QFileInfo(BrushExport::folder()).path()));
    QFile inTheWay(BrushExport::folder());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    const auto away = qScopeGuard([&] { inTheWay.remove(); });
    ViewedSession session;
    QSignalSpy refused(&session.document, &Document::refused),
        kept(&session.document.saver(), &ModelSaver::brushExported);
    session.document.saver().exportBrush();
    session.wait();
    QCOMPARE(refused.count(), 1);
    QVERIFY2(refused[0][0].toString().contains(BrushExport::folder()), qPrintable(refused[0][0].toString()));
    QCOMPARE(kept.count(), 0);
}

void TestDocumentModel::strokesBeforeAndAfter_areUndoneAndRedone()
{
    ViewedSession session;
    const core::ModelCommand commands[] = {core::Move{{3, 4, 5}}, core::Mirror{0}, core::RemeshUniformly{4},
                                           core::Fill{{1, 2, 3}}, core::Scale{30}, core::Scale{0.02},
                                           core::Recentre{}};
    std::vector<std::uint64_t> states = {session.state()};
    for (const core::ModelCommand& command : commands) {
        session.stroke({50, 0, 0});
        session.wait();
        if (session.document.history().stack().count() == static_cast<int>(states.size()))
            states.push_back(session.state());
        session.apply(command);
        if (session.document.history().stack().count() == static_cast<int>(states.size()))
            states.push_back(session.state());
    }
    QVERIFY(states.size() > 9);
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        session.document.history().undo();
        QCOMPARE(session.state(), states[i - 1]);
    }
    session.document.history().goTo(static_cast<int>(states.size()) - 1);
    QCOMPARE(session.state(), states.back());
    session.document.history().goTo(0);
    QCOMPARE(session.state(), states.front());
}

void TestDocumentModel::undo_rightAfterACommandUndoesThatCommand()
{
    ViewedSession session;
    const std::uint64_t start = session.state();
    session.document.changer().apply(core::Mirror{1});
    session.document.history().undo(); // undo waits for the command
    session.wait();
    QCOMPARE(session.state(), start);
    QVERIFY(session.document.history().canRedo());
}

void TestDocumentModel::strokesMeanwhile_areRefusedWithAWord()
{
    ViewedSession session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    session.document.changer().apply(core::RemeshUniformly{3});
    session.stroke({50, 0, 0});
    QCOMPARE(noticed.size(), 1);
    session.wait();
    QCOMPARE(session.document.history().stack().count(), 1);
    session.stroke({50, 0, 0});
    session.wait();
    QCOMPARE(session.document.history().stack().count(), 2);
}

void TestDocumentModel::nothing_isNoStepAndIsSaid()
{
    ViewedSession session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    session.apply(core::Move{});
    session.apply(core::RemeshUniformly{});
    QCOMPARE(noticed.size(), 2);
    QCOMPARE(session.document.history().stack().count(), 0);
    QVERIFY(!session.document.savedState().isModified());
}

void TestDocumentModel::refusal_leavesAllAsItIsAndSaysWhy()
{
    ViewedSession session;
    session.stroke({50, 0, 0});
    session.wait();
    const std::uint64_t before = session.state();
    QSignalSpy refused(&session.document, &Document::refused);
    for (const core::ModelCommand& command :
         {core::ModelCommand(core::Move{{1e5, 0, 0}}), core::ModelCommand(core::Scale{1e9}),
          core::ModelCommand(core::RemeshUniformly{0.001})})
        session.apply(command);
    QCOMPARE(refused.size(), 3);
    for (const QList<QVariant>& arguments : refused)
        QVERIFY(arguments[0].toString().endsWith(QLatin1Char('.')));
    QCOMPARE(session.state(), before);
    QCOMPARE(session.document.history().stack().count(), 1);
}

void TestDocumentModel::stop_leavesAllAsItIs()
{
    ViewedSession session;
    const std::uint64_t before = session.state();
    QSignalSpy cancellable(&session.document.job(), &BackgroundJob::cancellable),
        refused(&session.document, &Document::refused);
    session.document.changer().apply(core::RemeshUniformly{0.6});
    QVERIFY(!cancellable.isEmpty() && cancellable.last()[0].toBool());
    session.document.cancelJob();
    QVERIFY(!cancellable.last()[0].toBool());
    session.wait();
    QCOMPARE(session.state(), before);
    QCOMPARE(session.document.history().stack().count(), 0);
    QVERIFY(refused.isEmpty() && !session.document.savedState().isModified());
    session.apply(core::Mirror{0}); // later commands work normally after the stop
    QCOMPARE(session.document.history().stack().count(), 1);
}

/// The mesh thread is delayed. A change must be reported only after it has been recorded, because an unrecorded one
/// would be lost in a crash.
void TestDocumentModel::change_isToldOnceItIsMade()
{
    QSemaphore delay;
    ViewedSession session;
    const auto releaseAtEnd = qScopeGuard([&delay] { delay.release(); });
    QSignalSpy cancellable(&session.document.job(), &BackgroundJob::cancellable),
        noticed(&session.document, &Document::noticed);
    session.document.changer().apply(core::Scale{2}); // the mesh thread makes a copy first
    session.worker.post([&delay](core::Sculptor&) { delay.acquire(); });
    QTRY_VERIFY(!cancellable.isEmpty() && !cancellable.last()[0].toBool());
    QVERIFY(!session.document.savedState().isModified() && !session.document.history().canUndo() &&
            session.document.job().isBusy());
    session.stroke({0, 0, 50});
    session.document.cancelJob(); // the change can no longer be cancelled
    session.document.history().undo();
    delay.release();
    session.wait();
    QVERIFY(session.document.history().canRedo() && !session.document.history().canUndo());
    QCOMPARE(noticed.size(), 1);
}

void TestDocumentModel::undo_isToldOnceItIsMade()
{
    QSemaphore delay;
    ViewedSession session;
    const auto releaseAtEnd = qScopeGuard([&delay] { delay.release(); });
    session.stroke({0, 0, 50});
    session.wait();
    session.worker.post([&delay](core::Sculptor&) { delay.acquire(); });
    QSignalSpy modified(&session.document.savedState(), &SavedState::modifiedChanged);
    session.document.history().undo();
    QVERIFY(session.document.history().canRedo());
    session.document.history().redo();
    session.document.history().undo();
    QTest::qWait(100);
    QVERIFY(modified.isEmpty() && !session.document.queue().isSettled());
    delay.release();
    session.wait();
    QCOMPARE(modified.size(), 1);
    QVERIFY(!session.document.savedState().isModified() && session.document.history().canRedo());
}

void TestDocumentModel::insert_fromAFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("small.ply"));
    core::writeMesh(path.toStdString(), core::icosphere(2, 10));
    ViewedSession session;
    const std::uint64_t start = session.state();
    session.document.changer().insert({path, core::Insert::Place::Beside});
    session.wait();
    QCOMPARE(session.document.modelInfo().vertices, quint64(10242 + 162));
    QVERIFY(session.document.modelInfo().size.x() > 120);
    session.document.history().undo();
    QCOMPARE(session.state(), start);
}

void TestDocumentModel::insert_refusalsNameTheFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("small.ply"));
    core::writeMesh(path.toStdString(), core::icosphere(2, 10));
    ViewedSession session;
    QSignalSpy refused(&session.document, &Document::refused);
    session.document.changer().insert({path, core::Insert::Place::AsItIs});
    session.wait();
    session.document.changer().insert({path, core::Insert::Place::Centre, {50, 0, 0}});
    session.wait();
    session.document.changer().insert(
        {folder.filePath(QStringLiteral("small.not.there.ply")), core::Insert::Place::Beside});
    session.wait();
    QCOMPARE(refused.size(), 3);
    for (const QList<QVariant>& arguments : refused)
        QVERIFY2(arguments[0].toString().contains(QStringLiteral("small")), qPrintable(arguments[0].toString()));
    QCOMPARE(session.document.history().stack().count(), 0);
}

void TestDocumentModel::insert_combinesAsOneStep()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("small.ply"));
    core::writeMesh(path.toStdString(), core::icosphere(2, 10));
    ViewedSession session;
    QSignalSpy refused(&session.document, &Document::refused), noticed(&session.document, &Document::noticed);
    const std::uint64_t start = session.state();
    ui::InsertRequest insertion{path, core::Insert::Place::Centre, {50, 0, 0}};
    insertion.combination = core::Insert::Combination::Join;
    session.document.changer().insert(insertion);
    session.wait();
    QVERIFY(session.document.modelInfo().size.x() > 108);
    QCOMPARE(session.document.history().stack().undoText(), QStringLiteral("Join"));
    session.document.history().undo();
    QCOMPARE(session.state(), start);

    core::Insert hole;
    hole.place = core::Insert::Place::Centre;
    hole.combination = core::Insert::Combination::Subtract;
    hole.primitive.emplace().kind = core::Primitive::Kind::Cylinder;
    hole.primitive->length(core::Primitive::Measure::Height) = 200;
    session.document.changer().apply(hole);
    session.wait();
    QCOMPARE(session.document.history().stack().undoText(), QStringLiteral("Subtract"));
    session.document.history().undo();
    QCOMPARE(session.state(), start);
    QVERIFY(refused.isEmpty() && noticed.isEmpty());

    hole.centre = {300, 0, 0};
    session.document.changer().apply(hole);
    session.wait();
    QCOMPARE(noticed.size(), 1);
    QCOMPARE(noticed[0][0].toString(), QStringLiteral("There is nothing to subtract: the models do not overlap."));
    hole.combination = core::Insert::Combination::Intersect;
    session.document.changer().apply(hole);
    session.wait();
    QCOMPARE(refused.size(), 1);
    QCOMPARE(refused[0][0].toString(),
             QStringLiteral("The model stays as it is, because nothing of it would be left."));
    hole.primitive->length(core::Primitive::Measure::Radius) = 0;
    session.document.changer().apply(hole);
    session.wait();
    QCOMPARE(refused.size(), 2);
    QCOMPARE(session.state(), start);
}

void TestDocumentModel::insert_brokenIsRepairedAsOneStep()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("broken.ply"));
    core::writeMesh(path.toStdString(),
                    shapes::together(core::icosphere(2, 10), shapes::moved(core::icosphere(2, 10), {9, 0, 0})));
    ViewedSession session;
    const std::uint64_t start = session.state();
    QSignalSpy refused(&session.document, &Document::refused),
        repairable(&session.document.changer(), &ModelChanger::insertionRepairable),
        repaired(&session.document.changer(), &ModelChanger::insertedRepaired);
    session.document.changer().insert({path, core::Insert::Place::Beside});
    session.wait();
    QCOMPARE(repairable.size(), 1);
    QVERIFY(repairable[0][1].toString().contains(QStringLiteral("broken.ply")));
    QCOMPARE(session.state(), start);
    auto insertion = repairable[0][0].value<ui::InsertRequest>();
    QCOMPARE(insertion.path, path);
    insertion.repair.emplace();
    session.document.changer().insert(insertion);
    session.wait();
    QVERIFY(refused.isEmpty());
    QCOMPARE(repaired.size(), 1);
    QVERIFY(!repaired[0][1].toStringList().isEmpty());
    QCOMPARE(session.document.history().stack().count(), 1);
    QVERIFY(session.document.modelInfo().size.x() > 100 + 29);
    session.document.history().undo();
    QCOMPARE(session.state(), start);
    // one triangle, which encloses nothing
    core::writeMesh(path.toStdString(), {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {}, {{0, 1, 2}}});
    session.document.changer().insert(insertion);
    session.wait();
    QCOMPARE(refused.size(), 1);
    QCOMPARE(session.state(), start);
}

void TestDocumentModel::insert_tellsWhatWasLeftOut()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("tiny.obj"));
    core::writeMesh(path.toStdString(), core::icosphere(1, 0.5));
    QFile file(path);
    QVERIFY(file.open(QIODevice::Append) && file.write("mtllib gold.mtl\nusemtl gold\n") > 0);
    file.close();
    ViewedSession session;
    QSignalSpy noticed(&session.document, &Document::noticed);
    session.document.changer().insert({path, core::Insert::Place::Beside});
    session.wait();
    QCOMPARE(noticed.size(), 1);
    QVERIFY(noticed[0][0].toString().contains(QStringLiteral("materials")));
    QVERIFY(noticed[0][0].toString().contains(QStringLiteral("in millimetres")));
}

void TestDocumentModel::insert_takesTheUnit()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("inch.stl"));
    core::writeMesh(path.toStdString(), shapes::cube(1));
    ViewedSession session;
    QSignalSpy noticed(&session.document, &Document::noticed), refused(&session.document, &Document::refused);
    session.document.changer().insert(
        {.path = path, .place = core::Insert::Place::Centre, .centre = {80, 0, 0}, .unit = 25.4});
    session.wait();
    QVERIFY(noticed.isEmpty()); // an explicit unit is not questioned
    QTRY_VERIFY(std::abs(session.document.modelInfo().box.max().x() - (80 + 12.7)) < 1e-3);
    session.document.history().undo();
    session.document.changer().insert({.path = path, .unit = 1e39});
    session.wait();
    QCOMPARE(refused.size(), 1);
    QVERIFY(refused[0][0].toString().contains(QStringLiteral("overflow")));
}

void TestDocumentModel::facts_followTheModel()
{
    ViewedSession session;
    QTRY_VERIFY(std::abs(session.document.modelInfo().area - 31400) < 200);
    const double detail = session.document.modelInfo().uniformDetail;
    QVERIFY(detail > 2 && detail < 3);
    session.apply(core::Scale{0.1});
    QTRY_VERIFY(std::abs(session.document.modelInfo().size.x() - 10) < 0.01);
    QTRY_VERIFY(std::abs(session.document.modelInfo().area - 314) < 2);
    QVERIFY(std::abs(session.document.modelInfo().uniformDetail - detail / 10) < 1e-9);
    session.document.history().undo();
    QTRY_VERIFY(std::abs(session.document.modelInfo().size.x() - 100) < 0.01);
}

void TestDocumentModel::progress_grows()
{
    ViewedSession session;
    double last = 0;
    int calls = 0;
    connect(&session.document.job(), &BackgroundJob::progressed, &session.document, [&](double share) {
        QVERIFY(share >= last && share <= 1);
        last = share;
        ++calls;
    });
    session.apply(core::RemeshUniformly{1});
    QVERIFY(calls > 5);
}

void TestDocumentModel::reset_isTheStartAndOneStep()
{
    ViewedSession session;
    const std::uint64_t start = session.state();
    QSignalSpy noticed(&session.document, &Document::noticed);
    session.apply(core::Reset{});
    QCOMPARE(noticed.size(), 1); // a notice reports that there is nothing to reset
    session.stroke({50, 0, 0});
    session.apply(core::Scale{40}); // the scaled model needs a coarser lattice
    session.stroke({0, 2000, 0});
    const std::uint64_t changed = session.state();
    session.apply(core::Reset{});
    QCOMPARE(session.state(), start);
    QCOMPARE(session.document.history().stack().count(), 4);
    session.document.history().undo();
    QCOMPARE(session.state(), changed);
    session.document.history().redo();
    QCOMPARE(session.state(), start);
    session.stroke({50, 0, 0});
    session.wait();
    QCOMPARE(session.document.history().stack().count(), 5);
}

void TestDocumentModel::spilledCommands_comeBack()
{
    ViewedSession session;
    session.document.history().store().setCap(1);
    std::vector<std::uint64_t> states = {session.state()};
    for (const core::ModelCommand& command :
         {core::ModelCommand(core::Scale{40}), core::ModelCommand(core::Mirror{2}),
          core::ModelCommand(core::RemeshUniformly{100}), core::ModelCommand(core::Fill{{9, 9, 9}})}) {
        session.apply(command);
        states.push_back(session.state());
    }
    QCOMPARE(session.document.history().stack().count(), 4);
    for (int i = 3; i >= 0; --i) {
        session.document.history().undo();
        QCOMPARE(session.state(), states[static_cast<std::size_t>(i)]);
    }
    for (int i = 1; i <= 4; ++i) {
        session.document.history().redo();
        QCOMPARE(session.state(), states[static_cast<std::size_t>(i)]);
    }
}

void TestDocumentModel::end_whileAChangeGoesOn()
{
    for (int i = 0; i < 3; ++i) {
        ViewedSession session;
        session.document.changer().apply(core::RemeshUniformly{0.8});
        if (i > 0)
            QTest::qWait(20 * i);
    }
}

void TestDocumentModel::opening_canBeStopped()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.ply"));
    core::writeMesh(path.toStdString(), core::icosphere(7, 10));
    ViewedSession session;
    const std::uint64_t before = session.state();
    QSignalSpy refused(&session.document, &Document::refused);
    session.document.opener().open(path);
    QVERIFY(session.document.job().isBusy());
    session.document.cancelJob();
    session.wait();
    QCOMPARE(session.state(), before);
    QVERIFY(refused.isEmpty());
    session.document.opener().open(path);
    session.wait();
    QCOMPARE(session.document.modelInfo().faces, quint64(327680));
}

FETTLE_TEST(TestDocumentModel, QCoreApplication)
#include "tst_document_model.moc"
