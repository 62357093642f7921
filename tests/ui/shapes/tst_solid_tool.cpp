// Places solids on a ball and on the ground beside it, by a press and a drag.

#include "ui/shapes/solid_tool.h"

#include "core/analysis/mesh_check.h"
#include "core/operations/detached_part.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/test_main.h"
#include "tests/ui/view_stage.h"
#include "ui/shapes/solid_card.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>

using core::Vec3;
using Kind = core::Primitive::Kind;
using Measure = core::Primitive::Measure;

namespace
{
/// Answers the tool's questions about the ball, and keeps its requests.
struct SolidStage : ui::ViewStage
{
    SolidStage()
        : ViewStage(4)
        , tool(new ui::SolidTool(actions, &brush, viewport))
        , card(viewport->findChild<ui::SolidCard*>())
        , sculptor(core::buildMesh(core::icosphere(4, 30)).mesh)
    {
        QObject::connect(tool, &ui::ViewTool::surfaceWanted, tool, [this](const auto& rays, const auto& answer) {
            ui::ViewTool::Hits hits;
            for (const core::Ray& ray : rays)
                hits.push_back(sculptor.hit(ray));
            answer(hits);
        });
        QObject::connect(tool, &ui::ViewTool::requested, tool, [this](const core::ModelCommand& command) {
            requests.push_back(std::get<core::Insert>(command));
            tool->endRequest(true);
        });
        in<QComboBox>("solidCombination")->setCurrentIndex(0); // a part of its own
    }

    QAction* action() const { return actions.get(QStringLiteral("model.placeSolid")); }
    template <class W> W* in(const char* name) const { return card->findChild<W*>(QLatin1StringView(name)); }
    void choose(Kind kind) { in<QComboBox>("solidKind")->setCurrentIndex(static_cast<int>(kind)); }
    /// Drags so many millimetres to the right of a point.
    void dragAt(const Vec3& point, double mm)
    {
        action()->setChecked(true);
        drag(at(point), QPoint(int(std::lround(mm * viewport->camera().pixelsPerMm(point))), 0));
    }
    core::Insert applied()
    {
        in<QPushButton>("solidApply")->click();
        return requests.back();
    }

    ui::SolidTool* tool;
    ui::SolidCard* card;
    core::Sculptor sculptor;
    std::vector<core::Insert> requests;
};
} // namespace

class TestSolidTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void solid_standsOnTheModel_data();
    void solid_standsOnTheModel();
    void solid_isTurnedToTheSurface();
    void solid_isMirrored();
    void solid_standsOnTheGround();
    void drag_givesTheSize();
    void numbers_areTyped();
    void capsule_isPossibleAtOnce();
    void solid_isShownTranslucent();
    void apply_makesASoundPart();
    void escape_makesNothing();
    void busyProgram_getsNoRequest();
};

void TestSolidTool::solid_standsOnTheModel_data()
{
    QTest::addColumn<int>("kind");
    for (const Kind kind : {Kind::Cuboid, Kind::Ball, Kind::Cylinder, Kind::Cone, Kind::Capsule, Kind::Torus})
        QTest::newRow(std::string(core::name(kind)).c_str()) << static_cast<int>(kind);
}

/// The base touches the surface where the button was pressed, and the axis is along the document's axis nearest to the
/// normal there: from the front, at the middle, z.
void TestSolidTool::solid_standsOnTheModel()
{
    QFETCH(int, kind);
    SolidStage stage;
    stage.choose(static_cast<Kind>(kind));
    stage.dragAt(Vec3::Zero(), 6);
    const core::Insert insert = stage.applied();
    QVERIFY(insert.primitive->kind == static_cast<Kind>(kind));
    const core::PrimitiveResult made = core::makePrimitive(*insert.primitive);
    core::Box box;
    for (const core::Vec3f& p : made.mesh->points)
        box.extend(Vec3(p.cast<double>() + insert.centre));
    QVERIFY(std::abs(box.min().z() - 30) < 0.2);
    QVERIFY(std::abs(box.center().x()) < 0.3 && std::abs(box.center().y()) < 0.3);
}

/// The solid is turned with a slanted surface, unless the user wants it upright.
void TestSolidTool::solid_isTurnedToTheSurface()
{
    SolidStage stage;
    const Vec3 normal = Vec3(0.3, 0.6, 1).normalized();
    stage.choose(Kind::Cone);
    stage.dragAt(30 * normal, 5);
    const core::Insert turned = stage.applied();
    QVERIFY(turned.primitive->axis.normalized().dot(normal) > 0.995);
    const double half = turned.primitive->length(Measure::Height) / 2;
    QVERIFY((turned.centre - half * turned.primitive->axis.normalized() - 30 * normal).norm() < 0.5);
    stage.dragAt(30 * normal, 5);
    stage.in<QCheckBox>("solidTurned")->setChecked(false);
    const core::Insert upright = stage.applied();
    QCOMPARE(upright.primitive->axis, Vec3::UnitZ());
    QVERIFY((upright.centre - Vec3(0, 0, half) - 30 * normal).norm() < 0.5);
}

/// The solid is mirrored with symmetry, but one that is put almost on the plane is on it.
void TestSolidTool::solid_isMirrored()
{
    SolidStage stage;
    stage.brush.setSymmetric(true);
    const QImage before = stage.picture();
    stage.choose(Kind::Cylinder);
    stage.dragAt({15, 0, 0}, 5);
    const QRect shown = changed(before, stage.picture());
    QVERIFY(shown.left() < stage.at({-14, 0, 0}).x() && shown.right() > stage.at({14, 0, 0}).x());
    core::ModelChange change = applyToCopy(*stage.mesh, stage.applied());
    stage.mesh->swap(change.delta);
    QCOMPARE(core::checkMesh(core::surfaceOf(*stage.mesh, 1)).components, std::size_t(2));
    stage.dragAt(Vec3(4 / stage.viewport->camera().pixelsPerMm(Vec3::Zero()), 12, 0), 5);
    const core::Insert atPlane = stage.applied();
    QCOMPARE(atPlane.centre.x(), 0.0);
    QCOMPARE(atPlane.primitive->axis.x(), 0.0);
}

void TestSolidTool::solid_standsOnTheGround()
{
    SolidStage stage;
    stage.viewport->navigation()->turnTo(ui::OrbitCamera::Side::Top);
    stage.choose(Kind::Cylinder);
    stage.dragAt({40, -30, 10}, 5);
    const core::Insert insert = stage.applied();
    QCOMPARE(insert.primitive->axis, Vec3::UnitY());
    const Vec3 base = insert.centre - Vec3(0, insert.primitive->length(Measure::Height) / 2, 0);
    QVERIFY2((base - Vec3(40, -30, 10)).norm() < 0.3, qPrintable(QString::number((base - Vec3(40, -30, 10)).norm())));
}

void TestSolidTool::drag_givesTheSize()
{
    SolidStage stage;
    stage.choose(Kind::Ball);
    stage.dragAt(Vec3::Zero(), 7);
    QVERIFY(std::abs(stage.applied().primitive->length(Measure::Radius) - 7) < 0.2);
    stage.choose(Kind::Cuboid);
    stage.dragAt(Vec3::Zero(), 7);
    QVERIFY(std::abs(stage.applied().primitive->length(Measure::Width) - 14) < 0.4);
    // a click makes a solid of the usual size
    stage.dragAt(Vec3::Zero(), 0);
    QVERIFY(stage.applied().primitive->length(Measure::Width) > 1);
}

/// A typed measure keeps the base where it is; a typed coordinate moves the solid.
void TestSolidTool::numbers_areTyped()
{
    SolidStage stage;
    stage.choose(Kind::Cylinder);
    stage.dragAt(Vec3::Zero(), 5);
    stage.in<QDoubleSpinBox>("height")->setValue(20);
    stage.in<QDoubleSpinBox>("radius")->setValue(2.5);
    QVERIFY(std::abs(stage.in<QDoubleSpinBox>("centreZ")->value() - 40) < 0.2);
    stage.in<QDoubleSpinBox>("centreX")->setValue(9);
    stage.in<QDoubleSpinBox>("height")->setValue(30);
    QTest::keyClick(stage.in<QDoubleSpinBox>("height"), Qt::Key_Return);
    const core::Insert& insert = stage.requests.back();
    QCOMPARE(insert.primitive->length(Measure::Radius), 2.5);
    QCOMPARE(insert.primitive->length(Measure::Height), 30.0);
    QCOMPARE(insert.centre.x(), 9.0);
    QVERIFY(std::abs(insert.centre.z() - 40) < 0.2);
    QVERIFY(!stage.in<QDoubleSpinBox>("width")->isVisible());
}

void TestSolidTool::capsule_isPossibleAtOnce()
{
    SolidStage stage;
    stage.choose(Kind::Ball);
    stage.dragAt(Vec3::Zero(), 5);
    stage.choose(Kind::Capsule);
    QVERIFY(stage.in<QPushButton>("solidApply")->isEnabled());
    QVERIFY(core::makePrimitive(*stage.applied().primitive).mesh);
}

void TestSolidTool::solid_isShownTranslucent()
{
    SolidStage stage;
    const QImage before = stage.picture();
    stage.dragAt(Vec3::Zero(), 8);
    QVERIFY(changed(before, stage.picture()).width() > 20);
    stage.action()->setChecked(false);
    QCOMPARE(stage.picture(), before);
}

void TestSolidTool::apply_makesASoundPart()
{
    SolidStage stage;
    stage.choose(Kind::Torus);
    stage.dragAt({10, 10, 0}, 6);
    core::ModelChange change = applyToCopy(*stage.mesh, stage.applied());
    QVERIFY(change.changes);
    stage.mesh->swap(change.delta);
    QVERIFY(core::checkMesh(core::surfaceOf(*stage.mesh, 1)).printReady());
    QCOMPARE(stage.mesh->frame().parts.all().back().name, std::string("Torus"));
    QVERIFY(!stage.action()->isChecked());
}

void TestSolidTool::escape_makesNothing()
{
    SolidStage stage;
    stage.dragAt(Vec3::Zero(), 5);
    QVERIFY(stage.card->isVisible());
    QTest::keyClick(stage.viewport, Qt::Key_Escape);
    QVERIFY(!stage.action()->isChecked());
    QVERIFY(!stage.card->isVisible());
    QVERIFY(stage.requests.empty());
}

void TestSolidTool::busyProgram_getsNoRequest()
{
    SolidStage stage;
    stage.dragAt(Vec3::Zero(), 5);
    stage.tool->setEnabled(false);
    QTest::keyClick(stage.viewport, Qt::Key_Return);
    QVERIFY(stage.requests.empty());
    stage.tool->setEnabled(true);
    QTest::keyClick(stage.viewport, Qt::Key_Return);
    QCOMPARE(stage.requests.size(), std::size_t(1));
}

FETTLE_TEST(TestSolidTool, ui::TestApplication)
#include "tst_solid_tool.moc"
