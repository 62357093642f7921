#include "ui/drawing/preview_panel.h"
#include "ui/window/main_window.h"

#include "core/mesh/dirty_slots.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

namespace
{
ui::SharedDrawing sharedDrawingOf(const core::TriangleMesh& mesh, bool isInterim = false, std::size_t maxEdges = 1000)
{
    core::DrawArrays model;
    model.apply(core::wholePatchOf(*mesh_asserts::sculptable(mesh)));
    auto drawing = std::make_shared<core::LineDrawing>(core::drawLines(model, {512, true, maxEdges}, {}).value());
    drawing->isInterim = isInterim;
    return drawing;
}

template <class Widget> Widget* child(const ui::MainWindow& window, const char* name)
{
    return window.findChild<Widget*>(QLatin1StringView(name));
}

/// A window with the visible preview panel.
struct Shown
{
    Shown()
    {
        window.show();
        panel->toggleViewAction()->trigger();
    }

    ui::MainWindow window;
    ui::PreviewPanel* panel = window.findChild<ui::PreviewPanel*>();
    QSignalSpy wanted{panel, &ui::PreviewPanel::drawingRequested};
    ui::DrawingCanvas* canvas = child<ui::DrawingCanvas>(window, "preview.canvas");
};

QImage pictureOf(ui::DrawingCanvas* canvas)
{
    QSignalSpy painted(canvas, &ui::DrawingCanvas::painted);
    painted.wait();
    return canvas->picture();
}
} // namespace

class TestPreviewPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void itWantsDrawingsWhileItIsSeen()
    {
        ui::MainWindow window;
        window.show();
        auto* panel = window.findChild<ui::PreviewPanel*>();
        QVERIFY(panel && !panel->isVisible());
        QSignalSpy wanted(panel, &ui::PreviewPanel::drawingRequested);
        panel->toggleViewAction()->trigger();
        QTRY_COMPARE(wanted.size(), 1);
        QCOMPARE(wanted.takeFirst(), QVariantList({true, false}));
        child<QComboBox>(window, "preview.style")->setCurrentIndex(1);
        QCOMPARE(wanted.takeFirst(), QVariantList({true, true}));
        panel->toggleViewAction()->trigger();
        QTRY_COMPARE(wanted.size(), 1);
        QCOMPARE(wanted.takeFirst(), QVariantList({false, true}));
    }

    void itShowsWhatItIsGiven()
    {
        Shown shown;
        QTRY_VERIFY(shown.canvas->isVisible());
        shown.panel->setDrawing(sharedDrawingOf(shapes::cube(40)));
        const int all = inked(pictureOf(shown.canvas));
        QVERIFY(all > 100);
        child<QToolButton>(shown.window, "preview.dimensions")->click();
        const int lines = inked(pictureOf(shown.canvas));
        QVERIFY(lines > 100 && lines < all);
        child<QComboBox>(shown.window, "preview.style")->setCurrentIndex(1);
        QVERIFY(inked(pictureOf(shown.canvas)) > 2 * lines);
        shown.panel->setDrawing({});
        QCOMPARE(inked(pictureOf(shown.canvas)), 0);
    }

    void itSaysWhatIsMissing()
    {
        Shown shown;
        const auto* note = child<QLabel>(shown.window, "preview.note");
        QTRY_VERIFY(shown.canvas->isVisible());
        shown.panel->setDrawing(sharedDrawingOf(shapes::cube(40)));
        QVERIFY(!note->isVisible());
        shown.panel->setDrawing(sharedDrawingOf(shapes::cube(40), true));
        QVERIFY(!note->isVisible()); // simplified, but no lines are missing
        shown.panel->setDrawing(sharedDrawingOf(shapes::cube(40), true, 2));
        QVERIFY(note->isVisible());
        const QString interim = note->text();
        shown.panel->setDrawing(sharedDrawingOf(shapes::cube(40), false, 2));
        QVERIFY(note->isVisible() && !note->text().isEmpty() && note->text() != interim);
    }

    void keysAndWheelZoomAndZeroFits()
    {
        Shown shown;
        QTRY_VERIFY(shown.canvas->isVisible());
        shown.panel->setDrawing(sharedDrawingOf(core::icosphere(2, 30)));
        const QImage fitted = pictureOf(shown.canvas);
        QTest::keyClick(shown.canvas, Qt::Key_Plus);
        QVERIFY(shown.canvas->zoom() > 1);
        QVERIFY(pictureOf(shown.canvas) != fitted);
        QTest::keyClick(shown.canvas, Qt::Key_0);
        QCOMPARE(shown.canvas->zoom(), 1.0);
        QCOMPARE(pictureOf(shown.canvas), fitted);
    }

    void theChoiceComesBack()
    {
        {
            const ui::MainWindow window;
            child<QComboBox>(window, "preview.sides")->setCurrentIndex(3);
            child<QComboBox>(window, "preview.style")->setCurrentIndex(1);
            child<QToolButton>(window, "preview.dimensions")->click();
        }
        const ui::MainWindow window;
        QCOMPARE(child<QComboBox>(window, "preview.sides")->currentIndex(), 3);
        QCOMPARE(child<QComboBox>(window, "preview.style")->currentIndex(), 1);
        QVERIFY(!child<QToolButton>(window, "preview.dimensions")->isChecked());
        QSettings().setValue(QStringLiteral("drawing/sides"), 77);
        QCOMPARE(child<QComboBox>(ui::MainWindow(), "preview.sides")->currentIndex(), 0);
    }

    void aSheetIsAskedForByName()
    {
        const QTemporaryDir folder;
        Shown shown;
        shown.window.setModel(
            {QStringLiteral("lion.stl"), 8, 12, {1, 1, 1}, core::Box(core::Vec3(0, 0, 0), core::Vec3(1, 1, 1))});
        QSignalSpy asked(shown.panel, &ui::PreviewPanel::exportRequested);
        shown.window.action(QStringLiteral("file.exportDrawing"))->trigger();
        QFileDialog* dialog = nullptr;
        QTRY_VERIFY((dialog = child<QFileDialog>(shown.window, "drawingDialog")) && dialog->isVisible());
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        QCOMPARE(name->text(), QStringLiteral("lion"));
        dialog->setDirectory(folder.path());
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_COMPARE(asked.size(), 1);
        QCOMPARE(asked[0],
                 QVariantList({folder.filePath(QStringLiteral("lion.pdf")), QStringLiteral("lion.stl"), false}));
    }
};

FETTLE_TEST(TestPreviewPanel, ui::TestApplication)
#include "tst_preview_panel.moc"
