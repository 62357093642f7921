// Tests the print check in the real window: what it finds, shows and discards, and the commands that belong to it.

#include "tests/support/clay.h"
#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "ui/print/print_panel.h"
#include "ui/settings/settings.h"
#include "ui/widgets/side_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>

using namespace app;

namespace
{
/// Opens a model from a file and activates the window.
void open(Program& program, const core::TriangleMesh& mesh, const QTemporaryDir& folder)
{
    const QString path = folder.filePath(QStringLiteral("model.stl"));
    core::writeMesh(path.toStdString(), mesh);
    openFile(program, path);
}

/// Returns a cube, and beside it a plate 0.5 mm thick.
core::TriangleMesh plateAndCube()
{
    return shapes::together(shapes::moved(shapes::cube(20), {-40, -10, -10}), clay::slab(30, 0.5, 6));
}

template <class Widget> Widget* part(Program& program, const char* name)
{
    return program.window.findChild<Widget*>(QLatin1StringView(name));
}

QString verdict(Program& program)
{
    return part<QLabel>(program, "print.verdict")->text();
}

QListWidgetItem* rowWith(Program& program, const QString& text)
{
    const auto rows = part<QListWidget>(program, "print.findings")->findItems(text, Qt::MatchContains);
    return rows.isEmpty() ? nullptr : rows[0];
}

bool isAnswered(Program& program)
{
    return part<QListWidget>(program, "print.findings")->isEnabled() &&
           part<QListWidget>(program, "print.findings")->count() > 0;
}

void check(Program& program)
{
    QTest::keyClick(&program.window, Qt::Key_P, Qt::ControlModifier);
    QTRY_VERIFY(part<ui::SidePanel>(program, "printPanel")->isVisible());
    QTRY_VERIFY(isAnswered(program));
}

/// Returns the number of blue or orange pixels, colours that clay never has.
int shadedPixels(Program& program)
{
    const QImage picture = program.window.viewport()->grabFramebuffer();
    int count = 0;
    for (int y = 0; y < picture.height(); y += 2) {
        for (int x = 0; x < picture.width(); x += 2) {
            const QColor color = picture.pixelColor(x, y);
            count += color.blue() > color.red() + 70 || color.red() > color.blue() + 120 ? 1 : 0;
        }
    }
    return count;
}
} // namespace

class TestPrintPanelWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void check_findsThinWallsAndShowsThem();
    void places_areFlownTo();
    void places_bringTheirColours();
    void changes_outdateIt();
    void saving_keepsIt();
    void closing_takesColoursAway();
    void limits_evaluateAgain();
    void printers_areEdited();
    void stopping_leavesItUnchecked();
    void base_isFlattenedAndPlaced();
    void home_isTheControlsThatHasTheFocus();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestPrintPanelWindow::init()
{
    QSettings().clear();
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestPrintPanelWindow::check_findsThinWallsAndShowsThem()
{
    Program program;
    open(program, plateAndCube(), *m_folder);
    QCOMPARE(shadedPixels(program), 0);
    check(program);
    QVERIFY(rowWith(program, QStringLiteral("thinner than 0.8")));
    QVERIFY(rowWith(program, QStringLiteral("0.50 mm")));
    QVERIFY(rowWith(program, QStringLiteral("Fits")));
    QVERIFY(verdict(program).contains(QStringLiteral("Fix before printing")));
    QTRY_VERIFY(shadedPixels(program) > 1000);
}

void TestPrintPanelWindow::places_areFlownTo()
{
    Program program;
    open(program, plateAndCube(), *m_folder);
    check(program);
    auto* list = part<QListWidget>(program, "print.findings");
    QListWidgetItem* place = rowWith(program, QStringLiteral("0.50 mm"));
    list->setFocus();
    list->setCurrentItem(place);
    const core::Vec3 before = program.window.viewport()->camera().target();
    QTest::keyClick(list, Qt::Key_Return);
    QTRY_VERIFY((program.window.viewport()->camera().target() - before).norm() > 1);
    const ui::OrbitCamera& camera = program.window.viewport()->camera();
    const double plate = program.document.modelInfo().box.max().x() - 15; // x of the plate's centre
    QTRY_VERIFY(std::abs(camera.target().x() - plate) < 15.1 && std::abs(camera.viewDirection().y()) > 0.9);
    QTest::qWait(800); // waits until the camera has arrived
    const core::Vec3 eye = camera.eye();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(rowWith(program, QStringLiteral("Fits"))).center());
    QTest::qWait(500);
    QCOMPARE(camera.eye(), eye); // this finding has no place
}

/// Choosing an overhang changes the colours from thickness to overhang, unless the user has switched colours off.
void TestPrintPanelWindow::places_bringTheirColours()
{
    Program program;
    open(program, core::icosphere(5, 30), *m_folder);
    check(program);
    auto* list = part<QListWidget>(program, "print.findings");
    auto* colours = part<QComboBox>(program, "print.picture");
    const auto choosePlace = [&] {
        QListWidgetItem* place = rowWith(program, QStringLiteral("up to "));
        list->scrollToItem(place);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(place).center());
    };
    QCOMPARE(colours->currentText(), QStringLiteral("Thickness"));
    choosePlace();
    QTRY_COMPARE(colours->currentText(), QStringLiteral("Overhang"));
    QTest::qWait(500); // waits until the findings have been evaluated again
    QVERIFY(list->currentItem()->text().contains(QStringLiteral("up to ")));
    colours->setCurrentIndex(0);
    QTRY_COMPARE(shadedPixels(program), 0);
    choosePlace();
    QTest::qWait(500);
    QCOMPARE(colours->currentText(), QStringLiteral("None"));
}

void TestPrintPanelWindow::changes_outdateIt()
{
    Program program;
    open(program, core::icosphere(5, 30), *m_folder);
    check(program);
    QTRY_VERIFY(shadedPixels(program) > 1000);
    const QString known = verdict(program);
    drag(program.window.viewport(), {30, 10});
    QTRY_VERIFY(!isAnswered(program));
    QVERIFY(verdict(program) != known);
    QTRY_COMPARE(shadedPixels(program), 0);
    QTRY_VERIFY(isAnswered(program)); // starts by itself when the model is at rest
    QTRY_VERIFY(shadedPixels(program) > 1000);
}

/// Saving does not change the model, so the findings remain.
void TestPrintPanelWindow::saving_keepsIt()
{
    Program program;
    open(program, plateAndCube(), *m_folder);
    check(program);
    QTRY_VERIFY(shadedPixels(program) > 1000);
    program.document.saver().save(m_folder->filePath(QStringLiteral("saved.glb")));
    QTRY_VERIFY(program.document.modelInfo().path.endsWith(QStringLiteral("saved.glb")) &&
                !program.document.job().isBusy());
    QVERIFY(isAnswered(program));
    QVERIFY(shadedPixels(program) > 1000);
}

void TestPrintPanelWindow::closing_takesColoursAway()
{
    Program program;
    open(program, core::icosphere(5, 30), *m_folder);
    check(program);
    QTRY_VERIFY(shadedPixels(program) > 1000);
    part<ui::SidePanel>(program, "printPanel")->setState(ui::SidePanel::State::Hidden);
    QTRY_COMPARE(shadedPixels(program), 0);
    QTest::keyClick(&program.window, Qt::Key_P, Qt::ControlModifier);
    QTRY_VERIFY(shadedPixels(program) > 1000);
    part<QComboBox>(program, "print.picture")->setFocus();
    QTest::keyClick(part<QComboBox>(program, "print.picture"), Qt::Key_Up);
    QTRY_COMPARE(shadedPixels(program), 0);
}

void TestPrintPanelWindow::limits_evaluateAgain()
{
    Program program;
    open(program, plateAndCube(), *m_folder);
    check(program);
    auto* wall = part<QDoubleSpinBox>(program, "print.wall");
    wall->setFocus();
    wall->selectAll();
    QTest::keyClicks(wall, QStringLiteral("0.4"));
    QTest::keyClick(wall, Qt::Key_Return);
    QTRY_VERIFY(!rowWith(program, QStringLiteral("thinner than")));
    QVERIFY(rowWith(program, QStringLiteral("Walls from 0.500 mm")));
    QVERIFY(rowWith(program, QStringLiteral("overhangs beyond 45")));
    auto* overhang = part<QDoubleSpinBox>(program, "print.overhang");
    overhang->setFocus();
    overhang->selectAll();
    QTest::keyClicks(overhang, QStringLiteral("90"));
    QTest::keyClick(overhang, Qt::Key_Return);
    QTRY_VERIFY(rowWith(program, QStringLiteral("No overhangs")));
    QCOMPARE(ui::Settings().get<ui::PrintSettings>().wall, 0.4);
}

void TestPrintPanelWindow::printers_areEdited()
{
    Program program;
    open(program, plateAndCube(), *m_folder);
    check(program);
    QTest::mouseClick(part<QToolButton>(program, "print.printers"), Qt::LeftButton);
    QDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = part<QDialog>(program, "printersDialog")) && dialog->isVisible());
    auto* table = dialog->findChild<QTableWidget*>();
    while (table->rowCount() > 1) {
        table->setCurrentCell(0, 0);
        QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("removePrinter")), Qt::LeftButton);
    }
    table->item(0, 0)->setText(QStringLiteral("Tiny"));
    for (int i = 1; i <= 3; ++i)
        qobject_cast<QDoubleSpinBox*>(table->cellWidget(0, i))->setValue(30);
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
    QTRY_VERIFY(rowWith(program, QStringLiteral("Too large for Tiny")));
    QCOMPARE(ui::Settings().get(&ui::Setting::printers).size(), 1);
    QCOMPARE(ui::Settings().get(&ui::Setting::printers)[0].bed.z, 30.0);
}

void TestPrintPanelWindow::stopping_leavesItUnchecked()
{
    Program program;
    open(program, core::icosphere(7, 30), *m_folder);
    QTest::keyClick(&program.window, Qt::Key_P, Qt::ControlModifier);
    auto* button = part<QToolButton>(program, "print.check");
    QTRY_COMPARE(button->accessibleName(), QStringLiteral("Stop"));
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_COMPARE(button->accessibleName(), QStringLiteral("Check Now"));
    QTest::qWait(1500);
    QVERIFY(!isAnswered(program));
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(isAnswered(program));
}

void TestPrintPanelWindow::base_isFlattenedAndPlaced()
{
    Program program;
    open(program, core::icosphere(5, 30), *m_folder);
    check(program);
    QVERIFY(rowWith(program, QStringLiteral("Rests on a point")));
    program.window.action(QStringLiteral("model.flattenBase"))->trigger();
    QDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = part<QDialog>(program, "baseDialog")) && dialog->isVisible());
    auto* height = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("height"));
    height->selectAll();
    QTest::keyClicks(height, QStringLiteral("5"));
    QTest::keyClick(height, Qt::Key_Return);
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    QTRY_VERIFY(std::abs(program.document.modelInfo().box.min().y() + 25) < 0.01);
    QTRY_VERIFY(isAnswered(program) && !rowWith(program, QStringLiteral("Rests on a point")));
    program.window.action(QStringLiteral("model.placeOnBed"))->trigger();
    QTRY_COMPARE(program.document.modelInfo().box.min().y(), 0.0);
    QCOMPARE(program.document.history().stack().count(), 2);
    program.window.activateWindow();
    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&program.window, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(std::abs(program.document.modelInfo().box.min().y() + 30) < 0.01);
}

/// The Home key frames the model, except when a focused control uses it to go to its first entry.
void TestPrintPanelWindow::home_isTheControlsThatHasTheFocus()
{
    Program program;
    open(program, core::icosphere(4, 30), *m_folder);
    check(program);
    const ui::OrbitCamera& camera = program.window.viewport()->camera();
    const core::Vec3 framed = camera.eye();
    program.window.viewport()->setFocus();
    program.window.viewport()->navigation()->flyTo({0, 30, 0}, {0, 1, 0}, 5);
    QTRY_VERIFY((camera.eye() - framed).norm() > 10);
    QTest::qWait(800); // waits until the camera has arrived
    const core::Vec3 near = camera.eye();
    auto* printer = part<QComboBox>(program, "print.printer");
    printer->setCurrentIndex(3);
    printer->setFocus();
    QTest::keyClick(printer, Qt::Key_Home);
    QCOMPARE(printer->currentIndex(), 0);
    QCOMPARE(camera.eye(), near);
    program.window.viewport()->setFocus();
    QTest::keyClick(program.window.viewport(), Qt::Key_Home);
    QTRY_VERIFY((camera.eye() - near).norm() > 10);
}

FETTLE_TEST(TestPrintPanelWindow, app::OnScreen)

#include "tst_print_panel.moc"
