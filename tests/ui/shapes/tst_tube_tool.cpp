// Draws tubes over a ball, and changes them by their handles and numbers.

#include "ui/shapes/tube_tool.h"

#include "core/analysis/mesh_check.h"
#include "core/operations/detached_part.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/test_main.h"
#include "tests/ui/view_stage.h"
#include "ui/shapes/tube_card.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>

using core::Vec3;

namespace
{
/// Answers the tool's questions about the ball, and keeps its requests.
struct TubeStage : ui::ViewStage
{
    TubeStage()
        : ViewStage(4)
        , tool(new ui::TubeTool(actions, &brush, viewport))
        , sculptor(core::buildMesh(core::icosphere(4, 30)).mesh)
    {
        brush.setValue(core::Parameter::Radius, 4);
        QObject::connect(tool, &ui::ViewTool::surfaceWanted, tool, [this](const auto& rays, const auto& answer) {
            ui::ViewTool::Hits hits;
            for (const core::Ray& ray : rays)
                hits.push_back(sculptor.hit(ray));
            answer(hits);
        });
        QObject::connect(tool, &ui::ViewTool::requested, tool, [this](const core::ModelCommand& command) {
            requests.push_back(std::get<core::Insert>(command));
            tool->endRequest(isMade);
        });
        in<QComboBox>("tubeCombination")->setCurrentIndex(0); // a part of its own
    }

    QAction* action() const { return actions.get(QStringLiteral("model.tube")); }
    template <class W> W* in(const char* name) const
    {
        return viewport->findChild<ui::TubeCard*>()->findChild<W*>(QLatin1StringView(name));
    }
    void apply() { in<QPushButton>("tubeApply")->click(); }
    /// Draws a line from the left of the ball across its middle to the right of it.
    void drawAcross()
    {
        action()->trigger();
        drag(at({-45, 0, 0}), at({45, 0, 0}) - at({-45, 0, 0}));
    }
    const std::vector<core::TubePoint>& path() const { return requests.back().primitive->path; }

    ui::TubeTool* tool;
    core::Sculptor sculptor;
    std::vector<core::Insert> requests;
    bool isMade = true; ///< whether requests are fulfilled
};
} // namespace

class TestTubeTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void curve_liesOnTheModelAndBesideIt();
    void straightCurve_bendsOverTheModel();
    void tube_isMirrored();
    void curveAtThePlane_isOnIt();
    void curve_ofAShakingHandIsSmooth();
    void tube_isShownTranslucent();
    void point_isMovedByItsDot();
    void radius_isChangedByItsCircle();
    void radius_isTyped();
    void points_areAddedAndRemoved();
    void pressBeside_movesTheView();
    void refused_keepsTheTube();
    void escape_makesNothing();
    void anotherTool_endsThisOne();
    void impossibleTube_cannotBeApplied();
};

void TestTubeTool::curve_liesOnTheModelAndBesideIt()
{
    TubeStage stage;
    stage.action()->trigger();
    stage.press(stage.at({-45, 5, 0}));
    for (int x = -45; x <= 45; x += 3)
        stage.move(stage.at({double(x), 5 + 12 * std::sin(x * 0.12), 0}));
    stage.release(stage.at({45, 5, 0}));
    stage.apply();
    QCOMPARE(stage.requests.size(), std::size_t(1));
    QVERIFY(!stage.action()->isChecked());
    const core::Insert& insert = stage.requests.back();
    QVERIFY(insert.combination == core::Insert::Combination::Part);
    QCOMPARE(insert.name, std::string("Tube"));
    QCOMPARE_GE(stage.path().size(), std::size_t(5));
    QCOMPARE_LE(stage.path().size(), std::size_t(20));
    for (const core::TubePoint& p : stage.path()) {
        QCOMPARE(p.radius, 4.0);
        const double across = std::hypot(p.position.x(), p.position.y());
        if (across < 25)
            QVERIFY(std::abs(p.position.norm() - 30) < 0.3);
    }
    core::ModelChange change = applyToCopy(*stage.mesh, insert);
    QVERIFY(change.changes);
    stage.mesh->swap(change.delta);
    const core::TriangleMesh tube = core::surfaceOf(*stage.mesh, 1);
    QVERIFY(core::checkMesh(tube).printReady());
    core::Box box;
    for (const core::Vec3f& p : tube.points)
        box.extend(p.cast<double>());
    QVERIFY(box.min().x() < -44 && box.max().x() > 44 && box.max().z() > 30);
}

/// A straight line over the view bends over the model, without a fold where it comes to it.
void TestTubeTool::straightCurve_bendsOverTheModel()
{
    TubeStage stage;
    stage.drawAcross();
    stage.apply();
    const core::TriangleMesh swept = core::Tube(stage.path(), 1).swept();
    for (const core::Vec3f& p : swept.points)
        QVERIFY2(std::abs(p.x()) > 27 || std::abs(p.norm() - 30) < 5.5, qPrintable(QString::number(p.norm())));
    QCOMPARE(core::checkMesh(swept).intersections.count, std::size_t(0));
}

/// The tube and its mirror image are shown and made with symmetry.
void TestTubeTool::tube_isMirrored()
{
    TubeStage stage;
    stage.brush.setSymmetric(true);
    const QImage before = stage.picture();
    stage.action()->trigger();
    stage.press(stage.at({10, 0, 0}));
    for (int i = 0; i <= 20; ++i)
        stage.move(stage.at({10.0 + i, double(i), 0}));
    stage.release(stage.at({30, 20, 0}));
    const QRect shown = changed(before, stage.picture());
    QVERIFY(shown.left() < stage.at({-20, 0, 0}).x() && shown.right() > stage.at({20, 0, 0}).x());
    stage.apply();
    QVERIFY(stage.requests.back().symmetry == core::Symmetry::X);
    core::ModelChange change = applyToCopy(*stage.mesh, stage.requests.back());
    stage.mesh->swap(change.delta);
    QCOMPARE(core::checkMesh(core::surfaceOf(*stage.mesh, 1)).components, std::size_t(2));
}

/// Points beside the plane of symmetry by a few pixels are meant to be on it.
void TestTubeTool::curveAtThePlane_isOnIt()
{
    TubeStage stage;
    stage.brush.setSymmetric(true);
    stage.action()->trigger();
    const QPoint top = stage.at({0, 25, 0});
    stage.press(top);
    for (int y = 0; y <= 200; ++y)
        stage.move(top + QPoint(y % 5 - 2, y));
    stage.release(top + QPoint(0, 200));
    stage.apply();
    for (const core::TubePoint& p : stage.path())
        QCOMPARE(p.position.x(), 0.0);
}

/// Neighbouring points are as far apart as the tube is thick, and its ends are where the curve began and ended.
void TestTubeTool::curve_ofAShakingHandIsSmooth()
{
    TubeStage stage;
    stage.action()->trigger();
    stage.press(stage.at({-45, 3, 0}));
    for (int x = -45; x <= 45; ++x)
        stage.move(stage.at({double(x), x % 2 == 0 ? 1.5 : -1.5, 0}));
    stage.release(stage.at({45, 1.5, 0}));
    stage.apply();
    const std::vector<core::TubePoint>& path = stage.path();
    QCOMPARE_GE(path.size(), std::size_t(2));
    for (std::size_t i = 1; i < path.size(); ++i)
        QCOMPARE_GE((path[i].position - path[i - 1].position).norm(), path[i].radius);
    QVERIFY(std::abs(path.front().position.x() + 45) < 0.5);
    QVERIFY(std::abs(path.back().position.x() - 45) < 0.5);
}

void TestTubeTool::tube_isShownTranslucent()
{
    TubeStage stage;
    const QImage before = stage.picture();
    stage.drawAcross();
    QVERIFY(changed(before, stage.picture()).width() > before.width() / 3);
    stage.action()->setChecked(false);
    QCOMPARE(stage.picture(), before);
}

void TestTubeTool::point_isMovedByItsDot()
{
    TubeStage stage;
    stage.drawAcross();
    stage.drag(stage.at({45, 0, 0}), QPoint(0, -60));
    stage.apply();
    const double up = 60 / stage.viewport->camera().pixelsPerMm(Vec3::Zero());
    const core::TubePoint& moved = stage.path().back();
    QVERIFY2(std::abs(moved.position.y() - up) < 0.3, qPrintable(QString::number(moved.position.y())));
    QVERIFY(std::abs(stage.path().front().position.y()) < 0.3);
}

void TestTubeTool::radius_isChangedByItsCircle()
{
    for (const bool ofAll : {false, true}) {
        TubeStage stage;
        stage.drawAcross();
        const double perMm = stage.viewport->camera().pixelsPerMm(Vec3::Zero());
        const QPoint rim = stage.at({45, 0, 0}) + QPoint(0, int(std::lround(4 * perMm)));
        stage.drag(rim, QPoint(0, int(std::lround(4 * perMm))), ofAll ? Qt::ShiftModifier : Qt::NoModifier);
        stage.apply();
        QVERIFY(std::abs(stage.path().back().radius - 8) < 0.3);
        QVERIFY(std::abs(stage.path().front().radius - (ofAll ? 8 : 4)) < 0.3);
    }
}

void TestTubeTool::radius_isTyped()
{
    TubeStage stage;
    stage.drawAcross();
    stage.press(stage.at({45, 0, 0}));
    stage.release(stage.at({45, 0, 0}));
    auto* field = stage.in<QDoubleSpinBox>("tubeRadius");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QLocale().toString(6.5));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(stage.path().back().radius, 6.5);
    QCOMPARE(stage.path().front().radius, 4.0);
    stage.drawAcross();
    stage.in<QDoubleSpinBox>("tubeRadius")->setValue(3);
    stage.in<QCheckBox>("tubeAllRadii")->setChecked(true);
    stage.apply();
    for (const core::TubePoint& p : stage.path())
        QCOMPARE(p.radius, 3.0);
}

void TestTubeTool::points_areAddedAndRemoved()
{
    TubeStage stage;
    stage.drawAcross();
    stage.doubleClick(stage.at({38, 0, 0}));
    stage.drag(stage.at({38, 0, 0}), QPoint(0, -30));
    stage.apply();
    const std::size_t points = stage.path().size();
    QVERIFY(stage.path()[points - 2].position.y() > 3);

    stage.drawAcross();
    stage.doubleClick(stage.at({38, 0, 0}));
    stage.press(stage.at({38, 0, 0}));
    QTest::keyClick(stage.viewport, Qt::Key_Delete); // has no effect during a drag
    stage.move(stage.at({38, 5, 0}));
    stage.release(stage.at({38, 5, 0}));
    QTest::keyClick(stage.viewport, Qt::Key_Delete);
    stage.apply();
    QCOMPARE(stage.path().size(), points - 1);
    stage.drawAcross();
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(stage.viewport, Qt::Key_Delete);
    QTest::keyClick(stage.viewport, Qt::Key_Return);
    QCOMPARE(stage.path().size(), std::size_t(2));
}

void TestTubeTool::refused_keepsTheTube()
{
    TubeStage stage;
    stage.isMade = false;
    stage.drawAcross();
    stage.apply();
    QVERIFY(stage.action()->isChecked());
    stage.isMade = true;
    stage.apply();
    QVERIFY(!stage.action()->isChecked());
    QCOMPARE(stage.requests.size(), std::size_t(2));
    QVERIFY(stage.requests[0].primitive->path == stage.requests[1].primitive->path);
}

/// The view's input decides about a press beside the handles; nobody answers its question here.
void TestTubeTool::pressBeside_movesTheView()
{
    TubeStage stage;
    stage.drawAcross();
    stage.press(stage.at({45, 0, 0}));
    QVERIFY(!stage.viewport->input()->isPressPending());
    stage.release(stage.at({45, 0, 0}));
    stage.press(stage.at({0, -40, 0}));
    QVERIFY(stage.viewport->input()->isPressPending());
    QVERIFY(stage.action()->isChecked());
}

void TestTubeTool::escape_makesNothing()
{
    TubeStage stage;
    stage.drawAcross();
    QTest::keyClick(stage.viewport, Qt::Key_Escape);
    QVERIFY(!stage.action()->isChecked());
    QVERIFY(stage.requests.empty());
    // a click is no curve
    stage.action()->trigger();
    stage.press(stage.at({0, 0, 0}));
    stage.release(stage.at({0, 0, 0}));
    QVERIFY(!stage.viewport->findChild<ui::TubeCard*>()->isVisible());
    stage.drag(stage.at({-45, 0, 0}), QPoint(200, 0));
    QVERIFY(stage.viewport->findChild<ui::TubeCard*>()->isVisible());
}

void TestTubeTool::anotherTool_endsThisOne()
{
    TubeStage stage;
    stage.drawAcross();
    stage.viewport->input()->setMode(ui::PointerMode::Add);
    QVERIFY(!stage.action()->isChecked());
    QVERIFY(!stage.viewport->findChild<ui::TubeCard*>()->isVisible());
}

void TestTubeTool::impossibleTube_cannotBeApplied()
{
    TubeStage stage;
    stage.drawAcross();
    stage.in<QDoubleSpinBox>("tubeRadius")->setValue(0.001);
    stage.in<QCheckBox>("tubeAllRadii")->setChecked(true);
    QVERIFY(!stage.in<QPushButton>("tubeApply")->isEnabled());
    QVERIFY(!stage.in<QLabel>("tubeProblem")->text().isEmpty());
    QTest::keyClick(stage.viewport, Qt::Key_Return);
    QVERIFY(stage.requests.empty());
    stage.in<QDoubleSpinBox>("tubeRadius")->setValue(2);
    QVERIFY(stage.in<QPushButton>("tubeApply")->isEnabled());
}

FETTLE_TEST(TestTubeTool, ui::TestApplication)
#include "tst_tube_tool.moc"
