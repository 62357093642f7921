#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>

using core::Footprint;
using core::Sculptor;
using core::Slot;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
/// Returns a ray brush that colours everything it selects and does not remesh.
core::StrokeSettings dye(double radius)
{
    core::StrokeSettings settings;
    settings.tool = core::Tool::Paint;
    settings.brush = core::BrushShape::Ray;
    settings.radius = radius;
    settings.falloff = 0;
    settings.color = {1, 2, 3};
    return settings;
}

/// Returns the vertices that the engine selects, identified by their new colour. Undoes the stroke.
std::vector<Slot> dyed(Sculptor& sculptor, const core::StrokeSettings& settings, const core::Ray& ray)
{
    core::StrokeSample sample;
    sample.position = ray.origin;
    sample.direction = ray.direction;
    sculptor.beginStroke(settings);
    sculptor.addSample(sample);
    core::MeshDelta delta = sculptor.endStroke();
    std::vector<Slot> slots;
    for (Slot v = 0; v < sculptor.mesh().slots().vertices; ++v)
        if (sculptor.mesh().isVertex(v) && sculptor.mesh().color(v) == settings.color)
            slots.push_back(v);
    sculptor.swap(delta);
    return slots;
}

std::vector<Slot> slotsOf(Footprint footprint)
{
    std::ranges::sort(footprint.slots);
    const auto twice = std::ranges::unique(footprint.slots);
    footprint.slots.erase(twice.begin(), twice.end());
    return footprint.slots;
}
} // namespace

class TestFootprint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWhatTheEngineSelects_data();
    void isWhatTheEngineSelects();
    void ofTheRayBrush_leavesTheOtherSideOut();
    void weighsAsTheBrushDoes();
    void changesNothing();
    void ofTooManyVertices_isEmpty();
};

void TestFootprint::isWhatTheEngineSelects_data()
{
    QTest::addColumn<core::Symmetry>("symmetry");
    QTest::newRow("one side") << core::Symmetry::None;
    QTest::newRow("mirrored") << core::Symmetry::X;
}

void TestFootprint::isWhatTheEngineSelects()
{
    QFETCH(core::Symmetry, symmetry);
    Sculptor sculptor(sculptable(shapes::torus()));
    StrokeFuzzer random(20240812);
    int compared = 0;
    for (int i = 0; i < 100; ++i) {
        core::StrokeSettings settings = dye(random.uniform(0.1, 3));
        settings.symmetry = symmetry;
        const Vec3 from = 20 * random.direction();
        const core::Ray ray{from, (3 * random.direction() - from).normalized()};
        const auto hit = sculptor.hit(ray);
        if (!hit)
            continue;
        QCOMPARE(slotsOf(sculptor.footprint(settings, hit->position)), dyed(sculptor, settings, ray));
        ++compared;
    }
    QVERIFY(compared > 30);
}

void TestFootprint::ofTheRayBrush_leavesTheOtherSideOut()
{
    Sculptor sculptor(sculptable(clay::slab(1, 0.05, 40)));
    core::StrokeSettings settings = dye(0.2);
    const auto hit = sculptor.hit({{0.01, 5, 0.02}, -Vec3::UnitY()});
    QVERIFY(hit);
    const auto below = [&] {
        return std::ranges::count_if(sculptor.footprint(settings, hit->position).slots,
                                     [&](Slot v) { return sculptor.mesh().point(v).y() < 0; });
    };
    QCOMPARE(below(), 0);
    QVERIFY(sculptor.footprint(settings, hit->position).slots.size() > 100);
    settings.brush = core::BrushShape::Sphere;
    QVERIFY(below() > 0);
}

void TestFootprint::weighsAsTheBrushDoes()
{
    Sculptor sculptor(sculptable(clay::slab(1, 0.05, 40)));
    core::StrokeSettings settings = dye(0.2);
    const Vec3 center = sculptor.hit({{0.01, 5, 0.02}, -Vec3::UnitY()})->position;
    for (const std::uint8_t weight : sculptor.footprint(settings, center).weights)
        QCOMPARE(weight, std::uint8_t(255));
    settings.falloff = 4;
    const Footprint footprint = sculptor.footprint(settings, center);
    QCOMPARE(footprint.weights.size(), footprint.slots.size());
    const auto [least, most] = std::ranges::minmax(footprint.weights);
    QVERIFY(least >= 1 && least < 40 && most > 240);
}

/// A query must not change the mesh, even between sub-steps of a dab.
void TestFootprint::changesNothing()
{
    const auto stroke = [](bool asks) {
        Sculptor sculptor(sculptable(shapes::torus()));
        int asked = 0;
        sculptor.setBetweenSubsteps([&] {
            if (asks)
                asked += sculptor.footprint(dye(2), {3, 0, 0}).slots.empty() ? 0 : 1;
        });
        core::StrokeSettings settings;
        settings.radius = 1;
        settings.strength = 5;
        sculptor.beginStroke(settings);
        core::StrokeSample sample;
        sample.position = {4, 0, 0};
        sculptor.addSample(sample);
        sculptor.endStroke();
        return std::pair(sculptor.mesh().stateHash(), asked);
    };
    const auto [quiet, none] = stroke(false);
    const auto [asked, some] = stroke(true);
    QVERIFY(some > 0);
    QCOMPARE(asked, quiet);
}

void TestFootprint::ofTooManyVertices_isEmpty()
{
    Sculptor sculptor(sculptable(clay::slab(1, 0.05, 200)));
    const Vec3 center = sculptor.hit({{0.01, 5, 0.02}, -Vec3::UnitY()})->position;
    QVERIFY(sculptor.mesh().live().vertices > Footprint::maxSlots);
    QVERIFY(sculptor.footprint(dye(9), center).slots.empty());
    QVERIFY(!sculptor.footprint(dye(0.2), center).slots.empty());
}

FETTLE_TEST(TestFootprint)
#include "tst_footprint.moc"
