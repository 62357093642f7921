// Tests the parts of a document in the real window: the panel, the commands, picking, and undo across parts.

#include "tests/support/clay.h"
#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "app/analysis/print_analysis.h"
#include "app/model/model_loader.h"
#include "core/io/mesh_io.h"
#include "core/operations/detached_part.h"
#include "core/parts/part_split.h"
#include "core/repair/repair.h"
#include "core/sculpt/sculptor.h"
#include "ui/gizmo/gizmo.h"
#include "ui/model/model_panel.h"
#include "ui/model/objects_bar.h"
#include "ui/parts/combination_card.h"
#include "ui/parts/parts_panel.h"
#include "ui/settings/settings.h"
#include "ui/shapes/tube_card.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/side_panel.h"

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

#include <future>

using namespace app;
using core::PartId;

namespace
{
QTreeWidget* list(Program& program)
{
    return program.window.findChild<QTreeWidget*>(QStringLiteral("partList"));
}

QStringList names(Program& program)
{
    QStringList result;
    for (int i = 0; i < list(program)->topLevelItemCount(); ++i)
        result << list(program)->topLevelItem(i)->text(0);
    return result;
}

void waitUntilSettled(Program& program)
{
    QTRY_VERIFY(!program.document.job().isBusy() && program.document.queue().isSettled());
}

void trigger(Program& program, const char* id)
{
    program.window.action(QLatin1StringView(id))->trigger();
    waitUntilSettled(program);
}

void apply(Program& program, const core::ModelCommand& command)
{
    program.document.changer().apply(command);
    waitUntilSettled(program);
}

/// Returns a hash of each part's surface that does not depend on slots.
std::map<PartId, std::uint64_t> hashes(Program& program)
{
    std::promise<std::map<PartId, std::uint64_t>> answer;
    program.worker.post([&](core::Sculptor& sculptor) {
        std::map<PartId, std::uint64_t> result;
        for (const core::Part& part : sculptor.mesh().frame().parts.all())
            result[part.id] =
                core::Mesh(core::surfaceOf(sculptor.mesh(), part.id), sculptor.mesh().lattice()).meshHash();
        answer.set_value(result);
    });
    return answer.get_future().get();
}

/// Opens a ball and adds a copy of it beside, which is active then.
void openTwoBalls(Program& program, const QTemporaryDir& folder)
{
    const QString path = folder.filePath(QStringLiteral("ball.stl"));
    core::writeMesh(path.toStdString(), core::icosphere(4, 20));
    openFile(program, path);
    program.window.findChild<ui::SidePanel*>(QStringLiteral("partsPanel"))->setState(ui::SidePanel::State::Open);
    trigger(program, "parts.duplicate");
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy"}));
    QTest::mouseClick(list(program)->viewport(), Qt::LeftButton, {},
                      list(program)->visualItemRect(list(program)->topLevelItem(1)).center());
    QTRY_COMPARE(program.document.parts().active(), PartId(1));
    apply(program, core::Move{{30, 0, 0}});
}

/// Shows two balls from the front, and makes the first active.
void showTwoBalls(Program& program, const QTemporaryDir& folder)
{
    openTwoBalls(program, folder);
    program.document.parts().activate(0);
    trigger(program, "view.front");
    trigger(program, "view.frame");
}

void clickAt(Program& program, const core::Vec3& place, Qt::KeyboardModifiers keys = {})
{
    ui::Viewport* view = program.window.viewport();
    const auto pixel = view->camera().project(place);
    QTest::mouseClick(view, Qt::LeftButton, keys, {static_cast<int>(pixel.x()), static_cast<int>(pixel.y())});
}

/// Writes three balls of radius 4 as objects. Returns the file's path.
QString writeObjects(const QTemporaryDir& folder, const char* name, float distance)
{
    std::vector<core::PartPiece> pieces;
    std::vector<core::Part> parts;
    for (const char* const part : {"Low", "Middle", "High"}) {
        const auto id = static_cast<PartId>(pieces.size());
        parts.push_back({id, part, true, false, std::nullopt});
        pieces.push_back({id, shapes::moved(core::icosphere(3, 4), {0, distance * float(id), 0}), {}, {}});
    }
    const QString path = folder.filePath(QLatin1StringView(name));
    core::writeMesh(path.toStdString(), core::joined(pieces), {.parts = core::PartList(parts)});
    return path;
}

ui::ObjectsBar* bar(Program& program)
{
    for (ui::ObjectsBar* bar : program.window.findChildren<ui::ObjectsBar*>())
        if (bar->isVisible() && bar->isEnabled())
            return bar;
    return nullptr;
}

QString words(Program& program)
{
    return bar(program) ? bar(program)->findChild<QLabel*>(QStringLiteral("objectsText"))->text() : QString();
}

void press(Program& program, const char* button)
{
    bar(program)->findChild<QPushButton*>(QLatin1StringView(button))->click();
    waitUntilSettled(program);
}

/// Combines the active part with the selected ones. Returns the card that belongs to the preview.
QWidget* preview(Program& program, const char* id)
{
    auto* card = program.window.findChild<ui::CombinationCard*>();
    program.window.action(QLatin1StringView(id))->trigger();
    [card] { QTRY_VERIFY(card->isVisible()); }();
    return card;
}

/// Saves a picture of the window to the file that the environment variable names, for people to look at.
void savePicture(Program& program)
{
    const QString picture = qEnvironmentVariable("FETTLE_PICTURE");
    if (picture.isEmpty())
        return;
    QTest::qWait(500);
    program.window.grab().save(picture);
}
} // namespace

class TestPartsWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void stroke_changesTheActivePart();
    void undo_activatesThePartThatItChanges();
    void click_withAltChoosesThePart();
    void click_withoutKeysAfterTheCommand();
    void click_withCtrlOnlyExtendsTheSelection();
    void duplicate_activatesTheCopy();
    void handles_moveTheActivePart();
    void handles_comeWithAnInsertedPart();
    void row_hidesLocksAndRenames();
    void name_thatIsTooLong();
    void isolate_andBack();
    void showAll_showsAreasAndParts();
    void combine_joinsTheSelected();
    void combine_isCancelled();
    void combine_showsAnotherOperation();
    void combine_endsBeforeTheWindowCloses();
    void tube_isDrawnInTheView();
    void commands_areRefusedInWords();
    void insertedPart_becomesTheActiveOne();
    void insertedPart_needsNoEditablePart();
    void objects_openAsTheUserChooses();
    void objectsThatOverlap_openAsParts();
    void objects_ofManyNames();
    void objects_moreThanPartsAreOne();
    void objects_unsoundAreRepairedAsOne();
    void document_hasNoBar();
    void modelPanel_isOfTheActivePart();
    void printCheck_isOfTheVisibleParts();
    void printCheck_unitesPartsThatOverlap();
};

void TestPartsWindow::init()
{
    QSettings().clear();
}

void TestPartsWindow::stroke_changesTheActivePart()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto before = hashes(program);
    QTest::mouseClick(list(program)->viewport(), Qt::LeftButton, {},
                      list(program)->visualItemRect(list(program)->topLevelItem(0)).center());
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    core::StrokeSettings settings;
    settings.radius = 6;
    program.document.strokes().beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {-20, 0, 0};
    program.document.strokes().addSample(sample);
    program.document.strokes().endStroke();
    waitUntilSettled(program);
    const auto after = hashes(program);
    QVERIFY(after.at(0) != before.at(0));
    QCOMPARE(after.at(1), before.at(1));
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Part 1: Pull"));
    savePicture(program);
}

void TestPartsWindow::undo_activatesThePartThatItChanges()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto moved = hashes(program);
    program.document.parts().activate(0);
    apply(program, core::Fill{{250, 20, 20}});
    program.document.parts().activate(1);
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    QCOMPARE(hashes(program), moved);
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(1));
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(names(program), QStringList({"Part 1"}));
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    program.document.history().goTo(3);
    waitUntilSettled(program);
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy"}));
}

void TestPartsWindow::click_withAltChoosesThePart()
{
    const QTemporaryDir folder;
    Program program;
    showTwoBalls(program, folder);
    clickAt(program, {40, 0, 0}, Qt::AltModifier);
    QTRY_COMPARE(program.document.parts().active(), PartId(1));
    clickAt(program, {-10, 0, 0}, Qt::AltModifier);
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    QCOMPARE(program.document.history().stack().count(), 2); // neither click sculpted
}

/// The command makes the part active that is clicked next, once; Esc ends it.
void TestPartsWindow::click_withoutKeysAfterTheCommand()
{
    const QTemporaryDir folder;
    Program program;
    showTwoBalls(program, folder);
    ui::Viewport* view = program.window.viewport();
    const QAction* action = program.window.action(QStringLiteral("parts.choose"));
    trigger(program, "parts.choose");
    QVERIFY(action->isChecked());
    QCOMPARE(view->cursor().shape(), Qt::PointingHandCursor);
    QTest::keyClick(view, Qt::Key_Escape);
    QVERIFY(!action->isChecked());
    QCOMPARE(program.document.parts().active(), PartId(0));
    trigger(program, "parts.choose");
    clickAt(program, {40, 0, 0});
    QTRY_COMPARE(program.document.parts().active(), PartId(1));
    QVERIFY(!action->isChecked());
    QVERIFY(view->cursor().shape() != Qt::PointingHandCursor);
    waitUntilSettled(program);
    QCOMPARE(program.document.history().stack().count(), 2); // the click did not sculpt
}

void TestPartsWindow::click_withCtrlOnlyExtendsTheSelection()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto click = [&](int row, Qt::KeyboardModifiers keys) {
        QTest::mouseClick(list(program)->viewport(), Qt::LeftButton, keys,
                          list(program)->visualItemRect(list(program)->topLevelItem(row)).center());
    };
    const auto isBold = [&](int row) { return list(program)->topLevelItem(row)->font(0).bold(); };
    for (const auto key : {Qt::ControlModifier, Qt::ShiftModifier}) {
        click(0, {});
        QTRY_COMPARE(program.document.parts().active(), PartId(0));
        click(1, key);
        QCOMPARE(program.document.parts().active(), PartId(0));
        QCOMPARE(list(program)->selectedItems().size(), 2);
        QVERIFY(isBold(0) && !isBold(1));
        trigger(program, "parts.lock"); // a change of the list leaves the selection as it is
        QTRY_VERIFY(program.document.parts().list().find(0)->isLocked);
        QCOMPARE(list(program)->selectedItems().size(), 2);
        savePicture(program);
        trigger(program, "parts.lock");
        click(1, {});
        QTRY_COMPARE(program.document.parts().active(), PartId(1));
        QCOMPARE(list(program)->selectedItems().size(), 1);
        QVERIFY(!isBold(0) && isBold(1));
    }
    click(0, {});
    click(1, Qt::ControlModifier);
    click(0, Qt::ControlModifier); // not selected any more, but active
    QCOMPARE(program.document.parts().active(), PartId(0));
    QVERIFY(isBold(0));
    click(1, {});
    QTRY_COMPARE(program.document.parts().active(), PartId(1));
}

void TestPartsWindow::duplicate_activatesTheCopy()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    program.document.parts().activate(0);
    trigger(program, "parts.duplicate");
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy 2", "Part 1 copy"}));
    QCOMPARE(program.document.parts().active(), PartId(2));
    const auto before = hashes(program);
    apply(program, core::Move{{0, 50, 0}});
    QVERIFY(hashes(program).at(2) != before.at(2));
    QCOMPARE(hashes(program).at(0), before.at(0));
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(2));
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    program.document.history().redo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(2));
}

/// Drags an arrow of the handles: one step of the active part, which undo takes back. The handles follow the part.
void TestPartsWindow::handles_moveTheActivePart()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto before = hashes(program);
    program.window.action(QStringLiteral("model.transform"))->trigger();
    const auto* gizmo = program.window.findChild<ui::Gizmo*>(QStringLiteral("transformGizmo"));
    QTRY_VERIFY(gizmo->frame().has_value());
    QVERIFY((gizmo->frame()->centre - core::Vec3(30, 0, 0)).norm() < 0.1);
    ui::Viewport* view = program.window.viewport();
    const auto at = [&](const core::Vec3& point) {
        const ui::OrbitCamera::Pixel pixel = view->camera().project(point);
        return QPointF(pixel.x(), pixel.y()).toPoint();
    };
    const core::Vec3 centre = gizmo->frame()->centre;
    const core::Vec3 tip = centre + core::Vec3(0, ui::GizmoShape::length / view->camera().pixelsPerMm(centre), 0);
    const QPoint from = at(tip), to = at(tip + core::Vec3(0, 15, 0));
    const auto send = [view](QEvent::Type type, const QPoint& place, Qt::MouseButton button, Qt::MouseButtons held) {
        QMouseEvent event(type, place, view->mapToGlobal(place), button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(view, &event);
    };
    send(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int i = 1; i <= 8; ++i)
        send(QEvent::MouseMove, from + (to - from) * i / 8, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    QTRY_VERIFY(hashes(program) != before);
    waitUntilSettled(program);
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Part 1 copy: Move"));
    QCOMPARE(hashes(program).at(0), before.at(0));
    QTRY_VERIFY((gizmo->frame()->centre - core::Vec3(30, 15, 0)).norm() < 0.3);
    program.document.history().undo();
    waitUntilSettled(program);
    QCOMPARE(hashes(program), before);
    QTRY_VERIFY((gizmo->frame()->centre - core::Vec3(30, 0, 0)).norm() < 0.1);
    program.document.parts().activate(0);
    QTRY_VERIFY(gizmo->frame()->centre.norm() < 0.1);
}

/// A part that the window inserts gets the handles; one that a replay or a headset inserts does not.
void TestPartsWindow::handles_comeWithAnInsertedPart()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    core::Insert insert;
    insert.primitive = core::Primitive();
    insert.place = core::Insert::Place::Centre;
    insert.centre = {0, 30, 0};
    insert.combination = core::Insert::Combination::Part;
    const QAction* action = program.window.action(QStringLiteral("model.transform"));
    apply(program, insert);
    QTRY_COMPARE(names(program).size(), 3);
    QVERIFY(!action->isChecked());
    Q_EMIT program.window.commandRequested(insert);
    QTRY_VERIFY(action->isChecked());
    QTRY_COMPARE(names(program).size(), 4);
    const auto* gizmo = program.window.findChild<ui::Gizmo*>(QStringLiteral("transformGizmo"));
    QTRY_VERIFY(gizmo->frame() && (gizmo->frame()->centre - insert.centre).norm() < 0.1);
}

void TestPartsWindow::row_hidesLocksAndRenames()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto click = [&](int row, int column) {
        const QTreeWidgetItem* item = list(program)->topLevelItem(row);
        const QModelIndex index = list(program)->indexFromItem(item, column);
        QTest::mouseClick(list(program)->viewport(), Qt::LeftButton, {}, list(program)->visualRect(index).center());
        waitUntilSettled(program);
    };
    const auto part = [&](PartId id) { return *program.document.parts().list().find(id); };
    click(0, 1);
    QTRY_VERIFY(!part(0).isVisible && part(1).isVisible);
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Part 1: Hide"));
    click(0, 1);
    QTRY_VERIFY(part(0).isVisible);
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Part 1: Show"));
    click(1, 2);
    QTRY_VERIFY(part(1).isLocked);
    program.document.parts().activate(1);
    const auto before = hashes(program);
    QStringList sentences;
    QObject::connect(&program.document, &Document::refused, [&](const QString& sentence) { sentences << sentence; });
    apply(program, core::Fill{{1, 2, 3}});
    QCOMPARE(sentences.size(), 1);
    QCOMPARE(hashes(program), before);
    list(program)->topLevelItem(0)->setText(0, QStringLiteral("Rad ü"));
    QTRY_COMPARE(part(0).name, std::string("Rad ü"));
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(names(program).front(), QStringLiteral("Part 1"));
}

void TestPartsWindow::name_thatIsTooLong()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    QStringList notices;
    QObject::connect(&program.document, &Document::noticed, [&](const QString& sentence) { notices << sentence; });
    const QString longest(core::PartList::maxNameBytes, u'x');
    for (int i = 1; i <= 2; ++i) { // the second one changes nothing
        list(program)->topLevelItem(0)->setText(0, longest + u'y');
        QTRY_COMPARE(notices.size(), i);
        QCOMPARE(notices.back(), QStringLiteral("The name was too long, so its end was cut off."));
        waitUntilSettled(program);
        QTRY_COMPARE(names(program).front(), longest);
    }
    list(program)->topLevelItem(0)->setText(0, longest.chopped(1));
    QTRY_COMPARE(program.document.parts().list().find(0)->name, longest.chopped(1).toStdString());
    waitUntilSettled(program);
    QCOMPARE(notices.size(), 2);
}

void TestPartsWindow::isolate_andBack()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    trigger(program, "parts.duplicate");
    QTRY_COMPARE(list(program)->topLevelItemCount(), 3);
    program.document.parts().activate(0);
    trigger(program, "parts.hide");
    program.document.parts().activate(1);
    trigger(program, "parts.isolate");
    const auto isVisible = [&](PartId id) { return program.document.parts().list().isVisible(id); };
    QTRY_VERIFY(!isVisible(0) && isVisible(1) && !isVisible(2));
    trigger(program, "parts.isolate");
    QTRY_VERIFY(!isVisible(0) && isVisible(1) && isVisible(2)); // what was hidden before stays hidden
    trigger(program, "parts.showAll");
    QTRY_VERIFY(isVisible(0));
}

/// One key shows a hidden part and a hidden area, in one step.
void TestPartsWindow::showAll_showsAreasAndParts()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto hidden = [&program] {
        std::promise<std::pair<std::size_t, std::size_t>> answer;
        program.worker.post([&](core::Sculptor& sculptor) {
            const core::Mesh& mesh = sculptor.mesh();
            const auto vertices = std::ranges::count_if(mesh.vertices(), [&](auto v) { return mesh.isHidden(v); });
            const auto parts =
                std::ranges::count(mesh.frame().parts.all(), false, [](const auto& part) { return part.isVisible; });
            answer.set_value({static_cast<std::size_t>(vertices), static_cast<std::size_t>(parts)});
        });
        return answer.get_future().get();
    };
    apply(program, core::MaskOperation{core::MaskOperation::Kind::Invert, {}});
    apply(program, core::Hide{core::Hide::What::Masked});
    program.document.parts().activate(0);
    trigger(program, "parts.hide");
    const auto before = hidden();
    QVERIFY(before.first > 0 && before.second == 1);
    const int steps = program.document.history().stack().count();
    trigger(program, "parts.showAll");
    QVERIFY(hidden() == std::pair(std::size_t(0), std::size_t(0)));
    QCOMPARE(program.document.history().stack().count(), steps + 1);
    program.document.history().undo();
    waitUntilSettled(program);
    QVERIFY(hidden() == before);
}

void TestPartsWindow::combine_joinsTheSelected()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto before = hashes(program);
    program.document.parts().activate(0);
    QTRY_VERIFY(list(program)->currentItem() == list(program)->topLevelItem(0));
    list(program)->topLevelItem(1)->setSelected(true);
    QTest::keyClick(preview(program, "parts.union"), Qt::Key_Return);
    waitUntilSettled(program);
    QTRY_COMPARE(names(program), QStringList({"Part 1"}));
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Part 1: Join"));
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(hashes(program), before);
}

/// A preview that is cancelled, in any of three ways, leaves the parts bit for bit, and no step.
void TestPartsWindow::combine_isCancelled()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    apply(program, core::Move{{-28, 0, 0}});
    const auto before = hashes(program);
    const int steps = program.document.history().stack().count();
    program.document.parts().activate(0);
    list(program)->topLevelItem(1)->setSelected(true);
    QStringList notices;
    QObject::connect(&program.document, &Document::noticed, [&](const QString& sentence) { notices << sentence; });
    const auto cancelBy = [&](const std::function<void(QWidget*)>& cancel) {
        QWidget* card = preview(program, "parts.subtract");
        QTRY_COMPARE(names(program), QStringList({"Part 1"}));
        QVERIFY(hashes(program) != before);
        program.document.strokes().addSphere(core::StrokeSettings(), core::StrokeSample());
        QTRY_COMPARE(notices.size(), 1);
        notices.clear();
        cancel(card);
        waitUntilSettled(program);
        QTRY_VERIFY(!card->isVisible());
        QCOMPARE(hashes(program), before);
        QCOMPARE(program.document.history().stack().count(), steps);
        QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy"}));
        list(program)->topLevelItem(1)->setSelected(true);
    };
    cancelBy([](QWidget* card) { card->findChild<QPushButton*>(QStringLiteral("combinationCancel"))->click(); });
    cancelBy([&](QWidget*) { program.window.action(QStringLiteral("edit.stop"))->trigger(); });
    cancelBy([&](QWidget*) { program.window.action(QStringLiteral("edit.undo"))->trigger(); });
    trigger(program, "parts.hide"); // a later command is not cancelled, too
    QTRY_VERIFY(!program.document.parts().list().isVisible(0));
}

void TestPartsWindow::combine_showsAnotherOperation()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    apply(program, core::Move{{-28, 0, 0}});
    const auto before = hashes(program);
    program.document.parts().activate(0);
    list(program)->topLevelItem(1)->setSelected(true);
    QWidget* card = preview(program, "parts.subtract");
    savePicture(program);
    const auto subtracted = hashes(program);
    card->findChild<QToolButton*>(QStringLiteral("combinationIntersect"))->click();
    QTRY_VERIFY(card->isEnabled());
    QVERIFY(hashes(program) != subtracted);
    card->findChild<QToolButton*>(QStringLiteral("combinationSubtract"))->click();
    QTRY_VERIFY(card->isEnabled());
    QCOMPARE(hashes(program), subtracted);
    card->findChild<QPushButton*>(QStringLiteral("combinationApply"))->click();
    waitUntilSettled(program);
    QVERIFY(!card->isVisible());
    QCOMPARE(hashes(program), subtracted);
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Part 1: Subtract"));
    program.document.history().undo();
    waitUntilSettled(program);
    QCOMPARE(hashes(program), before);
    program.document.history().redo();
    waitUntilSettled(program);
    QCOMPARE(hashes(program), subtracted);
}

void TestPartsWindow::combine_endsBeforeTheWindowCloses()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    program.document.parts().activate(0);
    list(program)->topLevelItem(1)->setSelected(true);
    preview(program, "parts.union");
    program.document.savedState().setSaved(program.document.history().stack().index());
    program.window.close();
    QTRY_VERIFY(!program.window.isVisible());
    QTRY_COMPARE(hashes(program).size(), std::size_t(2));
}

/// A curve over the ball becomes a tube that is a part of its own, in one step, and has the handles then.
void TestPartsWindow::tube_isDrawnInTheView()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    trigger(program, "view.front");
    trigger(program, "view.frame");
    const auto before = hashes(program);
    ui::Viewport* view = program.window.viewport();
    program.window.action(QStringLiteral("model.tube"))->trigger();
    const QPointF from(view->width() * 0.15, view->height() * 0.5);
    const auto at = [&](double share) {
        return (from + QPointF(share * view->width() * 0.7, view->height() * 0.2 * std::sin(share * 9))).toPoint();
    };
    sendMouse(view, QEvent::MouseButtonPress, at(0), Qt::LeftButton);
    for (int i = 1; i <= 60; ++i) {
        QMouseEvent move(QEvent::MouseMove, at(i / 60.0), view->mapToGlobal(at(i / 60.0)), Qt::NoButton, Qt::LeftButton,
                         {});
        QCoreApplication::sendEvent(view, &move);
    }
    QTest::mouseRelease(view, Qt::LeftButton, {}, at(1));
    auto* card = view->findChild<ui::TubeCard*>();
    QTRY_VERIFY(card->isVisible());
    card->findChild<QComboBox*>(QStringLiteral("tubeCombination"))->setCurrentIndex(0);
    savePicture(program);
    QTest::keyClick(view, Qt::Key_Return);
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy", "Tube"}));
    waitUntilSettled(program);
    QCOMPARE(program.document.parts().active(), PartId(2));
    QTRY_VERIFY(program.window.action(QStringLiteral("model.transform"))->isChecked());
    program.document.history().undo();
    waitUntilSettled(program);
    QCOMPARE(hashes(program), before);
}

void TestPartsWindow::commands_areRefusedInWords()
{
    const QTemporaryDir folder;
    Program program;
    const QString path = folder.filePath(QStringLiteral("ball.stl"));
    core::writeMesh(path.toStdString(), core::icosphere(4, 20));
    openFile(program, path);
    QStringList sentences;
    QObject::connect(&program.document, &Document::refused, [&](const QString& sentence) { sentences << sentence; });
    for (const char* id : {"parts.delete", "parts.separate", "parts.union"})
        trigger(program, id);
    QCOMPARE(sentences.size(), 3);
    QVERIFY(sentences[0].contains(QStringLiteral("last part")));
    QCOMPARE(program.document.history().stack().count(), 0);
}

void TestPartsWindow::insertedPart_becomesTheActiveOne()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    program.document.parts().activate(0);
    const auto before = hashes(program);
    core::Insert ball;
    ball.combination = core::Insert::Combination::Part;
    ball.place = core::Insert::Place::AsItIs;
    ball.primitive.emplace().kind = core::Primitive::Kind::Ball;
    ball.primitive->length(core::Primitive::Measure::Radius) = 12;
    ball.name = "Ball";
    const int steps = program.document.history().stack().count();
    apply(program, ball);
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy", "Ball"}));
    QTRY_COMPARE(program.document.parts().active(), PartId(2));
    QTRY_VERIFY(list(program)->currentItem() == list(program)->topLevelItem(2));
    QCOMPARE(program.document.history().stack().count(), steps + 1);
    QCOMPARE(program.document.history().undoText(), QStringLiteral("Insert"));

    const QString path = folder.filePath(QStringLiteral("Ball.stl"));
    core::writeMesh(path.toStdString(), core::icosphere(3, 5));
    ui::InsertRequest insertion{path};
    insertion.combination = core::Insert::Combination::Part;
    program.document.changer().insert(insertion);
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy", "Ball", "Ball 2"}));
    QTRY_COMPARE(program.document.parts().active(), PartId(3));

    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(2)); // it was active before
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    QCOMPARE(hashes(program), before);
    program.document.history().redo();
    waitUntilSettled(program);
    QTRY_COMPARE(program.document.parts().active(), PartId(2));
}

void TestPartsWindow::insertedPart_needsNoEditablePart()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    trigger(program, "parts.hide");
    core::Insert box;
    box.combination = core::Insert::Combination::Part;
    box.primitive.emplace().kind = core::Primitive::Kind::Cuboid;
    apply(program, box);
    QTRY_COMPARE(names(program), QStringList({"Part 1", "Part 1 copy", "Part 3"}));
}

void TestPartsWindow::objects_openAsTheUserChooses()
{
    const QTemporaryDir folder;
    const QString path = writeObjects(folder, "three.3mf", 30);
    Program program;
    openFile(program, path);
    QTRY_VERIFY(bar(program));
    QCOMPARE(words(program), QStringLiteral("three.3mf has 3 objects. They are one part now."));
    QCOMPARE(names(program).size(), 1);
    savePicture(program);
    press(program, "asParts");
    QTRY_COMPARE(names(program), QStringList({"Low", "Middle", "High"}));
    QTRY_VERIFY(bar(program) && words(program).contains(QStringLiteral("Each is a part now.")));
    QVERIFY(ui::Settings().get<ui::Preferences>().opensObjectsAsParts);
    press(program, "leaveObjects");
    QTRY_VERIFY(!bar(program));

    Q_EMIT program.window.files()->openRequested(path); // remembered
    QTRY_VERIFY(bar(program));
    QTRY_COMPARE(names(program).size(), 3);
    press(program, "asOnePart");
    QTRY_COMPARE(names(program).size(), 1);
    QVERIFY(!ui::Settings().get<ui::Preferences>().opensObjectsAsParts);
    QTRY_VERIFY(bar(program));
    apply(program, core::Fill{{1, 2, 3}});
    QTRY_VERIFY(!bar(program)); // a change takes the question away
}

void TestPartsWindow::objectsThatOverlap_openAsParts()
{
    const QTemporaryDir folder;
    Program program;
    QSignalSpy noticed(&program.document, &Document::noticed);
    openFile(program, writeObjects(folder, "three.obj", 5));
    QTRY_COMPARE(names(program), QStringList({"Low", "Middle", "High"}));
    QVERIFY(!bar(program));
    QCOMPARE(noticed.size(), 1);
    QVERIFY(noticed[0][0].toString().startsWith(
        QStringLiteral("The objects of three.obj overlap or touch, so each is a part.")));
    QVERIFY(!program.document.savedState().isModified());
}

/// Tests names of 10,000 characters, and 500 objects.
void TestPartsWindow::objects_ofManyNames()
{
    const QTemporaryDir folder;
    std::vector<core::PartPiece> pieces;
    for (PartId id = 0; id < 500; ++id) {
        pieces.push_back({id, core::icosphere(1, 1), {}, {}});
        for (core::Vec3f& p : pieces.back().mesh.points)
            p += core::Vec3f(float(id % 25) * 3, float(id / 25) * 3, 0);
    }
    const QString path = folder.filePath(QStringLiteral("many.obj"));
    core::writeMesh(path.toStdString(), core::joined(pieces));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray text = file.readAll();
    QCOMPARE(text.count("o Part "), 500);
    text.replace("o Part 1\n", "o " + QByteArray(10'000, 'x') + '\n');
    file.resize(0);
    file.write(text);
    file.close();
    ui::Preferences preferences;
    preferences.opensObjectsAsParts = true;
    ui::Settings().set(preferences);
    Program program;
    openFile(program, path);
    QTRY_COMPARE(names(program).size(), 500);
    QCOMPARE(names(program)[0], QString(core::PartList::maxNameBytes, u'x'));
    QCOMPARE(names(program)[499], QStringLiteral("Part 500"));
}

void TestPartsWindow::objects_moreThanPartsAreOne()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("dust.obj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    constexpr int count = static_cast<int>(core::PartList::maxParts) + 1;
    for (int i = 0; i < count; ++i)
        file.write(QStringLiteral("o %1\nv %2 0 0\nv %3 0 0\nv %2 1 0\nv %2 0 1\n"
                                  "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n")
                       .arg(i)
                       .arg(2 * i)
                       .arg(2 * i + 1)
                       .toUtf8());
    file.close();
    for (const auto objects : {ModelLoader::Objects::AsOnePart, ModelLoader::Objects::AsParts}) {
        const LoadedModel model = ModelLoader::load(path, {}, {}, objects);
        QVERIFY2(model.sculptor, qPrintable(model.problem));
        QCOMPARE(model.sculptor->mesh().live().faces, std::size_t(4 * count));
        QCOMPARE(model.parts.size(), std::size_t(1));
        QCOMPARE(model.objects.count, std::size_t(1)); // there is no choice
        QVERIFY2(model.notice.contains(QStringLiteral("more objects than a model may have parts (1,000)")),
                 qPrintable(model.notice));
    }
}

void TestPartsWindow::objects_unsoundAreRepairedAsOne()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("open.obj"));
    const std::vector<core::PartPiece> pieces = {{0, core::icosphere(3, 9), {}, {}},
                                                 {1, shapes::moved(shapes::openCone(12), {40, 0, 0}), {}, {}}};
    core::writeMesh(path.toStdString(), core::joined(pieces));
    for (const auto objects : {ModelLoader::Objects::AsOnePart, ModelLoader::Objects::AsParts}) {
        const LoadedModel model = ModelLoader::load(path, {}, {}, objects);
        QVERIFY(!model.sculptor && model.isRepairable);
        QVERIFY2(model.problem.endsWith(QStringLiteral(" A repair makes one part of its 2 objects.")),
                 qPrintable(model.problem));
    }
    const LoadedModel repaired = ModelLoader::loadRepaired(path, {});
    QVERIFY2(repaired.sculptor, qPrintable(repaired.problem));
    QCOMPARE(repaired.sculptor->mesh().frame().parts.size(), std::size_t(1));
}

void TestPartsWindow::document_hasNoBar()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("saved.glb"));
    Program program;
    openTwoBalls(program, folder);
    program.document.saver().save(path);
    waitUntilSettled(program);
    for (const bool asParts : {false, true}) {
        ui::Preferences preferences;
        preferences.opensObjectsAsParts = asParts;
        ui::Settings().set(preferences);
        Program again;
        openFile(again, path);
        QTRY_COMPARE(names(again), QStringList({"Part 1", "Part 1 copy"}));
        QVERIFY(!bar(again));
    }
}

void TestPartsWindow::modelPanel_isOfTheActivePart()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    program.window.findChild<ui::SidePanel*>(QStringLiteral("modelPanel"))->setState(ui::SidePanel::State::Open);
    const auto value = [&program](const char* id) {
        return program.window.modelPanel()->findChild<QLabel*>(QLatin1StringView(id))->text();
    };
    QTRY_COMPARE(value("model.part"), QStringLiteral("Part 1 copy"));
    QCOMPARE(value("model.components"), QStringLiteral("1"));
    const QString size = value("model.size");
    apply(program, core::FlattenBase{20});
    QTRY_VERIFY(value("model.size") != size);
    program.document.parts().activate(0);
    QTRY_COMPARE(value("model.part"), QStringLiteral("Part 1"));
    QCOMPARE(value("model.size"), size); // the other part is as large as it was
}

void TestPartsWindow::printCheck_isOfTheVisibleParts()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    apply(program, core::Move{{20, 0, 0}}); // the balls do not overlap any more
    PrintAnalysis analysis(&program.document, &program.worker);
    analysis.setActive(true);
    std::size_t faces = 0;
    std::size_t shaded = 0;
    QObject::connect(&analysis, &PrintAnalysis::finished,
                     [&](const core::MeshReport& mesh, const core::PrintReport&, core::PartUnion, const auto& shades) {
                         faces = mesh.faces;
                         shaded = shades ? shades->slots.size() : 0;
                     });
    analysis.setOptions({{}, core::PrintPicture::Overhang});
    const std::size_t whole = program.document.modelInfo().faces;
    QTRY_COMPARE(faces, whole);
    QVERIFY(shaded > 0);
    const std::size_t shadedBefore = shaded;
    trigger(program, "parts.hide");
    QTRY_COMPARE(faces, whole / 2);
    QVERIFY(shaded > 0 && shaded < shadedBefore);
}

/// Tests a plate of 0.5 mm that is sunk into a block: the plate alone is too thin, the union is not.
void TestPartsWindow::printCheck_unitesPartsThatOverlap()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plate.glb"));
    core::TriangleMesh plate = shapes::cube(10);
    for (core::Vec3f& p : plate.points)
        p.y() = p.y() > 0 ? 10.25F : 9.75F;
    core::MeshFrame frame;
    frame.parts = core::PartList({{0, "Block", true, false, std::nullopt}, {1, "Plate", true, false, std::nullopt}});
    core::DocumentMetadata metadata;
    metadata.frame = frame;
    core::writeMesh(path.toStdString(), core::joined({{0, shapes::cube(20), {}, {}}, {1, plate, {}, {}}}),
                    {.metadata = metadata});
    Program program;
    openFile(program, path);
    QTRY_COMPARE(names(program), QStringList({"Block", "Plate"}));
    PrintAnalysis analysis(&program.document, &program.worker);
    std::optional<core::PartUnion> united;
    core::PrintReport report;
    core::MeshReport surface;
    std::vector<core::Slot> shaded;
    double share = 0;
    bool isAscending = true;
    QObject::connect(&analysis, &PrintAnalysis::progressed, [&](double next) {
        isAscending = isAscending && next >= share;
        share = next;
    });
    QObject::connect(&analysis, &PrintAnalysis::finished,
                     [&](const core::MeshReport& mesh, const core::PrintReport& print, core::PartUnion parts,
                         const std::shared_ptr<const core::Footprint>& shades) {
                         surface = mesh;
                         report = print;
                         united = parts;
                         shaded = shades->slots;
                         QCOMPARE(shades->weights.size(), shaded.size());
                     });
    analysis.setOptions({{}, core::PrintPicture::Thickness});
    analysis.setActive(true);
    QTRY_VERIFY(united);
    QCOMPARE(int(*united), int(core::PartUnion::Done));
    QVERIFY(isAscending);
    QVERIFY(surface.printReady());
    QVERIFY(std::abs(*surface.volume - (8000 + 100 * 0.25)) < 1e-3);
    QVERIFY(!core::hasThinWalls(report, {}));
    // the block's eight corners and the four of the plate outside of it are on the union, the four in it are not
    QCOMPARE(shaded.size(), std::size_t(12));
    trigger(program, "model.printCheck");
    const auto* findings = program.window.findChild<QListWidget*>(QStringLiteral("print.findings"));
    QVERIFY(findings);
    const auto count = [findings] {
        return findings->findItems(QStringLiteral("Overlapping parts checked as one"), Qt::MatchExactly).size();
    };
    QTRY_COMPARE(count(), 1);
    savePicture(program);
    united.reset();
    share = 0;
    trigger(program, "parts.isolate");
    QTRY_VERIFY(united);
    QCOMPARE(int(*united), int(core::PartUnion::NotNeeded));
    QTRY_COMPARE(count(), 0);
}

FETTLE_TEST(TestPartsWindow, app::OnScreen)

#include "tst_parts_window.moc"
