#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "app/model/model_export.h"
#include "app/model/model_loader.h"

#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"
#include "core/sculpt/sculptor.h"
#include "ui/files/slicer.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QPointer>
#include <QProcess>
#include <QRadioButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace app;

namespace
{
constexpr int gapToCircle = 8;
const ModelExport::OnStage quiet = [](const QString&) {};

std::shared_ptr<core::Mesh> ball(double radius)
{
    return std::shared_ptr<core::Mesh>(core::buildMesh(core::icosphere(4, radius)).mesh);
}

template <class Widget> Widget* in(const QDialog* dialog, const char* name)
{
    return dialog->findChild<Widget*>(QLatin1StringView(name));
}
/// Puts a shell script on the PATH in place of a slicer, for the lifetime of the object.
class SlicerOnPath
{
public:
    explicit SlicerOnPath(const QByteArray& script) : m_before(qgetenv("PATH"))
    {
        QFile file(m_folder.filePath(QStringLiteral("prusa-slicer")));
        if (file.open(QIODevice::WriteOnly))
            file.write("#!/bin/sh\n" + script + "\n");
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("PATH", m_folder.path().toLocal8Bit() + ':' + m_before);
    }
    ~SlicerOnPath() { qputenv("PATH", m_before); }
    Q_DISABLE_COPY_MOVE(SlicerOnPath)

private:
    QTemporaryDir m_folder;
    QByteArray m_before;
};

/// Returns a request for two balls of radius 10, named Left and Right, as parts of one document.
ExportRequest requestOfTwo(const QString& path, float distance, bool isRightVisible = true)
{
    std::vector<core::PartPiece> pieces;
    for (const core::PartId part : {core::PartId(0), core::PartId(3)}) {
        pieces.push_back({part, core::icosphere(3, 10), {}, {}});
        for (core::Vec3f& p : pieces.back().mesh.points)
            p.x() += part == 0 ? 0 : distance;
    }
    core::MeshFrame named;
    named.parts =
        core::PartList({{0, "Left", true, false, std::nullopt}, {3, "Right", isRightVisible, false, std::nullopt}});
    ExportRequest request{path};
    request.mesh = core::buildMesh(core::joined(pieces), true, {}, named).mesh;
    request.metadata.frame = request.mesh->frame();
    return request;
}

/// Clicks the circle of a radio button, because the space right of its text is not clickable.
void press(QRadioButton* button)
{
    QTest::mouseClick(button, Qt::LeftButton, {}, {gapToCircle, button->height() / 2});
}
} // namespace

/// Tests that exported files are what the program reports them to be.
class TestModelExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void verdict_isOneLine_data();
    void verdict_isOneLine();
    void verdict_tellsWhatSlicersMisread();
    void damagedFile_isFound_data();
    void damagedFile_isFound();
    void stoppedInTime_writesNothing();
    void stoppedLater_isNotReadBack();
    void fewerTriangles_leaveTheModelAlone();
    void tooFewTriangles_areToldOf();
    void dialog_writesWhatItIsAskedFor();
    void dialog_presetsSetTheBudget();
    void dialog_comesBackAsItWasAgreedTo();
    void fewerTriangles_carryNoNotes_data();
    void fewerTriangles_carryNoNotes();
    void stop_endsAnExport();
    void slicer_tellsWhatItSays_data();
    void slicer_tellsWhatItSays();
    void slicer_thatHangsIsStopped();
    void parts_areJoinedForPrintIfTheyOverlap_data();
    void parts_areJoinedForPrintIfTheyOverlap();
    void parts_stayApartIfWished_data();
    void parts_stayApartIfWished();
    void parts_areSoundEvenIfTheyStayApart();
    void parts_thatDecimationMakesOverlapAreToldOf();
    void parts_areObjectsOfPrusaSlicer();
    void dialog_offersToUniteOverlappingParts();
    void parts_eachKeepTheirShareOfTriangles();
    void hiddenParts_areInGlbOnly_data();
    void hiddenParts_areInGlbOnly();
    void savedParts_openAgain();

private:
    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QTemporaryDir m_folder;
};

void TestModelExport::verdict_isOneLine_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view ending : core::writtenEndings())
        QTest::addRow("%s", ending.data())
            << QStringLiteral("ball.") + QLatin1StringView(ending.data(), static_cast<qsizetype>(ending.size()));
}

void TestModelExport::verdict_isOneLine()
{
    QFETCH(QString, name);
    const QString target = m_folder.filePath(name);
    const ExportOutcome outcome = ModelExport::run({target, 0, false, {}, ball(20)}, quiet, {});
    QVERIFY2(outcome.problem.isEmpty(), qPrintable(outcome.problem));
    QVERIFY2(outcome.verdict.startsWith(name) && outcome.verdict.contains(QStringLiteral("40.0 × 40.0 × 40.0 mm")) &&
                 outcome.verdict.contains(QStringLiteral("5,120 triangles")) &&
                 outcome.verdict.contains(QStringLiteral("watertight")),
             qPrintable(outcome.verdict));
    QVERIFY(!outcome.verdict.contains(u'\n') && !outcome.verdict.contains(QStringLiteral("inches")));
}

void TestModelExport::verdict_tellsWhatSlicersMisread()
{
    const ExportOutcome outcome = ModelExport::run({path("small.stl"), 0, false, {}, ball(1)}, quiet, {});
    QVERIFY2(outcome.verdict.contains(QStringLiteral("inches")), qPrintable(outcome.verdict));
}

void TestModelExport::damagedFile_isFound_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("at"); ///< offset of the byte that is inverted; -1: the file is deleted
    QTest::newRow("STL, a coordinate") << QStringLiteral("a.stl") << 84 + 12;
    QTest::newRow("STL, the count") << QStringLiteral("a.stl") << 80;
    QTest::newRow("PLY, a coordinate") << QStringLiteral("a.ply") << 400;
    QTest::newRow("GLB, the head") << QStringLiteral("a.glb") << 0;
    QTest::newRow("gone") << QStringLiteral("a.stl") << -1;
}

/// Damages the file between writing and verification, as a failing disk might.
void TestModelExport::damagedFile_isFound()
{
    QFETCH(QString, name);
    QFETCH(int, at);
    const QString target = m_folder.filePath(name);
    const auto damage = [&](const QString& what) {
        QFile file(target);
        if (!what.startsWith(QStringLiteral("Reading")))
            return;
        if (at < 0) {
            file.remove();
            return;
        }
        QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(at));
        char byte = 0;
        QVERIFY(file.getChar(&byte) && file.seek(at) && file.putChar(static_cast<char>(~byte)));
    };
    const ExportOutcome outcome = ModelExport::run({target, 0, false, {}, ball(20)}, damage, {});
    QVERIFY(outcome.verdict.isEmpty());
    QVERIFY2(outcome.problem.contains(target), qPrintable(outcome.problem));
}

void TestModelExport::stoppedInTime_writesNothing()
{
    std::stop_source stop;
    const core::JobControl control{stop.get_token(), [&](double) { stop.request_stop(); }};
    const ExportOutcome outcome = ModelExport::run({path("stopped.stl"), 200, false, {}, ball(20)}, quiet, control);
    QVERIFY(outcome.problem.isEmpty() && outcome.verdict.isEmpty());
    QVERIFY(!QFile::exists(path("stopped.stl")));
}

void TestModelExport::stoppedLater_isNotReadBack()
{
    std::stop_source stop;
    const auto onProgress = [&](const QString& what) {
        if (what.startsWith(QStringLiteral("Reading")))
            stop.request_stop();
    };
    const ExportOutcome outcome =
        ModelExport::run({path("later.stl"), 0, false, {}, ball(20)}, onProgress, {stop.get_token(), {}});
    QVERIFY2(outcome.verdict.contains(QStringLiteral("not verified")), qPrintable(outcome.verdict));
    QVERIFY(QFile::exists(path("later.stl")));
}

void TestModelExport::fewerTriangles_leaveTheModelAlone()
{
    Program program;
    sculptBall(program);
    const quint64 faces = program.document.modelInfo().faces;
    QSignalSpy exported(&program.document.saver(), &ModelSaver::exported);
    program.document.saver().exportTo(path("few.stl"), {.maxTriangles = 500});
    QTRY_COMPARE(exported.size(), 1);
    const core::TriangleMesh few = core::readMesh(path("few.stl").toStdString());
    QVERIFY(few.triangles.size() <= 500 && core::checkMesh(few).printReady());
    QCOMPARE(program.document.modelInfo().faces, faces);
    QVERIFY(program.document.savedState().isModified() && program.document.modelInfo().path.isEmpty());
}

void TestModelExport::tooFewTriangles_areToldOf()
{
    const auto ring = std::make_shared<core::Mesh>(std::move(*core::buildMesh(shapes::torus({30, 8, 48, 24})).mesh));
    const ExportOutcome outcome = ModelExport::run({path("ring.stl"), 8, false, {}, ring}, quiet, {});
    QVERIFY2(outcome.problem.isEmpty(), qPrintable(outcome.problem));
    QVERIFY2(outcome.verdict.contains(QStringLiteral("8 triangles were asked for")), qPrintable(outcome.verdict));
    const std::size_t written = core::readMesh(path("ring.stl").toStdString()).triangles.size();
    QVERIFY(written > 8 && outcome.verdict.contains(QStringLiteral("%1 triangles;").arg(written)));
}

void TestModelExport::dialog_writesWhatItIsAskedFor()
{
    Program program;
    sculptBall(program);
    QTest::keyClick(&program.window, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = program.window.findChild<QDialog*>(QStringLiteral("exportChoice"))) && dialog->isVisible());
    press(in<QRadioButton>(dialog, "glb"));
    auto* most = in<QSpinBox>(dialog, "most");
    QVERIFY(most->isEnabled());
    most->selectAll();
    QTest::keyClicks(most, QStringLiteral("321"));
    QTest::keyClick(most, Qt::Key_Return);
    chooseFile(program, "exportDialog", path("game")); // the file's ending comes from the preset
    QTRY_VERIFY2(notice(program).contains(QStringLiteral("watertight")), qPrintable(notice(program)));
    const core::TriangleMesh game = core::readMesh(path("game.glb").toStdString());
    QVERIFY(game.triangles.size() <= 321 && game.triangles.size() > 300);
    QVERIFY(notice(program).contains(QString::number(game.triangles.size())));
}

void TestModelExport::dialog_presetsSetTheBudget()
{
    QSettings().clear();
    Program program;
    sculptBall(program);
    program.window.action(QStringLiteral("file.exportFor"))->trigger();
    QDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = program.window.findChild<QDialog*>(QStringLiteral("exportChoice"))) && dialog->isVisible());
    const auto* limits = in<QCheckBox>(dialog, "limits");
    QVERIFY(in<QRadioButton>(dialog, "stl")->isChecked() && !limits->isChecked() &&
            !in<QSpinBox>(dialog, "most")->isEnabled());
    QTRY_VERIFY(in<QRadioButton>(dialog, "stl")->hasFocus());
    for (const char* name : {"stl", "3mf"})
        QTest::keyClick(in<QRadioButton>(dialog, name), Qt::Key_Down);
    QVERIFY(in<QRadioButton>(dialog, "glb")->isChecked());
    QTRY_VERIFY(limits->isChecked() && in<QSpinBox>(dialog, "most")->isEnabled());
    press(in<QRadioButton>(dialog, "3mf"));
    QVERIFY(!limits->isChecked());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!program.window.findChild<QDialog*>(QStringLiteral("exportChoice")));
    QVERIFY(!program.window.findChild<QDialog*>(QStringLiteral("exportDialog")));
}

/// The dialog remembers accepted settings, but not cancelled ones.
void TestModelExport::dialog_comesBackAsItWasAgreedTo()
{
    QSettings().clear();
    const SlicerOnPath slicer("exit 0");
    Program program;
    sculptBall(program);
    const auto ask = [&program]() -> QDialog* {
        program.window.action(QStringLiteral("file.exportFor"))->trigger();
        return program.window.findChild<QDialog*>(QStringLiteral("exportChoice"));
    };
    QPointer<QDialog> dialog = ask();
    QTRY_VERIFY(dialog && dialog->isVisible());
    press(in<QRadioButton>(dialog, "3mf"));
    QTest::keyClick(in<QCheckBox>(dialog, "slices"), Qt::Key_Space);
    QTest::keyClick(in<QCheckBox>(dialog, "limits"), Qt::Key_Space);
    in<QSpinBox>(dialog, "most")->selectAll();
    QTest::keyClicks(in<QSpinBox>(dialog, "most"), QStringLiteral("777"));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!dialog);
    dialog = ask();
    QTRY_VERIFY(dialog && dialog->isVisible());
    QVERIFY(in<QRadioButton>(dialog, "stl")->isChecked() && !in<QCheckBox>(dialog, "limits")->isChecked() &&
            !in<QCheckBox>(dialog, "slices")->isChecked());

    press(in<QRadioButton>(dialog, "3mf"));
    QTest::keyClick(in<QCheckBox>(dialog, "slices"), Qt::Key_Space);
    QTest::keyClick(in<QCheckBox>(dialog, "limits"), Qt::Key_Space);
    in<QSpinBox>(dialog, "most")->selectAll();
    QTest::keyClicks(in<QSpinBox>(dialog, "most"), QStringLiteral("777"));
    QTest::keyClick(in<QSpinBox>(dialog, "most"), Qt::Key_Return);
    chooseFile(program, "exportDialog", path("again.3mf"));
    QTRY_VERIFY(!program.document.job().isBusy() && QFile::exists(path("again.3mf")));
    dialog = ask();
    QTRY_VERIFY(dialog && dialog->isVisible());
    QVERIFY(in<QRadioButton>(dialog, "3mf")->isChecked() && in<QCheckBox>(dialog, "slices")->isChecked());
    QTRY_VERIFY(in<QRadioButton>(dialog, "3mf")->hasFocus());
    QVERIFY(in<QCheckBox>(dialog, "limits")->isChecked() && in<QSpinBox>(dialog, "most")->isEnabled());
    QCOMPARE(in<QSpinBox>(dialog, "most")->value(), 777);
    // slicing is disabled because no slicer reads GLB, but the choice is remembered
    press(in<QRadioButton>(dialog, "glb"));
    QVERIFY(!in<QCheckBox>(dialog, "slices")->isEnabled() && in<QCheckBox>(dialog, "slices")->isChecked());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!dialog);
}

void TestModelExport::fewerTriangles_carryNoNotes_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("most");
    QTest::addColumn<bool>("carries");
    QTest::newRow("all triangles") << QStringLiteral("all.glb") << quint64(0) << true;
    QTest::newRow("a budget that it keeps") << QStringLiteral("kept.glb") << quint64(1'000'000) << true;
    QTest::newRow("fewer triangles") << QStringLiteral("few.glb") << quint64(500) << false;
    QTest::newRow("fewer triangles, palette in a comment") << QStringLiteral("few.ply") << quint64(500) << false;
}

/// Lattice, view and brush belong to the full model, so a reduced export must not contain them.
void TestModelExport::fewerTriangles_carryNoNotes()
{
    QFETCH(QString, name);
    QFETCH(quint64, most);
    QFETCH(bool, carries);
    Program program;
    sculptBall(program);
    QSignalSpy exported(&program.document.saver(), &ModelSaver::exported);
    program.document.saver().exportTo(m_folder.filePath(name), {.maxTriangles = most});
    QTRY_COMPARE(exported.size(), 1);
    const std::filesystem::path file = m_folder.filePath(name).toStdString();
    const core::DocumentMetadata metadata = core::readMetadata(file);
    QCOMPARE(metadata.frame.has_value(), carries);
    QCOMPARE(metadata.view.has_value(), carries);
    QCOMPARE(metadata.brush.has_value(), carries);
    QCOMPARE(!metadata.palette.empty(), carries);
    QFile bytes(m_folder.filePath(name));
    QVERIFY(bytes.open(QIODevice::ReadOnly));
    const QByteArray all = bytes.readAll();
    QCOMPARE(all.contains("FETTLE_document"), carries);
    QCOMPARE(all.contains("extensionsUsed"), carries);
}

void TestModelExport::stop_endsAnExport()
{
    Program program;
    const QString large = path("large.ply");
    core::writeMesh(large.toStdString(), core::icosphere(7, 50)); // 327,680 triangles take seconds to export
    program.window.show();
    program.document.opener().open(large);
    QTRY_VERIFY(!program.document.job().isBusy() && program.document.modelInfo().path == large);
    QSignalSpy noticed(&program.document, &Document::noticed),
        progressed(&program.document.job(), &BackgroundJob::progressed);
    program.document.saver().exportTo(path("never.stl"), {.maxTriangles = 100});
    QTRY_VERIFY(!progressed.isEmpty());
    program.window.action(QStringLiteral("edit.stop"))->trigger();
    QTRY_VERIFY(!program.document.job().isBusy());
    QCOMPARE(noticed.size(), 1);
    QVERIFY(!QFile::exists(path("never.stl")));
}

void TestModelExport::slicer_tellsWhatItSays_data()
{
    QTest::addColumn<QByteArray>("program"); ///< called with --export-gcode --output G-CODE MODEL
    QTest::addColumn<QString>("said");
    QTest::newRow("slices")
        << QByteArray(
               "printf ';LAYER_CHANGE\\n;LAYER_CHANGE\\n; estimated printing time (normal mode) = 1h 2m\\n' > \"$3\"")
        << QStringLiteral("layers 2, time 1h\u00A02m");
    QTest::newRow("complains") << QByteArray(
                                      "echo first; echo 'All objects are outside of the print volume.' >&2; exit 1")
                               << QStringLiteral("All objects are outside of the print volume.");
    QTest::newRow("writes nothing") << QByteArray("echo done") << QStringLiteral("cannot slice it: done");
    QTest::newRow("crashes") << QByteArray("echo ouch; kill -SEGV $$") << QStringLiteral("cannot slice it: ouch");
}

/// The script on the PATH has the name of the slicer.
void TestModelExport::slicer_tellsWhatItSays()
{
    QFETCH(QByteArray, program);
    QFETCH(QString, said);
    const SlicerOnPath slicer(program);
    const ExportOutcome outcome = ModelExport::run({path("sliced.stl"), 0, true, {}, ball(20)}, quiet, {});
    QVERIFY2(outcome.verdict.contains(QStringLiteral("watertight")) && outcome.verdict.contains(said),
             qPrintable(outcome.verdict));
}

void TestModelExport::slicer_thatHangsIsStopped()
{
    const SlicerOnPath slicer("exec sleep 1000");
    std::stop_source stop;
    const auto onProgress = [&](const QString& what) {
        if (what.startsWith(QStringLiteral("Slicing")))
            stop.request_stop();
    };
    const ExportOutcome outcome =
        ModelExport::run({path("sliced.stl"), 0, true, {}, ball(20)}, onProgress, {stop.get_token(), {}});
    QVERIFY2(outcome.verdict.contains(QStringLiteral("was stopped")), qPrintable(outcome.verdict));
}

static int modelExportMain(int argc, char* argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    return test::run<TestModelExport, app::OnScreen>(argc, argv);
}

void TestModelExport::parts_areJoinedForPrintIfTheyOverlap_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<float>("distance");
    QTest::addColumn<std::size_t>("objects");
    const auto row = [](const char* name, float distance, std::size_t objects) {
        QTest::addRow("%s, %g mm apart", name, double(distance)) << QString::fromLatin1(name) << distance << objects;
    };
    constexpr float across = 15, apart = 30;
    row("a.stl", across, 1);
    row("a.3mf", across, 1);
    row("a.ply", across, 1);
    row("a.off", across, 1);
    row("a.obj", across, 2);
    row("a.glb", across, 2);
    row("b.3mf", apart, 2);
    row("b.stl", apart, 1);
}

void TestModelExport::parts_areJoinedForPrintIfTheyOverlap()
{
    QFETCH(QString, name);
    QFETCH(float, distance);
    QFETCH(std::size_t, objects);
    const ExportOutcome outcome = ModelExport::run(requestOfTwo(m_folder.filePath(name), distance), quiet, {});
    QVERIFY2(outcome.problem.isEmpty(), qPrintable(outcome.problem));
    const core::ReadResult read = core::readModel(m_folder.filePath(name).toStdString(), {.keepsObjects = true});
    QCOMPARE(read.parts.size(), objects);
    if (objects == 2)
        QVERIFY(read.parts.all()[0].name == "Left" && read.parts.all()[1].name == "Right");
    const core::MeshReport report = core::checkMesh(read.mesh);
    QVERIFY(report.printReady());
    const double one = *core::checkMesh(core::icosphere(3, 10)).volume;
    if (name.startsWith(QStringLiteral("a.")) && objects == 1)
        QVERIFY(*report.volume<1.99 * one&& * report.volume> 1.5 * one);
    else
        QVERIFY(std::abs(*report.volume - 2 * one) < 1e-3 * one);
}

void TestModelExport::parts_stayApartIfWished_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<std::size_t>("objects");
    QTest::newRow("one surface") << QStringLiteral("kept.stl") << std::size_t(1);
    QTest::newRow("objects") << QStringLiteral("kept.3mf") << std::size_t(2);
}

void TestModelExport::parts_stayApartIfWished()
{
    QFETCH(QString, name);
    QFETCH(std::size_t, objects);
    ExportRequest request = requestOfTwo(path(qPrintable(name)), 15);
    request.joinsParts = false;
    const std::size_t faces = request.mesh->live().faces;
    const ExportOutcome outcome = ModelExport::run(request, quiet, {});
    QVERIFY2(outcome.problem.isEmpty(), qPrintable(outcome.problem));
    QCOMPARE(outcome.verdict.contains(QStringLiteral("parts that overlap")), objects == 1);
    const core::ReadResult read = core::readModel(request.path.toStdString(), {.keepsObjects = true});
    QCOMPARE(read.parts.size(), objects);
    QCOMPARE(read.mesh.triangles.size(), faces);
}

/// Tests that a part that intersects itself is not excused by overlapping another part.
void TestModelExport::parts_areSoundEvenIfTheyStayApart()
{
    for (const float distance : {15.0f, 30.0f}) {
        ExportRequest request = requestOfTwo(path("unsound.stl"), distance);
        request.joinsParts = false;
        core::Mesh& mesh = *request.mesh;
        core::Slot left = 0;
        for (core::Slot v = 0; v < mesh.slots().vertices; ++v)
            left = mesh.point(v).x() < mesh.point(left).x() ? v : left;
        mesh.beginStroke();
        mesh.setPoint(left, mesh.lattice().snap(mesh.point(left).cast<double>() + core::Vec3(21, 0, 0)));
        mesh.endStroke();
        const ExportOutcome outcome = ModelExport::run(request, quiet, {});
        QVERIFY2(outcome.verdict.isEmpty(), qPrintable(outcome.verdict));
        QVERIFY2(outcome.problem.contains(QStringLiteral("intersect")), qPrintable(outcome.problem));
    }
}

/// Tests a ball in a shell with so little space between them that fewer triangles make them meet. The surface in the
/// file is not what was wished, although both parts are sound.
void TestModelExport::parts_thatDecimationMakesOverlapAreToldOf()
{
    core::TriangleMesh hollow = core::icosphere(4, 10.05);
    for (core::Triangle& t : hollow.triangles)
        std::swap(t[1], t[2]);
    core::MeshFrame named;
    named.parts = core::PartList({{0, "Ball", true, false, std::nullopt}, {1, "Shell", true, false, std::nullopt}});
    const core::TriangleMesh shell = core::joined({{1, core::icosphere(4, 14), {}, {}}, {1, hollow, {}, {}}});
    ExportRequest request{path("close.stl"), 300};
    request.mesh =
        core::buildMesh(core::joined({{0, core::icosphere(4, 10), {}, {}}, {1, shell, {}, {}}}), true, {}, named).mesh;
    QVERIFY(request.mesh);
    request.metadata.frame = request.mesh->frame();
    const ExportOutcome outcome = ModelExport::run(request, quiet, {});
    QVERIFY(!core::checkMesh(core::readMesh(request.path.toStdString())).printReady());
    QVERIFY2(outcome.verdict.isEmpty() && outcome.problem.contains(QStringLiteral("intersect")),
             qPrintable(outcome.verdict + outcome.problem));
}

/// Tests that a real slicer reads parts of a 3MF as objects of their own, where they were placed.
void TestModelExport::parts_areObjectsOfPrusaSlicer()
{
    if (ui::installedSlicer().isEmpty())
        QSKIP("PrusaSlicer is not installed");
    const ExportRequest request = requestOfTwo(path("placed.3mf"), 30);
    QVERIFY(ModelExport::run(request, quiet, {}).problem.isEmpty());
    QProcess slicer;
    slicer.start(ui::installedSlicer(), {QStringLiteral("--info"), request.path});
    QVERIFY(slicer.waitForFinished());
    QList<double> starts;
    for (const QByteArray& line : slicer.readAllStandardOutput().split('\n'))
        if (line.startsWith("min_x = "))
            starts << line.mid(8).toDouble();
    QCOMPARE(starts.size(), 2);
    QVERIFY(std::abs(std::abs(starts[1] - starts[0]) - 30) < 1e-3);
}

void TestModelExport::dialog_offersToUniteOverlappingParts()
{
    QSettings().clear();
    Program program;
    sculptBall(program);
    const auto ask = [&program] {
        program.window.action(QStringLiteral("file.exportFor"))->trigger();
        return QPointer(program.window.findChild<QDialog*>(QStringLiteral("exportChoice")));
    };
    QPointer<QDialog> dialog = ask();
    QTRY_VERIFY(dialog && dialog->isVisible());
    QTest::qWait(200);
    QVERIFY(!in<QCheckBox>(dialog, "joins")->isVisible()); // one part
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!dialog);

    program.window.action(QStringLiteral("parts.duplicate"))->trigger();
    QTRY_COMPARE(program.document.parts().list().size(), std::size_t(2));
    dialog = ask();
    QTRY_VERIFY(dialog && in<QCheckBox>(dialog, "joins")->isVisible());
    QVERIFY(in<QLabel>(dialog, "overlap")->isVisible());
    QVERIFY(in<QCheckBox>(dialog, "joins")->isEnabled() && in<QCheckBox>(dialog, "joins")->isChecked());
    const QString picture = qEnvironmentVariable("FETTLE_PICTURE");
    if (!picture.isEmpty())
        dialog->grab().save(picture);
    press(in<QRadioButton>(dialog, "glb"));
    QVERIFY(!in<QCheckBox>(dialog, "joins")->isEnabled());
    press(in<QRadioButton>(dialog, "stl"));
    QTest::keyClick(in<QCheckBox>(dialog, "joins"), Qt::Key_Space);
    QTest::keyClick(in<QSpinBox>(dialog, "most"), Qt::Key_Return);
    chooseFile(program, "exportDialog", path("double"));
    QTRY_VERIFY2(notice(program).contains(QStringLiteral("parts that overlap")), qPrintable(notice(program)));
    QCOMPARE(core::readMesh(path("double.stl").toStdString()).triangles.size(), program.document.modelInfo().faces);

    dialog = ask(); // the choice is remembered
    QTRY_VERIFY(dialog && in<QCheckBox>(dialog, "joins")->isVisible());
    QVERIFY(!in<QCheckBox>(dialog, "joins")->isChecked());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!dialog);
}

void TestModelExport::parts_eachKeepTheirShareOfTriangles()
{
    ExportRequest request = requestOfTwo(path("few.glb"), 15);
    request.maxTriangles = 600;
    const ExportOutcome outcome = ModelExport::run(std::move(request), quiet, {});
    QVERIFY2(outcome.problem.isEmpty(), qPrintable(outcome.problem));
    const core::ReadResult read = core::readModel(path("few.glb").toStdString());
    const auto pieces = core::splitByPart(read.mesh);
    QCOMPARE(pieces.size(), std::size_t(2));
    for (const core::PartPiece& piece : pieces)
        QVERIFY(piece.mesh.triangles.size() <= 300 && piece.mesh.triangles.size() > 200);
    QVERIFY(core::checkMesh(read.mesh).printReady());
    QCOMPARE(read.parts.all()[1].name, "Right");
}

void TestModelExport::hiddenParts_areInGlbOnly_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view ending : core::writtenEndings())
        QTest::addRow("%s", ending.data())
            << QStringLiteral("hidden.") + QLatin1StringView(ending.data(), static_cast<qsizetype>(ending.size()));
}

void TestModelExport::hiddenParts_areInGlbOnly()
{
    QFETCH(QString, name);
    const QString target = m_folder.filePath(name);
    const ExportRequest request = requestOfTwo(target, 15, false);
    const ExportOutcome outcome = ModelExport::run(request, quiet, {});
    QVERIFY2(outcome.problem.isEmpty(), qPrintable(outcome.problem));
    const std::size_t all = request.mesh->live().faces;
    const bool isGlb = name.endsWith(QStringLiteral("glb"));
    const core::ReadResult read = core::readModel(target.toStdString());
    QCOMPARE(read.mesh.triangles.size(), isGlb ? all : all / 2);
    QVERIFY(!isGlb || read.parts == request.metadata.frame->parts);

    core::DocumentMetadata hidden = request.metadata;
    std::vector<core::Part> parts = hidden.frame->parts.all();
    for (core::Part& part : parts)
        part.isVisible = false;
    hidden.frame->parts = core::PartList(parts);
    const QString problem = ModelLoader::save(target, core::extractMesh(*request.mesh), hidden);
    QCOMPARE(problem.isEmpty(), isGlb);
    QVERIFY2(isGlb || problem.contains(QStringLiteral("hidden")), qPrintable(problem));
}

/// Tests that a saved document of several parts opens as it was.
void TestModelExport::savedParts_openAgain()
{
    const ExportRequest request = requestOfTwo(path("saved.glb"), 15, false);
    QVERIFY(ModelLoader::save(request.path, core::extractMesh(*request.mesh), request.metadata).isEmpty());
    for (const LoadedModel& loaded : {ModelLoader::load(request.path), ModelLoader::loadInPlace(request.path)}) {
        QVERIFY2(loaded.sculptor && loaded.problem.isEmpty(), qPrintable(loaded.problem));
        QVERIFY2(loaded.notice.isEmpty(), qPrintable(loaded.notice));
        QVERIFY(loaded.sculptor->mesh().frame().parts == request.mesh->frame().parts);
        QCOMPARE(loaded.sculptor->mesh().meshHash(), request.mesh->meshHash());
    }
}

FETTLE_TEST_MAIN(TestModelExport, modelExportMain)
#include "tst_model_export.moc"
