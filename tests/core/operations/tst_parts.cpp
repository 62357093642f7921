// Tests documents of several parts: strokes and commands change one part and leave the others bit for bit, every part
// stays a sound solid, and undo restores everything.
#include "core/mesh/draw_arrays.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/plane_cut.h"
#include "core/operations/snapshot.h"
#include "core/operations/transform.h"
#include "core/operations/transform_region.h"
#include "core/parts/part_split.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <array>
#include <map>
#include <set>
#include <sstream>

using core::CombineParts;
using core::Mesh;
using core::ModelChange;
using core::ModelRefusal;
using core::Part;
using core::PartId;
using core::PartList;
using core::Sculptor;
using core::SetOperation;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

namespace
{
TriangleMesh ballAt(const Vec3& centre, double radius, int subdivisions = 3)
{
    TriangleMesh ball = core::icosphere(subdivisions, radius);
    for (core::Vec3f& p : ball.points)
        p += centre.cast<float>();
    return ball;
}

TriangleMesh turnedOver(TriangleMesh mesh)
{
    for (core::Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

/// Returns a document in which each mesh is a part, with ids 0, 1, ...
std::unique_ptr<Mesh> document(const std::vector<TriangleMesh>& solids)
{
    std::vector<core::PartPiece> pieces;
    for (const TriangleMesh& solid : solids)
        pieces.push_back({static_cast<PartId>(pieces.size()), solid, {}, {}});
    return core::buildMesh(core::joined(pieces)).mesh;
}

/// Three balls of which each overlaps the next.
std::unique_ptr<Mesh> threeBalls()
{
    return document({ballAt({0, 0, 0}, 10), ballAt({12, 0, 0}, 8), ballAt({20, 5, 1}, 6)});
}

/// The surface of each part, as sums over its faces that do not depend on slots.
std::map<PartId, std::uint64_t> hashes(const Mesh& mesh)
{
    std::map<PartId, std::uint64_t> result;
    for (const Part& part : mesh.frame().parts.all())
        result[part.id] = Mesh(core::surfaceOf(mesh, part.id), mesh.lattice()).meshHash();
    return result;
}

/// Returns the first defect, or an empty text.
std::string unsoundness(const Mesh& mesh)
{
    const TriangleMesh whole = core::extractMesh(mesh);
    const std::vector<core::PartPiece> pieces = core::splitByPart(whole);
    if (pieces.size() > mesh.frame().parts.size()) // strokes may have removed all faces of a part
        return std::to_string(pieces.size()) + " parts, listed: " + std::to_string(mesh.frame().parts.size());
    for (const core::PartPiece& piece : pieces) {
        const std::string name = "part " + std::to_string(piece.part);
        if (!mesh.frame().parts.find(piece.part))
            return name + " is not listed";
        if (!core::checkMesh(piece.mesh).printReady() || !judgedByCgal(piece.mesh).value_or(CgalVerdict()).allWell())
            return name + " is not sound";
    }
    return core::checkMesh(whole).printReady() ? std::string() : "the whole is not sound";
}

bool isEveryPartSound(const Mesh& mesh)
{
    return unsoundness(mesh).empty();
}

double volumeOf(const Mesh& mesh, PartId part)
{
    return core::checkMesh(core::surfaceOf(mesh, part)).volume.value_or(0);
}

/// Applies the command and checks that undo and redo restore every bit.
ModelChange applyChecked(Mesh& mesh, const core::ModelCommand& command, PartId part = 0)
{
    ModelChange change = core::applyToCopy(mesh, command, {}, part);
    if (change.refusal != ModelRefusal::None)
        return change;
    const std::uint64_t before = mesh.stateHash();
    mesh.swap(change.delta);
    const std::uint64_t after = mesh.stateHash();
    std::stringstream disk;
    change.delta.write(disk);
    core::MeshDelta delta = core::MeshDelta::read(disk);
    mesh.swap(delta);
    if (mesh.stateHash() != before)
        qFatal("undo differs");
    mesh.swap(delta);
    if (mesh.stateHash() != after)
        qFatal("redo differs");
    return change;
}
} // namespace

class TestParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void list_keepsItsRules();
    void list_staysTheSameForOnePart();
    void strokes_changeOnePart();
    void stroke_ofAPartIsThatOfThePartAlone();
    void stroke_ofAHiddenOrLockedPartDoesNothing();
    void ray_findsTheVisiblePartInFront();
    void hidden_partsAreNotDrawn();
    void hidden_clayOfAPartStaysHidden();
    void commands_changeOnePart_data();
    void commands_changeOnePart();
    void commands_onAllParts();
    void part_thatGrowsTakesAllToAnotherLattice();
    void duplicate_addsTheSame();
    void delete_removesIt();
    void separate_keepsVoids();
    void combine_volumesAddUp();
    void combine_refuses();
    void snapshot_restoresParts();
    void check_allowsPartsToOverlap();
    void hidden_clayIsNeitherDrawnNorChanged();
    void hidden_clayMayBeCoarserThanTheBrush_data();
    void hidden_clayMayBeCoarserThanTheBrush();
    void randomWork_staysSound();
};

void TestParts::list_keepsItsRules()
{
    QVERIFY(!PartList::isUsable({}));
    QVERIFY(!PartList::isUsable({{0, "a", true, false, {}}, {0, "b", true, false, {}}}));
    QVERIFY(!PartList::isUsable({{0, std::string(PartList::maxNameBytes + 1, 'a'), true, false, {}}}));
    const PartList list({{4, "a", true, false, {}}, {0, "b", false, false, {}}, {1, "c", true, true, {}}});
    QCOMPARE(list.freeId(), PartId(2));
    QVERIFY(list.isEditable(4) && !list.isEditable(0) && !list.isEditable(1) && !list.isEditable(9));
    QVERIFY(list.with({0, "b", false, false, {}}) == list);
    QCOMPARE(list.without({4, 0}).all().front().name, std::string("c"));
    // a name is cut at the end of a character: 3 bytes each
    std::string name;
    for (int i = 0; i < 100; ++i)
        name += "\xe4\xbb\xb6";
    const std::string cut = core::shortened(name);
    QVERIFY(cut.size() <= PartList::maxNameBytes && cut.size() % 3 == 0 && name.starts_with(cut));
}

void TestParts::list_staysTheSameForOnePart()
{
    const std::unique_ptr<Mesh> mesh = core::buildMesh(ballAt({0, 0, 0}, 10)).mesh;
    QVERIFY(mesh->frame().parts == PartList());
    QVERIFY(core::extractMesh(*mesh).parts.empty());
}

void TestParts::strokes_changeOnePart()
{
    Sculptor sculptor(threeBalls());
    StrokeFuzzer fuzzer(numberFromEnvironment("FETTLE_SEED", 1));
    for (int i = 0; i < 60; ++i) {
        const auto part = static_cast<PartId>(fuzzer.below(3));
        core::Stroke stroke = fuzzer.stroke(sculptor.mesh());
        stroke.settings.part = part;
        const auto before = hashes(sculptor.mesh());
        sculptor.beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples)
            sculptor.addSample(sample);
        sculptor.endStroke();
        for (const auto& [id, hash] : hashes(sculptor.mesh()))
            QVERIFY2(id == part || hash == before.at(id), qPrintable(QStringLiteral("stroke %1").arg(i)));
        QVERIFY(sculptor.indexIsConsistent());
    }
    QVERIFY(isEveryPartSound(sculptor.mesh()));
}

void TestParts::stroke_ofAPartIsThatOfThePartAlone()
{
    const std::unique_ptr<Mesh> both = document({ballAt({0, 0, 0}, 10), ballAt({6, 0, 0}, 9)});
    core::MeshFrame frame = both->frame();
    frame.parts = {};
    auto alone = std::make_unique<Mesh>(core::surfaceOf(*both, 1), both->lattice());
    alone->beginStroke();
    alone->setFrame(frame);
    alone->endStroke();
    Sculptor one(std::move(alone)), two(std::make_unique<Mesh>(*both));
    core::StrokeSettings settings;
    settings.radius = 3;
    settings.strength = 0.5;
    for (const core::Tool tool : {core::Tool::Pull, core::Tool::Smooth, core::Tool::Grab, core::Tool::Flatten}) {
        settings.tool = tool;
        for (Sculptor* sculptor : {&one, &two}) {
            settings.part = sculptor == &one ? 0 : 1;
            sculptor->beginStroke(settings);
            for (int i = 0; i < 6; ++i) {
                core::StrokeSample sample;
                sample.position = {14.5 - i * 0.3, double(i), 0.5 * i};
                sample.direction = {-1, 0, 0};
                sculptor->addSample(sample);
            }
            sculptor->endStroke();
        }
    }
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-3 * b; };
    QVERIFY(near(volumeOf(one.mesh(), 0), volumeOf(two.mesh(), 1)));
    QVERIFY(volumeOf(two.mesh(), 1) != volumeOf(*both, 1));
    QCOMPARE(hashes(two.mesh()).at(0), hashes(*both).at(0));
}

void TestParts::stroke_ofAHiddenOrLockedPartDoesNothing()
{
    const std::unique_ptr<Mesh> mesh = threeBalls();
    applyChecked(*mesh, core::ShowParts{{1, 2}});
    applyChecked(*mesh, core::EditPart{"Wheel", true, core::Rgb{255, 0, 0}, 0}, 1);
    QCOMPARE(mesh->frame().parts.all().front().name, std::string("Wheel"));
    const ModelChange added = core::applyToCopy(
        *mesh, core::Insert{ballAt({0, 0, 0}, 3), core::Insert::Place::AsItIs, {}, core::Insert::Combination::Part}, {},
        PartId(0));
    QVERIFY(added.changes); // a new part changes none of the others
    for (const PartId part : {PartId(0), PartId(1)})
        QCOMPARE(core::applyToCopy(*mesh, core::Move{{1, 0, 0}}, {}, part).refusal, ModelRefusal::NotEditable);
    QCOMPARE(core::applyToCopy(*mesh, core::Fill{{1, 2, 3}}, {}, 7).refusal, ModelRefusal::NoSuchPart);
    Sculptor sculptor(std::make_unique<Mesh>(*mesh));
    for (const PartId part : {PartId(0), PartId(1), PartId(7)}) {
        core::StrokeSettings settings;
        settings.part = part;
        settings.radius = 4;
        sculptor.beginStroke(settings);
        core::StrokeSample sample;
        sample.position = part == 0 ? Vec3(-10, 0, 0) : Vec3(12, 0, 8);
        sculptor.addSample(sample);
        QVERIFY(sculptor.endStroke().empty());
    }
}

void TestParts::ray_findsTheVisiblePartInFront()
{
    Sculptor sculptor(threeBalls());
    const core::Ray ray{{50, 0, 0}, {-1, 0, 0}};
    QCOMPARE(sculptor.visibleHit(ray)->part, PartId(2));
    QCOMPARE(sculptor.activePart(), PartId(0));
    ModelChange change = core::applyToCopy(sculptor.mesh(), core::ShowParts{{0, 1}});
    sculptor.swap(change.delta);
    QCOMPARE(sculptor.visibleHit(ray)->part, PartId(1));
    sculptor.swap(change.delta);
    QCOMPARE(sculptor.visibleHit(ray)->part, PartId(2));
    QVERIFY(!sculptor.visibleHit({{50, 0, 0}, {1, 0, 0}}));
}

void TestParts::hidden_partsAreNotDrawn()
{
    Sculptor sculptor(threeBalls());
    core::DrawArrays arrays;
    arrays.apply(sculptor.wholePatch());
    sculptor.takePatch();
    const auto drawn = [&](PartId part) {
        std::size_t count = 0;
        for (const Slot f : sculptor.mesh().faces())
            count += sculptor.mesh().partOfFace(f) == part && !arrays.isFree(f) ? 1 : 0;
        return count;
    };
    const std::size_t all = drawn(1);
    QVERIFY(all > 0);
    ModelChange change = core::applyToCopy(sculptor.mesh(), core::ShowParts{{0, 2}});
    for (const std::size_t expected : {std::size_t(0), all, std::size_t(0)}) {
        sculptor.swap(change.delta);
        arrays.apply(sculptor.takePatch());
        QCOMPARE(drawn(1), expected);
        QVERIFY(drawn(0) > 0 && drawn(2) > 0);
        core::DrawArrays late;
        late.apply(sculptor.wholePatch());
        QVERIFY(late.faces == arrays.faces);
    }
}

/// Hidden clay of one part of several stays hidden and unchanged by commands that take the part out and put it back.
void TestParts::hidden_clayOfAPartStaysHidden()
{
    const std::unique_ptr<Mesh> mesh = threeBalls();
    mesh->beginStroke();
    std::vector<Vec3f> hidden;
    const Vec3f middle = core::transformRegionOf(*mesh, 1).box.center().cast<float>();
    for (const Slot v : mesh->vertices()) {
        if (mesh->part(v) == 1 && mesh->point(v).x() > middle.x() + 0.5F) {
            mesh->setHidden(v, true);
            hidden.push_back(mesh->point(v));
        }
    }
    mesh->endStroke();
    const auto isStillHidden = [&] {
        std::size_t count = 0;
        for (const Slot v : mesh->vertices())
            count += mesh->isHidden(v) && std::ranges::find(hidden, mesh->point(v)) != hidden.end();
        return count == hidden.size();
    };
    QVERIFY(hidden.size() > 20 && isStillHidden());
    const core::Rgb before = mesh->color(*mesh->vertices().begin()), red{240, 10, 10};
    applyChecked(*mesh, core::Fill{red}, 1);
    QVERIFY(isStillHidden());
    for (const Slot v : mesh->vertices())
        QCOMPARE(mesh->color(v) == red, mesh->part(v) == 1 && !mesh->isHidden(v));
    const Vec3 cut = middle.cast<double>() - Vec3(1, 0, 0);
    QVERIFY(applyChecked(*mesh, core::trimBeyond(cut, -Vec3::UnitX(), core::boxOf(*mesh)), 1).changes);
    QVERIFY(isStillHidden());
    const core::Trim upper =
        core::trimBeyond(middle.cast<double>() + Vec3(0, 0.3, 0), Vec3::UnitY(), core::boxOf(*mesh));
    QVERIFY(applyChecked(*mesh, core::SplitPart{upper.area, "upper"}, 1).changes);
    std::size_t count = 0;
    for (const Slot v : mesh->vertices())
        count += mesh->isHidden(v);
    QVERIFY(mesh->frame().parts.size() == 4 && count > hidden.size() * 9 / 10); // but for corners of cut faces
    QVERIFY(before != red && isEveryPartSound(*mesh));
}

void TestParts::commands_changeOnePart_data()
{
    QTest::addColumn<int>("command");
    for (int i = 0; i < 9; ++i)
        QTest::addRow("%d", i) << i;
}

void TestParts::commands_changeOnePart()
{
    QFETCH(int, command);
    const core::ModelCommand commands[] = {core::Move{{1, 2, 3}},
                                           core::Rotate{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3::UnitZ()))},
                                           core::Mirror{0},
                                           core::Fill{{200, 10, 10}},
                                           core::MaskOperation{core::MaskOperation::Kind::Invert, {}},
                                           core::RemeshUniformly{1.3},
                                           core::Symmetrize{core::Symmetry::Y, core::Half::Positive},
                                           core::FlattenBase{2},
                                           core::Move{{100, 0, 0}}};
    const std::unique_ptr<Mesh> mesh = threeBalls();
    const auto before = hashes(*mesh);
    const double volume = volumeOf(*mesh, 1);
    const ModelChange change = applyChecked(*mesh, commands[command], 1);
    QVERIFY(change.changes);
    QVERIFY(isEveryPartSound(*mesh));
    QCOMPARE(mesh->frame().parts.size(), std::size_t(3));
    const auto after = hashes(*mesh);
    QVERIFY(after.at(1) != before.at(1) || command == 4); // a mask is not part of the hash
    if (command != 8) {                                   // so far that the lattice becomes coarser
        QCOMPARE(after.at(0), before.at(0));
        QCOMPARE(after.at(2), before.at(2));
    }
    if (command < 3 || command == 8)
        QVERIFY(std::abs(volumeOf(*mesh, 1) - volume) < 1e-3 * volume);
}

void TestParts::commands_onAllParts()
{
    const std::unique_ptr<Mesh> mesh = threeBalls();
    const double volumes[] = {volumeOf(*mesh, 0), volumeOf(*mesh, 1), volumeOf(*mesh, 2)};
    QVERIFY(applyChecked(*mesh, core::Scale{2}, 1).changes);
    for (const PartId part : {PartId(0), PartId(1), PartId(2)})
        QVERIFY(std::abs(volumeOf(*mesh, part) / volumes[part] - 8) < 1e-3);
    QVERIFY(applyChecked(*mesh, core::PlaceOnBed{}, 2).changes);
    QVERIFY(isEveryPartSound(*mesh));
    float lowest = 1e9f;
    for (const Slot v : mesh->vertices())
        lowest = std::min(lowest, mesh->point(v).y());
    QCOMPARE(lowest, 0.0f);
}

void TestParts::part_thatGrowsTakesAllToAnotherLattice()
{
    const std::unique_ptr<Mesh> mesh = document({ballAt({0, 0, 0}, 1), ballAt({1, 0, 0}, 1)});
    const core::Lattice before = mesh->lattice();
    const double volume = volumeOf(*mesh, 0);
    int moves = 0;
    while (mesh->lattice() == before && ++moves < 12)
        QVERIFY(applyChecked(*mesh, core::Move{{std::ldexp(3.0, moves), 0, 0}}, 1).refusal != ModelRefusal::FacesMeet);
    QVERIFY(moves < 12 || mesh->lattice() == before);
    QVERIFY(isEveryPartSound(*mesh));
    QVERIFY(std::abs(volumeOf(*mesh, 0) - volume) < 1e-3 * volume);
}

void TestParts::duplicate_addsTheSame()
{
    const std::unique_ptr<Mesh> mesh = threeBalls();
    const ModelChange change = applyChecked(*mesh, core::DuplicatePart{"Copy"}, 1);
    QVERIFY(change.changes);
    QCOMPARE(change.addedPart.value_or(0), PartId(3));
    const auto after = hashes(*mesh);
    QCOMPARE(mesh->frame().parts.size(), std::size_t(4));
    QCOMPARE(mesh->frame().parts.all()[2].name, std::string("Copy")); // behind the original
    QCOMPARE(after.at(3), after.at(1));
    QVERIFY(isEveryPartSound(*mesh));
}

void TestParts::delete_removesIt()
{
    const std::unique_ptr<Mesh> mesh = threeBalls();
    const auto before = hashes(*mesh);
    QVERIFY(applyChecked(*mesh, core::DeletePart{}, 1).changes);
    QCOMPARE(hashes(*mesh), (std::map<PartId, std::uint64_t>{{0, before.at(0)}, {2, before.at(2)}}));
    QCOMPARE(applyChecked(*mesh, core::DeletePart{}, 1).refusal, ModelRefusal::NoSuchPart);
    QVERIFY(applyChecked(*mesh, core::DeletePart{}, 0).changes);
    QCOMPARE(applyChecked(*mesh, core::DeletePart{}, 2).refusal, ModelRefusal::LastPart);
    QVERIFY(isEveryPartSound(*mesh));
}

/// A hollow ball with a ball inside its void, and a ball beside: three pieces.
void TestParts::separate_keepsVoids()
{
    std::vector<core::PartPiece> shells;
    for (const TriangleMesh& shell :
         {ballAt({0, 0, 0}, 10), turnedOver(ballAt({0, 0, 0}, 8)), ballAt({0, 0, 0}, 4), ballAt({20, 0, 0}, 5)})
        shells.push_back({0, shell, {}, {}});
    const std::unique_ptr<Mesh> mesh = core::buildMesh(core::joined(shells)).mesh;
    const double volume = volumeOf(*mesh, 0);
    QVERIFY(applyChecked(*mesh, core::SeparatePart{}).changes);
    QCOMPARE(mesh->frame().parts.size(), std::size_t(3));
    QVERIFY(isEveryPartSound(*mesh));
    double sum = 0;
    for (const Part& part : mesh->frame().parts.all())
        sum += volumeOf(*mesh, part.id);
    QVERIFY(std::abs(sum - volume) < 1e-6 * volume);
    for (const Part& part : mesh->frame().parts.all())
        QCOMPARE(applyChecked(*mesh, core::SeparatePart{}, part.id).refusal, ModelRefusal::OnePiece);
}

void TestParts::combine_volumesAddUp()
{
    StrokeFuzzer random(numberFromEnvironment("FETTLE_SEED", 1));
    for (int i = 0; i < 20; ++i) {
        const Vec3 centre = random.direction() * random.uniform(2, 14);
        const std::unique_ptr<Mesh> start =
            document({ballAt({0, 0, 0}, 10), ballAt(centre, random.uniform(3, 8)), ballAt({40, 0, 0}, 3)});
        const auto after = [&](SetOperation operation) {
            Mesh mesh = *start;
            const ModelChange change = applyChecked(mesh, CombineParts{operation, {1}});
            if (change.refusal == ModelRefusal::FacesMeet)
                qFatal("seed and pair %d, operation %d: refused", i, static_cast<int>(operation));
            if (!change.changes)
                return operation == SetOperation::Difference ? volumeOf(mesh, 0) : 0.0;
            if (!isEveryPartSound(mesh) || mesh.frame().parts.find(1) || hashes(mesh).at(2) != hashes(*start).at(2))
                qFatal("unsound");
            return volumeOf(mesh, 0);
        };
        const double a = volumeOf(*start, 0), b = volumeOf(*start, 1);
        const double united = after(SetOperation::Union), common = after(SetOperation::Intersection),
                     rest = after(SetOperation::Difference);
        const QString sums = QStringLiteral("pair %1: %2 and %3, union %4, common %5, rest %6")
                                 .arg(i)
                                 .arg(a)
                                 .arg(b)
                                 .arg(united)
                                 .arg(common)
                                 .arg(rest);
        QVERIFY2(std::abs(united + common - a - b) < 1e-4 * (a + b), qPrintable(sums));
        QVERIFY2(std::abs(rest + common - a) < 1e-4 * a, qPrintable(sums));
    }
}

void TestParts::combine_refuses()
{
    const std::unique_ptr<Mesh> mesh = document({ballAt({0, 0, 0}, 10), ballAt({40, 0, 0}, 5), ballAt({0, 0, 0}, 10)});
    const auto refusal = [&](SetOperation operation, std::vector<PartId> others) {
        return core::applyToCopy(*mesh, CombineParts{operation, std::move(others)}, {}, 0).refusal;
    };
    QCOMPARE(refusal(SetOperation::Difference, {1}), ModelRefusal::PartsApart);
    QCOMPARE(refusal(SetOperation::Intersection, {1}), ModelRefusal::NothingLeft);
    QCOMPARE(refusal(SetOperation::Difference, {2}), ModelRefusal::NothingLeft);
    QCOMPARE(refusal(SetOperation::Union, {0}), ModelRefusal::NoOtherPart);
    QCOMPARE(refusal(SetOperation::Union, {7}), ModelRefusal::NoSuchPart);
    QCOMPARE(refusal(SetOperation::Union, {}), ModelRefusal::NoOtherPart);
    QCOMPARE(refusal(SetOperation::Union, {1}), ModelRefusal::None); // two pieces in one part
    applyChecked(*mesh, core::ShowParts{{0}});
    QCOMPARE(refusal(SetOperation::Union, {1}), ModelRefusal::NotEditable);
}

void TestParts::snapshot_restoresParts()
{
    const std::unique_ptr<Mesh> mesh = threeBalls();
    applyChecked(*mesh, core::EditPart{"Nose", false, {}, 9}, 1);
    applyChecked(*mesh, core::EditPart{"Ear", false, {}, {}}, 0);
    QCOMPARE(mesh->frame().parts.all().front().name, std::string("Ear")); // it stays in its place
    QCOMPARE(mesh->frame().parts.all().back().name, std::string("Nose"));
    const auto start = core::snapshotOf(*mesh);
    const auto before = hashes(*mesh);
    QVERIFY(applyChecked(*mesh, core::DeletePart{}, 1).changes);
    QVERIFY(applyChecked(*mesh, core::Reset{start}).changes);
    QCOMPARE(hashes(*mesh), before);
    QVERIFY(mesh->frame() == start->frame);
    // a saved document: built again from its surface and frame
    const auto again = core::buildMesh(start->surface, false, {}, start->frame).mesh;
    QVERIFY(again && again->frame() == start->frame);
    QCOMPARE(hashes(*again), before);
}

void TestParts::check_allowsPartsToOverlap()
{
    TriangleMesh whole = core::extractMesh(*threeBalls());
    const core::MeshReport report = core::checkMesh(whole);
    QVERIFY(report.printReady());
    QCOMPARE(report.components, std::size_t(3));
    QCOMPARE(report.genus, std::optional<std::int64_t>(0));
    whole.parts.clear();
    QVERIFY(!core::checkMesh(whole).printReady());
}

/// Masks the half x > 0, hides it, and sculpts with every tool over the border.
void TestParts::hidden_clayIsNeitherDrawnNorChanged()
{
    Sculptor sculptor(threeBalls());
    const auto run = [&](const core::ModelCommand& command) {
        ModelChange change = core::applyToCopy(sculptor.mesh(), command, {}, 0);
        sculptor.swap(change.delta);
        return change;
    };
    QVERIFY(!core::applyToCopy(sculptor.mesh(), core::Hide{core::Hide::What::Masked}, {}, 0).changes);
    core::StrokeSettings masking;
    masking.tool = core::Tool::Mask;
    masking.radius = 9;
    masking.falloff = 0;
    sculptor.beginStroke(masking);
    core::StrokeSample sample;
    sample.position = {10, 0, 0};
    sculptor.addSample(sample);
    sculptor.endStroke();
    const auto hides = run(core::Hide{core::Hide::What::Masked});
    QVERIFY(hides.changes);
    run(core::MaskOperation{core::MaskOperation::Kind::Clear, {}});
    const auto hiddenPlaces = [&] {
        std::set<std::array<float, 3>> places;
        for (const Slot v : sculptor.mesh().vertices()) {
            const core::Vec3f& p = sculptor.mesh().point(v);
            if (sculptor.mesh().isHidden(v))
                places.insert({p.x(), p.y(), p.z()});
        }
        return places;
    };
    const auto before = hiddenPlaces();
    QVERIFY(before.size() > 50);
    core::DrawArrays arrays;
    arrays.apply(sculptor.wholePatch());
    for (const Slot f : sculptor.mesh().faces())
        QCOMPARE(arrays.isFree(f), sculptor.mesh().isFaceHidden(f));
    // a ray through the hidden side meets no front face; the other side is met from its outside
    QVERIFY(!sculptor.hit({{50, 0, 0}, {-1, 0, 0}}));
    QVERIFY(sculptor.hit({{-50, 0, 0}, {1, 0, 0}}).has_value());
    StrokeFuzzer random(numberFromEnvironment("FETTLE_SEED", 1));
    for (int i = 0; i < byEffort(48, 480); ++i) {
        core::Stroke stroke = random.stroke(sculptor.mesh());
        stroke.settings.part = 0;
        stroke.settings.tool = static_cast<core::Tool>(i % static_cast<int>(core::toolNames().size()));
        sculptor.beginStroke(stroke.settings);
        for (const core::StrokeSample& one : stroke.samples)
            sculptor.addSample(one);
        sculptor.endStroke();
        QVERIFY2(hiddenPlaces() == before, qPrintable(QStringLiteral("stroke %1").arg(i)));
    }
    QVERIFY(isEveryPartSound(sculptor.mesh()));
    QVERIFY(run(core::Hide{core::Hide::What::Nothing}).changes);
    QVERIFY(hiddenPlaces().empty());
    core::DrawArrays shown;
    shown.apply(sculptor.wholePatch());
    for (const Slot f : sculptor.mesh().faces())
        QVERIFY(!shown.isFree(f));
}

void TestParts::hidden_clayMayBeCoarserThanTheBrush_data()
{
    QTest::addColumn<core::Topology>("topology");
    QTest::newRow("refine") << core::Topology::Refine;
    QTest::newRow("adaptive") << core::Topology::Adaptive;
    QTest::newRow("keep") << core::Topology::Keep;
    QTest::newRow("uniform") << core::Topology::Uniform;
}

/// Sculpts over the border of a hidden half, whose edges are many times longer than those that the brush wants: the
/// stroke ends, makes about as many vertices as where nothing is hidden, and leaves the hidden half as it is.
void TestParts::hidden_clayMayBeCoarserThanTheBrush()
{
    QFETCH(const core::Topology, topology);
    const auto hiddenFaces = [](const Mesh& mesh) {
        std::vector<std::array<Vec3f, 3>> faces;
        for (const Slot f : mesh.faces())
            if (const auto& [a, b, c] = mesh.corners(f); mesh.isFaceHidden(f))
                faces.push_back({mesh.point(a), mesh.point(b), mesh.point(c)});
        return faces;
    };
    const auto sculpt = [&](Sculptor& sculptor, core::Tool tool) {
        core::StrokeSettings settings;
        settings.tool = tool;
        settings.topology = topology;
        settings.radius = 1.5;
        settings.detail = 0.3;
        sculptor.beginStroke(settings);
        for (const double x : {0.0, 0.4, 0.8}) {
            core::StrokeSample sample;
            sample.position = {x, 0.3, 15};
            sculptor.addSample(sample);
        }
        sculptor.endStroke();
    };
    for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
        const auto tool = static_cast<core::Tool>(i);
        const std::string name(core::toolNames()[i]);
        std::unique_ptr<Mesh> mesh = document({core::icosphere(4, 15)});
        mesh->beginStroke();
        for (const Slot v : mesh->vertices())
            mesh->setHidden(v, mesh->point(v).y() < 0.001F);
        mesh->endStroke();
        const auto before = hiddenFaces(*mesh);
        Sculptor sculptor(std::move(mesh)), whole(document({core::icosphere(4, 15)}));
        sculpt(sculptor, tool);
        sculpt(whole, tool);
        QVERIFY2(sculptor.mesh().live().vertices < 2 * whole.mesh().live().vertices, name.c_str());
        QVERIFY2(hiddenFaces(sculptor.mesh()) == before, name.c_str());
        QVERIFY2(isEveryPartSound(sculptor.mesh()), name.c_str());
    }
}

/// Random strokes and part commands, undone at the end.
void TestParts::randomWork_staysSound()
{
    StrokeFuzzer random(numberFromEnvironment("FETTLE_SEED", 1));
    Sculptor sculptor(threeBalls());
    const std::uint64_t start = sculptor.mesh().stateHash();
    std::vector<core::MeshDelta> undo;
    const int steps = byEffort(60, 600);
    for (int i = 0; i < steps; ++i) {
        const PartList& parts = sculptor.mesh().frame().parts;
        const PartId part = parts.all()[random.below(parts.size())].id;
        const PartId other = parts.all()[random.below(parts.size())].id;
        if (random.below(3) > 0) {
            core::Stroke stroke = random.stroke(sculptor.mesh());
            stroke.settings.part = part;
            sculptor.beginStroke(stroke.settings);
            for (const core::StrokeSample& sample : stroke.samples)
                sculptor.addSample(sample);
            undo.push_back(sculptor.endStroke());
        } else {
            const auto operation = static_cast<SetOperation>(random.below(3));
            const core::ModelCommand commands[] = {
                core::DuplicatePart{"copy"},
                core::SeparatePart{},
                CombineParts{operation, {other}},
                core::Move{random.direction() * random.uniform(0, 6)},
                core::Rotate{Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0, 3), random.direction()))},
                core::EditPart{"name", random.below(8) == 0, {}, random.below(4)},
                core::MaskOperation{core::MaskOperation::Kind::Clear, {}}};
            const core::ModelCommand& command = commands[random.below(std::size(commands))];
            if (parts.size() > 8)
                continue;
            ModelChange change = core::applyToCopy(sculptor.mesh(), command, {}, part);
            if (!change.changes)
                continue;
            sculptor.swap(change.delta);
            undo.push_back(std::move(change.delta));
        }
        QVERIFY2(sculptor.indexIsConsistent(), qPrintable(QStringLiteral("step %1").arg(i)));
        if (const std::string defect = i % 10 == 9 ? unsoundness(sculptor.mesh()) : std::string(); !defect.empty())
            QFAIL(qPrintable(QStringLiteral("step %1: %2").arg(i).arg(QString::fromStdString(defect))));
    }
    while (!undo.empty()) {
        sculptor.swap(undo.back());
        undo.pop_back();
    }
    QCOMPARE(sculptor.mesh().stateHash(), start);
}

FETTLE_TEST(TestParts, QCoreApplication)

#include "tst_parts.moc"
