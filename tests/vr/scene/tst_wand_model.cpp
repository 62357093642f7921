#include "core/analysis/mesh_check.h"
#include "core/io/mesh/vertex_welder.h"
#include "tests/support/test_main.h"
#include "vr/scene/wand_model.h"

#include <QTest>

#include <set>

using vr::WandPart;
using vr::WandSpot;

namespace
{
core::TriangleMesh welded(const core::DrawArrays& arrays)
{
    core::TriangleMesh mesh;
    for (const core::DrawVertex& vertex : arrays.vertices)
        mesh.points.push_back(vertex.position);
    mesh.triangles = arrays.faces;
    core::io::weld(mesh, {});
    return mesh;
}

core::Box boxOf(const core::TriangleMesh& mesh)
{
    core::Box box;
    for (const core::Vec3f& point : mesh.points)
        box.extend(point.cast<double>());
    return box;
}

core::Box boxOf(WandPart part)
{
    return boxOf(welded(vr::wandPartModel(part)));
}
} // namespace

/// Tests of the wands' model: each part is a sound solid of about its true size, and each button is where its label
/// points.
class TestWandModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void parts_areSolids_data();
    void parts_areSolids();
    void wand_isAsLongAsAVives();
    void places_lieOnTheirParts_data();
    void places_lieOnTheirParts();
    void buttons_standOutOfTheBody();
    void pad_isWhereThumbsAre();
    void stick_leansToWhereItIsPushed();
    void trigger_turnsIntoTheBody();
};

void TestWandModel::parts_areSolids_data()
{
    QTest::addColumn<int>("part");
    for (std::size_t part = 0; part < vr::wandPartCount; ++part)
        QTest::addRow("%zu", part) << static_cast<int>(part);
}

/// Also tests that no two vertices are equal: triangles share them.
void TestWandModel::parts_areSolids()
{
    QFETCH(int, part);
    const core::DrawArrays arrays = vr::wandPartModel(static_cast<WandPart>(part));
    const core::MeshReport report = core::checkMesh(welded(arrays));
    QVERIFY(report.printReady());
    QCOMPARE(report.components, std::size_t(static_cast<WandPart>(part) == WandPart::Side ? 2 : 1));
    std::set<std::pair<std::vector<float>, std::array<std::int8_t, 4>>> drawn;
    for (const core::DrawVertex& vertex : arrays.vertices)
        QVERIFY(
            drawn.emplace(std::vector<float>(vertex.position.begin(), vertex.position.end()), vertex.normal).second);
    for (const core::Triangle& face : arrays.faces) {
        const auto at = [&](int corner) {
            return core::Vec3f(arrays.vertices[face[static_cast<std::size_t>(corner)]].position);
        };
        const core::Vec3f outward = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        for (const core::Slot corner : face) {
            const auto& normal = arrays.vertices[corner].normal;
            const core::Vec3f unit = core::Vec3f(normal[0], normal[1], normal[2]) / 127;
            QVERIFY(std::abs(unit.norm() - 1) < 0.02F);
            QVERIFY(unit.dot(outward) > 0.6F);
        }
    }
}

void TestWandModel::wand_isAsLongAsAVives()
{
    core::Box all;
    for (std::size_t part = 0; part < vr::wandPartCount; ++part)
        all.extend(boxOf(static_cast<WandPart>(part)));
    QVERIFY(std::abs(all.sizes().z() - 0.24) < 0.005);
    QVERIFY(all.sizes().x() < 0.06 && all.sizes().y() < 0.06);
    QVERIFY(all.contains(core::Vec3::Zero())); // the palm is at the origin
    QCOMPARE(all.min().z(), boxOf(WandPart::Tip).min().z());
}

void TestWandModel::places_lieOnTheirParts_data()
{
    QTest::addColumn<int>("spot");
    QTest::addColumn<int>("part");
    const auto row = [](const char* name, WandSpot spot, WandPart part) {
        QTest::newRow(name) << static_cast<int>(spot) << static_cast<int>(part);
    };
    row("pad up", WandSpot::PadUp, WandPart::PadUp);
    row("pad left", WandSpot::PadLeft, WandPart::PadLeft);
    row("pad down", WandSpot::PadDown, WandPart::PadDown);
    row("pad right", WandSpot::PadRight, WandPart::PadRight);
    row("pad middle", WandSpot::PadMiddle, WandPart::PadMiddle);
    row("menu", WandSpot::Menu, WandPart::Menu);
    row("trigger", WandSpot::Trigger, WandPart::Trigger);
    row("side", WandSpot::Side, WandPart::Side);
}

void TestWandModel::places_lieOnTheirParts()
{
    QFETCH(int, spot);
    QFETCH(int, part);
    const core::Vec3 place = vr::placeOf(static_cast<WandSpot>(spot));
    for (std::size_t other = 0; other < vr::wandPartCount; ++other) {
        double nearest = 1;
        for (const core::Vec3f& point : welded(vr::wandPartModel(static_cast<WandPart>(other))).points)
            nearest = std::min(nearest, (point.cast<double>() - place).norm());
        if (static_cast<int>(other) == part)
            QVERIFY(nearest < 0.006);
        const core::Box box = boxOf(static_cast<WandPart>(other));
        QCOMPARE(box.exteriorDistance(place) < 0.0005, static_cast<int>(other) == part || box.contains(place));
    }
}

/// Checks that the place of each button is not inside the wand's body.
void TestWandModel::buttons_standOutOfTheBody()
{
    const core::TriangleMesh body = welded(vr::wandPartModel(WandPart::Body));
    for (std::size_t spot = 0; spot < vr::wandSpotCount; ++spot) {
        const core::Vec3 place = vr::placeOf(static_cast<WandSpot>(spot));
        double turns = 0; // the solid angle of the body seen from the place
        for (const core::Triangle& face : body.triangles) {
            const auto from = [&](std::size_t i) { return core::Vec3(body.points[face[i]].cast<double>() - place); };
            const core::Vec3 a = from(0), b = from(1), c = from(2);
            turns += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                           b.dot(c) * a.norm() + c.dot(a) * b.norm());
        }
        QVERIFY(std::abs(turns) < 0.1);
    }
}

void TestWandModel::pad_isWhereThumbsAre()
{
    core::Box pad;
    for (const WandPart part : {WandPart::PadUp, WandPart::PadDown, WandPart::PadLeft, WandPart::PadRight})
        pad.extend(boxOf(part));
    QVERIFY((vr::placeOnPad({1, 0}) - core::Vec3(pad.max().x(), pad.max().y(), pad.center().z())).norm() < 0.001);
    QVERIFY((vr::placeOnPad({0, 1}) - core::Vec3(0, pad.max().y(), pad.min().z())).norm() <
            0.001); // away from the hand
    QVERIFY(boxOf(WandPart::PadLeft).max().x() < 0 && boxOf(WandPart::PadRight).min().x() > 0);
    QVERIFY(boxOf(WandPart::PadUp).max().z() < boxOf(WandPart::PadDown).min().z());
}

/// Checks that a push beyond the stick's rim leans it as far as a push to the rim, and that the stick's foot stays in
/// the body.
void TestWandModel::stick_leansToWhereItIsPushed()
{
    const core::Box rest = boxOf(WandPart::Stick);
    const core::Vec3 top(0, rest.max().y(), rest.center().z()), foot(0, rest.min().y(), rest.center().z());
    QVERIFY(rest.max().y() > vr::placeOnPad({0, 0}).y());
    QVERIFY(vr::stickTurn({0, 0}).isApprox(Eigen::Affine3d::Identity()));
    for (const Eigen::Vector2d& push : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(-0.6, -0.8)}) {
        const core::Vec3 wanted = (vr::placeOnPad(push) - vr::placeOnPad({0, 0})).normalized();
        const core::Vec3 half = vr::stickTurn(push / 2) * top - top, whole = vr::stickTurn(push) * top - top;
        QVERIFY(core::Vec3(whole.x(), 0, whole.z()).normalized().isApprox(wanted, 1e-9));
        QVERIFY(whole.norm() > 1.5 * half.norm() && half.norm() > 0.001);
        QVERIFY(vr::stickTurn(2 * push).isApprox(vr::stickTurn(push)));
        QVERIFY((vr::stickTurn(push) * foot).isApprox(foot, 1e-6));
    }
}

void TestWandModel::trigger_turnsIntoTheBody()
{
    QVERIFY(vr::triggerTurn(0).isApprox(Eigen::Affine3d::Identity()));
    const core::Box rest = boxOf(WandPart::Trigger);
    const core::Vec3 lowest(0, rest.min().y(), rest.center().z());
    double before = lowest.y();
    for (const double pull : {0.25, 0.5, 1.0}) {
        const double height = (vr::triggerTurn(pull) * lowest).y();
        QVERIFY(height > before);
        before = height;
    }
    QVERIFY(vr::triggerTurn(7).isApprox(vr::triggerTurn(1)));
}

FETTLE_TEST(TestWandModel, QCoreApplication)
#include "tst_wand_model.moc"
