// Tests the parts of a document in the real window: the panel, the commands, picking, and undo across parts.

#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/operations/detached_part.h"
#include "core/sculpt/sculptor.h"
#include "ui/gizmo/gizmo.h"
#include "ui/parts/parts_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/side_panel.h"

#include <QAction>
#include <QTemporaryDir>
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
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.job().isBusy() && program.document.queue().isSettled(), longestWait);
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
} // namespace

class TestPartsWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void stroke_changesTheActivePart();
    void undo_activatesThePartThatItChanges();
    void click_withAltChoosesThePart();
    void handles_moveTheActivePart();
    void row_hidesLocksAndRenames();
    void isolate_andBack();
    void combine_joinsTheSelected();
    void commands_areRefusedInWords();
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
    const QString picture = qEnvironmentVariable("FETTLE_PICTURE");
    if (!picture.isEmpty()) {
        QTest::qWait(500);
        program.window.grab().save(picture);
    }
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
    openTwoBalls(program, folder);
    program.document.parts().activate(0);
    trigger(program, "view.front");
    trigger(program, "view.frame");
    ui::Viewport* view = program.window.viewport();
    const auto at = [&](const core::Vec3& p) {
        const auto pixel = view->camera().project(p);
        return QPoint(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    };
    QTest::mouseClick(view, Qt::LeftButton, Qt::AltModifier, at({40, 0, 0}));
    QTRY_COMPARE(program.document.parts().active(), PartId(1));
    QTest::mouseClick(view, Qt::LeftButton, Qt::AltModifier, at({-10, 0, 0}));
    QTRY_COMPARE(program.document.parts().active(), PartId(0));
    QCOMPARE(program.document.history().stack().count(), 2); // neither click sculpted
}

/// Drags an arrow of the handles: one step of the active part, which undo takes back. The handles follow the part.
void TestPartsWindow::handles_moveTheActivePart()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto before = hashes(program);
    program.window.action(QStringLiteral("model.transform"))->trigger();
    const auto* gizmo = program.window.findChild<ui::Gizmo*>();
    QTRY_VERIFY_WITH_TIMEOUT(gizmo->frame().has_value(), longestWait);
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
    QTRY_VERIFY_WITH_TIMEOUT(hashes(program) != before, longestWait);
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
    click(0, 1);
    QTRY_VERIFY(part(0).isVisible);
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

void TestPartsWindow::combine_joinsTheSelected()
{
    const QTemporaryDir folder;
    Program program;
    openTwoBalls(program, folder);
    const auto before = hashes(program);
    program.document.parts().activate(0);
    QTRY_VERIFY(list(program)->currentItem() == list(program)->topLevelItem(0));
    list(program)->topLevelItem(1)->setSelected(true);
    trigger(program, "parts.union");
    QTRY_COMPARE(names(program), QStringList({"Part 1"}));
    program.document.history().undo();
    waitUntilSettled(program);
    QTRY_COMPARE(hashes(program), before);
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

FETTLE_TEST(TestPartsWindow, app::OnScreen)

#include "tst_parts_window.moc"
