#include "app/headset/headset_settings_store.h"
#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "ui/brush/color_panel.h"
#include "ui/settings/settings.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/keyboard_cursor.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace
{
bool isSound(const QString& path)
{
    return core::checkMesh(core::readMesh(path.toStdString())).printReady();
}
} // namespace

class TestEndToEnd : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void openPullUndoExport();
    void heldPull_goesOnAndEscTakesItBack();
    void toolsByModifier();
    void sculptedByKeysAlone();
    void handsOfTheNextVisit_areChosenInTheMenu();
    void refusedFileLeavesTheModel();
    void closing_asksOnlyWithChanges();
    void closing_waitsForThePress();
    void saving_byKey();
    void numberedCopies_leaveTheFile();
    void swatches_areSavedWithTheModel();
    void closing_maySaveFirst();
    void opening_maySaveFirst();
    void aSaveGivenUp_givesUpWhatWaitedForIt();
    void tooMuchWork_isSaid();
};

void TestEndToEnd::openPullUndoExport()
{
    QTemporaryDir folder;
    const QString in = folder.filePath(QStringLiteral("ball.stl")), out = folder.filePath(QStringLiteral("out.stl"));
    core::writeMesh(in.toStdString(), core::icosphere(4, 30));

    Program program;
    openFile(program, in, {900, 700});
    QVERIFY(program.window.windowTitle().contains(QStringLiteral("ball.stl")));

    QAction* undo = program.window.action(QStringLiteral("edit.undo"));
    QVERIFY(!undo->isEnabled());
    drag(program.window.viewport(), {40, 20});
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    QVERIFY(undo->isEnabled() && program.window.isWindowModified());

    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(program.document.history().stack().index(), 0);
    QTRY_VERIFY(!program.window.isWindowModified());
    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(program.document.history().stack().index(), 1);
    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(program.document.history().stack().index(), 0);
    QTest::keyClick(&program.window, Qt::Key_Y, Qt::ControlModifier);
    QTRY_COMPARE(program.document.history().stack().index(), 1);

    QSignalSpy exported(&program.document.saver(), &ModelSaver::exported);
    Q_EMIT program.window.files()->exportRequested(out);
    QTRY_COMPARE(exported.size(), 1);
    const core::TriangleMesh mesh = core::readMesh(out.toStdString());
    const core::MeshReport report = core::checkMesh(mesh);
    QVERIFY(report.printReady());
    QCOMPARE(quint64(report.faces), program.document.modelInfo().faces);
    QVERIFY(report.volume.value_or(0) > core::checkMesh(core::readMesh(in.toStdString())).volume.value_or(0));
    QVERIFY(program.window.isWindowModified()); // exporting does not count as saving
    const ui::ViewportStats stats = program.window.viewport()->stats();
    qInfo("input to patch %.1f ms, worst %.1f ms; to the screen %.1f ms", program.worker.stats().latencyMs,
          program.worker.stats().worstLatencyMs, stats.latencyMs);
}

/// A press held in one place makes one dab at once and then ten per second. Esc cancels the stroke.
void TestEndToEnd::heldPull_goesOnAndEscTakesItBack()
{
    QTemporaryDir folder;
    const QString ball = folder.filePath(QStringLiteral("ball.stl"));
    core::writeMesh(ball.toStdString(), core::icosphere(5, 30));
    Program program;
    openFile(program, ball, {900, 700});
    ui::Viewport* viewport = program.window.viewport();
    const auto size = [&] { return program.document.modelInfo().box.sizes().maxCoeff(); };
    const std::uint64_t before = meshHash(program.worker);
    QTest::mousePress(viewport, Qt::LeftButton, {}, middle(viewport));
    QTest::qWait(2000);
    QTest::keyClick(viewport, Qt::Key_Escape);
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, middle(viewport));
    QTRY_VERIFY(program.document.queue().isSettled());
    QCOMPARE(meshHash(program.worker), before);
    QCOMPARE(program.document.history().stack().count(), 0);

    const double sizeBefore = size();
    QTest::mousePress(viewport, Qt::LeftButton, {}, middle(viewport));
    QTest::qWait(2000);
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, middle(viewport));
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    const double radius = program.window.brush()->stroke().radius;
    QTRY_VERIFY2(size() > sizeBefore + 0.5 * radius, qPrintable(QStringLiteral("%1 %2").arg(size()).arg(sizeBefore)));
}

void TestEndToEnd::toolsByModifier()
{
    Program program;
    program.window.resize(900, 700);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(!program.document.job().isBusy());
    QTRY_VERIFY(program.window.viewport()->stats().patches > 0);
    int steps = 0;
    for (const Qt::KeyboardModifiers modifiers : {Qt::NoModifier, Qt::ControlModifier, Qt::ShiftModifier}) {
        drag(program.window.viewport(), {30, 10}, modifiers);
        ++steps;
        QTRY_COMPARE(program.document.history().stack().count(), steps);
    }
    QVERIFY(program.document.history().stack().text(0) != program.document.history().stack().text(1));
    QVERIFY(program.document.history().stack().text(1) != program.document.history().stack().text(2));
}

/// Sculpts from the menus to the export by keys only, without the mouse.
void TestEndToEnd::sculptedByKeysAlone()
{
    QTemporaryDir folder;
    const QString in = folder.filePath(QStringLiteral("ball.stl")), out = folder.filePath(QStringLiteral("out.stl"));
    core::writeMesh(in.toStdString(), core::icosphere(4, 30));
    Program program;
    openFile(program, in, {900, 700});
    ui::Viewport* view = program.window.viewport();
    const QUndoStack& steps = program.document.history().stack();

    QTest::keyClick(&program.window, Qt::Key_K, Qt::ControlModifier);
    QVERIFY(view->keyboardCursor()->isOn() && view->hasFocus());
    QVERIFY(program.window.findChild<QWidget*>(QStringLiteral("keyCross"))->isVisible());
    QTest::keyClick(view, Qt::Key_1); // key for Pull
    QTest::keyPress(view, Qt::Key_Space);
    for (int i = 0; i < 10; ++i)
        QTest::keyClick(view, Qt::Key_Right);
    QTest::keyRelease(view, Qt::Key_Space);
    QTRY_COMPARE(steps.count(), 1);

    const core::Vec3 before = view->camera().viewDirection();
    QTest::keyClick(view, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(view->camera().viewDirection() != before);
    QTest::keyClick(view, Qt::Key_I, Qt::ShiftModifier);
    QTest::keyClick(view, Qt::Key_Return);
    QTest::keyClick(view, Qt::Key_Down);
    QTest::keyClick(view, Qt::Key_Return);
    QTRY_COMPARE(steps.count(), 2);
    QVERIFY(steps.text(0) != steps.text(1)); // the second step is a Push

    QTest::keyClick(&program.window, Qt::Key_K, Qt::ControlModifier);
    QVERIFY(!view->keyboardCursor()->isOn());
    QTest::keyClick(view, Qt::Key_Space);
    QTRY_VERIFY(program.document.queue().isSettled());
    QCOMPARE(steps.count(), 2);

    QSignalSpy exported(&program.document.saver(), &ModelSaver::exported);
    Q_EMIT program.window.files()->exportRequested(out);
    QTRY_COMPARE(exported.size(), 1);
    QVERIFY(isSound(out));
}

/// The choice of hands is saved. Switching one-handed mode off restores two hands.
void TestEndToEnd::handsOfTheNextVisit_areChosenInTheMenu()
{
    const auto hands = [] { return HeadsetSettingsStore().load().wands; };
    const QStringList ids{QStringLiteral("vr.oneHand"), QStringLiteral("vr.leftHanded")};
    {
        Program program;
        for (const QString& id : ids)
            program.window.action(id)->trigger();
    }
    QCOMPARE(hands(), (vr::WandSettings{vr::ButtonPreset::OneHand, vr::Side::Left}));
    Program program;
    for (const QString& id : ids) {
        QVERIFY(program.window.action(id)->isChecked());
        program.window.action(id)->trigger();
    }
    QCOMPARE(hands(), vr::WandSettings());
}

void TestEndToEnd::refusedFileLeavesTheModel()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("short.obj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    file.close();

    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(!program.document.job().isBusy());
    QSignalSpy refused(&program.document, &Document::refused);
    Q_EMIT program.window.files()->openRequested(path);
    QTRY_COMPARE(refused.size(), 1);
    QCOMPARE(program.document.modelInfo().vertices, quint64(10242));
    QVERIFY(program.document.modelInfo().path.isEmpty());
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget != &program.window)
            widget->close();
}

void TestEndToEnd::closing_asksOnlyWithChanges()
{
    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(!program.document.job().isBusy());
    int asked = 0;
    program.document.opener().setDiscardPrompt([&](const std::function<void()>&) { return ++asked > 1; });
    core::StrokeSample sample;
    sample.position = {50, 0, 0};
    program.document.strokes().beginStroke({});
    program.document.strokes().addSample(sample);
    program.document.strokes().endStroke();
    QVERIFY(!program.window.close()); // the stroke has not been reported yet
    QTRY_COMPARE(asked, 1);
    QCOMPARE(program.document.history().stack().count(), 1);
    program.document.history().undo();
    QTRY_VERIFY(program.document.queue().isSettled());
    QVERIFY(program.window.close());
    QCOMPARE(asked, 1);
}

/// Closing the window is requested while it is still unknown whether a press is on the model. The press becomes a
/// stroke first.
void TestEndToEnd::closing_waitsForThePress()
{
    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(!program.document.job().isBusy());
    QTRY_VERIFY(program.window.viewport()->stats().patches > 0);
    int asked = 0;
    program.document.opener().setDiscardPrompt([&](const std::function<void()>&) { return ++asked > 1; });
    QTest::mousePress(program.window.viewport(), Qt::LeftButton, {}, middle(program.window.viewport()));
    QVERIFY(program.window.viewport()->input()->isPressPending());
    QVERIFY(!program.window.close());
    QCOMPARE(asked, 0);
    QTRY_COMPARE(asked, 1);
    QCOMPARE(program.document.history().stack().count(), 1);
    QVERIFY(program.window.isVisible());
    QVERIFY(program.window.close());
    QCOMPARE(asked, 2);
}

/// The second press of the save key writes to the file that the first one chose.
void TestEndToEnd::saving_byKey()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.ply"));
    Program program;
    sculptBall(program);
    program.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&program.window));
    QTest::keySequence(&program.window, program.window.action(QStringLiteral("file.save"))->shortcut());
    chooseFile(program, "saveDialog", path);
    QTRY_VERIFY(notice(program).contains(QStringLiteral("mine.ply")));
    QVERIFY(isSound(path));
    QTRY_VERIFY(!program.window.isWindowModified() &&
                program.window.windowTitle().startsWith(QStringLiteral("mine.ply")));

    const qint64 size = QFileInfo(path).size();
    program.window.brush()->setValue(core::Parameter::Detail, 0.6);
    drag(program.window.viewport(), {40, 20});
    QTRY_VERIFY(program.document.queue().isSettled() && program.window.isWindowModified());
    QTest::keySequence(&program.window, program.window.action(QStringLiteral("file.save"))->shortcut());
    QTRY_VERIFY(!program.window.isWindowModified());
    QVERIFY(QFileInfo(path).size() > size);
}

void TestEndToEnd::numberedCopies_leaveTheFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine-002.ply"));
    Program program;
    sculptBall(program);
    program.document.saver().save(path);
    QTRY_COMPARE(program.document.modelInfo().path, path);
    core::writeMesh(folder.filePath(QStringLiteral("mine-007.stl")).toStdString(), core::icosphere(2, 10));
    core::writeMesh(folder.filePath(QStringLiteral("another-100.stl")).toStdString(), core::icosphere(2, 10));
    for (const char* name : {"mine-008.ply", "mine-009.ply"}) {
        const QString copy = folder.filePath(QLatin1StringView(name));
        program.window.action(QStringLiteral("file.saveCopy"))->trigger();
        QTRY_VERIFY(QFileInfo::exists(copy) && !program.document.job().isBusy());
        QVERIFY(isSound(copy));
    }
    QCOMPARE(program.document.modelInfo().path, path);
}

void TestEndToEnd::swatches_areSavedWithTheModel()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.ply"));
    const QList<core::Rgb> own = {{1, 2, 3}, {250, 128, 0}};
    Program program;
    sculptBall(program);
    auto* colors = program.window.findChild<ui::ColorPanel*>();
    const QList<core::Rgb> persons = colors->swatches();
    colors->setSwatches(own);
    program.document.saver().save(path);
    QTRY_COMPARE(program.document.modelInfo().path, path);
    colors->setSwatches(persons);
    program.document.opener().open(path);
    QTRY_VERIFY(!program.document.job().isBusy() && colors->swatches() == own);
    QVERIFY(ui::Settings().get(&ui::Setting::swatches) == persons); // other models keep the user's own swatches
}

void TestEndToEnd::closing_maySaveFirst()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.stl"));
    Program program;
    sculptBall(program);
    answerQuestion(program, QMessageBox::Save);
    QVERIFY(!program.window.close());
    QVERIFY(program.window.isVisible());
    chooseFile(program, "saveDialog", path);
    QTRY_VERIFY(!program.window.isVisible()); // the window closes without another action
    QVERIFY(isSound(path));
}

void TestEndToEnd::opening_maySaveFirst()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.obj")),
                  other = folder.filePath(QStringLiteral("other.stl"));
    core::writeMesh(other.toStdString(), core::icosphere(2, 10));
    Program program;
    sculptBall(program);
    answerQuestion(program, QMessageBox::Save);
    program.window.action(QStringLiteral("file.open"))->trigger();
    chooseFile(program, "openDialog", other);
    chooseFile(program, "saveDialog", path);
    QTRY_COMPARE(program.document.modelInfo().path, other);
    QTRY_VERIFY(!program.document.job().isBusy());
    QCOMPARE(program.document.modelInfo().vertices, quint64(162));
    QVERIFY(isSound(path));
    QVERIFY(core::readMesh(path.toStdString()).points.size() > 162);
}

/// Cancelling the save dialog cancels the close or open that waited for it. A later save has no such effect.
void TestEndToEnd::aSaveGivenUp_givesUpWhatWaitedForIt()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.stl"));
    Program program;
    sculptBall(program);
    answerQuestion(program, QMessageBox::Save);
    QVERIFY(!program.window.close());
    QFileDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = program.window.findChild<QFileDialog*>(QStringLiteral("saveDialog"))));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!program.window.findChild<QFileDialog*>(QStringLiteral("saveDialog")));
    QVERIFY(program.window.isVisible() && program.window.isWindowModified());

    program.window.action(QStringLiteral("file.saveAs"))->trigger();
    chooseFile(program, "saveDialog", path);
    QTRY_VERIFY(!notice(program).isEmpty());
    QTest::qWait(100);
    QVERIFY(program.window.isVisible());
    QVERIFY(isSound(path));
}

/// The brush is much finer than the surface, so the work limit of a dab is reached.
void TestEndToEnd::tooMuchWork_isSaid()
{
    Program program;
    sculptBall(program);
    QVERIFY(notice(program).isEmpty());
    program.window.brush()->setValue(core::Parameter::Detail, 0.05);
    QSignalSpy noticed(&program.document, &Document::noticed);
    QTest::mouseClick(program.window.viewport(), Qt::LeftButton, {}, middle(program.window.viewport()));
    QTRY_COMPARE(noticed.size(), 1); // long timeout, because sanitizers are ten times slower
    QCOMPARE(notice(program), ui::ErrorMessages::shortfall(core::Shortfall::Capped));
    QTRY_VERIFY(program.document.queue().isSettled());
    QCOMPARE(noticed.size(), 1);
}

FETTLE_TEST(TestEndToEnd, app::OnScreen)
#include "tst_end_to_end.moc"
