#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"
#include "vr/scene/mesh_stream.h"

#include <QTest>

using core::MeshPatch;
using core::Slot;

namespace
{
/// A replacement of MeshBuffer that keeps the contents in memory.
struct MemoryBuffer
{
    struct Counters
    {
        std::uint64_t bytes = 0;
    };

    std::vector<core::DrawVertex> vertices;
    std::vector<core::Triangle> faces;
    std::size_t maxBytes = 0; ///< size of the largest patch applied, bytes
    Counters sent;

    void create(int*) {}
    void destroy() { *this = {}; }
    const Counters& counters() const { return sent; }

    void apply(const MeshPatch& patch)
    {
        if (patch.whole) {
            vertices.clear();
            faces.clear();
        }
        vertices.resize(patch.vertexSlots);
        faces.resize(patch.faceSlots);
        put(patch.vertexSpans, patch.vertices, vertices);
        put(patch.faceSpans, patch.faces, faces);
        maxBytes = std::max(maxBytes, vr::bytesOf(patch));
        sent.bytes += vr::bytesOf(patch);
    }

    template <class Value>
    static void put(const std::vector<core::SlotSpan>& spans, const std::vector<Value>& from, std::vector<Value>& to)
    {
        auto next = from.begin();
        for (const core::SlotSpan& span : spans) {
            std::copy_n(next, span.count, to.begin() + span.first);
            next += span.count;
        }
        QCOMPARE(next, from.end());
    }

    bool shows(const MemoryBuffer& other) const
    {
        const auto same = [](const core::DrawVertex& a, const core::DrawVertex& b) {
            return a.position == b.position && a.normal == b.normal && a.color == b.color && a.crease == b.crease;
        };
        return std::ranges::equal(vertices, other.vertices, same) && faces == other.faces;
    }
};

using Stream = vr::MeshStream<MemoryBuffer>;

core::DrawVertex vertex(StrokeFuzzer& random)
{
    return {core::Vec3f::Constant(static_cast<float>(random.below(1 << 20))), {}, {}};
}

core::Triangle face(StrokeFuzzer& random)
{
    return {static_cast<Slot>(random.below(1 << 20)), 1, 2};
}

/// Fills values for all slots, or for random spans of slots.
template <class Value, class Make>
void fill(std::vector<core::SlotSpan>& spans, std::vector<Value>& values, Slot slots, bool all, const Make& make)
{
    for (Slot at = 0; at < slots;) {
        const Slot count = all ? slots : std::min<Slot>(slots - at, 1 + static_cast<Slot>(make.random.below(500)));
        spans.push_back({at, count});
        for (Slot i = 0; i < count; ++i)
            values.push_back(make());
        at += count + 1 + static_cast<Slot>(make.random.below(1 + slots / 4));
    }
}

struct MakeVertex
{
    StrokeFuzzer& random;
    core::DrawVertex operator()() const { return vertex(random); }
};
struct MakeFace
{
    StrokeFuzzer& random;
    core::Triangle operator()() const { return face(random); }
};

MeshPatch patch(StrokeFuzzer& random, Slot vertices, Slot faces, bool whole)
{
    MeshPatch made;
    made.whole = whole;
    made.vertexSlots = vertices;
    made.faceSlots = faces;
    fill(made.vertexSpans, made.vertices, vertices, whole, MakeVertex{random});
    fill(made.faceSpans, made.faces, faces, whole, MakeFace{random});
    return made;
}

/// Returns a whole patch for another model, often one that takes several frames to load.
MeshPatch wholePatch(StrokeFuzzer& random)
{
    const Slot size = random.below(3) == 0 ? 0 : random.below(2) == 0 ? 1000 : 150'000;
    return patch(random, size + static_cast<Slot>(random.below(5000)), 2 * size + static_cast<Slot>(random.below(5000)),
                 true);
}

/// Returns a patch after which the mesh is larger or smaller.
MeshPatch nextPatch(StrokeFuzzer& random, const MemoryBuffer& mesh)
{
    const auto changed = [&](std::size_t slots) {
        return static_cast<Slot>(
            std::max<long>(0, static_cast<long>(slots) + static_cast<long>(random.below(200)) - 80));
    };
    const Slot vertices = changed(mesh.vertices.size()), faces = changed(mesh.faces.size());
    MeshPatch made = patch(random, vertices, faces, false);
    // a patch must contain all new slots
    const auto complete = [&](auto& spans, auto& values, std::size_t before, Slot now, const auto& make) {
        const Slot said = spans.empty() ? 0 : spans.back().first + spans.back().count;
        const Slot from = std::max(static_cast<Slot>(before), said);
        if (from >= now)
            return;
        from == said && !spans.empty() ? void(spans.back().count += now - from) : spans.push_back({from, now - from});
        for (Slot slot = from; slot < now; ++slot)
            values.push_back(make());
    };
    complete(made.vertexSpans, made.vertices, mesh.vertices.size(), vertices, MakeVertex{random});
    complete(made.faceSpans, made.faces, mesh.faces.size(), faces, MakeFace{random});
    return made;
}

void finish(Stream& stream)
{
    for (int frame = 0; stream.isLoading() && frame < 100; ++frame)
        stream.step();
    QVERIFY(!stream.isLoading());
}
} // namespace

class TestMeshStream : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anySequence_endsAsIfAppliedDirectly();
    void beforeTheFirstFrame_allIsThereAtOnce();
    void smallModels_areThereAtOnce();
    void largeModels_comeInSlices();
    void spansAreKept();
};

/// Checks that the mesh shown is always a complete one: the newest, or while that is loading, the last one before it.
void TestMeshStream::anySequence_endsAsIfAppliedDirectly()
{
    StrokeFuzzer random(20261122);
    for (int run = 0; run < 12; ++run) {
        Stream stream;
        stream.create(static_cast<int*>(nullptr));
        MemoryBuffer direct, before;
        const auto apply = [&](const MeshPatch& patch) {
            if (patch.whole && !stream.isLoading())
                before = direct;
            direct.apply(patch);
            stream.apply(patch);
        };
        apply(wholePatch(random));
        QVERIFY(stream.shown().shows(direct));
        for (int i = 0; i < 60; ++i) {
            if (random.below(2) == 0)
                stream.step();
            else
                apply(random.below(12) == 0 ? wholePatch(random) : nextPatch(random, direct));
            QVERIFY(stream.shown().shows(stream.isLoading() ? before : direct));
        }
        finish(stream);
        QVERIFY(stream.shown().shows(direct));
        stream.destroy();
    }
}

void TestMeshStream::beforeTheFirstFrame_allIsThereAtOnce()
{
    StrokeFuzzer random(1);
    Stream stream;
    const MeshPatch large = patch(random, 200'000, 400'000, true);
    MemoryBuffer direct;
    direct.apply(large);
    stream.apply(large);
    QVERIFY(!stream.isLoading());
    QVERIFY(stream.shown().shows(direct));
    QCOMPARE(stream.wholeUploads(), 1U);
}

void TestMeshStream::smallModels_areThereAtOnce()
{
    StrokeFuzzer random(2);
    Stream stream;
    stream.step();
    const MeshPatch small = patch(random, 40'000, 80'000, true);
    QVERIFY(vr::bytesOf(small) < vr::sliceBytes);
    stream.apply(small);
    MemoryBuffer direct;
    direct.apply(small);
    QVERIFY(stream.shown().shows(direct));
    stream.step();
    stream.apply(patch(random, 200'000, 400'000, true));
    QVERIFY(stream.isLoading());
    stream.step();
    stream.apply(small); // replaces the model that was loading
    QVERIFY(!stream.isLoading() && stream.shown().shows(direct));
    QCOMPARE(stream.wholeUploads(), 2U);
}

void TestMeshStream::largeModels_comeInSlices()
{
    StrokeFuzzer random(3);
    Stream stream;
    stream.step();
    const MeshPatch large = patch(random, 200'000, 400'000, true);
    stream.apply(large);
    std::uint64_t sent = 0;
    int frames = 0;
    for (; stream.isLoading(); ++frames) {
        stream.step();
        QVERIFY(stream.bytes() - sent <= vr::sliceBytes);
        sent = stream.bytes();
    }
    QCOMPARE(sent, vr::bytesOf(large));
    QVERIFY(frames <= 4 + static_cast<int>(sent / vr::sliceBytes));
    const MemoryBuffer& shown = stream.shown();
    QCOMPARE(shown.vertices.size(), 200'000U);
}

/// Checks whole patches with several spans, which may end within a slice.
void TestMeshStream::spansAreKept()
{
    StrokeFuzzer random(4);
    MeshPatch whole = patch(random, 150'000, 300'000, true);
    whole.vertexSpans = {{0, 49'999}, {49'999, 2}, {50'001, 0}, {50'001, 99'999}};
    whole.faceSpans = {{0, 1}, {1, 299'999}};
    MemoryBuffer direct;
    direct.apply(whole);
    for (const std::size_t bytes : {std::size_t(1'000'000), std::size_t(999'999), std::size_t(10'000'000)}) {
        MemoryBuffer sliced;
        for (vr::PatchSlices slices(whole); !slices.atEnd();)
            sliced.apply(slices.next(bytes));
        QVERIFY(sliced.shows(direct));
        QVERIFY(sliced.maxBytes <= bytes);
    }
}

FETTLE_TEST(TestMeshStream, QCoreApplication)
#include "tst_mesh_stream.moc"
