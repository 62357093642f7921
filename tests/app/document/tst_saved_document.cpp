#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "ui/brush/color_panel.h"
#include "ui/reference/reference_images.h"
#include "ui/util/thread_mailbox.h"

#include <QAction>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace app;

namespace
{
struct MeshState
{
    std::uint64_t hash = 0;
    core::MeshFrame frame;
    friend bool operator==(const MeshState&, const MeshState&) = default;
};

MeshState stateOf(Program& program)
{
    return ask(program.worker, [](core::Sculptor& sculptor) {
        return MeshState{sculptor.mesh().meshHash(), sculptor.mesh().frame()};
    });
}

/// Sculpts a ball and saves it in the dialog under a name without an ending.
void saveNew(Program& program, const QString& path)
{
    sculptBall(program);
    QTest::keyClick(&program.window, Qt::Key_S, Qt::ControlModifier);
    chooseFile(program, "saveDialog", path);
    QTRY_VERIFY(!program.document.savedState().isModified() && !program.document.job().isBusy());
}
} // namespace

/// Tests what a saved file restores.
class TestSavedDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void untitled_isSavedAsGlb();
    void reopened_isTheSame();
    void oftenReopened_isStillTheSame();
    void formatThatHoldsLess_isToldOnce();
    void strangersGlb_leavesBrushAndViewAlone();

private:
    QTemporaryDir m_folder;
};

void TestSavedDocument::untitled_isSavedAsGlb()
{
    Program program;
    saveNew(program, m_folder.filePath(QStringLiteral("first")));
    QCOMPARE(program.document.modelInfo().path, m_folder.filePath(QStringLiteral("first.glb")));
    QVERIFY(!core::readMesh(m_folder.filePath(QStringLiteral("first.glb")).toStdString()).triangles.empty());
}

void TestSavedDocument::reopened_isTheSame()
{
    const QString path = m_folder.filePath(QStringLiteral("head.glb"));
    Program program;
    sculptBall(program);
    // sets a uniform detail different from the one that an import would choose
    program.document.changer().apply(core::RemeshUniformly{9});
    QTRY_COMPARE(program.document.history().stack().count(), 2);
    program.document.changer().apply(core::Move{{10, 0, 3}}); // an import would undo this move
    QTRY_COMPARE(program.document.history().stack().count(), 3);
    ui::BrushSettings& brush = *program.window.brush();
    brush.set(&core::StrokeSettings::symmetry, core::Symmetry::Z);
    brush.set(&core::StrokeSettings::topology, core::Topology::Uniform);
    brush.set(&core::StrokeSettings::color, core::Rgb{1, 2, 3});
    brush.setTool(core::Tool::Paint);
    brush.setValue(core::Parameter::Radius, 17);
    program.window.viewport()->navigation()->turnTo(ui::OrbitCamera::Side::Left);
    program.window.action(QStringLiteral("view.orthographic"))->setChecked(true);
    const QList<core::Rgb> swatches = {{9, 8, 7}, {200, 1, 1}};
    auto* colors = program.window.findChild<ui::ColorPanel*>();
    colors->setSwatches(swatches);
    Q_EMIT colors->swatchesChanged();
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::red);
    QVERIFY(picture.save(m_folder.filePath(QStringLiteral("head.png"))));
    auto* references = program.window.findChild<ui::ReferenceImages*>();
    references->choose(ui::OrbitCamera::Side::Left, m_folder.filePath(QStringLiteral("head.png")), {});
    QTRY_VERIFY(!references->saved().empty());
    QVERIFY(program.document.savedState().isModified()); // an unsaved reference image counts as a change
    program.document.saver().save(path);
    QTRY_VERIFY(!program.document.savedState().isModified() && !program.document.job().isBusy());
    const MeshState saved = stateOf(program);
    const core::SavedView view = program.window.viewport()->camera().saved();

    program.document.opener().openStarter(core::Starter::Cube);
    QTRY_VERIFY(program.document.modelInfo().path.isEmpty() && !program.document.job().isBusy());
    QVERIFY(references->saved().empty());
    brush.set(&core::StrokeSettings::symmetry, core::Symmetry::None);
    brush.set(&core::StrokeSettings::topology, core::Topology::Adaptive);
    brush.setTool(core::Tool::Pull);
    colors->setSwatches({{0, 0, 0}});
    program.window.viewport()->navigation()->turnTo(ui::OrbitCamera::Side::Top);
    program.window.action(QStringLiteral("view.orthographic"))->setChecked(false);

    program.document.opener().open(path);
    QTRY_VERIFY(program.document.modelInfo().path == path && !program.document.job().isBusy());
    QVERIFY(stateOf(program) == saved);
    QVERIFY(!program.document.savedState().isModified());
    const core::SavedView seen = program.window.viewport()->camera().saved();
    QVERIFY(seen.target == view.target && seen.distance == view.distance && seen.yaw == view.yaw &&
            seen.pitch == view.pitch && seen.orthographic);
    QVERIFY(program.window.action(QStringLiteral("view.orthographic"))->isChecked());
    QCOMPARE(brush.stroke().symmetry, core::Symmetry::Z);
    QVERIFY(program.window.action(QStringLiteral("symmetry.on"))->isChecked());
    QCOMPARE(brush.stroke().topology, core::Topology::Uniform);
    QCOMPARE(brush.tool(), core::Tool::Paint);
    QVERIFY((brush.stroke().color == core::Rgb{1, 2, 3}));
    QCOMPARE(brush.value(core::Parameter::Radius), 17.0);
    QVERIFY(QList<core::Rgb>(colors->swatches().begin(), colors->swatches().end()) == swatches);
    QCOMPARE(references->path(ui::OrbitCamera::Side::Left), m_folder.filePath(QStringLiteral("head.png")));
    QTRY_VERIFY(references->reference(ui::OrbitCamera::Side::Left).picture);
    QVERIFY(!program.document.savedState().isModified());
    references->remove(ui::OrbitCamera::Side::Left);
    QVERIFY(program.document.savedState().isModified() && program.window.isWindowModified());
}

/// Each reopening sorts the slots again, and the file is saved again by a different path.
void TestSavedDocument::oftenReopened_isStillTheSame()
{
    const QString path = m_folder.filePath(QStringLiteral("often.glb"));
    Program program;
    saveNew(program, path);
    const MeshState saved = stateOf(program);
    for (int i = 0; i < 3; ++i) {
        program.document.opener().open(path);
        QTRY_VERIFY(!program.document.job().isBusy() && program.document.history().stack().count() == 0);
        QVERIFY(stateOf(program) == saved);
        program.document.saver().save(path);
        QTRY_VERIFY(!program.document.job().isBusy());
    }
}

void TestSavedDocument::formatThatHoldsLess_isToldOnce()
{
    const QString path = m_folder.filePath(QStringLiteral("scan.stl"));
    core::writeMesh(path.toStdString(), core::icosphere(3, 20));
    Program program;
    sculptBall(program);
    answerQuestion(program, QMessageBox::Discard);
    program.document.opener().open(path);
    QTRY_VERIFY(program.document.modelInfo().path == path && !program.document.job().isBusy());
    drag(program.window.viewport(), {40, 20});
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    QTest::keyClick(&program.window, Qt::Key_S, Qt::ControlModifier); // saves to the same file, in its format
    QTRY_VERIFY(!program.document.savedState().isModified() && !program.document.job().isBusy());
    QVERIFY2(notice(program).contains(QStringLiteral("GLB")), qPrintable(notice(program)));
    QCOMPARE(core::readMesh(path.toStdString()).points.size(), program.document.modelInfo().vertices);
    QTest::keyClick(&program.window, Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(!notice(program).contains(QStringLiteral("GLB")));
}

void TestSavedDocument::strangersGlb_leavesBrushAndViewAlone()
{
    const QString path = m_folder.filePath(QStringLiteral("stranger.glb"));
    core::writeMesh(path.toStdString(), core::icosphere(3, 20));
    Program program;
    program.window.brush()->setTool(core::Tool::Flatten);
    program.window.brush()->set(&core::StrokeSettings::symmetry, core::Symmetry::Y);
    program.document.opener().open(path);
    QTRY_VERIFY(program.document.modelInfo().path == path && !program.document.job().isBusy());
    QCOMPARE(program.window.brush()->tool(), core::Tool::Flatten);
    QCOMPARE(program.window.brush()->stroke().symmetry, core::Symmetry::Y);
}

static int savedDocumentMain(int argc, char* argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    return test::run<TestSavedDocument, app::OnScreen>(argc, argv);
}

FETTLE_TEST_MAIN(TestSavedDocument, savedDocumentMain)
#include "tst_saved_document.moc"
