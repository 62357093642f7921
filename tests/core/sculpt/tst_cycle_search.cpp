#include "core/sculpt/fuse/cycle_search.h"

#include "core/sculpt/fuse/cycle_cut.h"
#include "core/sculpt/verify/verified_mesh.h"

#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <numbers>

using core::Slot, core::Vec3;
using mesh_asserts::eulerNumber, mesh_asserts::sculptable;
using Around = core::CycleSearch::Around;

namespace
{
constexpr shapes::TorusSize size{.ring = 3, .tube = 0.7, .around = 24, .across = 8};

double lengthOf(const core::Mesh& mesh, const std::vector<Slot>& cycle)
{
    double length = 0;
    for (std::size_t i = 0; i < cycle.size(); ++i)
        length += (mesh.point(cycle[i]) - mesh.point(cycle[(i + 1) % cycle.size()])).cast<double>().norm();
    return length;
}

core::SlotSet allOf(const core::Mesh& mesh)
{
    core::SlotSet all;
    for (Slot v = 0; v < mesh.slots().vertices; ++v)
        all.add(v);
    return all;
}

Slot nearestTo(const core::Mesh& mesh, const Vec3& place)
{
    Slot nearest = 0;
    for (Slot v = 0; v < mesh.slots().vertices; ++v)
        if ((mesh.point(v).cast<double>() - place).norm() < (mesh.point(nearest).cast<double>() - place).norm())
            nearest = v;
    return nearest;
}
} // namespace

class TestCycleSearch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void find_theHoleOfARing();
    void find_theTubeOfARing();
    void find_onlyAmongWhatIsGiven();
    void find_nothingOnABall();
    void cutCycle_fillsTheHole();
};

/// The tunnel cycle is around the hole of the ring. The shorter cycle around the tube does not count, because it
/// encloses the solid.
void TestCycleSearch::find_theHoleOfARing()
{
    const auto mesh = sculptable(shapes::torus(size));
    const double inner = size.ring - size.tube, around = 2 * std::numbers::pi * inner;
    core::CycleSearch search;
    for (const double angle : {0.0, 1.0, 4.0}) {
        const Slot v = nearestTo(*mesh, inner * Vec3(std::cos(angle), 0, std::sin(angle)));
        const std::vector<Slot> cycle = search.find(*mesh, allOf(*mesh), v, Around::Tunnel, 1.05 * around);
        QVERIFY(cycle.size() > 2);
        QVERIFY(lengthOf(*mesh, cycle) <= 1.05 * around);
        for (std::size_t i = 0; i < cycle.size(); ++i) {
            QVERIFY(mesh->findHalfedge(cycle[i], cycle[(i + 1) % cycle.size()]) != core::noSlot);
            const Vec3 p = mesh->point(cycle[i]).cast<double>();
            QVERIFY(std::hypot(p.x(), p.z()) < size.ring);
        }
        QVERIFY(search.find(*mesh, allOf(*mesh), v, Around::Tunnel, 0.9 * around).empty());
    }
}

/// The handle cycle is around the tube. It is found from any vertex of the ring, even where the cycle around the hole
/// is equally short.
void TestCycleSearch::find_theTubeOfARing()
{
    const auto mesh = sculptable(shapes::torus(size));
    const double around = 2 * std::numbers::pi * size.tube;
    core::CycleSearch search;
    for (Slot v = 0; v < mesh->slots().vertices; v += 5) {
        const std::vector<Slot> cycle = search.find(*mesh, allOf(*mesh), v, Around::Handle, around);
        QVERIFY(cycle.size() > 2 && lengthOf(*mesh, cycle) <= around);
        Vec3 middle = Vec3::Zero();
        for (Slot w : cycle)
            middle += mesh->point(w).cast<double>() / static_cast<double>(cycle.size());
        QVERIFY(std::abs(std::hypot(middle.x(), middle.z()) - size.ring) < 0.2 * size.tube);
        QVERIFY(search.find(*mesh, allOf(*mesh), v, Around::Handle, 0.8 * around).empty());
    }
}

/// Half of a ring has no cycle around its hole, but it has one around its tube.
void TestCycleSearch::find_onlyAmongWhatIsGiven()
{
    const auto mesh = sculptable(shapes::torus(size));
    const double inner = size.ring - size.tube, around = 2 * std::numbers::pi * size.ring;
    core::SlotSet half;
    for (Slot v = 0; v < mesh->slots().vertices; ++v) {
        if (mesh->point(v).x() > -0.1F)
            half.add(v);
    }
    core::CycleSearch search;
    const Slot v = nearestTo(*mesh, {inner, 0, 0});
    QVERIFY(search.find(*mesh, half, v, Around::Tunnel, around).empty());
    QVERIFY(!search.find(*mesh, allOf(*mesh), v, Around::Tunnel, around).empty());
    QVERIFY(!search.find(*mesh, half, v, Around::Handle, 2 * std::numbers::pi * size.tube).empty());
}

void TestCycleSearch::find_nothingOnABall()
{
    const auto mesh = sculptable(core::icosphere(3, 1));
    core::CycleSearch search;
    for (Slot v = 0; v < mesh->slots().vertices; v += 7)
        for (const double length : {0.5, 2.0, 4.0})
            for (const Around kind : {Around::Tunnel, Around::Handle})
                QVERIFY(search.find(*mesh, allOf(*mesh), v, kind, length).empty());
}

void TestCycleSearch::cutCycle_fillsTheHole()
{
    const auto mesh = sculptable(shapes::torus(size));
    core::VerifiedMesh surface(*mesh);
    QCOMPARE(eulerNumber(*mesh), 0);
    const double inner = size.ring - size.tube;
    core::CycleSearch search;
    const std::vector<Slot> cycle =
        search.find(*mesh, allOf(*mesh), nearestTo(*mesh, {inner, 0, 0}), Around::Tunnel, 8 * inner);
    mesh->beginStroke();
    const auto surgery = core::cutCycle(*mesh, cycle, core::DrawBack::AlongSurface, 0.05);
    QVERIFY(surgery);
    QVERIFY(surface.tryOperation([&] { mesh->replaceFaces(*surgery); }));
    mesh->endStroke();
    QCOMPARE(eulerNumber(*mesh), 2);
    QVERIFY(search.find(*mesh, allOf(*mesh), nearestTo(*mesh, {inner, 0.05, 0}), Around::Tunnel, 8 * inner).empty());
}

FETTLE_TEST(TestCycleSearch, QCoreApplication)
#include "tst_cycle_search.moc"
