// Tests that a viewer has the state of the mesh after it has applied patches, or any merge of them.

#include "core/mesh/dirty_slots.h"
#include "core/mesh/mesh_patch.h"
#include "core/operations/model_command.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"
#include "tests/support/viewer.h"

#include <QTest>

using core::MeshPatch;
using core::Sculptor;
using core::Slot;
using core::SlotSpan;
using mesh_asserts::sculptable;

namespace
{
bool isInForm(const std::vector<SlotSpan>& spans, std::size_t values, Slot length)
{
    std::size_t count = 0;
    Slot end = 0;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (spans[i].count == 0 || (i > 0 && spans[i].first <= end))
            return false; // spans must be ascending, disjoint and not adjacent
        end = spans[i].first + spans[i].count;
        count += spans[i].count;
    }
    return count == values && end <= length;
}

bool isInForm(const MeshPatch& patch)
{
    return isInForm(patch.vertexSpans, patch.vertices.size(), patch.vertexSlots) &&
           isInForm(patch.faceSpans, patch.faces.size(), patch.faceSlots);
}

/// A series of strokes, undos and redos, with the patch of each and the whole mesh after each.
struct Run
{
    std::vector<MeshPatch> patches, wholes;
    explicit Run(std::uint64_t runSeed)
    {
        Sculptor sculptor(sculptable(core::icosphere(2, 1)));
        StrokeFuzzer random(runSeed);
        wholes.push_back(sculptor.wholePatch());
        std::vector<core::MeshDelta> undo;
        const auto note = [&] {
            patches.push_back(sculptor.takePatch());
            wholes.push_back(sculptor.wholePatch());
        };
        for (int i = 0; i < 12; ++i) {
            if (!undo.empty() && random.below(3) == 0) {
                sculptor.swap(undo.back());
                note();
                if (random.below(2) == 0) {
                    sculptor.swap(undo.back());
                    note();
                } else {
                    undo.pop_back();
                }
                continue;
            }
            const core::Stroke stroke = random.stroke(sculptor.mesh());
            sculptor.beginStroke(stroke.settings);
            for (const core::StrokeSample& sample : stroke.samples) {
                sculptor.addSample(sample);
                note();
            }
            undo.push_back(sculptor.endStroke());
        }
    }
};
} // namespace

class TestMeshPatch : public QObject
{
    Q_OBJECT

    static constexpr std::uint64_t seed = 20240812;

private Q_SLOTS:
    void patchesOneByOne_giveTheMesh();
    void anyMergedRun_givesTheMesh();
    void merge_intoTheWhole_staysWhole();
    void whole_replacesWhatWasBefore();
    void undo_shrinksTheArrays();
    void undoOfAnInsertion_isSeen();
    void merge_ofSmallSpans_agreesWithSlots();
    void nothingChanged_isAnEmptyPatch();
};

void TestMeshPatch::patchesOneByOne_giveTheMesh()
{
    for (std::uint64_t round = 0; round < 6; ++round) {
        const Run run(seed + round);
        Viewer viewer = viewerOf(run.wholes[0]);
        for (std::size_t i = 0; i < run.patches.size(); ++i) {
            QVERIFY(isInForm(run.patches[i]) && !run.patches[i].whole);
            QVERIFY(i == 0 || run.patches[i].epoch > run.patches[i - 1].epoch);
            viewer.apply(run.patches[i]);
            QVERIFY2(viewer == viewerOf(run.wholes[i + 1]),
                     qPrintable(QString::fromLatin1("seed %1, patch %2").arg(seed + round).arg(i)));
            QCOMPARE(run.patches[i].liveVertices, run.wholes[i + 1].liveVertices);
            QCOMPARE(run.patches[i].liveFaces, run.wholes[i + 1].liveFaces);
        }
    }
}

void TestMeshPatch::anyMergedRun_givesTheMesh()
{
    const Run run(seed);
    StrokeFuzzer random(seed);
    for (int round = 0; round < 60; ++round) {
        Viewer viewer = viewerOf(run.wholes[0]);
        std::size_t i = 0;
        while (i < run.patches.size()) {
            MeshPatch merged = run.patches[i++];
            for (std::uint64_t more = random.below(12); more > 0 && i < run.patches.size(); --more) {
                merged.merge(MeshPatch(run.patches[i++]));
                QVERIFY(isInForm(merged));
            }
            viewer.apply(merged);
            QVERIFY2(viewer == viewerOf(run.wholes[i]),
                     qPrintable(QString::fromLatin1("seed %1, up to %2").arg(seed).arg(i)));
            QCOMPARE(merged.liveFaces, run.wholes[i].liveFaces);
        }
    }
}

void TestMeshPatch::merge_intoTheWhole_staysWhole()
{
    const Run run(seed);
    MeshPatch inbox = run.wholes[0];
    for (std::size_t i = 0; i < run.patches.size(); ++i) {
        inbox.merge(MeshPatch(run.patches[i]));
        QVERIFY(inbox.whole && isInForm(inbox));
        QVERIFY(viewerOf(inbox) == viewerOf(run.wholes[i + 1]));
    }
}

void TestMeshPatch::whole_replacesWhatWasBefore()
{
    const Run run(seed);
    MeshPatch inbox = run.patches[0];
    inbox.merge(MeshPatch(run.wholes.back()));
    QVERIFY(inbox.whole && viewerOf(inbox) == viewerOf(run.wholes.back()));
}

void TestMeshPatch::undo_shrinksTheArrays()
{
    Sculptor sculptor(sculptable(core::icosphere(2, 1)));
    const Slot before = sculptor.wholePatch().vertexSlots;
    core::StrokeSettings settings;
    settings.radius = 0.3;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {0, 0, 1};
    sculptor.addSample(sample);
    core::MeshDelta delta = sculptor.endStroke();
    MeshPatch patch = sculptor.takePatch();
    QVERIFY(patch.vertexSlots > before);
    sculptor.swap(delta);
    patch.merge(sculptor.takePatch());
    QCOMPARE(patch.vertexSlots, before);
    QVERIFY(isInForm(patch));
}

/// Undo of an insertion changes nothing except that the arrays become shorter, which the patch must report.
void TestMeshPatch::undoOfAnInsertion_isSeen()
{
    Sculptor sculptor(sculptable(core::icosphere(2, 1)));
    Viewer viewer = viewerOf(sculptor.wholePatch());
    const core::Insert insertion{shapes::moved(core::icosphere(1, 1), {5, 0, 0}), core::Insert::Place::AsItIs};
    core::ModelChange change = core::applyToCopy(sculptor.mesh(), insertion);
    QVERIFY(change.changes);
    for (int i = 0; i < 4; ++i) { // redo and undo, twice
        sculptor.swap(change.delta);
        const MeshPatch patch = sculptor.takePatch();
        QCOMPARE(patch.shortens, i % 2 == 1);
        QVERIFY(!patch.empty());
        viewer.apply(patch);
        QVERIFY(viewer == viewerOf(sculptor.wholePatch()));
    }
    QVERIFY(sculptor.takePatch().empty());
}

/// Compares merged patches with arrays that have one entry per slot.
void TestMeshPatch::merge_ofSmallSpans_agreesWithSlots()
{
    StrokeFuzzer random(seed);
    Slot value = 1;
    const auto randomPatch = [&] {
        MeshPatch patch;
        patch.faceSlots = 1 + static_cast<Slot>(random.below(30));
        for (Slot at = static_cast<Slot>(random.below(5)); at < patch.faceSlots;
             at += 1 + static_cast<Slot>(random.below(5))) {
            SlotSpan span = {at, 0};
            for (std::uint64_t n = 1 + random.below(5); n > 0 && at < patch.faceSlots; --n, ++at, ++span.count)
                patch.faces.push_back({value, value + 1, value + 2}), ++value;
            patch.faceSpans.push_back(span);
        }
        return patch;
    };
    for (int round = 0; round < 20'000; ++round) {
        MeshPatch first = randomPatch(), second = randomPatch();
        std::vector<std::optional<core::Triangle>> expected(second.faceSlots);
        for (const MeshPatch* patch : {&first, &second}) {
            std::size_t at = 0;
            for (const SlotSpan& span : patch->faceSpans) {
                for (Slot i = span.first; i < span.first + span.count; ++i, ++at) {
                    if (i < expected.size())
                        expected[i] = patch->faces[at];
                }
            }
        }
        first.merge(std::move(second));
        QVERIFY2(isInForm(first), qPrintable(QString::fromLatin1("seed %1, round %2").arg(seed).arg(round)));
        std::vector<std::optional<core::Triangle>> merged(first.faceSlots);
        std::size_t at = 0;
        for (const SlotSpan& span : first.faceSpans) {
            for (Slot i = span.first; i < span.first + span.count; ++i)
                merged.at(i) = first.faces.at(at++);
        }
        QVERIFY2(merged == expected, qPrintable(QString::fromLatin1("seed %1, round %2").arg(seed).arg(round)));
    }
}

void TestMeshPatch::nothingChanged_isAnEmptyPatch()
{
    Sculptor sculptor(sculptable(core::icosphere(2, 1)));
    QVERIFY(sculptor.takePatch().empty());
    QVERIFY(!sculptor.wholePatch().empty());
    QVERIFY(sculptor.takePatch().empty());
}

FETTLE_TEST(TestMeshPatch)
#include "tst_mesh_patch.moc"
