#include "core/drawing/model_thumbnail.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"
#include "ui/actions/actions.h"
#include "ui/help/start_page.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QToolButton>

#include <algorithm>
#include <cstdlib>

using ui::MainWindow;
using ui::StartPage;

namespace
{
constexpr int pictureSide = 144; ///< pixels; twice the displayed size, for high-resolution screens

QImage pictureOf(core::Starter starter)
{
    const core::ModelThumbnail picture = core::drawThumbnail(core::starterModel(starter), pictureSide, {}).value();
    const auto* bytes = picture.rgba.front().data();
    return QImage(bytes, picture.width, picture.height, QImage::Format_RGBA8888_Premultiplied)
        .convertToFormat(QImage::Format_RGBA8888);
}

/// Returns true if the images are equal except for rounding.
bool isAlike(const QImage& one, const QImage& other)
{
    if (one.size() != other.size())
        return false;
    const auto same = [](uchar a, uchar b) { return std::abs(a - b) <= 2; };
    return std::equal(one.constBits(), one.constBits() + one.sizeInBytes(), other.constBits(), same);
}
} // namespace

class TestStartPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void itComesWhenAskedAndGoes()
    {
        MainWindow window;
        StartPage* page = shownIn(window, false);
        QVERIFY(!page->isVisible());
        window.action(QStringLiteral("help.start"))->trigger();
        QVERIFY(page->isVisible() && window.centralWidget()->rect().contains(page->geometry()));
        QVERIFY(page->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!page->isVisible());
        window.action(QStringLiteral("help.start"))->trigger();
        page->findChild<QToolButton*>(QStringLiteral("startClose"))->click();
        QVERIFY(!page->isVisible());
        window.action(QStringLiteral("help.start"))->trigger();
        sendMouse(window.centralWidget(), QEvent::MouseButtonPress, {3, 3}, Qt::LeftButton);
        QVERIFY(!page->isVisible());
    }

    void everyStarterIsThere()
    {
        MainWindow window;
        StartPage* page = shownIn(window, true);
        const QSignalSpy requested(window.files(), &ui::ModelFiles::starterRequested);
        for (const ui::ActionInfo& row : ui::actionTable()) {
            if (row.menu != ui::MenuId::New)
                continue;
            page->open();
            auto* button = page->findChild<QToolButton*>(QStringLiteral("start.") + QLatin1StringView(row.id));
            QVERIFY2(button, row.id);
            const auto before = requested.size();
            QTest::keyClick(button, Qt::Key_Space);
            QCOMPARE(requested.size(), before + 1);
            QVERIFY(!page->isVisible());
        }
        QCOMPARE(requested.size(), 7);
    }

    /// Starter pictures are files drawn in advance; each must be redrawn when its starter changes.
    void picturesAreOfTheStarters()
    {
        const QDir made(QDir::temp().filePath(QStringLiteral("fettle-starters")));
        std::size_t number = 0;
        for (const ui::ActionInfo& row : ui::actionTable()) {
            if (row.menu != ui::MenuId::New)
                continue;
            const QString file = QStringLiteral("starter-%1.png").arg(QLatin1StringView(row.id).mid(4));
            const QImage shown = QImage(QStringLiteral(":/pictures/") + file).convertToFormat(QImage::Format_RGBA8888);
            const QImage drawn = pictureOf(core::starters[number++]);
            if (!isAlike(shown, drawn)) {
                QVERIFY(made.mkpath(QStringLiteral(".")) && drawn.save(made.filePath(file)));
                QFAIL(qPrintable(QStringLiteral("resources/pictures/%1 is not of its starter; %2 is.")
                                     .arg(file, made.filePath(file))));
            }
        }
    }

    void recentFilesAreOpened()
    {
        QTemporaryFile file;
        QVERIFY(file.open());
        ui::Settings().set(&ui::Setting::recentFiles, {QStringLiteral("/no/such.stl"), file.fileName()});
        MainWindow window;
        StartPage* page = shownIn(window, true);
        auto* list = page->findChild<QListWidget*>(QStringLiteral("startRecent"));
        QTRY_COMPARE(list->count(), 1); // the other recent file does not exist
        const QSignalSpy requested(window.files(), &ui::ModelFiles::openRequested);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QCOMPARE(requested.size(), 1);
        QCOMPARE(requested[0][0].toString(), file.fileName());
        QVERIFY(!page->isVisible());
    }

    void recentFilesHavePictures()
    {
        const QTemporaryDir folder;
        const QString model = folder.filePath(QStringLiteral("ball.stl"));
        core::writeMesh(model.toStdString(), core::icosphere(2, 20));
        ui::Settings().set(&ui::Setting::recentFiles, {model});
        MainWindow window;
        const auto* list = shownIn(window, true)->findChild<QListWidget*>(QStringLiteral("startRecent"));
        const auto middle = [list] {
            const QImage picture = list->item(0)->icon().pixmap(list->iconSize()).toImage();
            return picture.pixelColor(picture.rect().center()).alpha();
        };
        QCOMPARE(middle(), 0);
        QTRY_COMPARE(middle(), 255);
    }

    void withoutRecentFilesNothingCanBeChosen()
    {
        MainWindow window;
        auto* list = shownIn(window, true)->findChild<QListWidget*>(QStringLiteral("startRecent"));
        QCOMPARE(list->count(), 1);
        QVERIFY(!(list->item(0)->flags() & Qt::ItemIsEnabled));
    }

    void lessonsAreOffered()
    {
        MainWindow window;
        StartPage* page = shownIn(window, true);
        QImage picture(96, 96, QImage::Format_RGB32);
        picture.fill(Qt::red);
        page->setLessons({{QStringLiteral("mug"), QStringLiteral("A mug"), QStringLiteral("With a handle."), picture}});
        const QSignalSpy chosen(page, &StartPage::lessonChosen);
        auto* button = page->findChild<QToolButton*>(QStringLiteral("start.lesson.mug"));
        QVERIFY(button && !button->icon().isNull());
        QTest::keyClick(button, Qt::Key_Space);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toString(), QStringLiteral("mug"));
        QVERIFY(!page->isVisible());
    }

    void guideIsOpened()
    {
        MainWindow window;
        shownIn(window, true)->findChild<QPushButton*>(QStringLiteral("startGuide"))->click();
        QTRY_VERIFY(window.findChild<QDialog*>(QStringLiteral("guide")) &&
                    window.findChild<QDialog*>(QStringLiteral("guide"))->isVisible());
    }

    void whetherItIsShownIsRemembered()
    {
        QVERIFY(ui::Settings().get(&ui::Setting::showsStartPage));
        MainWindow window;
        auto* box = shownIn(window, true)->findChild<QCheckBox*>(QStringLiteral("startAlways"));
        QVERIFY(box->isChecked());
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(!ui::Settings().get(&ui::Setting::showsStartPage));
    }

    void everyControlHasANameAndATip()
    {
        MainWindow window;
        int controls = 0;
        StartPage* page = shownIn(window, true);
        page->setLessons({{QStringLiteral("mug"), QStringLiteral("A mug"), QStringLiteral("With a handle."), {}}});
        for (const QWidget* widget : page->findChildren<QWidget*>()) {
            if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().isEmpty() ||
                widget->objectName().startsWith(QLatin1StringView("qt_")))
                continue;
            ++controls;
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                     qPrintable(widget->objectName()));
            QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
        }
        QVERIFY(controls >= 12);
    }

    /// The first model is set behind the page, which stays open. A later model closes the page.
    void itGoesWhenAModelIsChosen()
    {
        MainWindow window;
        StartPage* page = shownIn(window, true);
        const ui::ModelInfo model{QStringLiteral("a"), 2562, 5120, core::Vec3::Constant(100),
                                  core::Box(core::Vec3::Constant(-50), core::Vec3::Constant(50))};
        window.setModel(model);
        QVERIFY(page->isVisible());
        window.setModel(model);
        QVERIFY(!page->isVisible());
    }

    /// The whole page is visible; in windows smaller than 960 x 540 it can be scrolled.
    void itFitsASmallWindow()
    {
        MainWindow window;
        StartPage* page = shownIn(window, true);
        const QImage picture(150, 100, QImage::Format_RGB32);
        page->setLessons({{QStringLiteral("mug"), QStringLiteral("A mug"), QStringLiteral("With a handle."), picture}});
        for (const QSize size : {QSize(960, 540), QSize(700, 420), QSize(1280, 690)}) {
            window.resize(size);
            QTRY_VERIFY(window.rect().contains(page->geometry()));
            auto* area = page->findChild<QScrollArea*>();
            QTRY_COMPARE(area->verticalScrollBar()->maximum() > 0, size.height() < 540);
            auto* guide = page->findChild<QPushButton*>(QStringLiteral("startGuide"));
            area->ensureWidgetVisible(guide);
            QTRY_COMPARE(guide->visibleRegion(), QRegion(guide->rect()));
        }
    }

private:
    static StartPage* shownIn(MainWindow& window, bool isOpen)
    {
        window.resize(1280, 690);
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qWarning("the window is not active");
        auto* page = window.findChild<StartPage*>();
        if (isOpen)
            page->open();
        return page;
    }
};

FETTLE_TEST(TestStartPage, ui::TestApplication)
#include "tst_start_page.moc"
