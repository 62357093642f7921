#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"

#include "core/io/mesh_io.h"
#include "ui/files/file_browser.h"
#include "ui/files/file_grid.h"
#include "ui/settings/settings.h"
#include "ui/util/thread_mailbox.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace app;

namespace
{
enum class Fault { DiskFull, NotPermitted };

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A folder with a model. The folder can be made unwritable and writable again.
class Place
{
public:
    Place(const places::SmallDisk& disk, Fault fault) : m_disk(disk), m_fault(fault)
    {
        QFile::remove(at("filler"));
        core::writeMesh(at("lion.ply").toStdString(), core::icosphere(3, 20));
    }
    ~Place()
    {
        repair();
        for (const QString& name : files())
            QFile::remove(at(name.toUtf8().constData()));
    }
    void spoil() const
    {
        if (m_fault == Fault::DiskFull)
            m_disk.fill();
        else
            QFile::setPermissions(folder(), QFile::ReadOwner | QFile::ExeOwner);
    }
    void repair() const
    {
        if (m_fault == Fault::DiskFull)
            QFile::remove(at("filler"));
        else
            QFile::setPermissions(folder(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    QString folder() const
    {
        return m_fault == Fault::DiskFull ? QString::fromStdString(m_disk.folder().string()) : m_own.path();
    }
    QString at(const char* name) const { return folder() + QLatin1Char('/') + QString::fromUtf8(name); }
    QStringList files() const { return QDir(folder()).entryList(QDir::Files | QDir::Hidden, QDir::Name); }
    QString word() const
    {
        return m_fault == Fault::DiskFull ? QStringLiteral("the disk is full.")
                                          : QStringLiteral("it is not allowed (Permission denied).");
    }

private:
    const places::SmallDisk& m_disk;
    Fault m_fault;
    QTemporaryDir m_own;
};

/// A model with an unsaved stroke, whose folder then becomes unwritable.
struct Spoilt
{
    Spoilt(const places::SmallDisk& disk, Fault fault) : place(disk, fault)
    {
        program.window.resize(900, 700);
        program.window.show();
        program.document.opener().open(place.at("lion.ply"));
    }
    void sculpt()
    {
        QVERIFY(QTest::qWaitForWindowExposed(&program.window));
        QTRY_VERIFY(!program.document.job().isBusy() && program.document.modelInfo().path == place.at("lion.ply"));
        QTRY_VERIFY(program.window.viewport()->stats().patches > 0);
        drag(program.window.viewport(), {40, 20});
        QTRY_COMPARE(program.document.history().stack().count(), 1);
        QTRY_VERIFY(program.document.queue().isSettled());
        place.spoil();
        bytes = read(place.at("lion.ply"));
        files = place.files();
        hash = state();
    }
    std::uint64_t state() { return stateHash(program.worker); }
    QMessageBox* problem() const { return program.window.findChild<QMessageBox*>(QStringLiteral("problem")); }
    /// Returns a description of the visible state, for the message of a check that timed out.
    QString seen()
    {
        QString all = program.document.job().isBusy() ? QStringLiteral("busy") : QStringLiteral("idle");
        all += program.document.queue().isSettled() ? QStringLiteral(", settled") : QStringLiteral(", unsettled");
        for (const QWidget* widget : QApplication::topLevelWidgets()) {
            const auto* box = qobject_cast<const QMessageBox*>(widget);
            if (box || widget->isVisible())
                all += QStringLiteral("; %1 %2 \"%3\" %4")
                           .arg(QLatin1StringView(widget->metaObject()->className()), widget->objectName(),
                                widget->windowTitle(),
                                widget->isVisible() ? QStringLiteral("visible") : QStringLiteral("hidden"));
            if (box)
                all += QStringLiteral(": ") + box->text();
        }
        return all;
    }
    void answer()
    {
        const auto isAnswered = [this] {
            if (problem())
                QTest::mouseClick(problem()->button(QMessageBox::Ok), Qt::LeftButton);
            return !problem();
        };
        QTRY_VERIFY2(isAnswered(),
                     qPrintable(seen())); // repeated, because a busy machine may lose a press on a new dialog
    }
    void verifySaved()
    {
        QTRY_VERIFY2(!program.document.savedState().isModified() && !program.document.job().isBusy(),
                     qPrintable(seen()));
    }
    /// Opens the folder in the file browser.
    void browse()
    {
        press("file.browse");
        program.window.findChild<ui::FileBrowser*>()->goTo(place.folder());
        auto* grid = program.window.findChild<ui::FileGrid*>();
        QTRY_COMPARE(grid->model()->rowCount(), 1);
        grid->setCurrentIndex(grid->model()->index(0, 0));
    }
    void press(const char* id) { program.window.action(QLatin1StringView(id))->trigger(); }
    /// Checks that one sentence reports the file, that the folder's files are complete and unchanged, and that the
    /// model is unchanged.
    void verifyRefused(const QString& name)
    {
        QTRY_VERIFY(problem() && problem()->isVisible() && !program.document.job().isBusy());
        const QString sentence = problem()->text();
        QVERIFY2(sentence.startsWith(place.at(name.toUtf8().constData())) && sentence.endsWith(place.word()),
                 qPrintable(sentence));
        answer();
        QCOMPARE(read(place.at("lion.ply")), bytes);
        QCOMPARE(place.files(), files);
        QCOMPARE(state(), hash);
        QVERIFY(program.document.savedState().isModified() && program.window.isWindowModified() &&
                program.document.history().canUndo());
        QCOMPARE(program.document.modelInfo().path, place.at("lion.ply"));
    }

    Place place;
    // after strokes in a smaller view, the model would not fit the small disk
    Program program{{480, 360}};
    QByteArray bytes;
    QStringList files;
    std::uint64_t hash = 0;
};
} // namespace

/// Tests full disks, and folders and files without write permission.
class TestUnwritablePlaces : public QObject
{
    Q_OBJECT

public:
    static inline const places::SmallDisk* disk = nullptr; ///< small disk, mounted by main()

private Q_SLOTS:
    void save_losesNothing_data() { faults(); }
    void save_losesNothing();
    void failedFiles_mayGoElsewhere_data();
    void failedFiles_mayGoElsewhere();
    void closing_staysWhenItsSaveFails_data() { faults(); }
    void closing_staysWhenItsSaveFails();
    void numberedCopy_isWholeOrNotThere_data() { faults(); }
    void numberedCopy_isWholeOrNotThere();
    void exports_areWholeOrNotThere_data();
    void exports_areWholeOrNotThere();
    void reducedExport_leavesTheOldFile_data() { faults(); }
    void reducedExport_leavesTheOldFile();
    void duplicate_isWholeOrNotThere_data() { faults(); }
    void duplicate_isWholeOrNotThere();
    void filesThatMayNoMoreBeRead_haveAWord();

private:
    static void faults();
    bool isMissing(Fault fault) const { return fault == Fault::DiskFull && !disk->isThere(); }
};

#define SKIP_WITHOUT(fault)                                                                                            \
    if (isMissing(fault))                                                                                              \
    QSKIP("A small disk cannot be mounted here.")

void TestUnwritablePlaces::faults()
{
    QTest::addColumn<Fault>("fault");
    QTest::newRow("full disk") << Fault::DiskFull;
    QTest::newRow("closed folder") << Fault::NotPermitted;
}

void TestUnwritablePlaces::save_losesNothing()
{
    QFETCH(Fault, fault);
    SKIP_WITHOUT(fault);
    Spoilt s(*disk, fault);
    s.sculpt();
    s.press("file.save");
    s.verifyRefused(QStringLiteral("lion.ply"));
    s.place.repair();
    s.press("file.save");
    s.verifySaved();
    QVERIFY(read(s.place.at("lion.ply")) != s.bytes);
    QCOMPARE(core::readMesh(s.place.at("lion.ply").toStdString()).points.size(),
             s.program.document.modelInfo().vertices);
}

void TestUnwritablePlaces::failedFiles_mayGoElsewhere_data()
{
    QTest::addColumn<QByteArray>("command");
    QTest::addColumn<QByteArray>("dialog");
    QTest::newRow("save") << QByteArray("file.saveAs") << QByteArray("saveDialog");
    QTest::newRow("export") << QByteArray("file.exportAs") << QByteArray("exportDialog");
}

/// The dialog opens again with the file name. Next time it starts in the folder of the last successful save.
void TestUnwritablePlaces::failedFiles_mayGoElsewhere()
{
    QFETCH(QByteArray, command);
    QFETCH(QByteArray, dialog);
    const QTemporaryDir good;
    Spoilt s(*disk, Fault::NotPermitted);
    s.sculpt();
    ui::Settings().set(&ui::Setting::lastFolder, good.path());
    s.press(command.constData());
    chooseFile(s.program, dialog.constData(), s.place.at("tiger.stl"));
    QTRY_VERIFY(s.problem() && s.problem()->isVisible() && !s.program.document.job().isBusy());
    QCOMPARE(ui::Settings().lastFolder(), good.path());
    const auto isOffer = [](const QAbstractButton* b) { return b->text().contains(QStringLiteral("Another Place")); };
    const QList<QAbstractButton*> buttons = s.problem()->buttons();
    const auto offer = std::ranges::find_if(buttons, isOffer);
    QVERIFY(offer != buttons.end());
    QTest::mouseClick(*offer, Qt::LeftButton);
    QFileDialog* again = nullptr;
    QTRY_VERIFY((again = s.program.window.findChild<QFileDialog*>(QLatin1StringView(dialog))) && again->isVisible());
    QCOMPARE(again->selectedFiles().value(0).section(u'/', -1).section(u'.', 0, 0), QStringLiteral("tiger"));
    chooseFile(s.program, dialog.constData(), good.filePath(QStringLiteral("tiger.stl")));
    QTRY_VERIFY(QFile::exists(good.filePath(QStringLiteral("tiger.stl"))) && !s.program.document.job().isBusy());
    QTRY_VERIFY(!s.problem());
    QCOMPARE(ui::Settings().lastFolder(), good.path());
}

void TestUnwritablePlaces::closing_staysWhenItsSaveFails()
{
    QFETCH(Fault, fault);
    SKIP_WITHOUT(fault);
    Spoilt s(*disk, fault);
    s.sculpt();
    answerQuestion(s.program, QMessageBox::Save);
    QVERIFY(!s.program.window.close());
    s.verifyRefused(QStringLiteral("lion.ply"));
    QVERIFY(s.program.window.isVisible());
    s.place.repair();
    s.press("file.save"); // saving does not close the window this time
    s.verifySaved();
    QVERIFY(s.program.window.isVisible());
}

void TestUnwritablePlaces::numberedCopy_isWholeOrNotThere()
{
    QFETCH(Fault, fault);
    SKIP_WITHOUT(fault);
    Spoilt s(*disk, fault);
    s.sculpt();
    s.press("file.saveCopy");
    s.verifyRefused(QStringLiteral("lion-001.ply"));
}

void TestUnwritablePlaces::exports_areWholeOrNotThere_data()
{
    QTest::addColumn<Fault>("fault");
    QTest::addColumn<QString>("name");
    for (const char* name : {"lion.stl", "lion.obj", "sheet.pdf", "sheet.svg", "sheet.png"}) {
        QTest::addRow("%s, full disk", name) << Fault::DiskFull << QString::fromLatin1(name);
        QTest::addRow("%s, closed folder", name) << Fault::NotPermitted << QString::fromLatin1(name);
    }
}

void TestUnwritablePlaces::exports_areWholeOrNotThere()
{
    QFETCH(Fault, fault);
    QFETCH(QString, name);
    SKIP_WITHOUT(fault);
    Spoilt s(*disk, fault);
    s.sculpt();
    const bool isDrawing = name.startsWith(QLatin1StringView("sheet"));
    s.press(isDrawing ? "file.exportDrawing" : "file.exportAs");
    chooseFile(s.program, isDrawing ? "drawingDialog" : "exportDialog", s.place.folder() + QLatin1Char('/') + name);
    s.verifyRefused(name);
}

/// Exports over the model's own file, which the user confirms.
void TestUnwritablePlaces::reducedExport_leavesTheOldFile()
{
    QFETCH(Fault, fault);
    SKIP_WITHOUT(fault);
    QSettings().clear();
    Spoilt s(*disk, fault);
    s.sculpt();
    s.program.document.saver().exportTo(s.place.at("lion.ply"), {.maxTriangles = 800});
    s.verifyRefused(QStringLiteral("lion.ply"));
    s.press("file.exportFor");
    auto* choice = s.program.window.findChild<QDialog*>(QStringLiteral("exportChoice"));
    QTRY_VERIFY(choice->isVisible());
    auto* most = choice->findChild<QSpinBox*>();
    QTest::keyClick(choice->findChild<QCheckBox*>(QStringLiteral("limits")), Qt::Key_Space);
    most->selectAll();
    QTest::keyClicks(most, QStringLiteral("800"));
    QTest::keyClick(most, Qt::Key_Return);
    chooseFile(s.program, "exportDialog", s.place.at("lion.stl"));
    s.verifyRefused(QStringLiteral("lion.stl"));
}

void TestUnwritablePlaces::duplicate_isWholeOrNotThere()
{
    QFETCH(Fault, fault);
    SKIP_WITHOUT(fault);
    Spoilt s(*disk, fault);
    s.sculpt();
    s.browse();
    s.press("files.duplicate");
    const QString word =
        fault == Fault::DiskFull ? QStringLiteral("No space left") : QStringLiteral("permission denied");
    QTRY_VERIFY2(notice(s.program).contains(word), qPrintable(notice(s.program)));
    QCOMPARE(s.place.files(), s.files);
    QCOMPARE(read(s.place.at("lion.ply")), s.bytes);
}

void TestUnwritablePlaces::filesThatMayNoMoreBeRead_haveAWord()
{
    Spoilt s(*disk, Fault::NotPermitted);
    s.sculpt();
    s.browse();
    QFile::setPermissions(s.place.at("lion.ply"), {});
    answerQuestion(s.program, QMessageBox::Discard);
    s.press("files.open");
    QTRY_VERIFY(s.problem() && s.problem()->isVisible());
    QCOMPARE(s.problem()->text(), s.place.at("lion.ply") + QStringLiteral(" cannot be read (Permission denied)."));
    s.answer();
    QTRY_VERIFY(!s.program.document.job().isBusy());
    QCOMPARE(s.state(), s.hash);
    QVERIFY(s.program.document.savedState().isModified());
    QFile::setPermissions(s.place.folder(), {});
    const auto* empty = s.program.window.findChild<QLabel*>(QStringLiteral("files.empty"));
    QTRY_VERIFY(empty->isVisible());
    QCOMPARE(empty->text(), s.place.folder() + QStringLiteral(" cannot be opened: permission denied."));
}

static int unwritablePlacesMain(int argc, char* argv[])
{
    const QTemporaryDir folder;
    const places::SmallDisk disk(folder.filePath(QStringLiteral("small")).toStdString());
    places::obeyPermissions();
    TestUnwritablePlaces::disk = &disk;
    return test::run<TestUnwritablePlaces, app::OnScreen>(argc, argv);
}

FETTLE_TEST_MAIN(TestUnwritablePlaces, unwritablePlacesMain)
#include "tst_unwritable_places.moc"
