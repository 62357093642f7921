#include "core/mesh/draw_arrays.h"
#include "core/render/mesh_buffer.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <map>

namespace
{
/// A fake OpenGL with buffers in plain memory that records wrong use of them.
class MemoryGl
{
public:
    using Bytes = std::vector<unsigned char>;

    void glGenBuffers(int, unsigned int* id) { m_buffers[*id = ++m_made] = {}; }
    void glDeleteBuffers(int, const unsigned int* id) { m_buffers.erase(*id); }
    void glGenVertexArrays(int, unsigned int* id)
    {
        *id = ++m_made;
        ++m_vertexArrays;
    }
    void glDeleteVertexArrays(int, const unsigned int*) { --m_vertexArrays; }
    void glBindVertexArray(unsigned int) {}
    void glEnableVertexAttribArray(unsigned int) {}
    void glBindBuffer(unsigned int target, unsigned int id) { m_bound[target] = id; }

    void glBufferData(unsigned int target, std::ptrdiff_t size, const void* data, unsigned int)
    {
        bound(target).assign(static_cast<std::size_t>(size), garbage);
        if (data && size > 0)
            std::memcpy(bound(target).data(), data, static_cast<std::size_t>(size));
    }
    void glBufferSubData(unsigned int target, std::ptrdiff_t first, std::ptrdiff_t size, const void* data)
    {
        QVERIFY(first + size <= std::ssize(bound(target)));
        std::memcpy(bound(target).data() + first, data, static_cast<std::size_t>(size));
        ++writes;
    }
    void glCopyBufferSubData(unsigned int from, unsigned int to, std::ptrdiff_t, std::ptrdiff_t, std::ptrdiff_t size)
    {
        QVERIFY(size <= std::ssize(bound(from)) && size <= std::ssize(bound(to)));
        std::memcpy(bound(to).data(), bound(from).data(), static_cast<std::size_t>(size));
    }
    void glVertexAttribPointer(unsigned int index, int, unsigned int, unsigned char, int, const void*)
    {
        attributes[index] = m_bound[core::gl::arrayBuffer];
        elements = m_bound[core::gl::elementArrayBuffer];
    }
    void glDrawElements(unsigned int, int count, unsigned int, const void*) { drawn = count; }

    const Bytes& buffer(unsigned int id) const { return m_buffers.at(id); }
    std::size_t owned() const { return m_buffers.size() + m_vertexArrays; }

    std::map<unsigned int, unsigned int> attributes; ///< buffer that each vertex attribute reads
    unsigned int elements = 0;
    int drawn = 0, writes = 0;

private:
    static constexpr unsigned char garbage = 0xAB;

    Bytes& bound(unsigned int target) { return m_buffers.at(m_bound.at(target)); }

    std::map<unsigned int, Bytes> m_buffers;
    std::map<unsigned int, unsigned int> m_bound;
    unsigned int m_made = 0;
    std::size_t m_vertexArrays = 0;
};

using Buffer = core::MeshBuffer<MemoryGl>;

template <class Value> bool startsWith(const MemoryGl::Bytes& bytes, const std::vector<Value>& values)
{
    return bytes.size() >= values.size() * sizeof(Value) &&
           std::memcmp(bytes.data(), values.data(), values.size() * sizeof(Value)) == 0;
}

bool holds(const MemoryGl& gl, const core::DrawArrays& arrays)
{
    return startsWith(gl.buffer(gl.attributes.at(0)), arrays.vertices) &&
           startsWith(gl.buffer(gl.elements), arrays.faces);
}

std::size_t bytesOf(const core::MeshPatch& patch)
{
    return patch.vertices.size() * sizeof(core::DrawVertex) + patch.faces.size() * sizeof(core::Triangle);
}

core::Footprint footprint(std::vector<core::Slot> slots, std::uint8_t weight)
{
    const std::size_t count = slots.size();
    return {std::move(slots), std::vector<std::uint8_t>(count, weight)};
}
} // namespace

class TestMeshBuffer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_gl = {};
        m_buffer = {};
        m_buffer.create(&m_gl);
    }
    void patches_makeWhatTheyMakeInMemory();
    void footprint_isMarkedAndTakenAway();
    void destroy_leavesNothing();

private:
    MemoryGl m_gl;
    Buffer m_buffer;
};

/// A stroke refines the mesh until the buffers must grow, and its undo shortens them. They must always equal the draw
/// arrays in memory.
void TestMeshBuffer::patches_makeWhatTheyMakeInMemory()
{
    core::Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(2, 1)));
    core::DrawArrays arrays;
    std::size_t sent = 0;
    const auto take = [&](const core::MeshPatch& patch) {
        arrays.apply(patch);
        m_buffer.apply(patch);
        sent += bytesOf(patch);
        return holds(m_gl, arrays) && m_buffer.counters().bytes == sent && m_buffer.faceSlots() == arrays.faces.size();
    };
    QVERIFY(take(sculptor.wholePatch()));
    sculptor.takePatch();
    core::StrokeSettings settings;
    settings.radius = 0.2;
    sculptor.beginStroke(settings);
    for (int i = 0; i < 40; ++i) {
        core::StrokeSample sample;
        sample.position = {std::cos(0.1 * i), std::sin(0.1 * i), 0};
        sculptor.addSample(sample);
        QVERIFY(take(sculptor.takePatch()));
    }
    core::MeshDelta delta = sculptor.endStroke();
    QVERIFY(m_buffer.counters().growths >= 2);
    const core::Slot grown = m_buffer.faceSlots();
    sculptor.swap(delta);
    QVERIFY(take(sculptor.takePatch()));
    QVERIFY(m_buffer.faceSlots() < grown);
    m_buffer.draw();
    QCOMPARE(m_gl.drawn, static_cast<int>(3 * arrays.faces.size()));
    QCOMPARE(m_buffer.counters().wholeUploads, std::uint64_t(1));
    const int writes = m_gl.writes;
    QVERIFY(take(sculptor.takePatch())); // an empty patch writes nothing
    QCOMPARE(m_gl.writes, writes);
}

/// All weights are 0 if there is no footprint. Slots that do not exist are ignored, and a new mesh resets all weights.
void TestMeshBuffer::footprint_isMarkedAndTakenAway()
{
    const core::MeshPatch whole = core::Sculptor(mesh_asserts::sculptable(core::icosphere(4, 1))).wholePatch();
    m_buffer.apply(whole);
    const auto marks = [&] {
        std::map<core::Slot, int> found;
        const MemoryGl::Bytes& weights = m_gl.buffer(m_gl.attributes.at(3));
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i] != 0)
                found[static_cast<core::Slot>(i)] = weights[i];
        return found;
    };
    using Marks = std::map<core::Slot, int>;
    QCOMPARE(marks(), Marks());
    const core::Footprint first = footprint({3, 2000, 2001, 1'000'000}, 9), second = footprint({2001, 1024, 1023}, 200);
    m_buffer.tint(&first);
    QCOMPARE(marks(), (Marks{{3, 9}, {2000, 9}, {2001, 9}}));
    m_buffer.tint(&second);
    QCOMPARE(marks(), (Marks{{1023, 200}, {1024, 200}, {2001, 200}}));
    m_buffer.apply(whole);
    QCOMPARE(marks(), Marks());
    m_buffer.tint(&second);
    m_buffer.tint(nullptr);
    QCOMPARE(marks(), Marks());
}

void TestMeshBuffer::destroy_leavesNothing()
{
    m_buffer.apply(core::Sculptor(mesh_asserts::sculptable(core::icosphere(2, 1))).wholePatch());
    QVERIFY(m_gl.owned() > 0);
    m_buffer.destroy();
    QCOMPARE(m_gl.owned(), std::size_t(0));
    m_buffer.destroy(); // a second call is harmless
}

FETTLE_TEST(TestMeshBuffer, QCoreApplication)
#include "tst_mesh_buffer.moc"
