// Cuts a ball along the plane of the plane cut tool, and looks at what is left of it.

#include "ui/gizmo/plane_cut_tool.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/rotation.h"
#include "core/mesh/dirty_slots.h"
#include "core/operations/detached_part.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/test_main.h"
#include "tests/ui/view_stage.h"
#include "ui/gizmo/gizmo.h"
#include "ui/gizmo/transform_tool.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

#include <numbers>
#include <utility>

using core::Vec3;

namespace
{
constexpr double radius = 30;

/// Makes the cuts that the tool requests.
struct CutStage : ui::ViewStage
{
    CutStage() : ViewStage(5), tool(new ui::PlaneCutTool(actions, &brush, viewport))
    {
        QObject::connect(tool, &ui::PlaneCutTool::regionWanted, tool,
                         [this] { tool->setRegion(core::transformRegionOf(*mesh, 0)); });
        QObject::connect(tool, &ui::PlaneCutTool::requested, tool,
                         [this](const core::ModelCommand& command) { requests.push_back(command); });
    }

    ui::Gizmo* gizmo() const { return viewport->findChild<ui::Gizmo*>(); }
    QAction* action() const { return actions.get(QStringLiteral("area.plane")); }
    void click(const char* button) { viewport->findChild<QPushButton*>(QLatin1StringView(button))->click(); }

    /// Drags an arrow of the gizmo upwards by so many pixels.
    void raise(int pixels)
    {
        const QPoint arrow = at(gizmo()->frame()->centre) - QPoint(0, static_cast<int>(ui::GizmoShape::length));
        drag(arrow, QPoint(0, -pixels));
    }

    /// Makes the requested cut. Returns the volume that is left of the part.
    double volumeLeft(core::PartId part = 0)
    {
        core::ModelChange change = applyToCopy(*mesh, requests.back());
        if (!change.changes)
            return -1;
        mesh->swap(change.delta);
        return core::checkMesh(core::surfaceOf(*mesh, part)).volume.value_or(-1);
    }

    ui::PlaneCutTool* tool;
    std::vector<core::ModelCommand> requests;
};

/// Returns the volume of the ball below a height.
double volumeBelow(double height)
{
    const double h = radius + height;
    return std::numbers::pi * h * h * (radius - h / 3);
}
} // namespace

class TestPlaneCutTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void cut_removesWhatIsTinted();
    void plane_isMovedByTheHandles();
    void otherParts_areNotTinted();
    void newFace_isNotTinted();
    void cut_hasThePaintColorIfWished();
    void swap_keepsTheOtherSide();
    void split_makesTwoParts();
    void symmetry_cutsBothSides();
    void symmetry_saysWhatItDoes();
    void escape_endsTheTool();
    void anotherTool_endsThisOne();
};

void TestPlaneCutTool::cut_removesWhatIsTinted()
{
    CutStage stage;
    const QImage before = stage.viewport->grabFramebuffer();
    stage.action()->trigger();
    QVERIFY(stage.gizmo()->isVisible());
    const QImage tinted = stage.viewport->grabFramebuffer();
    const ui::OrbitCamera::Pixel middle = stage.viewport->camera().project(Vec3::Zero());
    const double perMm = stage.viewport->camera().pixelsPerMm(Vec3::Zero()) * stage.viewport->devicePixelRatioF();
    const auto redness = [&](const QImage& picture, double height) {
        const QColor color =
            picture.pixelColor(static_cast<int>(middle.x() * stage.viewport->devicePixelRatioF()),
                               static_cast<int>(middle.y() * stage.viewport->devicePixelRatioF() - height * perMm));
        return color.red() - color.green();
    };
    QVERIFY(redness(tinted, 15) > redness(before, 15) + 30); // above the plane
    QVERIFY(std::abs(redness(tinted, -15) - redness(before, -15)) < 4);
    stage.click("planeCutAway");
    const double left = stage.volumeLeft();
    QVERIFY(std::abs(left - volumeBelow(0)) < 0.01 * left);
    for (const core::Slot v : stage.mesh->vertices())
        QVERIFY(stage.mesh->point(v).y() < 4 * stage.mesh->lattice().unit());
}

void TestPlaneCutTool::plane_isMovedByTheHandles()
{
    CutStage stage;
    stage.action()->trigger();
    stage.raise(50);
    QVERIFY(stage.requests.empty()); // only the plane has moved
    const double height = stage.gizmo()->frame()->centre.y();
    QVERIFY(height > 3);
    stage.click("planeCutAway");
    const double left = stage.volumeLeft();
    QVERIFY(std::abs(left - volumeBelow(height)) < 0.01 * left);
}

/// Only the active part is cut, so nothing of another one is tinted.
void TestPlaneCutTool::otherParts_areNotTinted()
{
    CutStage stage;
    stage.action()->trigger();
    stage.click("planeCutSplit");
    stage.volumeLeft();
    stage.showMesh();
    const auto rednessAt = [&](const Vec3& place) {
        const QPointF at = stage.viewport->devicePixelRatioF() * QPointF(stage.at(place));
        const QColor color = stage.picture().pixelColor(at.toPoint());
        return color.red() - color.green();
    };
    const Vec3 above(0, 20, 0), below(0, -20, 0); // in the part that was split off, and in the active one
    stage.tool->refresh();
    const int ofOther = rednessAt(above), ofActive = rednessAt(below);
    stage.click("planeCutSwap");
    QVERIFY(std::abs(rednessAt(above) - ofOther) < 4);
    QVERIFY(rednessAt(below) > ofActive + 30);
    stage.action()->trigger();
    QVERIFY(std::abs(rednessAt(above) - ofOther) < 4);
    QVERIFY(std::abs(rednessAt(below) - ofActive) < 4);
}

/// The plane stays where it was; the face that it has left looks as it does without the tool.
void TestPlaneCutTool::newFace_isNotTinted()
{
    CutStage stage;
    stage.action()->trigger();
    const Vec3 normal = Vec3(0.3, 1, 0.2).normalized();
    stage.gizmo()->setFrame(ui::GizmoFrame{{1, 4, 2}, core::rotationBetween(Vec3::UnitY(), normal)});
    Q_EMIT stage.gizmo()->frameMoved();
    stage.click("planeCutAway");
    stage.volumeLeft();
    stage.showMesh();
    stage.tool->refresh();
    stage.viewport->navigation()->turnTo(ui::OrbitCamera::Side::Top);
    const QImage on = stage.picture();
    stage.action()->trigger();
    const QImage off = stage.picture();
    const QPoint middle = stage.at({1, 4, 2}) * stage.viewport->devicePixelRatioF();
    const int reach = static_cast<int>(15 * stage.viewport->camera().pixelsPerMm(Vec3::Zero()));
    for (int y = -reach; y <= reach; y += 3) {
        for (int x = -reach; x <= reach; x += 3)
            QCOMPARE(on.pixel(middle + QPoint(x, y)), off.pixel(middle + QPoint(x, y)));
    }
}

void TestPlaneCutTool::cut_hasThePaintColorIfWished()
{
    CutStage stage;
    const core::Rgb color{20, 160, 90};
    stage.brush.set(&core::StrokeSettings::color, color);
    stage.action()->trigger();
    stage.click("planeCutAway");
    QVERIFY(!std::get<core::Trim>(stage.requests.back()).color);
    stage.viewport->findChild<QCheckBox*>(QStringLiteral("planeCutColors"))->click();
    stage.click("planeCutAway");
    stage.volumeLeft();
    for (const core::Slot v : stage.mesh->vertices()) {
        const core::Vec3f p = stage.mesh->point(v);
        if (p.y() > -0.01F && p.head<2>().norm() < 25)
            QVERIFY(stage.mesh->color(v) == color || p.norm() > 29);
        else if (p.y() < -1)
            QVERIFY(stage.mesh->color(v) != color);
    }
}

void TestPlaneCutTool::swap_keepsTheOtherSide()
{
    CutStage stage;
    stage.action()->trigger();
    stage.raise(50);
    const double height = stage.gizmo()->frame()->centre.y();
    stage.click("planeCutSwap");
    stage.click("planeCutAway");
    const double left = stage.volumeLeft();
    QVERIFY(std::abs(left - (volumeBelow(radius) - volumeBelow(height))) < 0.02 * left);
}

void TestPlaneCutTool::split_makesTwoParts()
{
    CutStage stage;
    const double whole = core::checkMesh(core::extractMesh(*stage.mesh)).volume.value();
    stage.action()->trigger();
    stage.raise(40);
    stage.click("planeCutSplit");
    const double below = stage.volumeLeft();
    QCOMPARE(stage.mesh->frame().parts.size(), std::size_t(2));
    const double above = core::checkMesh(core::surfaceOf(*stage.mesh, 1)).volume.value();
    QVERIFY(std::abs(below + above - whole) < 1e-5 * whole);
    QVERIFY(below > above && above > 0.05 * whole);
}

/// Cuts obliquely with symmetry: both sides are tinted beforehand, and gone afterwards.
void TestPlaneCutTool::symmetry_cutsBothSides()
{
    CutStage stage;
    const auto rednessAt = [&](const Vec3& place) {
        const double ratio = stage.viewport->devicePixelRatioF();
        const QPointF at = ratio * QPointF(stage.at(place));
        const QColor color = stage.picture().pixelColor(at.toPoint());
        return color.red() - color.green();
    };
    const Vec3 left(-22, 10, 0), right(22, 10, 0), middle(0, 6, 0);
    stage.action()->trigger();
    stage.gizmo()->setFrame(ui::GizmoFrame{{14, 0, 0}, core::rotationBetween(Vec3::UnitY(), Vec3(1, 0.2, 0.1))});
    Q_EMIT stage.gizmo()->frameMoved();
    const int before = rednessAt(left);
    QVERIFY(rednessAt(right) > rednessAt(middle) + 30);
    stage.brush.setSymmetric(true);
    QVERIFY(rednessAt(left) > before + 30); // at once
    QVERIFY(rednessAt(right) > rednessAt(middle) + 30);
    stage.click("planeCutAway");
    const double whole = volumeBelow(radius), left1 = stage.volumeLeft();
    QVERIFY(left1 > 0 && left1 < 0.8 * whole);
    VERIFY_SYMMETRIC(*stage.mesh, core::Symmetry::X);
}

void TestPlaneCutTool::symmetry_saysWhatItDoes()
{
    CutStage stage;
    stage.action()->trigger();
    const auto* word = stage.viewport->findChild<QLabel*>(QStringLiteral("planeCutWord"));
    QVERIFY(!word->isVisible());
    stage.brush.setSymmetric(true);
    QVERIFY(word->isVisible());
    const QWidget* bar = word->parentWidget();
    QVERIFY(bar->rect().contains(word->geometry()) && stage.viewport->rect().contains(bar->geometry()));
    const QString once = word->text(); // a level plane is its own mirror image
    const auto put = [&](const Vec3& point, const Vec3& normal) {
        stage.gizmo()->setFrame(ui::GizmoFrame{point, core::rotationBetween(Vec3::UnitY(), normal)});
        Q_EMIT stage.gizmo()->frameMoved();
        return word->text();
    };
    const QString twice = put({5, 0, 0}, {1, 1, 0}), half = put({0, 3, 0}, {1, 0, 0});
    QVERIFY(once != twice && twice != half && half != once);
    stage.click("planeCutAway");
    QVERIFY(std::abs(stage.volumeLeft() / volumeBelow(0) - 1) < 0.01);
    stage.brush.setSymmetric(false);
    QVERIFY(!word->isVisible());
}

void TestPlaneCutTool::escape_endsTheTool()
{
    CutStage stage;
    stage.action()->trigger();
    QTest::keyClick(stage.viewport, Qt::Key_Escape);
    QVERIFY(!stage.tool->isOn() && !stage.gizmo()->isVisible());
    QVERIFY(!stage.viewport->findChild<QWidget*>(QStringLiteral("planeCutBar"))->isVisible());
}

/// Only one of the tools with handles is on.
void TestPlaneCutTool::anotherTool_endsThisOne()
{
    CutStage stage;
    auto* other = new ui::TransformTool(stage.actions, stage.viewport);
    QObject::connect(other, &ui::TransformTool::regionWanted, other,
                     [&] { other->setRegion(core::transformRegionOf(*stage.mesh, 0)); });
    stage.action()->trigger();
    stage.actions.get(QStringLiteral("model.transform"))->trigger();
    QVERIFY(!stage.tool->isOn() && other->isOn());
    stage.action()->trigger();
    QVERIFY(stage.tool->isOn() && !other->isOn());
    QVERIFY(stage.viewport->input()->mode() == ui::PointerMode::Handles);
}

FETTLE_TEST(TestPlaneCutTool, ui::TestApplication)

#include "tst_plane_cut_tool.moc"
