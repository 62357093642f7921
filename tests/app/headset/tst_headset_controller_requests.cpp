#include "app/headset/headset.h"
#include "app/headset/headset_settings_store.h"

#include "core/io/mesh_io.h"
#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"
#include "ui/scene/materials.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace app;

namespace
{
QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The program with a model from a file, and a user in the headset.
struct ControllerVisit
{
    explicit ControllerVisit(const QString& path)
    {
        program.window.viewport()->setMaximumSize(240, 180); // small, because no test looks at it
        program.window.resize(640, 480);
        program.window.show();
        if (path.isEmpty())
            program.document.opener().openBall();
        else
            program.document.opener().open(path);
        wait();
        port = controller.open();
    }

    void wait()
    {
        const auto isDone = [this] { return !program.document.job().isBusy() && program.document.queue().isSettled(); };
        QTRY_VERIFY(program.document.modelInfo().faces > 0 && isDone());
        QTRY_VERIFY(!program.document.job().isBusy());
        QCoreApplication::processEvents();
    }

    void request(const vr::DocumentRequest& request)
    {
        port->request(request);
        QCoreApplication::processEvents();
        wait();
    }

    void stroke(const core::Vec3& where)
    {
        core::StrokeSettings settings;
        settings.radius = 12;
        QVERIFY(port->beginStroke(settings));
        core::StrokeSample sample;
        sample.position = where;
        port->addSample(sample);
        port->endStroke();
        wait();
    }

    std::uint64_t hash() { return meshHash(program.worker); }

    /// Returns the number of masked vertices.
    std::size_t masked()
    {
        return ask(program.worker, [](core::Sculptor& sculptor) {
            std::size_t count = 0;
            for (core::Slot v = 0; v < sculptor.mesh().slots().vertices; ++v)
                count += sculptor.mesh().isVertex(v) && sculptor.mesh().isMasked(v) ? 1 : 0;
            return count;
        });
    }

    vr::DocumentUpdate update()
    {
        QCoreApplication::processEvents();
        if (auto next = port->takeUpdate())
            last = *next;
        return last;
    }

    Program program;
    HeadsetController controller{{&program.document, &program.worker, &program.window}};
    std::shared_ptr<HeadsetPort> port;
    vr::DocumentUpdate last;
};
} // namespace

class TestHeadsetControllerRequests : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void update_isWholeAtFirst();
    void save_writesANumberedPair();
    void save_ofAModelWithoutAFile();
    void save_whereNothingFits();
    void save_whereOnlyTheFirstFits();
    void open_lettingChangesGo();
    void open_wouldLoseChanges();
    void open_ofAModelThatNeedsRepair();
    void open_whileBusy();
    void restore_isUndoable();
    void mask_isInvertedAndCleared();
    void class_hasItsToolsAndNoFiles();
    void undoAndRedo_fromBothSides();
    void brush_fromTheHeadset();
    void brush_fromTheWindow();
    void look_fromTheWindow();
    void settings_areKept();
    void files_comeWithPictures();
    void avatar_isSeen();
    void close_doesWhatWasRequested();
    void headset_thatIsNotThereSaysSo();

public:
    static inline const places::SmallDisk* disk = nullptr; ///< small disk, mounted by main()

private:
    QString at(const char* name) const { return m_folder->filePath(QLatin1StringView(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestHeadsetControllerRequests::init()
{
    ui::Settings().reset();
    m_folder = std::make_unique<QTemporaryDir>();
    core::writeMesh(at("vase.glb").toStdString(), core::icosphere(4, 50));
}

void TestHeadsetControllerRequests::update_isWholeAtFirst()
{
    ControllerVisit visit(at("vase.glb"));
    const auto update = visit.port->takeUpdate();
    QVERIFY(update);
    QVERIFY(update->box.sizes().isApprox(core::Vec3(100, 100, 100), 0.02));
    QVERIFY(update->shading == ui::shadingOf(visit.program.window.viewport()->appearance().material));
    QVERIFY(!update->canUndo && !update->canRedo && !update->isModified && !update->isBusy);
    QVERIFY(!update->plane);
    QVERIFY(!update->swatches.isEmpty());
    QCOMPARE(update->folder, QDir(m_folder->path()).dirName());
    visit.stroke({50, 0, 0});
    QVERIFY(visit.update().canUndo && visit.update().isModified);
}

void TestHeadsetControllerRequests::save_writesANumberedPair()
{
    ControllerVisit visit(at("vase.glb"));
    const QByteArray first = bytesOf(at("vase.glb"));
    visit.stroke({50, 0, 0});
    visit.request(vr::SaveModel());
    QTRY_VERIFY(!visit.program.document.savedState().isModified());
    QCOMPARE(visit.program.document.modelInfo().path, at("vase-001.glb"));
    QCOMPARE(visit.update().saved, QStringLiteral("vase-001.glb"));
    QVERIFY(visit.update().notice.contains(QStringLiteral("vase-001.stl")));
    QCOMPARE(bytesOf(at("vase.glb")), first);
    const core::TriangleMesh glb = core::readMesh(at("vase-001.glb").toStdString()),
                             stl = core::readMesh(at("vase-001.stl").toStdString());
    QCOMPARE(glb.triangles.size(), stl.triangles.size());
    QCOMPARE(visit.program.document.modelInfo().faces, quint64(glb.triangles.size()));

    core::writeMesh(at("vase-007.stl").toStdString(), core::icosphere(1, 50));
    const QByteArray others = bytesOf(at("vase-007.stl")), second = bytesOf(at("vase-001.glb"));
    visit.request(vr::SaveModel());
    QTRY_COMPARE(visit.program.document.modelInfo().path, at("vase-008.glb"));
    QVERIFY(QFile::exists(at("vase-008.stl")));
    QCOMPARE(bytesOf(at("vase-007.stl")), others);
    QCOMPARE(bytesOf(at("vase-001.glb")), second);
}

void TestHeadsetControllerRequests::save_ofAModelWithoutAFile()
{
    ui::Settings().set(&ui::Setting::lastFolder, m_folder->path());
    ControllerVisit visit({});
    visit.request(vr::SaveModel());
    QTRY_COMPARE(visit.program.document.modelInfo().path, m_folder->filePath(visit.update().saved));
    QVERIFY(visit.update().saved.endsWith(QStringLiteral("-001.glb")));
    QCOMPARE(QDir(m_folder->path()).entryList({QStringLiteral("*-001.*")}).size(), 2);
}

void TestHeadsetControllerRequests::save_whereNothingFits()
{
    if (!disk->isThere())
        QSKIP("no disk can be mounted here");
    const QString folder = QString::fromStdString(disk->folder().string());
    disk->fill();
    ui::Settings().set(&ui::Setting::lastFolder, folder);
    ControllerVisit visit({});
    visit.stroke({50, 0, 0});
    const QSignalSpy refused(&visit.program.document, &Document::refused);
    visit.request(vr::SaveModel());
    QTRY_COMPARE(refused.size(), 1);
    QCOMPARE(visit.update().notice, refused[0][0].toString());
    QVERIFY(visit.update().notice.contains(QStringLiteral("-001.glb")) && visit.update().saved.isEmpty());
    QVERIFY(visit.program.document.savedState().isModified() && visit.program.document.modelInfo().path.isEmpty());
    QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden), QStringList{QStringLiteral("filler")});
    QFile::remove(folder + QStringLiteral("/filler"));
}

void TestHeadsetControllerRequests::save_whereOnlyTheFirstFits()
{
    if (!disk->isThere())
        QSKIP("no disk can be mounted here");
    ui::Settings().set(&ui::Setting::lastFolder, QString::fromStdString(disk->folder().string()));
    ControllerVisit visit({});
    visit.stroke({50, 0, 0});
    visit.request(vr::SaveModel());
    QTRY_VERIFY(!visit.program.document.savedState().isModified());
    const QStringList files =
        QFileInfo(visit.program.document.modelInfo().path).dir().entryList(QDir::Files | QDir::Hidden);
    QCOMPARE(files, QStringList{visit.update().saved});
    QVERIFY(visit.update().notice.contains(files[0]) && visit.update().notice.contains(QStringLiteral(".stl")));
    QFile::remove(visit.program.document.modelInfo().path);
}

void TestHeadsetControllerRequests::open_lettingChangesGo()
{
    core::writeMesh(at("cup.stl").toStdString(), core::icosphere(2, 20));
    ControllerVisit visit(at("vase.glb"));
    const quint64 model = visit.update().model;
    visit.stroke({50, 0, 0});
    visit.request(vr::OpenModel{at("cup.stl"), true});
    QTRY_COMPARE(visit.program.document.modelInfo().path, at("cup.stl"));
    QVERIFY(!visit.program.document.savedState().isModified());
    QVERIFY(visit.update().model > model);
    QVERIFY(visit.update().box.sizes().isApprox(core::Vec3(40, 40, 40), 0.1));
    visit.request(vr::OpenModel{at("vase.glb")}); // no question, because nothing is unsaved
    QTRY_COMPARE(visit.program.document.modelInfo().path, at("vase.glb"));
    visit.stroke({50, 0, 0});
}

void TestHeadsetControllerRequests::open_wouldLoseChanges()
{
    core::writeMesh(at("cup.stl").toStdString(), core::icosphere(2, 20));
    ControllerVisit visit(at("vase.glb"));
    const QSignalSpy noticed(&visit.controller, &HeadsetController::noticed);
    visit.port->beginStroke({});
    core::StrokeSample sample;
    sample.position = {50, 0, 0};
    visit.port->addSample(sample);
    visit.port->endStroke();
    visit.request(vr::OpenModel{at("cup.stl")}); // the request comes immediately after the stroke
    QTRY_COMPARE(noticed.size(), 1);
    QVERIFY(visit.update().notice.contains(QStringLiteral("cup.stl")));
    QCOMPARE(visit.program.document.modelInfo().path, at("vase.glb"));
    QCOMPARE(visit.program.document.history().stack().count(), 1);
    visit.stroke({0, 50, 0});
    QCOMPARE(visit.program.document.history().stack().count(), 2);
}

void TestHeadsetControllerRequests::open_ofAModelThatNeedsRepair()
{
    QFile open(at("open.obj"));
    QVERIFY(open.open(QIODevice::WriteOnly));
    open.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    open.close();
    ControllerVisit visit(at("vase.glb"));
    const QSignalSpy repairable(&visit.program.document.opener(), &ModelOpener::repairable);
    visit.request(vr::OpenModel{at("open.obj")});
    QTRY_COMPARE(repairable.size(), 1);
    QVERIFY(visit.update().notice.startsWith(repairable[0][1].toString()));
    QCOMPARE(visit.program.document.modelInfo().path, at("vase.glb"));
    visit.stroke({50, 0, 0});
}

void TestHeadsetControllerRequests::open_whileBusy()
{
    ControllerVisit visit(at("vase.glb"));
    visit.program.document.saver().exportTo(at("vase.stl"));
    visit.port->request(vr::OpenModel{at("vase.glb")});
    visit.port->request(vr::SaveModel());
    visit.port->request(vr::RestoreModel());
    visit.port->request(core::MaskOperation{});
    QVERIFY(visit.program.document.job().isBusy());
    const QSignalSpy noticed(&visit.controller, &HeadsetController::noticed);
    QTRY_COMPARE(noticed.size(), 4);
    visit.wait();
    QCOMPARE(visit.program.document.modelInfo().path, at("vase.glb"));
    QCOMPARE(visit.program.document.history().stack().count(), 0);
}

void TestHeadsetControllerRequests::class_hasItsToolsAndNoFiles()
{
    ControllerVisit visit(at("vase.glb"));
    visit.stroke({50, 0, 0});
    const std::uint64_t hash = visit.hash();
    const QStringList files = QDir(m_folder->path()).entryList(QDir::Files);
    visit.program.window.setClassroom(
        {QStringLiteral("5b"), m_folder->path(), {core::Starter::Ball}, {core::Tool::Clay, core::Tool::Pull}});
    const std::pair<vr::DocumentRequest, const char*> requests[] = {
        {vr::SaveModel(), "Next Pupil"}, {vr::OpenModel{at("vase.glb"), true}, "vase.glb was not opened"}};
    for (const auto& [request, word] : requests) {
        visit.request(request);
        QVERIFY2(visit.update().notice.contains(QLatin1StringView(word)), qPrintable(visit.update().notice));
    }
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), files);
    QCOMPARE(visit.hash(), hash);
    const quint64 told = visit.update().brushChange;
    vr::ChooseBrush other{visit.program.window.brush()->stroke()};
    other.brush.tool = core::Tool::Stamp;
    visit.request(other);
    QVERIFY(visit.update().brushChange > told &&
            visit.update().brush.tool == core::Tool::Clay); // the headset is told the tool that is in use
    other.brush.tool = core::Tool::Pull;
    visit.request(other);
    QCOMPARE(visit.program.window.brush()->stroke().tool, core::Tool::Pull);
}

void TestHeadsetControllerRequests::restore_isUndoable()
{
    ControllerVisit visit(at("vase.glb"));
    const std::uint64_t before = visit.hash();
    visit.stroke({50, 0, 0});
    const std::uint64_t changed = visit.hash();
    visit.request(vr::RestoreModel());
    QTRY_COMPARE(visit.program.document.history().stack().count(), 2);
    QCOMPARE(visit.hash(), before);
    visit.request(vr::Undo());
    QCOMPARE(visit.hash(), changed);
}

/// Each mask command is one step. The headset, too, is told if there is nothing to clear.
void TestHeadsetControllerRequests::mask_isInvertedAndCleared()
{
    using How = core::MaskOperation::Kind;
    ControllerVisit visit(at("vase.glb"));
    QCOMPARE(visit.masked(), std::size_t(0));
    visit.request(core::MaskOperation{How::Invert});
    QCOMPARE(visit.masked(), std::size_t(visit.program.document.modelInfo().vertices));
    visit.request(core::MaskOperation{How::Clear});
    QCOMPARE(visit.masked(), std::size_t(0));
    QCOMPARE(visit.program.document.history().stack().count(), 2);
    visit.request(vr::Undo());
    QCOMPARE(visit.masked(), std::size_t(visit.program.document.modelInfo().vertices));
    visit.request(vr::Undo());
    const quint64 notices = visit.update().noticeCount;
    visit.request(core::MaskOperation{How::Clear});
    QTRY_VERIFY(visit.update().noticeCount > notices && !visit.update().notice.isEmpty());
    QCOMPARE(visit.program.document.history().stack().index(), 0);
}

void TestHeadsetControllerRequests::undoAndRedo_fromBothSides()
{
    ControllerVisit visit(at("vase.glb"));
    const std::uint64_t before = visit.hash();
    visit.stroke({50, 0, 0});
    const std::uint64_t one = visit.hash();
    visit.stroke({0, 50, 0});
    const std::uint64_t two = visit.hash();
    visit.request(vr::Undo());
    QCOMPARE(visit.hash(), one);
    visit.program.window.action(QStringLiteral("edit.undo"))->trigger();
    visit.wait();
    QCOMPARE(visit.hash(), before);
    QVERIFY(visit.update().canRedo && !visit.update().canUndo);
    visit.request(vr::Redo());
    visit.program.window.action(QStringLiteral("edit.redo"))->trigger();
    visit.wait();
    QCOMPARE(visit.hash(), two);
}

void TestHeadsetControllerRequests::brush_fromTheHeadset()
{
    ControllerVisit visit(at("vase.glb"));
    const ui::BrushSettings& brush = *visit.program.window.brush();
    const core::StrokeSettings before = brush.stroke();
    const quint64 changes = visit.update().brushChange;
    vr::ChooseBrush request{before};
    request.brush.tool = core::Tool::Paint;
    request.brush.brush = core::BrushShape::Ray;
    request.brush.topology = core::Topology::Uniform;
    request.brush.symmetry = core::Symmetry::Y;
    request.brush.radial = 5;
    request.brush.color = {1, 2, 3};
    request.brush.strength = 7;
    visit.request(request);
    QTRY_COMPARE(brush.tool(), core::Tool::Paint);
    QVERIFY(brush.stroke().brush == core::BrushShape::Ray && brush.stroke().topology == core::Topology::Uniform);
    QCOMPARE(brush.stroke().radial, 5);
    QVERIFY(brush.stroke().symmetry == core::Symmetry::Y && (brush.stroke().color == core::Rgb{1, 2, 3}));
    QVERIFY(brush.stroke().strength == before.strength && brush.stroke().radius == before.radius &&
            brush.stroke().place == before.place);
    const vr::DocumentUpdate update = visit.update();
    QCOMPARE(update.brushChange, changes);
    QCOMPARE(update.brush.tool, core::Tool::Paint);
}

void TestHeadsetControllerRequests::brush_fromTheWindow()
{
    ControllerVisit visit(at("vase.glb"));
    ui::BrushSettings& brush = *visit.program.window.brush();
    const quint64 changes = visit.update().brushChange;
    brush.scaleRadius(0.9); // radius changes of the window do not affect the headset
    QCOMPARE(visit.update().brushChange, changes);
    brush.setTool(core::Tool::Smooth);
    brush.set(&core::StrokeSettings::symmetry, core::Symmetry::Z);
    const vr::DocumentUpdate update = visit.update();
    QVERIFY(update.brushChange > changes);
    QCOMPARE(update.brush.tool, core::Tool::Smooth);
    QVERIFY(update.plane == core::Symmetry::Z);
    brush.setSymmetric(false);
    QVERIFY(visit.update().plane == core::Symmetry::Z);
    const quint64 before = visit.update().brushChange;
    brush.set(&core::StrokeSettings::radial, 7);
    QVERIFY(visit.update().brushChange > before && visit.update().brush.radial == 7);
}

void TestHeadsetControllerRequests::look_fromTheWindow()
{
    ControllerVisit visit(at("vase.glb"));
    visit.program.window.action(QStringLiteral("material.pearl"))->trigger();
    visit.program.window.action(QStringLiteral("view.flat"))->setChecked(true);
    QVERIFY(visit.update().shading == ui::shadingOf(ui::Material::Pearl));
    QVERIFY(visit.update().isFlat);
    QVERIFY(visit.update().hasTint && !visit.update().hasCavity);
    visit.program.window.action(QStringLiteral("view.tint"))->setChecked(false);
    visit.program.window.action(QStringLiteral("view.cavity"))->setChecked(true);
    QVERIFY(!visit.update().hasTint && visit.update().hasCavity);
}

void TestHeadsetControllerRequests::settings_areKept()
{
    ControllerVisit visit(at("vase.glb"));
    QVERIFY(HeadsetSettingsStore().load() == vr::HeadsetSettings());
    vr::HeadsetSettings settings{{vr::ButtonPreset::Studio, vr::Side::Left}, -0.25, 60, false, true, true, {}};
    settings.hapticLevels.of = {0, 0.25, 0.5, 0.75, 1, 0.1};
    visit.request(settings);
    QTRY_VERIFY(HeadsetSettingsStore().load() == settings);
    QSettings().setValue(QStringLiteral("headset/raised"), QStringLiteral("a lot"));
    QSettings().setValue(QStringLiteral("headset/preset"), QStringLiteral("another"));
    QCOMPARE(HeadsetSettingsStore().load().heightOffset, 0.0);
    QCOMPARE(HeadsetSettingsStore().load().wands.preset, vr::ButtonPreset::Paper);
    QCOMPARE(HeadsetSettingsStore().load().wands.sculpting, vr::Side::Left);
}

void TestHeadsetControllerRequests::files_comeWithPictures()
{
    core::writeMesh(at("cup.stl").toStdString(), core::icosphere(2, 20));
    QFile broken(at("broken.ply"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("ply\n") > 0);
    broken.close();
    QDir(m_folder->path()).mkdir(QStringLiteral("more.stl"));
    ControllerVisit visit(at("vase.glb"));
    const auto tile = [&](const char* name) {
        for (const vr::FileTile& file : visit.update().files)
            if (file.path == at(name) && file.name == QLatin1StringView(name))
                return file;
        return vr::FileTile();
    };
    QTRY_COMPARE(visit.update().files.size(), 3);
    QTRY_VERIFY(!tile("vase.glb").picture.isNull() && !tile("cup.stl").picture.isNull());
    QTRY_VERIFY(tile("broken.ply").isBroken);
    visit.request(vr::SaveModel());
    QTRY_COMPARE(visit.update().files.size(), 5);
    QFile::remove(at("cup.stl"));
    QTRY_COMPARE(visit.update().files.size(), 4);
}

void TestHeadsetControllerRequests::avatar_isSeen()
{
    ControllerVisit visit(at("vase.glb"));
    QList<std::optional<vr::AvatarState>> all;
    connect(&visit.controller, &HeadsetController::avatarChanged, this,
            [&](const std::optional<vr::AvatarState>& presence) { all << presence; });
    vr::AvatarState presence;
    for (int i = 1; i <= 50; ++i) {
        presence.model.translation().x() = i;
        visit.port->show(presence);
    }
    QTRY_COMPARE(all.size(), 1);
    QCOMPARE(all[0]->model.translation().x(), 50.0);
    visit.controller.close();
    QCOMPARE(all.size(), 2);
    QVERIFY(!all[1]);
}

/// The last requests and strokes of a visit are carried out. Then a second visit is possible.
void TestHeadsetControllerRequests::close_doesWhatWasRequested()
{
    ControllerVisit visit(at("vase.glb"));
    visit.stroke({50, 0, 0});
    visit.port->request(vr::Undo());
    core::StrokeSettings settings;
    settings.radius = 12;
    QVERIFY(visit.port->beginStroke(settings));
    core::StrokeSample sample;
    sample.position = {0, 50, 0};
    visit.port->addSample(sample);
    visit.controller.close();
    visit.wait();
    QCOMPARE(visit.program.worker.strokes().begun(), quint64(2));
    QCOMPARE(visit.program.document.history().stack().count(), 1);
    visit.port = visit.controller.open();
    visit.stroke({0, 0, 50});
    QCOMPARE(visit.program.document.history().stack().count(), 2);
    QVERIFY(visit.port->takePatch()->whole);
}

/// Each failed attempt reports the error. A window closed meanwhile waits for the attempt to end.
void TestHeadsetControllerRequests::headset_thatIsNotThereSaysSo()
{
    qputenv("XR_RUNTIME_JSON", at("none.json").toLocal8Bit());
    ControllerVisit visit(at("vase.glb"));
    visit.controller.close();
    auto* headset = visit.program.window.findChild<Headset*>();
    QList<vr::HeadsetReport> reports;
    connect(headset, &Headset::reported, this, [&](const vr::HeadsetReport& report) { reports << report; });
    for (int i = 0; i < 3; ++i) {
        reports.clear();
        visit.program.window.action(QStringLiteral("vr.enter"))->trigger();
        QVERIFY(headset->isActive());
        QTRY_VERIFY(!reports.isEmpty() && reports.last().isEnded());
        QVERIFY(!headset->isActive() && reports.last().end == vr::HeadsetEnd::Unavailable);
        QCOMPARE(notice(visit.program), reports.last().text);
    }
    headset->enter();
    visit.program.window.close();
    QVERIFY(visit.program.window.isVisible());
    QTRY_VERIFY(!visit.program.window.isVisible());
    QVERIFY(!headset->isActive());
}

static int controllerRequestsMain(int argc, char* argv[])
{
    const QTemporaryDir folder;
    const places::SmallDisk disk(folder.filePath(QStringLiteral("small")).toStdString(), 800);
    TestHeadsetControllerRequests::disk = &disk;
    return test::run<TestHeadsetControllerRequests, app::OnScreen>(argc, argv);
}

FETTLE_TEST_MAIN(TestHeadsetControllerRequests, controllerRequestsMain)
#include "tst_headset_controller_requests.moc"
