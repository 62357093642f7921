#include "app/headset/headset.h"
#include "app/headset/headset_settings.h"

#include "core/io/mesh_io.h"
#include "tests/support/program_driver.h"
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

/// The program with a model of a file, and somebody in the headset.
struct Visit
{
    explicit Visit(const QString& path)
    {
        program.window.viewport()->setMaximumSize(240, 180); // nobody looks at it
        program.window.resize(640, 480);
        program.window.show();
        if (path.isEmpty())
            program.document.openSphere();
        else
            program.document.open(path);
        wait();
        port = desk.open();
    }

    void wait()
    {
        const auto isDone = [this] { return !program.document.isBusy() && program.document.isSettled(); };
        QTRY_VERIFY_WITH_TIMEOUT(program.document.facts().faces > 0 && isDone(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!program.document.isBusy(), 60'000);
        QCoreApplication::processEvents();
    }

    void request(const vr::DocumentRequest& wish)
    {
        port->request(wish);
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

    std::uint64_t hash()
    {
        std::optional<std::uint64_t> answer;
        ui::ThreadMailbox mail;
        program.worker.post([&](core::Sculptor& sculptor) {
            mail.post([&answer, value = sculptor.mesh().meshHash()] { answer = value; });
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answer, 60'000); }();
        return answer.value_or(0);
    }

    /// Vertices.
    std::size_t masked()
    {
        std::optional<std::size_t> answer;
        ui::ThreadMailbox mail;
        program.worker.post([&](core::Sculptor& sculptor) {
            std::size_t count = 0;
            for (core::Slot v = 0; v < sculptor.mesh().slots().vertices; ++v)
                count += sculptor.mesh().isVertex(v) && sculptor.mesh().isMasked(v) ? 1 : 0;
            mail.post([&answer, count] { answer = count; });
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answer, 60'000); }();
        return answer.value_or(0);
    }

    vr::DocumentUpdate news()
    {
        QCoreApplication::processEvents();
        if (auto next = port->takeUpdate())
            last = *next;
        return last;
    }

    Program program;
    HeadsetDesk desk{{&program.document, &program.worker, &program.window}};
    std::shared_ptr<HeadsetPort> port;
    vr::DocumentUpdate last;
};
} // namespace

class TestHeadsetWishes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void news_areWholeAtFirst();
    void save_writesANumberedPair();
    void save_ofAModelWithoutAFile();
    void save_whereNothingFits();
    void save_whereOnlyTheFirstFits();
    void open_lettingChangesGo();
    void open_wouldLoseChanges();
    void open_ofAModelThatNeedsMending();
    void open_whileBusy();
    void restore_isUndoable();
    void mask_isInvertedAndCleared();
    void class_hasItsToolsAndNoFiles();
    void undoAndRedo_fromBothSides();
    void brush_fromTheHeadset();
    void brush_fromTheWindow();
    void look_fromTheWindow();
    void choice_isKept();
    void files_comeWithPictures();
    void presence_isSeen();
    void close_doesWhatWasWished();
    void headset_thatIsNotThereSaysSo();

public:
    static inline const places::SmallDisk* disk = nullptr; ///< mounted by main()

private:
    QString at(const char* name) const { return m_folder->filePath(QLatin1StringView(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestHeadsetWishes::init()
{
    ui::Settings().reset();
    m_folder = std::make_unique<QTemporaryDir>();
    core::writeMesh(at("vase.glb").toStdString(), core::icosphere(4, 50));
}

void TestHeadsetWishes::news_areWholeAtFirst()
{
    Visit visit(at("vase.glb"));
    const auto news = visit.port->takeUpdate();
    QVERIFY(news);
    QVERIFY(news->box.sizes().isApprox(core::Vec3(100, 100, 100), 0.02));
    QVERIFY(news->shading == ui::shadingOf(visit.program.window.viewport()->appearance().material));
    QVERIFY(!news->canUndo && !news->canRedo && !news->isModified && !news->isBusy);
    QCOMPARE(news->plane, core::Symmetry::Y);
    QVERIFY(!news->swatches.isEmpty());
    QCOMPARE(news->folder, QDir(m_folder->path()).dirName());
    visit.stroke({50, 0, 0});
    QVERIFY(visit.news().canUndo && visit.news().isModified);
}

void TestHeadsetWishes::save_writesANumberedPair()
{
    Visit visit(at("vase.glb"));
    const QByteArray first = bytesOf(at("vase.glb"));
    visit.stroke({50, 0, 0});
    visit.request(vr::SaveModel());
    QTRY_VERIFY_WITH_TIMEOUT(!visit.program.document.isModified(), 60'000);
    QCOMPARE(visit.program.document.path(), at("vase-001.glb"));
    QCOMPARE(visit.news().saved, QStringLiteral("vase-001.glb"));
    QVERIFY(visit.news().notice.contains(QStringLiteral("vase-001.stl")));
    QCOMPARE(bytesOf(at("vase.glb")), first);
    const core::TriangleMesh glb = core::readMesh(at("vase-001.glb").toStdString()),
                             stl = core::readMesh(at("vase-001.stl").toStdString());
    QCOMPARE(glb.triangles.size(), stl.triangles.size());
    QCOMPARE(visit.program.document.facts().faces, quint64(glb.triangles.size()));

    core::writeMesh(at("vase-007.stl").toStdString(), core::icosphere(1, 50));
    const QByteArray others = bytesOf(at("vase-007.stl")), second = bytesOf(at("vase-001.glb"));
    visit.request(vr::SaveModel());
    QTRY_COMPARE_WITH_TIMEOUT(visit.program.document.path(), at("vase-008.glb"), 60'000);
    QVERIFY(QFile::exists(at("vase-008.stl")));
    QCOMPARE(bytesOf(at("vase-007.stl")), others);
    QCOMPARE(bytesOf(at("vase-001.glb")), second);
}

void TestHeadsetWishes::save_ofAModelWithoutAFile()
{
    ui::Settings().setLastFolder(m_folder->path());
    Visit visit({});
    visit.request(vr::SaveModel());
    QTRY_COMPARE_WITH_TIMEOUT(visit.program.document.path(), m_folder->filePath(visit.news().saved), 60'000);
    QVERIFY(visit.news().saved.endsWith(QStringLiteral("-001.glb")));
    QCOMPARE(QDir(m_folder->path()).entryList({QStringLiteral("*-001.*")}).size(), 2);
}

void TestHeadsetWishes::save_whereNothingFits()
{
    if (!disk->isThere())
        QSKIP("no disk can be mounted here");
    const QString folder = QString::fromStdString(disk->folder().string());
    disk->fill();
    ui::Settings().setLastFolder(folder);
    Visit visit({});
    visit.stroke({50, 0, 0});
    const QSignalSpy refused(&visit.program.document, &Document::refused);
    visit.request(vr::SaveModel());
    QTRY_COMPARE_WITH_TIMEOUT(refused.size(), 1, 60'000);
    QCOMPARE(visit.news().notice, refused[0][0].toString());
    QVERIFY(visit.news().notice.contains(QStringLiteral("-001.glb")) && visit.news().saved.isEmpty());
    QVERIFY(visit.program.document.isModified() && visit.program.document.path().isEmpty());
    QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden), QStringList{QStringLiteral("filler")});
    QFile::remove(folder + QStringLiteral("/filler"));
}

void TestHeadsetWishes::save_whereOnlyTheFirstFits()
{
    if (!disk->isThere())
        QSKIP("no disk can be mounted here");
    ui::Settings().setLastFolder(QString::fromStdString(disk->folder().string()));
    Visit visit({});
    visit.stroke({50, 0, 0});
    visit.request(vr::SaveModel());
    QTRY_VERIFY_WITH_TIMEOUT(!visit.program.document.isModified(), 60'000);
    const QStringList files = QFileInfo(visit.program.document.path()).dir().entryList(QDir::Files | QDir::Hidden);
    QCOMPARE(files, QStringList{visit.news().saved});
    QVERIFY(visit.news().notice.contains(files[0]) && visit.news().notice.contains(QStringLiteral(".stl")));
    QFile::remove(visit.program.document.path());
}

void TestHeadsetWishes::open_lettingChangesGo()
{
    core::writeMesh(at("cup.stl").toStdString(), core::icosphere(2, 20));
    Visit visit(at("vase.glb"));
    const quint64 model = visit.news().model;
    visit.stroke({50, 0, 0});
    visit.request(vr::OpenModel{at("cup.stl"), true});
    QTRY_COMPARE_WITH_TIMEOUT(visit.program.document.path(), at("cup.stl"), 60'000);
    QVERIFY(!visit.program.document.isModified());
    QVERIFY(visit.news().model > model);
    QVERIFY(visit.news().box.sizes().isApprox(core::Vec3(40, 40, 40), 0.1));
    visit.request(vr::OpenModel{at("vase.glb")}); // there is nothing to lose
    QTRY_COMPARE_WITH_TIMEOUT(visit.program.document.path(), at("vase.glb"), 60'000);
    visit.stroke({50, 0, 0});
}

void TestHeadsetWishes::open_wouldLoseChanges()
{
    core::writeMesh(at("cup.stl").toStdString(), core::icosphere(2, 20));
    Visit visit(at("vase.glb"));
    const QSignalSpy noticed(&visit.desk, &HeadsetDesk::noticed);
    visit.port->beginStroke({});
    core::StrokeSample sample;
    sample.position = {50, 0, 0};
    visit.port->addSample(sample);
    visit.port->endStroke();
    visit.request(vr::OpenModel{at("cup.stl")}); // right after the stroke
    QTRY_COMPARE_WITH_TIMEOUT(noticed.size(), 1, 60'000);
    QVERIFY(visit.news().notice.contains(QStringLiteral("cup.stl")));
    QCOMPARE(visit.program.document.path(), at("vase.glb"));
    QCOMPARE(visit.program.document.undoStack().count(), 1);
    visit.stroke({0, 50, 0});
    QCOMPARE(visit.program.document.undoStack().count(), 2);
}

void TestHeadsetWishes::open_ofAModelThatNeedsMending()
{
    QFile open(at("open.obj"));
    QVERIFY(open.open(QIODevice::WriteOnly));
    open.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    open.close();
    Visit visit(at("vase.glb"));
    const QSignalSpy mendable(&visit.program.document, &Document::mendable);
    visit.request(vr::OpenModel{at("open.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(mendable.size(), 1, 60'000);
    QVERIFY(visit.news().notice.startsWith(mendable[0][1].toString()));
    QCOMPARE(visit.program.document.path(), at("vase.glb"));
    visit.stroke({50, 0, 0});
}

void TestHeadsetWishes::open_whileBusy()
{
    Visit visit(at("vase.glb"));
    visit.program.document.exportTo(at("vase.stl"));
    visit.port->request(vr::OpenModel{at("vase.glb")});
    visit.port->request(vr::SaveModel());
    visit.port->request(vr::RestoreModel());
    visit.port->request(core::MaskOperation{});
    QVERIFY(visit.program.document.isBusy());
    const QSignalSpy noticed(&visit.desk, &HeadsetDesk::noticed);
    QTRY_COMPARE_WITH_TIMEOUT(noticed.size(), 4, 60'000);
    visit.wait();
    QCOMPARE(visit.program.document.path(), at("vase.glb"));
    QCOMPARE(visit.program.document.undoStack().count(), 0);
}

void TestHeadsetWishes::class_hasItsToolsAndNoFiles()
{
    Visit visit(at("vase.glb"));
    visit.stroke({50, 0, 0});
    const std::uint64_t hash = visit.hash();
    const QStringList files = QDir(m_folder->path()).entryList(QDir::Files);
    visit.program.window.setClassroom(
        {QStringLiteral("5b"), m_folder->path(), {core::Starter::Ball}, {core::Tool::Clay, core::Tool::Pull}});
    const std::pair<vr::DocumentRequest, const char*> wishes[] = {
        {vr::SaveModel(), "Next Pupil"}, {vr::OpenModel{at("vase.glb"), true}, "vase.glb was not opened"}};
    for (const auto& [wish, word] : wishes) {
        visit.wish(wish);
        QVERIFY2(visit.news().notice.contains(QLatin1StringView(word)), qPrintable(visit.news().notice));
    }
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), files);
    QCOMPARE(visit.hash(), hash);
    const quint64 told = visit.news().brushChange;
    vr::ChooseBrush other{visit.program.window.strokeSettings()};
    other.brush.tool = core::Tool::Stamp;
    visit.wish(other);
    QVERIFY(visit.news().brushChange > told && visit.news().brush.tool == core::Tool::Clay); // it hears which there is
    other.brush.tool = core::Tool::Pull;
    visit.wish(other);
    QCOMPARE(visit.program.window.strokeSettings().tool, core::Tool::Pull);
}

void TestHeadsetWishes::restore_isUndoable()
{
    Visit visit(at("vase.glb"));
    const std::uint64_t before = visit.hash();
    visit.stroke({50, 0, 0});
    const std::uint64_t changed = visit.hash();
    visit.request(vr::RestoreModel());
    QTRY_COMPARE_WITH_TIMEOUT(visit.program.document.undoStack().count(), 2, 60'000);
    QCOMPARE(visit.hash(), before);
    visit.request(vr::Undo());
    QCOMPARE(visit.hash(), changed);
}

/// Each a step; that there is nothing to clear is told in the headset, too.
void TestHeadsetWishes::mask_isInvertedAndCleared()
{
    using How = core::MaskOperation::Kind;
    Visit visit(at("vase.glb"));
    QCOMPARE(visit.masked(), std::size_t(0));
    visit.wish(core::MaskOperation{How::Invert});
    QCOMPARE(visit.masked(), std::size_t(visit.program.document.facts().vertices));
    visit.wish(core::MaskOperation{How::Clear});
    QCOMPARE(visit.masked(), std::size_t(0));
    QCOMPARE(visit.program.document.undoStack().count(), 2);
    visit.request(vr::Undo());
    QCOMPARE(visit.masked(), std::size_t(visit.program.document.facts().vertices));
    visit.request(vr::Undo());
    const quint64 notices = visit.news().noticeCount;
    visit.wish(core::MaskOperation{How::Clear});
    QTRY_VERIFY(visit.news().noticeCount > notices && !visit.news().notice.isEmpty());
    QCOMPARE(visit.program.document.undoStack().index(), 0);
}

void TestHeadsetWishes::undoAndRedo_fromBothSides()
{
    Visit visit(at("vase.glb"));
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
    QVERIFY(visit.news().canRedo && !visit.news().canUndo);
    visit.request(vr::Redo());
    visit.program.window.action(QStringLiteral("edit.redo"))->trigger();
    visit.wait();
    QCOMPARE(visit.hash(), two);
}

void TestHeadsetWishes::brush_fromTheHeadset()
{
    Visit visit(at("vase.glb"));
    const ui::BrushSettings& brush = *visit.program.window.brush();
    const core::StrokeSettings before = brush.stroke();
    const quint64 changes = visit.news().brushChange;
    vr::ChooseBrush wish{before};
    wish.brush.tool = core::Tool::Paint;
    wish.brush.brush = core::BrushShape::Ray;
    wish.brush.topology = core::Topology::Uniform;
    wish.brush.symmetry = core::Symmetry::Y;
    wish.brush.radial = 5;
    wish.brush.color = {1, 2, 3};
    wish.brush.strength = 7;
    visit.wish(wish);
    QTRY_COMPARE_WITH_TIMEOUT(brush.tool(), core::Tool::Paint, 60'000);
    QVERIFY(brush.stroke().brush == core::BrushShape::Ray && brush.stroke().topology == core::Topology::Uniform);
    QCOMPARE(brush.stroke().radial, 5);
    QVERIFY(brush.stroke().symmetry == core::Symmetry::Y && (brush.stroke().color == core::Rgb{1, 2, 3}));
    QVERIFY(brush.stroke().strength == before.strength && brush.stroke().radius == before.radius &&
            brush.stroke().place == before.place);
    const vr::DocumentUpdate news = visit.news();
    QCOMPARE(news.brushChange, changes);
    QCOMPARE(news.brush.tool, core::Tool::Paint);
}

void TestHeadsetWishes::brush_fromTheWindow()
{
    Visit visit(at("vase.glb"));
    ui::BrushSettings& brush = *visit.program.window.brush();
    const quint64 changes = visit.news().brushChange;
    brush.scaleRadius(0.9); // the headset has its own
    QCOMPARE(visit.news().brushChange, changes);
    brush.setTool(core::Tool::Smooth);
    brush.set(&core::StrokeSettings::symmetry, core::Symmetry::Z);
    const vr::DocumentUpdate news = visit.news();
    QVERIFY(news.brushChange > changes);
    QCOMPARE(news.brush.tool, core::Tool::Smooth);
    QCOMPARE(news.plane, core::Symmetry::Z);
    brush.setSymmetric(false);
    QCOMPARE(visit.news().plane, core::Symmetry::Z);
    const quint64 before = visit.news().brushChange;
    brush.set(&core::StrokeSettings::radial, 7);
    QVERIFY(visit.news().brushChange > before && visit.news().brush.radial == 7);
}

void TestHeadsetWishes::look_fromTheWindow()
{
    Visit visit(at("vase.glb"));
    visit.program.window.action(QStringLiteral("material.pearl"))->trigger();
    visit.program.window.action(QStringLiteral("view.flat"))->setChecked(true);
    QVERIFY(visit.news().shading == ui::shadingOf(ui::Material::Pearl));
    QVERIFY(visit.news().isFlat);
}

void TestHeadsetWishes::choice_isKept()
{
    Visit visit(at("vase.glb"));
    QVERIFY(HeadsetSettings().choice() == vr::HeadsetSettings());
    vr::HeadsetSettings choice{{vr::ButtonPreset::Studio, vr::Side::Left}, -0.25, 60, false, true, {}};
    choice.hapticLevels.of = {0, 0.25, 0.5, 0.75, 1, 0.1};
    visit.wish(choice);
    QTRY_VERIFY_WITH_TIMEOUT(HeadsetSettings().choice() == choice, 60'000);
    QSettings().setValue(QStringLiteral("headset/raised"), QStringLiteral("a lot"));
    QSettings().setValue(QStringLiteral("headset/preset"), QStringLiteral("another"));
    QCOMPARE(HeadsetSettings().choice().heightOffset, 0.0);
    QCOMPARE(HeadsetSettings().choice().wands.preset, vr::ButtonPreset::Paper);
    QCOMPARE(HeadsetSettings().choice().wands.sculpting, vr::Side::Left);
}

void TestHeadsetWishes::files_comeWithPictures()
{
    core::writeMesh(at("cup.stl").toStdString(), core::icosphere(2, 20));
    QFile broken(at("broken.ply"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("ply\n") > 0);
    broken.close();
    QDir(m_folder->path()).mkdir(QStringLiteral("more.stl"));
    Visit visit(at("vase.glb"));
    const auto tile = [&](const char* name) {
        for (const vr::FileTile& file : visit.news().files)
            if (file.path == at(name) && file.name == QLatin1StringView(name))
                return file;
        return vr::FileTile();
    };
    QTRY_COMPARE_WITH_TIMEOUT(visit.news().files.size(), 3, 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(!tile("vase.glb").picture.isNull() && !tile("cup.stl").picture.isNull(), 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(tile("broken.ply").isBroken, 60'000);
    visit.request(vr::SaveModel());
    QTRY_COMPARE_WITH_TIMEOUT(visit.news().files.size(), 5, 60'000);
    QFile::remove(at("cup.stl"));
    QTRY_COMPARE_WITH_TIMEOUT(visit.news().files.size(), 4, 60'000);
}

void TestHeadsetWishes::presence_isSeen()
{
    Visit visit(at("vase.glb"));
    QList<std::optional<vr::AvatarState>> all;
    connect(&visit.desk, &HeadsetDesk::seen, this,
            [&](const std::optional<vr::AvatarState>& presence) { all << presence; });
    vr::AvatarState presence;
    for (int i = 1; i <= 50; ++i) {
        presence.model.translation().x() = i;
        visit.port->show(presence);
    }
    QTRY_COMPARE_WITH_TIMEOUT(all.size(), 1, 60'000);
    QCOMPARE(all[0]->model.translation().x(), 50.0);
    visit.desk.close();
    QCOMPARE(all.size(), 2);
    QVERIFY(!all[1]);
}

/// What was wished for and drawn last; then another visit.
void TestHeadsetWishes::close_doesWhatWasWished()
{
    Visit visit(at("vase.glb"));
    visit.stroke({50, 0, 0});
    visit.port->request(vr::Undo());
    core::StrokeSettings settings;
    settings.radius = 12;
    QVERIFY(visit.port->beginStroke(settings));
    core::StrokeSample sample;
    sample.position = {0, 50, 0};
    visit.port->addSample(sample);
    visit.desk.close();
    visit.wait();
    QCOMPARE(visit.program.worker.strokesBegun(), quint64(2));
    QCOMPARE(visit.program.document.undoStack().count(), 1);
    visit.port = visit.desk.open();
    visit.stroke({0, 0, 50});
    QCOMPARE(visit.program.document.undoStack().count(), 2);
    QVERIFY(visit.port->takePatch()->whole);
}

/// Each time anew, and a window that closes meanwhile waits for the end.
void TestHeadsetWishes::headset_thatIsNotThereSaysSo()
{
    qputenv("XR_RUNTIME_JSON", at("none.json").toLocal8Bit());
    Visit visit(at("vase.glb"));
    visit.desk.close();
    auto* headset = visit.program.window.findChild<Headset*>();
    QList<vr::HeadsetReport> reports;
    connect(headset, &Headset::reported, this, [&](const vr::HeadsetReport& report) { reports << report; });
    for (int i = 0; i < 3; ++i) {
        reports.clear();
        visit.program.window.action(QStringLiteral("vr.enter"))->trigger();
        QVERIFY(headset->isIn());
        QTRY_VERIFY_WITH_TIMEOUT(!reports.isEmpty() && reports.last().isEnded(), 60'000);
        QVERIFY(!headset->isIn() && reports.last().end == vr::HeadsetEnd::Unavailable);
        QCOMPARE(notice(visit.program), reports.last().text);
    }
    headset->enter();
    visit.program.window.close();
    QVERIFY(visit.program.window.isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!visit.program.window.isVisible(), 60'000);
    QVERIFY(!headset->isIn());
}

int main(int argc, char* argv[])
{
    const QTemporaryDir folder;
    const places::SmallDisk disk(folder.filePath(QStringLiteral("small")).toStdString(), 200);
    TestHeadsetWishes::disk = &disk;
    return runOnScreen<TestHeadsetWishes>(argc, argv, "tst_headset_wishes");
}
#include "tst_headset_controller_requests.moc"
