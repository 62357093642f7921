#include "ui/actions/actions.h"
#include "ui/files/file_browser.h"
#include "ui/files/file_grid.h"
#include "ui/files/file_list_model.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "tests/support/test_main.h"
#include "tests/ui/files/write_model.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPixmap>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QStandardPaths>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QToolButton>

namespace
{
/// A folder with two readable models, a damaged model, a subfolder with a model, and a file that is no model.
struct Models
{
    Models()
    {
        writeModel(path("ball 10.stl"), core::icosphere(3, 10));
        writeModel(path("ball 9.obj"), core::icosphere(2, 40));
        QFile broken(path("broken.ply"));
        if (broken.open(QIODevice::WriteOnly))
            broken.write("no ply");
        QFile(path("notes.txt")).open(QIODevice::WriteOnly);
        QDir(folder.path()).mkdir(QStringLiteral("inner"));
        writeModel(path("inner/ring.ply"), core::starterModel(core::Starter::Torus));
    }

    QString path(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir folder;
};

/// A window with the visible files panel, showing a folder whose files have all been read.
struct Shown
{
    explicit Shown(const Models& models) : Shown(models.folder.path()) {}
    explicit Shown(const QString& folder)
    {
        window.show();
        window.action(QStringLiteral("file.browse"))->trigger();
        panel->goTo(folder);
    }

    template <class T> T* child(const char* name) const { return window.findChild<T*>(QLatin1StringView(name)); }
    QString state() const { return child<QLabel>("files.state")->text(); }
    QString emptyWord() const
    {
        return child<QLabel>("files.empty")->isVisible() ? child<QLabel>("files.empty")->text() : QString();
    }

    QStringList names() const
    {
        QStringList all;
        for (int row = 0; row < grid->model()->rowCount(); ++row)
            all << grid->model()->index(row, 0).data().toString();
        return all;
    }
    QModelIndex find(const QString& name) const
    {
        const int row = static_cast<int>(names().indexOf(name));
        return row < 0 ? QModelIndex() : grid->model()->index(row, 0);
    }
    QImage picture(const QString& name) const { return find(name).data(Qt::DecorationRole).value<QPixmap>().toImage(); }
    QString problem(const QString& name) const { return find(name).data(ui::FileListModel::ProblemRole).toString(); }

    void choose(const QString& name) const
    {
        grid->setCurrentIndex(find(name));
        grid->setFocus();
    }
    /// Renames a file in place with F2.
    void rename(const QString& from, const QString& to) const
    {
        choose(from);
        QTest::keyClick(grid, Qt::Key_F2);
        auto* editor = grid->findChild<QLineEdit*>(QStringLiteral("files.rename"));
        QVERIFY(editor);
        QCOMPARE(editor->text(), QFileInfo(from).completeBaseName());
        editor->setText(to);
        QTest::keyClick(editor, Qt::Key_Return);
    }

    ui::MainWindow window;
    ui::FileBrowser* panel = window.findChild<ui::FileBrowser*>();
    ui::FileGrid* grid = window.findChild<ui::FileGrid*>();
    QSignalSpy noticed{panel, &ui::FileBrowser::noticed};
};

/// Chooses the order with the keys of the combo box.
void sortBy(const Shown& s, ui::FileOrder order)
{
    auto* box = s.child<QComboBox>("files.order");
    while (box->currentIndex() != static_cast<int>(order))
        QTest::keyClick(box, box->currentIndex() < static_cast<int>(order) ? Qt::Key_Down : Qt::Key_Up);
}
} // namespace

class TestFileBrowser : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void itIsHiddenUntilItIsAskedFor()
    {
        ui::MainWindow window;
        window.show();
        auto* dock = window.findChild<QDockWidget*>(QStringLiteral("filesPanel"));
        QVERIFY(dock && !dock->isVisible());
        window.action(QStringLiteral("file.browse"))->trigger();
        QVERIFY(dock->isVisible());
    }

    void aFolderOfModelsBecomesPictures()
    {
        const Models models;
        const Shown s(models);
        QTRY_COMPARE(s.names(), QStringList({QStringLiteral("inner"), QStringLiteral("ball 9.obj"),
                                             QStringLiteral("ball 10.stl"), QStringLiteral("broken.ply")}));
        QTRY_VERIFY(!s.picture(QStringLiteral("ball 10.stl")).isNull() &&
                    !s.picture(QStringLiteral("ball 9.obj")).isNull());
        const QImage fine = s.picture(QStringLiteral("ball 10.stl")), coarse = s.picture(QStringLiteral("ball 9.obj"));
        QVERIFY(inked(fine) > fine.width() * fine.height() / 2);
        QVERIFY(qAlpha(fine.pixel(0, 0)) == 0);
        QVERIFY(fine != coarse);
        QCOMPARE(s.find(QStringLiteral("ball 10.stl")).data(ui::FileListModel::VerticesRole).toInt(), 642);
        QTRY_VERIFY(s.problem(QStringLiteral("broken.ply")).contains(QStringLiteral("broken.ply")));
        QVERIFY(s.find(QStringLiteral("broken.ply")).data(Qt::ToolTipRole).toString() ==
                s.problem(QStringLiteral("broken.ply")));
        QTRY_VERIFY(!s.child<QToolButton>("files.stop")->isVisible());
        QVERIFY(s.state().contains(QStringLiteral("3")));
    }

    void itIsFilteredAndSorted()
    {
        const Models models;
        const Shown s(models);
        QTRY_VERIFY(s.names().size() == 4 && !s.child<QToolButton>("files.stop")->isVisible());
        auto* filter = s.child<QLineEdit>("files.filter");
        filter->setText(QStringLiteral("BALL"));
        QCOMPARE(s.names(), QStringList({QStringLiteral("ball 9.obj"), QStringLiteral("ball 10.stl")}));
        filter->setText(QStringLiteral("xyz"));
        QVERIFY(s.names().isEmpty() && s.emptyWord().contains(QStringLiteral("xyz")));
        filter->setText(QStringLiteral("ball"));
        QVERIFY(s.emptyWord().isEmpty());
        sortBy(s, ui::FileOrder::Vertices);
        // 162 and 642 vertices
        QCOMPARE(s.names(), QStringList({QStringLiteral("ball 9.obj"), QStringLiteral("ball 10.stl")}));
        s.child<QToolButton>("files.direction")->click();
        filter->clear();
        QCOMPARE(s.names(), QStringList({QStringLiteral("inner"), QStringLiteral("ball 10.stl"),
                                         QStringLiteral("ball 9.obj"), QStringLiteral("broken.ply")}));
        sortBy(s, ui::FileOrder::Size);
        QCOMPARE(s.names().constLast(), QStringLiteral("broken.ply"));
    }

    void theChoiceComesBack()
    {
        const Models models;
        {
            const Shown s(models);
            sortBy(s, ui::FileOrder::Date);
            s.child<QToolButton>("files.direction")->click();
            s.child<QSlider>("files.size")->setValue(160);
        }
        const ui::MainWindow window;
        QCOMPARE(window.findChild<ui::FileBrowser*>()->folder(), models.folder.path());
        QCOMPARE(window.findChild<QComboBox*>(QStringLiteral("files.order"))->currentIndex(), 2);
        QVERIFY(window.findChild<QToolButton*>(QStringLiteral("files.direction"))->isChecked());
        QCOMPARE(window.findChild<QSlider*>(QStringLiteral("files.size"))->value(), 160);
        QSettings().setValue(QStringLiteral("files/folder"), models.path("gone"));
        QSettings().setValue(QStringLiteral("files/order"), QStringLiteral("colour"));
        const ui::MainWindow other;
        QVERIFY(QDir(other.findChild<ui::FileBrowser*>()->folder()).exists());
        QCOMPARE(other.findChild<QComboBox*>(QStringLiteral("files.order"))->currentIndex(), 0);
    }

    /// The panel shows the model's folder once for each new folder. If the user then changes the folder, the panel
    /// stays there.
    void itBeginsWhereTheModelLies()
    {
        const Models models;
        ui::Settings().set(&ui::Setting::lastFolder, models.path("inner"));
        ui::MainWindow window;
        window.show();
        auto* panel = window.findChild<ui::FileBrowser*>();
        const auto browse = [&] {
            window.findChild<QDockWidget*>(QStringLiteral("filesPanel"))->hide();
            window.action(QStringLiteral("file.browse"))->trigger();
            return panel->folder();
        };
        QCOMPARE(browse(), models.path("inner"));
        panel->goTo(QDir::homePath());
        QCOMPARE(browse(), QDir::homePath());
        window.files()->setOpened({.name = QStringLiteral("ball 9.obj"), .box = {}, .path = models.path("ball 9.obj")});
        QCOMPARE(browse(), models.folder.path());
    }

    void returnInTheFolderGoesToTheFiles()
    {
        const Models models;
        const Shown s(QDir::homePath());
        auto* place = s.child<QLineEdit>("files.folder");
        place->setFocus();
        place->setText(models.folder.path());
        QTest::keyClick(place, Qt::Key_Return);
        QTRY_COMPARE(s.names().size(), 4);
        QTRY_VERIFY(s.grid->hasFocus());
    }

    void resettingKeepsTheFolder()
    {
        const Models models;
        const Shown s(models);
        sortBy(s, ui::FileOrder::Size);
        s.child<QSlider>("files.size")->setValue(200);
        ui::Settings settings;
        s.window.action(QStringLiteral("edit.preferences"))->trigger();
        auto* dialog = s.window.findChild<ui::PreferencesDialog*>();
        QVERIFY(dialog);
        Q_EMIT dialog->resetRequested();
        dialog->reject();
        QCOMPARE(s.child<QComboBox>("files.order")->currentIndex(), 0);
        QCOMPARE(s.child<QSlider>("files.size")->value(), ui::defaultPictureSize);
        QCOMPARE(s.panel->folder(), models.folder.path());
        QCOMPARE(settings.files().folder, models.folder.path());
        QVERIFY(settings.files().order == ui::FileOrder::Name &&
                settings.files().pictureSize == ui::defaultPictureSize);
    }

    void returnOpensAndEntersFolders()
    {
        const Models models;
        Shown s(models);
        QSignalSpy opened(s.window.files(), &ui::ModelFiles::openRequested);
        QTRY_COMPARE(s.names().size(), 4);
        s.choose(QStringLiteral("ball 9.obj"));
        QTest::keyClick(s.grid, Qt::Key_Return);
        QCOMPARE(opened.size(), 1);
        QCOMPARE(opened.takeFirst().constFirst().toString(), models.path("ball 9.obj"));
        s.window.progress()->begin(QStringLiteral("Opening"));
        QTest::keyClick(s.grid, Qt::Key_Return);
        QCOMPARE(opened.size(), 1); // opening another file is allowed while one is being opened
        opened.clear();
        s.window.progress()->end();

        s.choose(QStringLiteral("inner"));
        QTest::keyClick(s.grid, Qt::Key_Return);
        QCOMPARE(s.panel->folder(), models.path("inner"));
        QTRY_COMPARE(s.names(), QStringList({QStringLiteral("ring.ply")}));
        s.grid->setFocus();
        QTest::keyClick(s.grid, Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(s.panel->folder(), models.folder.path());
        QTRY_COMPARE(s.grid->currentIndex().data().toString(), QStringLiteral("inner"));
        QVERIFY(opened.isEmpty());
    }

    void theMenuIsOfTheTable()
    {
        const Models models;
        const Shown s(models);
        QTRY_COMPARE(s.names().size(), 4);
        s.choose(QStringLiteral("ball 9.obj"));
        Q_EMIT s.grid->customContextMenuRequested({10, 10});
        auto* menu = s.child<QMenu>("files.menu");
        QVERIFY(menu && menu->isVisible());
        for (const ui::ActionInfo& row : ui::actionTable())
            QCOMPARE(menu->actions().contains(s.window.action(QLatin1StringView(row.id))),
                     row.menu == ui::MenuId::Files);
        menu->close();
    }

    /// The commands are disabled while the panel is hidden or no file is selected.
    void theCommandsRestWhileThereIsNothingToActOn()
    {
        const Models models;
        const Shown s(models);
        const auto enabled = [&s](const char* id) { return s.window.action(QLatin1StringView(id))->isEnabled(); };
        QTRY_COMPARE(s.names().size(), 4);
        s.grid->setCurrentIndex({});
        s.grid->clearSelection();
        QVERIFY(!enabled("files.rename") && !enabled("files.trash") && !enabled("files.open") && enabled("files.up"));
        s.choose(QStringLiteral("inner"));
        QVERIFY(enabled("files.open") && !enabled("files.rename") && !enabled("files.trash"));
        s.choose(QStringLiteral("ball 9.obj"));
        QVERIFY(enabled("files.open") && enabled("files.rename") && enabled("files.trash"));
        s.child<QDockWidget>("filesPanel")->hide();
        for (const ui::ActionInfo& row : ui::actionTable())
            QVERIFY2(row.menu != ui::MenuId::Files || !enabled(row.id), row.id);
        s.child<QDockWidget>("filesPanel")->show();
        QVERIFY(enabled("files.rename") && enabled("files.up"));
    }

    void theKeysAreTheGridsAlone()
    {
        const Models models;
        Shown s(models);
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QTRY_COMPARE(s.names().size(), 4);
        auto* filter = s.child<QLineEdit>("files.filter");
        for (QWidget* elsewhere : {static_cast<QWidget*>(filter), static_cast<QWidget*>(s.window.viewport())}) {
            s.choose(QStringLiteral("ball 9.obj"));
            elsewhere->setFocus();
            for (const Qt::Key key : {Qt::Key_F2, Qt::Key_Delete, Qt::Key_Return, Qt::Key_Backspace})
                QTest::keyClick(elsewhere, key);
            QVERIFY(!s.grid->findChild<QLineEdit*>(QStringLiteral("files.rename")));
        }
        QTest::qWait(300);
        QVERIFY(s.noticed.isEmpty() && QFile::exists(models.path("ball 9.obj")));
        QCOMPARE(s.panel->folder(), models.folder.path());
    }

    void theKeysCanBeOthers()
    {
        const Models models;
        const Shown s(models);
        QTRY_COMPARE(s.names().size(), 4);
        s.window.findChild<ui::Actions*>()->setKeys(
            {ui::ShortcutPreset::Fettle,
             {{QStringLiteral("files.rename"), QStringLiteral("Q")},
              {QStringLiteral("files.open"), QStringLiteral("Return; Ctrl+Return")}}});
        const QList<QKeySequence> opening =
            // Its initial keys may be set although Return is otherwise reserved
            s.window.action(QStringLiteral("files.open"))->shortcuts();
        QVERIFY(opening.size() == 2 && opening.contains(QKeySequence(Qt::Key_Return)));
        const auto renames = [&s](Qt::Key key) {
            s.choose(QStringLiteral("ball 9.obj"));
            QTest::keyClick(s.grid, key);
            auto* editor = s.grid->findChild<QLineEdit*>(QStringLiteral("files.rename"));
            if (editor)
                QTest::keyClick(editor, Qt::Key_Escape);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return editor != nullptr;
        };
        QVERIFY(!renames(Qt::Key_F2));
        QVERIFY(renames(Qt::Key_Q));
    }

    void theyAreDoneFromTheCommandBox()
    {
        const Models models;
        Shown s(models);
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QTRY_COMPARE(s.names().size(), 4);
        s.choose(QStringLiteral("ball 9.obj"));
        s.window.viewport()->setFocus();
        QTest::keyClick(&s.window, Qt::Key_F3);
        auto* box = s.child<QDialog>("commandBox");
        QVERIFY(box);
        auto* words = box->findChild<QLineEdit*>();
        QTest::keyClicks(words, QStringLiteral("panel rename"));
        QTest::keyClick(words, Qt::Key_Return);
        QLineEdit* editor = nullptr;
        QTRY_VERIFY((editor = s.grid->findChild<QLineEdit*>(QStringLiteral("files.rename"))));
        QTRY_VERIFY(editor->hasFocus() && s.window.isActiveWindow());
        QTest::keyClicks(editor, QStringLiteral("new"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(QFile::exists(models.path("new.obj")));
    }

    void renamingKeepsTheEndingAndOverwritesNothing()
    {
        const Models models;
        Shown s(models);
        QTRY_COMPARE(s.names().size(), 4);
        s.rename(QStringLiteral("ball 9.obj"), QStringLiteral("Kugel ü"));
        QTRY_VERIFY(s.find(QStringLiteral("Kugel ü.obj")).isValid());
        QVERIFY(!QFile::exists(models.path("ball 9.obj")) && QFile::exists(models.path("Kugel ü.obj")));
        QTRY_COMPARE(s.grid->currentIndex().data().toString(), QStringLiteral("Kugel ü.obj"));
        QVERIFY(s.noticed.isEmpty());

        writeModel(models.path("taken.obj"), core::icosphere(1, 1));
        const qint64 size = QFileInfo(models.path("taken.obj")).size();
        for (const char* refused : {"taken", "", "a/b", "a:b", "..", "con", "a\tb"}) {
            s.noticed.clear();
            s.rename(QStringLiteral("Kugel ü.obj"), QString::fromUtf8(refused));
            QTRY_VERIFY2(s.noticed.size() == 1, refused);
            QVERIFY(s.noticed[0][0].toString().endsWith(QLatin1Char('.')));
            QVERIFY(QFile::exists(models.path("Kugel ü.obj")));
            QCOMPARE(QFileInfo(models.path("taken.obj")).size(), size);
        }
        s.noticed.clear();
        s.rename(QStringLiteral("Kugel ü.obj"), QString(400, QLatin1Char('x')));
        QTRY_COMPARE(s.noticed.size(), 1);
        QVERIFY(QFile::exists(models.path("Kugel ü.obj")));
    }

    void aPictureThatComesMeanwhileLeavesTheNameThatIsTyped()
    {
        const Models models;
        const Shown s(models);
        QTRY_VERIFY(!s.picture(QStringLiteral("ball 9.obj")).isNull());
        s.choose(QStringLiteral("ball 9.obj"));
        QTest::keyClick(s.grid, Qt::Key_F2);
        auto* editor = s.grid->findChild<QLineEdit*>(QStringLiteral("files.rename"));
        QVERIFY(editor && editor->hasSelectedText());
        editor->setText(QStringLiteral("new"));
        writeModel(models.path("ball 9.obj"), core::icosphere(1, 3));
        QTRY_COMPARE(s.find(QStringLiteral("ball 9.obj")).data(ui::FileListModel::VerticesRole).toInt(), 42);
        QCOMPARE(editor->text(), QStringLiteral("new"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(QFile::exists(models.path("new.obj")));
    }

    void aDuplicateIsTheSameAndTakesItsPictureFromTheCache()
    {
        const Models models;
        Shown s(models);
        QTRY_COMPARE(s.names().size(), 4);
        for (const char* copy : {"ball 10 copy.stl", "ball 10 copy 2.stl"}) {
            s.choose(QStringLiteral("ball 10.stl"));
            QTest::keyClick(s.grid, Qt::Key_D, Qt::ControlModifier);
            QTRY_VERIFY(QFile::exists(models.path(copy)));
            QTRY_COMPARE(s.grid->currentIndex().data().toString(), QString::fromUtf8(copy));
        }
        QTest::keyClick(s.grid, Qt::Key_D, Qt::ControlModifier);
        QTRY_VERIFY(QFile::exists(models.path("ball 10 copy 3.stl")));
        QFile one(models.path("ball 10.stl")), other(models.path("ball 10 copy 2.stl"));
        QVERIFY(one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly) && one.readAll() == other.readAll());
        QTRY_VERIFY(!s.picture(QStringLiteral("ball 10 copy.stl")).isNull());
        QTRY_COMPARE(s.picture(QStringLiteral("ball 10 copy.stl")), s.picture(QStringLiteral("ball 10.stl")));
    }

    void deleteGoesToTheTrash()
    {
        const Models models;
        Shown s(models);
        QTRY_COMPARE(s.names().size(), 4);
        s.choose(QStringLiteral("ball 9.obj"));
        QTest::keyClick(s.grid, Qt::Key_Delete);
        QTRY_COMPARE(s.noticed.size(), 1);
        QVERIFY(s.noticed[0][0].toString().contains(QStringLiteral("ball 9.obj")));
        // Qt's fallback trash must not be created in the working directory
        QVERIFY(!QFile::exists(QStringLiteral("files/ball 9.obj")));
        QTRY_COMPARE(s.find(QStringLiteral("ball 9.obj")).isValid(), QFile::exists(models.path("ball 9.obj")));
        if (QStorageInfo(models.folder.path()) == QStorageInfo(QDir::home())) { // another disk may have no trash
            QVERIFY(!QFile::exists(models.path("ball 9.obj")));
            const QDir trash(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                             QStringLiteral("/Trash/files"));
            QVERIFY(!trash.entryList({QStringLiteral("ball 9.obj*")}).isEmpty());
        }
        s.choose(QStringLiteral("inner"));
        QTest::keyClick(s.grid, Qt::Key_Delete);
        QVERIFY(QDir(models.path("inner")).exists());
    }

    void withoutATrashNothingIsDeleted()
    {
        const Models models;
        const QByteArray home = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", "/dev/null/data");
        const ui::FileOutcome outcome = ui::FileJobs::trash({models.path("ball 9.obj"), models.path("gone.obj")});
        home.isEmpty() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", home);
        QVERIFY(QFile::exists(models.path("ball 9.obj")));
        QVERIFY(!outcome.sentence.isEmpty());
        QVERIFY(!QFile::exists(QStringLiteral("files/ball 9.obj")));
    }

    void whatOthersDoIsSeen()
    {
        const Models models;
        const Shown s(models);
        QTRY_COMPARE(s.names().size(), 4);
        writeModel(models.path("late.stl"), core::icosphere(1, 5));
        QTRY_VERIFY(s.find(QStringLiteral("late.stl")).isValid());
        QTRY_VERIFY(!s.picture(QStringLiteral("late.stl")).isNull());
        QVERIFY(QFile::remove(models.path("late.stl")));
        QTRY_VERIFY(!s.find(QStringLiteral("late.stl")).isValid());
    }

    void aFolderThatCannotBeShownSaysWhy()
    {
        auto models = std::make_unique<Models>();
        const QString folder = models->path("inner");
        Shown s(folder);
        QTRY_COMPARE(s.names().size(), 1);
        models.reset();
        QTRY_VERIFY(s.emptyWord().contains(QStringLiteral("inner")));
        s.child<QToolButton>("files.upButton")->click();
        QVERIFY(QDir(s.panel->folder()).exists());

        auto* line = s.child<QLineEdit>("files.folder");
        line->setText(QStringLiteral("/nowhere/at/all"));
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_VERIFY(s.emptyWord().contains(QStringLiteral("/nowhere/at/all")));
        const QTemporaryDir empty;
        s.panel->goTo(empty.path());
        QTRY_VERIFY(s.emptyWord().contains(QStringLiteral("STL")));
    }
};

FETTLE_TEST(TestFileBrowser, ui::TestApplication)
#include "tst_file_browser.moc"
