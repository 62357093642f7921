#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "ui/files/file_browser.h"
#include "ui/files/file_grid.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace app;

namespace
{
/// Files of a model that takes long to open, and of two that open quickly.
struct Files
{
    Files()
    {
        core::writeMesh(large.toStdString(), core::icosphere(7, 40));
        core::writeMesh(small.toStdString(), core::icosphere(2, 10));
        core::writeMesh(other.toStdString(), core::icosphere(1, 10));
    }

    QTemporaryDir folder;
    QString large = folder.filePath(QStringLiteral("large.ply")), small = folder.filePath(QStringLiteral("small.stl"));
    QString other = folder.filePath(QStringLiteral("other.obj"));
};

bool dropFile(Program& program, const QString& path)
{
    return drop(program.window, {QUrl::fromLocalFile(path)});
}

/// Waits until the document is idle. Checks that the model of this file is open and that no other was opened before it.
void expectOnly(Program& program, const QSignalSpy& opened, const QString& path)
{
    QTRY_COMPARE(opened.size(), 1);
    QTRY_VERIFY(!program.document.job().isBusy() && program.document.queue().isSettled());
    QTest::qWait(200);
    QCOMPARE(opened.size(), 1);
    QCOMPARE(program.document.modelInfo().path, path);
}

/// Returns the open question whether to repair a broken model, or null.
QDialog* repairQuestion(const Program& program)
{
    return program.window.findChild<QDialog*>(QStringLiteral("mendDialog"));
}

QString repairReport(const Program& program)
{
    auto* report = program.window.findChild<QMessageBox*>(QStringLiteral("mendedDialog"));
    return report ? report->informativeText() : QString();
}

void writeCrossingBalls(const QString& path)
{
    core::writeMesh(path.toStdString(),
                    shapes::together(core::icosphere(2, 10), shapes::moved(core::icosphere(2, 10), {9, 0, 0})));
}

/// Counts the questions about unsaved changes, and answers each one with `mayLose`.
struct Asked
{
    Asked(Program& program, bool mayLose)
    {
        program.document.opener().setDiscardPrompt([this, mayLose](const std::function<void()>&) {
            ++times;
            return mayLose;
        });
    }
    int times = 0;
};
} // namespace

/// Tests a file that is chosen while something else is in progress.
class TestOpening : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theStartPageStandsOverTheFirstModel();
    void theLatestChoiceWins();
    void aFileOfThePanelWins();
    void aStarterWins();
    void changesAreAskedForOnce();
    void changesMadeMeanwhileAreAskedFor();
    void whoWillNotLoseThemKeepsTheModel();
    void afterSaving();
    void stopEndsBoth();
    void theFirstThatCannotBeReadIsNoMatter();
    void aBrokenModelIsRepaired_data();
    void aBrokenModelIsRepaired();
    void aRepairThatLosesMuchIsAsked();
    void aRepairAsksNoSecondTime();
    void aBrokenModelIsRepairedAndInserted();
};

/// The ball opens behind the start page, as at program start. The page closes when another model opens.
void TestOpening::theStartPageStandsOverTheFirstModel()
{
    Program program;
    program.window.show();
    program.document.opener().openBall();
    program.window.action(QStringLiteral("help.start"))->trigger();
    QTRY_VERIFY(program.document.modelInfo().faces > 0 && !program.document.job().isBusy());
    const auto* page = program.window.findChild<QWidget*>(QStringLiteral("startPage"));
    QVERIFY(page->isVisible());
    const Files files;
    QSignalSpy opened(&program.document, &Document::opened);
    program.document.opener().open(files.small);
    QTRY_COMPARE(opened.size(), 1);
    QVERIFY(!page->isVisible());
}

void TestOpening::theLatestChoiceWins()
{
    const Files files;
    Program program;
    sculptBall(program);
    program.document.history().undo();
    QTRY_VERIFY(!program.document.savedState().isModified());
    QSignalSpy opened(&program.document, &Document::opened), refused(&program.document, &Document::refused);
    QVERIFY(dropFile(program, files.large));
    QTRY_VERIFY(program.document.job().isBusy());
    QVERIFY(dropFile(program, files.other));
    QVERIFY(dropFile(program, files.small));
    expectOnly(program, opened, files.small);
    QVERIFY(refused.isEmpty());
    QCOMPARE(program.document.modelInfo().vertices, quint64(162));
    QVERIFY(program.window.windowTitle().startsWith(QStringLiteral("small.stl")));
}

void TestOpening::aFileOfThePanelWins()
{
    const Files files;
    Program program;
    program.window.show();
    program.window.action(QStringLiteral("file.browse"))->trigger();
    program.window.findChild<ui::FileBrowser*>()->goTo(files.folder.path());
    auto* grid = program.window.findChild<ui::FileGrid*>();
    const auto press = [grid](const QString& name) {
        for (int row = 0; row < grid->model()->rowCount(); ++row)
            if (const QModelIndex file = grid->model()->index(row, 0); file.data().toString() == name)
                grid->setCurrentIndex(file);
        QTest::keyClick(grid, Qt::Key_Return);
    };
    QTRY_COMPARE(grid->model()->rowCount(), 3);
    QSignalSpy opened(&program.document, &Document::opened);
    press(QStringLiteral("large.ply"));
    QVERIFY(program.document.job().isBusy());
    press(QStringLiteral("other.obj"));
    expectOnly(program, opened, files.other);
}

void TestOpening::aStarterWins()
{
    const Files files;
    Program program;
    program.window.show();
    QSignalSpy opened(&program.document, &Document::opened);
    program.document.opener().open(files.large);
    QVERIFY(program.document.job().isBusy());
    program.window.action(QStringLiteral("new.cube"))->trigger();
    expectOnly(program, opened, {});
}

/// A user who has discarded changes for one file is not asked again for the next one.
void TestOpening::changesAreAskedForOnce()
{
    const Files files;
    Program program;
    sculptBall(program);
    const Asked asked(program, true);
    QSignalSpy opened(&program.document, &Document::opened);
    QVERIFY(dropFile(program, files.large));
    QTRY_VERIFY(program.document.job().isBusy());
    QVERIFY(dropFile(program, files.small));
    expectOnly(program, opened, files.small);
    QCOMPARE(asked.times, 1);
}

void TestOpening::changesMadeMeanwhileAreAskedFor()
{
    const Files files;
    Program program;
    sculptBall(program);
    const Asked asked(program, true);
    QSignalSpy opened(&program.document, &Document::opened);
    program.document.opener().open(files.large);
    QVERIFY(program.document.job().isBusy());
    program.document.history().undo();
    program.document.history().redo();
    program.document.opener().open(files.small);
    expectOnly(program, opened, files.small);
    QCOMPARE(asked.times, 2);
}

void TestOpening::whoWillNotLoseThemKeepsTheModel()
{
    const Files files;
    Program program;
    sculptBall(program);
    program.document.history().undo();
    QTRY_VERIFY(!program.document.savedState().isModified());
    QSignalSpy opened(&program.document, &Document::opened);
    const Asked asked(program, false);
    program.document.opener().open(files.large);
    QVERIFY(program.document.job().isBusy());
    program.document.history().redo();
    QTRY_VERIFY(program.document.savedState().isModified());
    program.document.opener().open(files.small);
    QTRY_COMPARE(asked.times, 1);
    QTest::qWait(200);
    QVERIFY(!program.document.job().isBusy() && opened.isEmpty());
    QVERIFY(program.document.modelInfo().path.isEmpty() && program.document.savedState().isModified() &&
            program.document.history().canUndo());
}

/// A save in progress is completed before the chosen file opens.
void TestOpening::afterSaving()
{
    const Files files;
    const QString mine = files.folder.filePath(QStringLiteral("mine.ply"));
    Program program;
    sculptBall(program);
    QSignalSpy saved(&program.document.saver(), &ModelSaver::saved), opened(&program.document, &Document::opened);
    program.document.saver().save(mine);
    QVERIFY(program.document.job().isBusy());
    program.document.opener().open(files.small);
    QVERIFY(notice(program).length() > 0);
    expectOnly(program, opened, files.small);
    QCOMPARE(saved.size(), 1);
    QVERIFY(core::readMesh(mine.toStdString()).points.size() > 162);
}

void TestOpening::stopEndsBoth()
{
    const Files files;
    Program program;
    sculptBall(program);
    program.document.history().undo();
    QTRY_VERIFY(!program.document.savedState().isModified());
    program.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&program.window));
    QSignalSpy opened(&program.document, &Document::opened);
    program.document.opener().open(files.large);
    program.document.opener().open(files.other);
    QVERIFY(program.document.job().isBusy());
    program.window.action(QStringLiteral("edit.stop"))->trigger();
    QTRY_VERIFY(!program.document.job().isBusy());
    QTest::qWait(200);
    QVERIFY(opened.isEmpty() && !program.document.job().isBusy());
    QCOMPARE(program.document.modelInfo().vertices, quint64(10242));
}

void TestOpening::theFirstThatCannotBeReadIsNoMatter()
{
    const Files files;
    Program program;
    program.window.show();
    QSignalSpy opened(&program.document, &Document::opened), refused(&program.document, &Document::refused);
    program.document.opener().open(files.folder.filePath(QStringLiteral("not there.stl")));
    QVERIFY(program.document.job().isBusy());
    program.document.opener().open(files.small);
    expectOnly(program, opened, files.small);
    QVERIFY(refused.isEmpty());
}

void TestOpening::aBrokenModelIsRepaired_data()
{
    QTest::addColumn<bool>("agrees");
    QTest::newRow("who wants it gets a model without a file") << true;
    QTest::newRow("who does not keeps the model that is there") << false;
}

void TestOpening::aBrokenModelIsRepaired()
{
    QFETCH(bool, agrees);
    const QTemporaryDir folder;
    const QString broken = folder.filePath(QStringLiteral("broken.ply"));
    writeCrossingBalls(broken);
    Program program;
    program.window.show();
    QSignalSpy opened(&program.document, &Document::opened), refused(&program.document, &Document::refused);
    program.document.opener().open(broken);
    QTRY_VERIFY(repairQuestion(program) && !program.document.job().isBusy());
    opened.clear();
    QTest::keyClick(repairQuestion(program), agrees ? Qt::Key_Return : Qt::Key_Escape);
    QTRY_VERIFY(!repairQuestion(program));
    if (agrees) {
        QTRY_COMPARE(opened.size(), 1);
        QVERIFY(repairReport(program).contains(QStringLiteral("Intersections resolved")));
        QVERIFY(program.document.modelInfo().path.isEmpty());
        QVERIFY(program.document.savedState().isModified()); // the repaired model differs from the file
        QVERIFY(std::abs(program.document.modelInfo().size.x() - 29) < 0.1);
    } else {
        QTest::qWait(200);
        QVERIFY(opened.isEmpty());
    }
    QVERIFY(refused.isEmpty());
}

/// The faces of the ball are separate, so the surface can only be rebuilt. This requires the user's consent.
void TestOpening::aRepairThatLosesMuchIsAsked()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("apart.ply"));
    core::writeMesh(path.toStdString(), shapes::takenApart(core::icosphere(3, 10)));
    Program program;
    program.document.opener().openBall();
    QTRY_VERIFY(program.document.modelInfo().faces > 0 && !program.document.job().isBusy());
    const QSignalSpy opened(&program.document, &Document::opened);
    const auto question = [&] { return program.window.findChild<QDialog*>(QStringLiteral("repairDoubtDialog")); };
    for (const Qt::Key answer : {Qt::Key_Escape, Qt::Key_Return}) {
        program.document.opener().open(path);
        QTRY_VERIFY(repairQuestion(program) && !program.document.job().isBusy());
        QTest::keyClick(repairQuestion(program), Qt::Key_Return);
        QTRY_VERIFY(question() && !program.document.job().isBusy());
        QVERIFY(opened.isEmpty());
        const QList<QLabel*> labels = question()->findChildren<QLabel*>();
        QCOMPARE(std::ranges::count_if(labels, [](const QLabel* label) { return !label->pixmap().isNull(); }), 2);
        QTest::keyClick(question(), answer);
        QTRY_VERIFY(!question() && !repairQuestion(program));
    }
    QTRY_COMPARE(opened.size(), 1);
    QVERIFY(program.document.savedState().isModified());
    QVERIFY(repairReport(program).contains(QStringLiteral("rebuilt")));
}

/// A user who has discarded changes for a file is not asked again for its repair, but is asked for another file.
void TestOpening::aRepairAsksNoSecondTime()
{
    const Files files;
    const QString broken = files.folder.filePath(QStringLiteral("broken.ply"));
    writeCrossingBalls(broken);
    Program program;
    sculptBall(program);
    const Asked asked(program, true);
    QSignalSpy opened(&program.document, &Document::opened);
    const auto ask = [&] {
        program.document.opener().open(broken);
        QTRY_VERIFY(repairQuestion(program) && !program.document.job().isBusy());
    };
    ask();
    QCOMPARE(asked.times, 1);
    QTest::keyClick(repairQuestion(program), Qt::Key_Escape);
    QTRY_VERIFY(!repairQuestion(program));
    program.document.history().undo();
    program.document.history().redo();
    QTRY_VERIFY(program.document.queue().isSettled());
    ask(); // the undo and redo count as new changes
    QCOMPARE(asked.times, 2);
    QTest::keyClick(repairQuestion(program), Qt::Key_Return);
    QTRY_COMPARE(opened.size(), 1);
    QCOMPARE(asked.times, 2);
    // the file is listed although the repaired model is not saved
    QCOMPARE(ui::Settings().recentFiles().value(0), broken);
    QVERIFY(program.document.modelInfo().path.isEmpty());
    program.document.opener().open(files.small);
    QTRY_COMPARE(asked.times, 3);
    QTRY_COMPARE(opened.size(), 2);
}

void TestOpening::aBrokenModelIsRepairedAndInserted()
{
    const QTemporaryDir folder;
    const QString broken = folder.filePath(QStringLiteral("broken.ply"));
    writeCrossingBalls(broken);
    Program program;
    sculptBall(program);
    const double before = program.document.modelInfo().size.x();
    program.window.action(QStringLiteral("model.insert"))->trigger();
    chooseFile(program, "openDialog", broken);
    QDialog* place = nullptr;
    QTRY_VERIFY((place = program.window.findChild<QDialog*>(QStringLiteral("insertDialog"))) && place->isVisible());
    QTest::keyClick(place, Qt::Key_Return);
    QTRY_VERIFY(repairQuestion(program) && !program.document.job().isBusy());
    QTest::keyClick(repairQuestion(program), Qt::Key_Return);
    QTRY_VERIFY(repairReport(program).contains(QStringLiteral("Intersections resolved")));
    QTRY_VERIFY(!program.document.job().isBusy());
    QCOMPARE(program.document.history().stack().count(), 2);
    QTRY_VERIFY(program.document.modelInfo().size.x() > before + 29);
    QTest::keyClick(program.window.findChild<QMessageBox*>(QStringLiteral("mendedDialog")), Qt::Key_Return);
    QTRY_VERIFY(repairReport(program).isEmpty());
    program.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&program.window));
    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(program.document.modelInfo().size.x(), before);
}

FETTLE_TEST(TestOpening, app::OnScreen)
#include "tst_opening.moc"
