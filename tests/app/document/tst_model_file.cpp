#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "ui/files/file_browser.h"
#include "ui/files/file_grid.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QDir>
#include <QPushButton>
#include <QTemporaryDir>

using namespace app;

namespace
{
/// An open model in a file of its own, and the file browser showing its folder.
struct Opened
{
    Opened()
    {
        core::writeMesh(path.toStdString(), core::icosphere(3, 20));
        core::writeMesh(folder.filePath(QStringLiteral("other.ply")).toStdString(), core::icosphere(1, 20));
        program.window.resize(900, 700);
        program.window.show();
        program.window.activateWindow();
        program.document.opener().open(path);
        program.window.action(QStringLiteral("file.browse"))->trigger();
        program.window.findChild<ui::FileBrowser*>()->goTo(folder.path());
    }
    void wait()
    {
        QVERIFY(QTest::qWaitForWindowActive(&program.window));
        QTRY_VERIFY(program.document.modelInfo().path == path && !program.document.job().isBusy());
        QTRY_COMPARE(grid->model()->rowCount(), 2);
    }
    void choose(const QString& name) const
    {
        for (int row = 0; row < grid->model()->rowCount(); ++row)
            if (const QModelIndex file = grid->model()->index(row, 0); file.data().toString() == name)
                grid->setCurrentIndex(file);
        grid->setFocus();
    }
    /// Activates the window again.
    void comeBack()
    {
        QEvent event(QEvent::WindowActivate);
        QCoreApplication::sendEvent(&program.window, &event);
    }
    void overwriteByAnother() const { core::writeMesh(path.toStdString(), core::icosphere(2, 7)); }
    void press(const char* id) { program.window.action(QLatin1StringView(id))->trigger(); }
    QMessageBox* question() const
    {
        return program.window.findChild<QMessageBox*>(QStringLiteral("overwriteQuestion"));
    }
    void answer(QMessageBox::ButtonRole role) const
    {
        for (QAbstractButton* button : question()->buttons())
            if (question()->buttonRole(button) == role)
                return QTest::mouseClick(button, Qt::LeftButton);
    }
    static quint64 verticesIn(const QString& file) { return core::readMesh(file.toStdString()).points.size(); }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("lion.ply"));
    Program program;
    ui::FileGrid* grid = program.window.findChild<ui::FileGrid*>();
};
} // namespace

/// Tests the open model when its file is renamed, deleted, or written by another program.
class TestModelFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aNewNameIsTheModels();
    void anotherFilesNewNameIsNot();
    void inTheTrashTheModelIsUnsaved();
    void goneFromOutside_isSeen();
    void goneFromOutside_isWrittenAgainAndSaidSo();
    void changedByAnother_asks();
    void changedByAnother_maySaveElsewhere();
    void ownWritingIsNotAnothers();
    void aTypedNameWinsOverTheSuggestedOne();
};

void TestModelFile::aNewNameIsTheModels()
{
    Opened o;
    o.wait();
    o.choose(QStringLiteral("lion.ply"));
    QTest::keyClick(o.grid, Qt::Key_F2);
    auto* editor = o.grid->findChild<QLineEdit*>(QStringLiteral("files.rename"));
    QVERIFY(editor);
    QTest::keyClicks(editor, QStringLiteral("tiger"));
    QTest::keyClick(editor, Qt::Key_Return);
    const QString renamed = o.folder.filePath(QStringLiteral("tiger.ply"));
    QTRY_COMPARE(o.program.document.modelInfo().path, renamed);
    QVERIFY(o.program.window.windowTitle().startsWith(QStringLiteral("tiger.ply")));
    QCOMPARE(ui::Settings().recentFiles().constFirst(), renamed);
    QVERIFY(!ui::Settings().recentFiles().contains(o.path));
    QVERIFY(!o.program.window.isWindowModified());
    o.press("file.save");
    QTRY_VERIFY(notice(o.program).contains(QStringLiteral("tiger.ply")) && !o.program.document.job().isBusy());
    QVERIFY(!o.question() && !QFile::exists(o.path));
    QCOMPARE(Opened::verticesIn(renamed), quint64(642));
}

void TestModelFile::anotherFilesNewNameIsNot()
{
    Opened o;
    o.wait();
    o.choose(QStringLiteral("other.ply"));
    QTest::keyClick(o.grid, Qt::Key_F2);
    auto* editor = o.grid->findChild<QLineEdit*>(QStringLiteral("files.rename"));
    QTest::keyClicks(editor, QStringLiteral("tiger"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(QFile::exists(o.folder.filePath(QStringLiteral("tiger.ply"))));
    QTest::qWait(200);
    QCOMPARE(o.program.document.modelInfo().path, o.path);
    QVERIFY(o.program.window.windowTitle().startsWith(QStringLiteral("lion.ply")));
}

void TestModelFile::inTheTrashTheModelIsUnsaved()
{
    Opened o;
    o.wait();
    o.choose(QStringLiteral("lion.ply"));
    QTest::keyClick(o.grid, Qt::Key_Delete);
    QTRY_VERIFY(!notice(o.program).isEmpty());
    QTest::qWait(100);
    QCOMPARE(o.program.document.savedState().isModified(), !QFile::exists(o.path)); // not every disk has a trash
}

void TestModelFile::goneFromOutside_isSeen()
{
    Opened o;
    o.wait();
    QVERIFY(QFile::remove(o.path));
    o.comeBack();
    QVERIFY(notice(o.program).contains(QStringLiteral("lion.ply")));
    QVERIFY(o.program.document.savedState().isModified() && o.program.window.isWindowModified());
    answerQuestion(o.program, QMessageBox::Cancel);
    QVERIFY(!o.program.window.close()); // closing is refused, because the model is in no file
}

void TestModelFile::goneFromOutside_isWrittenAgainAndSaidSo()
{
    Opened o;
    o.wait();
    QVERIFY(QFile::remove(o.path));
    o.press("file.save");
    QTRY_VERIFY(QFile::exists(o.path) && !o.program.document.job().isBusy());
    QCOMPARE(Opened::verticesIn(o.path), quint64(642));
    QVERIFY(notice(o.program).contains(QStringLiteral("written again")));
    QVERIFY(!o.program.document.savedState().isModified() && !o.question());
    o.press("file.save");
    QTRY_VERIFY(!notice(o.program).contains(QStringLiteral("written again")) && !o.program.document.job().isBusy());
}

void TestModelFile::changedByAnother_asks()
{
    Opened o;
    o.wait();
    o.overwriteByAnother();
    const quint64 others = Opened::verticesIn(o.path);
    o.press("file.save");
    QVERIFY(o.question() && o.question()->isVisible() && !o.program.document.job().isBusy());
    o.answer(QMessageBox::RejectRole);
    QTRY_VERIFY(!o.question());
    QTest::qWait(100);
    QCOMPARE(Opened::verticesIn(o.path), others);

    o.press("file.save");
    o.answer(QMessageBox::DestructiveRole);
    QTRY_COMPARE(Opened::verticesIn(o.path), quint64(642));
    QTRY_VERIFY(!o.program.document.job().isBusy() && !o.question());
    o.press("file.save"); // the file is now the program's own version
    QVERIFY(!o.question());
    QTRY_VERIFY(!o.program.document.job().isBusy());
}

void TestModelFile::changedByAnother_maySaveElsewhere()
{
    Opened o;
    o.wait();
    o.overwriteByAnother();
    const quint64 others = Opened::verticesIn(o.path);
    const QTemporaryDir elsewhere;
    const QString mine = elsewhere.filePath(QStringLiteral("mine.ply"));
    o.press("file.save");
    o.answer(QMessageBox::AcceptRole);
    chooseFile(o.program, "saveDialog", mine);
    QTRY_VERIFY(o.program.document.modelInfo().path == mine && !o.program.document.job().isBusy());
    QCOMPARE(Opened::verticesIn(o.path), others);
    QCOMPARE(Opened::verticesIn(mine), quint64(642));
}

void TestModelFile::ownWritingIsNotAnothers()
{
    Opened o;
    o.wait();
    o.program.document.changer().apply(core::Recentre{});
    QTRY_VERIFY(!o.program.document.job().isBusy() && o.program.document.queue().isSettled());
    o.program.document.saver().exportTo(o.path);
    QTRY_VERIFY(notice(o.program).contains(QStringLiteral("lion.ply")) && !o.program.document.job().isBusy());
    o.press("file.save");
    QVERIFY(!o.question());
    QTRY_VERIFY(!o.program.document.job().isBusy());
}

/// Types a file name with real keys while the dialog suggests existing names with the same beginning.
void TestModelFile::aTypedNameWinsOverTheSuggestedOne()
{
    Opened o;
    o.wait();
    ui::Settings().set(&ui::Setting::lastFolder, o.folder.path());
    for (const char* name : {"lion.glb", "tiger-old.glb"})
        core::writeMesh(o.folder.filePath(QString::fromLatin1(name)).toStdString(), core::icosphere(1, 20));
    o.press("file.saveAs");
    QFileDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = o.program.window.findChild<QFileDialog*>(QStringLiteral("saveDialog"))) &&
                dialog->isVisible());
    QVERIFY(QTest::qWaitForWindowActive(dialog));
    auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    QTRY_VERIFY(name->hasFocus());
    QTRY_COMPARE(dialog->selectedFiles(),
                 QStringList{o.folder.filePath(QStringLiteral("lion.glb"))}); // the suggested file exists
    for (const char letter : {'t', 'i', 'g', 'e', 'r'}) {
        QTest::keyClick(dialog->windowHandle(), letter);
        QTRY_VERIFY(name->text().endsWith(QLatin1Char(letter)));
    }
    QTRY_VERIFY(QApplication::activePopupWidget());
    QTest::keyClick(dialog->windowHandle(), Qt::Key_Return);
    QTRY_COMPARE(o.program.document.modelInfo().path, o.folder.filePath(QStringLiteral("tiger.glb")));
    QTRY_VERIFY(!o.program.document.job().isBusy());
    QCOMPARE(QDir(o.folder.path()).entryList(QDir::Files).size(), 5);
}

FETTLE_TEST(TestModelFile, app::OnScreen)
#include "tst_model_file.moc"
