// Moves a ball by the handles and numbers of the transform tool, and looks at what the view shows.

#include "ui/gizmo/transform_tool.h"

#include "core/analysis/mesh_check.h"
#include "core/mesh/dirty_slots.h"
#include "tests/support/test_main.h"
#include "tests/ui/view_stage.h"
#include "ui/gizmo/gizmo.h"
#include "ui/gizmo/transform_fields.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QPushButton>

#include <utility>

using core::Vec3;

namespace
{
/// Makes the changes that the tool requests.
struct Stage : ui::ViewStage
{
    Stage() : ViewStage(4), tool(new ui::TransformTool(actions, viewport))
    {
        QObject::connect(tool, &ui::TransformTool::regionWanted, tool,
                         [this] { tool->setRegion(core::transformRegionOf(*mesh, 0)); });
        QObject::connect(tool, &ui::TransformTool::requested, tool, [this](const core::ModelCommand& command) {
            requests.push_back(std::get<core::Transform>(command));
        });
    }

    ui::Gizmo* gizmo() const { return viewport->findChild<ui::Gizmo*>(); }
    ui::TransformFields* fields() const { return viewport->findChild<ui::TransformFields*>(); }
    QAction* action() const { return actions.get(QStringLiteral("model.transform")); }

    /// Returns the pixel of the arrow's tip along X; the view is from the front.
    QPoint arrow() const { return at(gizmo()->frame()->centre) + QPoint(static_cast<int>(ui::GizmoShape::length), 0); }

    /// Makes the last requested change, and shows it.
    void apply()
    {
        QVERIFY(!requests.empty());
        core::ModelChange change = applyToCopy(*mesh, requests.back());
        QVERIFY(change.changes);
        mesh->swap(change.delta);
        QVERIFY(core::checkMesh(core::extractMesh(*mesh)).printReady());
        showMesh();
        tool->refresh();
    }
    Vec3 middle() const { return core::transformRegionOf(*mesh, 0).box.center(); }

    ui::TransformTool* tool;
    std::vector<core::Transform> requests;
};

/// Returns the share of pixels that differ by more than this sum of the channels.
double difference(const QImage& a, const QImage& b, int limit = 24)
{
    int differing = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            differing +=
                std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > limit;
        }
    }
    return double(differing) / (double(a.width()) * a.height());
}
} // namespace

class TestTransformTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void arrow_movesThePart();
    void preview_isTheResult_data();
    void preview_isTheResult();
    void handles_followThePart();
    void escape_takesBackTheDragThenEnds();
    void numbers_areAppliedOnReturn();
    void return_givesTheKeysBackToTheView();
    void columns_areEquallyFarApart();
    void presses_besideTheHandles_turnTheView();
    void alt_movesTheHandlesAlone();
    void axisKey_keepsToTheAxis();
    void ownAxes_areThoseOfThePart();
    void refusal_endsThePreview();
    void otherMode_endsTheTool();
};

void TestTransformTool::arrow_movesThePart()
{
    Stage stage;
    QVERIFY(!stage.gizmo()->isVisible() && !stage.fields()->isVisible());
    stage.action()->trigger();
    QVERIFY(stage.gizmo()->isVisible() && stage.fields()->isVisible());
    const double mm = 60 / stage.viewport->camera().pixelsPerMm(Vec3::Zero());
    stage.drag(stage.arrow(), {60, 25});
    QCOMPARE(stage.requests.size(), std::size_t(1));
    stage.apply();
    QVERIFY((stage.middle() - Vec3(mm, 0, 0)).norm() < 0.02 * mm);
}

void TestTransformTool::preview_isTheResult_data()
{
    QTest::addColumn<bool>("isMasked");
    QTest::addColumn<core::Transform>("transform");
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.6, Vec3(1, 1, 0).normalized()));
    for (const bool isMasked : {false, true}) {
        const char* const mask = isMasked ? "half masked" : "whole";
        QTest::addRow("move, %s", mask) << isMasked << core::Transform{{}, {12, 8, 0}};
        QTest::addRow("rotate, %s", mask) << isMasked << core::Transform{{5, 0, 0}, Vec3::Zero(), turn};
        QTest::addRow("scale, %s", mask) << isMasked
                                         << core::Transform{{0, 0, 0}, Vec3::Zero(), turn, {1.4, 0.8, 1}, turn};
    }
}

/// The picture of the preview is that of the changed mesh; where the mask's edge is drawn out, but for the shading.
void TestTransformTool::preview_isTheResult()
{
    QFETCH(bool, isMasked);
    QFETCH(core::Transform, transform);
    Stage stage;
    stage.mesh->beginStroke();
    for (const core::Slot v : stage.mesh->vertices()) {
        const core::Vec3f p = stage.mesh->point(v);
        if (isMasked)
            stage.mesh->setMask(v, static_cast<std::uint8_t>(std::clamp(127 - 12 * p.x(), 0.0F, 255.0F)));
        stage.mesh->setColor(v, p.y() > 5 ? core::Rgb{200, 60, 40} : core::Rgb{60, 90, 200});
    }
    stage.mesh->endStroke();
    stage.showMesh();
    const QImage before = stage.picture();
    stage.viewport->showMoved(core::transformRegionOf(*stage.mesh, 0).vertices, transform);
    const QImage preview = stage.picture();
    stage.viewport->showMoved({});
    QVERIFY(difference(stage.picture(), before) == 0);
    stage.requests.push_back(transform);
    stage.apply();
    const QImage result = stage.picture();
    QVERIFY(difference(before, result) > 0.01);
    const double differing = difference(preview, result, isMasked ? 120 : 24);
    QVERIFY2(differing < 0.004, qPrintable(QString::number(differing)));
}

void TestTransformTool::handles_followThePart()
{
    Stage stage;
    stage.action()->trigger();
    stage.drag(stage.arrow(), {70, 0});
    stage.apply();
    QVERIFY((stage.gizmo()->frame()->centre - stage.middle()).norm() < 0.01);
    // The change is undone: they go back with the part.
    const core::ModelChange back = applyToCopy(*stage.mesh, core::Move{-stage.middle()});
    core::MeshDelta delta = back.delta;
    stage.mesh->swap(delta);
    stage.tool->refresh();
    QVERIFY(stage.gizmo()->frame()->centre.norm() < 0.01);
}

void TestTransformTool::escape_takesBackTheDragThenEnds()
{
    Stage stage;
    stage.action()->trigger();
    const QImage before = stage.picture();
    const QPoint from = stage.arrow();
    stage.press(from);
    stage.move(from + QPoint(50, 0));
    QVERIFY(difference(before, stage.picture()) > 0.01);
    QTest::keyClick(stage.viewport, Qt::Key_Escape);
    stage.move(from + QPoint(70, 0));
    stage.release(from + QPoint(70, 0));
    QVERIFY(stage.requests.empty());
    QVERIFY(stage.tool->isOn());
    QVERIFY(stage.gizmo()->frame()->centre.isZero());
    QVERIFY(difference(before, stage.picture()) < 0.001);
    QTest::keyClick(stage.viewport, Qt::Key_Escape);
    QVERIFY(!stage.tool->isOn() && !stage.gizmo()->isVisible() && !stage.fields()->isVisible());
    QVERIFY(stage.viewport->input()->mode() == ui::PointerMode::Sculpt);
}

void TestTransformTool::numbers_areAppliedOnReturn()
{
    Stage stage;
    stage.action()->trigger();
    auto* move = stage.fields()->findChild<QDoubleSpinBox*>(QStringLiteral("moveY"));
    auto* scale = stage.fields()->findChild<QDoubleSpinBox*>(QStringLiteral("scaleX"));
    const QImage before = stage.picture();
    move->setValue(12.5);
    scale->setValue(2);
    QVERIFY(difference(before, stage.picture()) > 0.01);
    QTest::keyClick(move, Qt::Key_Return);
    QCOMPARE(stage.requests.size(), std::size_t(1));
    QVERIFY(stage.requests.front().by == Vec3(0, 12.5, 0) && stage.requests.front().scale == Vec3(2, 1, 1));
    QCOMPARE(move->value(), 0.0); // the next change begins anew
    QCOMPARE(scale->value(), 1.0);
    stage.apply();
    QTest::keyClick(move, Qt::Key_Return);
    QCOMPARE(stage.requests.size(), std::size_t(1)); // no change is no request
    stage.fields()->findChild<QPushButton*>(QStringLiteral("transformDone"))->click();
    QVERIFY(!stage.tool->isOn());
}

/// Undo after a number undoes the model, not the number.
void TestTransformTool::return_givesTheKeysBackToTheView()
{
    Stage stage;
    stage.action()->trigger();
    auto* move = stage.fields()->findChild<QDoubleSpinBox*>(QStringLiteral("moveX"));
    move->setFocus();
    move->selectAll();
    QTest::keyClicks(move, QStringLiteral("1,5"));
    QTest::keyClick(move, Qt::Key_Return);
    QCOMPARE(stage.requests.size(), std::size_t(1));
    QVERIFY(stage.requests.front().by == Vec3(1.5, 0, 0));
    QVERIFY(stage.viewport->hasFocus());
}

void TestTransformTool::columns_areEquallyFarApart()
{
    Stage stage;
    stage.action()->trigger();
    const auto left = [&](const char* name) {
        return stage.fields()->findChild<QDoubleSpinBox*>(QLatin1StringView(name))->x();
    };
    QVERIFY(std::abs((left("moveY") - left("moveX")) - (left("moveZ") - left("moveY"))) <= 1);
}

void TestTransformTool::presses_besideTheHandles_turnTheView()
{
    Stage stage;
    int strokes = 0;
    QObject::connect(stage.viewport->input(), &ui::PointerInput::strokeBegan, &stage.window, [&] { ++strokes; });
    QObject::connect(stage.viewport->input(), &ui::PointerInput::hoverRequested, &stage.window, [&] {
        stage.viewport->input()->setHover(core::SurfaceHit{{0, 0, 30}, Vec3::UnitZ(), 0, 0});
    });
    stage.action()->trigger();
    const Vec3 eye = stage.viewport->camera().eye();
    stage.drag(stage.at({-21, -21, 0}), {-40, 10});
    QCOMPARE(strokes, 0);
    QVERIFY(stage.requests.empty());
    QVERIFY(!stage.viewport->camera().eye().isApprox(eye));
}

void TestTransformTool::alt_movesTheHandlesAlone()
{
    Stage stage;
    stage.action()->trigger();
    stage.drag(stage.arrow(), {60, 0}, Qt::AltModifier);
    QVERIFY(stage.requests.empty());
    const Vec3 centre = stage.gizmo()->frame()->centre;
    QVERIFY(centre.x() > 5);
    stage.tool->refresh(); // for example after a stroke that left the part where it was
    QVERIFY(stage.gizmo()->frame()->centre == centre);
    stage.fields()->findChild<QDoubleSpinBox*>(QStringLiteral("rotateZ"))->setValue(90);
    QTest::keyClick(stage.fields(), Qt::Key_Return);
    QVERIFY(stage.requests.back().centre == centre);
    stage.apply();
    QVERIFY((stage.middle() - (centre + Vec3(0, -centre.x(), 0))).norm() < 0.01); // about the moved handles
    QVERIFY(stage.gizmo()->frame()->centre.isApprox(centre));
}

void TestTransformTool::axisKey_keepsToTheAxis()
{
    Stage stage;
    stage.action()->trigger();
    const QPoint centre = stage.at(stage.gizmo()->frame()->centre);
    stage.press(centre);
    stage.move(centre + QPoint(40, 30));
    QTest::keyClick(stage.viewport, Qt::Key_Y);
    stage.release(centre + QPoint(40, 30));
    QCOMPARE(stage.requests.size(), std::size_t(1));
    const Vec3 by = stage.requests.front().by;
    QVERIFY(std::abs(by.x()) < 1e-9 && std::abs(by.z()) < 1e-9 && by.y() < -1);
}

void TestTransformTool::ownAxes_areThoseOfThePart()
{
    Stage stage;
    stage.requests.push_back({Vec3::Zero(), Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3::UnitZ()))});
    stage.apply();
    stage.action()->trigger();
    QVERIFY(stage.gizmo()->frame()->axis(0).isApprox(Vec3::UnitX()));
    auto* axes = stage.fields()->findChild<QComboBox*>(QStringLiteral("transformAxes"));
    axes->setCurrentIndex(1);
    Q_EMIT axes->activated(1);
    QVERIFY((stage.gizmo()->frame()->axis(0) - Vec3(std::cos(0.5), std::sin(0.5), 0)).norm() < 1e-6);
}

void TestTransformTool::refusal_endsThePreview()
{
    Stage stage;
    stage.action()->trigger();
    const QImage before = stage.picture();
    stage.drag(stage.arrow(), {60, 0});
    QVERIFY(difference(before, stage.picture()) > 0.01);
    stage.tool->dropRequest();
    QVERIFY(difference(before, stage.picture()) < 0.001);
    QVERIFY(stage.gizmo()->frame()->centre.isZero());
}

void TestTransformTool::otherMode_endsTheTool()
{
    Stage stage;
    stage.action()->trigger();
    stage.viewport->input()->setMode(ui::PointerMode::Pick);
    QVERIFY(!stage.tool->isOn() && !stage.gizmo()->isVisible());
    QVERIFY(stage.viewport->input()->mode() == ui::PointerMode::Pick);
}

FETTLE_TEST(TestTransformTool, ui::TestApplication)

#include "tst_transform_tool.moc"
