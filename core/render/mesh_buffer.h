#pragma once

#include "core/mesh/mesh_patch.h"
#include "core/render/gl_constants.h"
#include "core/render/vertex_weight_buffer.h"

#include <cassert>
#include <cstddef>
#include <cstdint>

namespace core
{
/// Vertices and triangles of the mesh in OpenGL buffers, indexed by slot, for one viewer. No copy is kept on the CPU.
/// `Gl`: the viewer's table of OpenGL functions, version 3.3 core or later, under their own names. Thread: the OpenGL
/// context that was current at create() must be current at every call.
template <class Gl> class MeshBuffer
{
public:
    /// Statistics since create(): bytes sent, uploads of a whole mesh, and times that a buffer had to grow.
    struct Counters
    {
        std::uint64_t bytes = 0, wholeUploads = 0, growths = 0;
    };

    void create(Gl* gl);
    void destroy();

    /// Uploads the changed slots. Cost: one glBufferSubData per span. A buffer that is too small is replaced by one 1.5
    /// times the needed size, and its contents are copied within the GPU.
    void apply(const MeshPatch& patch);

    /// Marks the vertices of a footprint and removes earlier marks; null: marks none. A whole patch removes the marks.
    void tint(const Footprint* footprint);
    /// Colours the vertices in `shades` by their weight (see PrintScale) and restores the vertices shaded before. Other
    /// vertices keep their own colour. null: all vertices do.
    void shade(const Footprint* shades);
    bool isShaded() const { return m_isShaded; }

    /// Draws every face slot; a free slot has indices (0,0,0) and covers no pixel. Attributes: 0 position, 1 normal and
    /// mask, 2 colour and curvature, 3 footprint weight, 4 shade, 5 sharp edge.
    void draw() const;

    bool empty() const { return m_faceSlots == 0; }
    Slot vertexSlots() const { return m_vertexSlots; }
    Slot faceSlots() const { return m_faceSlots; }
    const Counters& counters() const { return m_counters; }

private:
    static constexpr std::size_t vertexBytes = sizeof(DrawVertex);
    static constexpr std::size_t faceBytes = sizeof(Triangle);

    struct Buffer
    {
        unsigned int id = 0;
        std::size_t capacity = 0; ///< bytes
    };

    /// Returns the capacity for a needed size: 1.5 times as much, so that refining strokes rarely force a copy.
    static constexpr std::size_t withReserve(std::size_t bytes) { return bytes + bytes / 2; }

    void allocate(Buffer& buffer, std::size_t bytes);
    void grow(Buffer& buffer, std::size_t usedBytes, std::size_t neededBytes);
    template <class Value>
    void upload(const Buffer& buffer, const std::vector<SlotSpan>& spans, const std::vector<Value>& values);
    void bindAttributes() const;

    Gl* m_gl = nullptr;
    unsigned int m_vertexArray = 0;
    Buffer m_vertices, m_indices;
    VertexWeightBuffer<Gl> m_tint, m_shades;
    bool m_isShaded = false;
    Slot m_vertexSlots = 0, m_faceSlots = 0;
    Counters m_counters;
};

template <class Gl> void MeshBuffer<Gl>::create(Gl* gl)
{
    m_gl = gl;
    m_gl->glGenVertexArrays(1, &m_vertexArray);
    m_tint.create(gl);
    m_shades.create(gl);
}

template <class Gl> void MeshBuffer<Gl>::destroy()
{
    if (!m_gl)
        return;
    m_gl->glDeleteBuffers(1, &m_vertices.id);
    m_gl->glDeleteBuffers(1, &m_indices.id);
    m_gl->glDeleteVertexArrays(1, &m_vertexArray);
    m_tint.destroy();
    m_shades.destroy();
    *this = {};
}

template <class Gl> void MeshBuffer<Gl>::apply(const MeshPatch& patch)
{
    const std::size_t vertices = patch.vertexSlots * vertexBytes, faces = patch.faceSlots * faceBytes;
    if (patch.whole) {
        allocate(m_vertices, withReserve(vertices));
        allocate(m_indices, withReserve(faces));
        m_tint.clear(m_vertices.capacity / vertexBytes);
        m_shades.clear(m_vertices.capacity / vertexBytes);
        m_isShaded = false;
        bindAttributes();
        ++m_counters.wholeUploads;
    } else if (vertices > m_vertices.capacity || faces > m_indices.capacity) {
        grow(m_vertices, m_vertexSlots * vertexBytes, vertices);
        grow(m_indices, m_faceSlots * faceBytes, faces);
        m_tint.grow(m_vertices.capacity / vertexBytes);
        m_shades.grow(m_vertices.capacity / vertexBytes);
        bindAttributes();
    }
    upload(m_vertices, patch.vertexSpans, patch.vertices);
    upload(m_indices, patch.faceSpans, patch.faces);
    m_vertexSlots = patch.vertexSlots;
    m_faceSlots = patch.faceSlots;
}

template <class Gl> void MeshBuffer<Gl>::tint(const Footprint* footprint)
{
    m_tint.show(footprint);
}

template <class Gl> void MeshBuffer<Gl>::shade(const Footprint* shades)
{
    m_shades.show(shades);
    m_isShaded = shades != nullptr;
}

template <class Gl> void MeshBuffer<Gl>::draw() const
{
    if (empty())
        return;
    m_gl->glBindVertexArray(m_vertexArray);
    m_gl->glDrawElements(gl::triangles, static_cast<int>(m_faceSlots * 3), gl::unsignedInt, nullptr);
    m_gl->glBindVertexArray(0);
}

template <class Gl> void MeshBuffer<Gl>::allocate(Buffer& buffer, std::size_t bytes)
{
    if (!buffer.id)
        m_gl->glGenBuffers(1, &buffer.id);
    m_gl->glBindBuffer(gl::copyWriteBuffer, buffer.id);
    m_gl->glBufferData(gl::copyWriteBuffer, static_cast<std::ptrdiff_t>(bytes), nullptr, gl::dynamicDraw);
    buffer.capacity = bytes;
}

template <class Gl> void MeshBuffer<Gl>::grow(Buffer& buffer, std::size_t usedBytes, std::size_t neededBytes)
{
    if (neededBytes <= buffer.capacity)
        return;
    Buffer larger;
    allocate(larger, withReserve(neededBytes));
    if (usedBytes > 0) {
        m_gl->glBindBuffer(gl::copyReadBuffer, buffer.id);
        m_gl->glCopyBufferSubData(gl::copyReadBuffer, gl::copyWriteBuffer, 0, 0,
                                  static_cast<std::ptrdiff_t>(usedBytes));
    }
    m_gl->glDeleteBuffers(1, &buffer.id);
    buffer = larger;
    ++m_counters.growths;
}

template <class Gl>
template <class Value>
void MeshBuffer<Gl>::upload(const Buffer& buffer, const std::vector<SlotSpan>& spans, const std::vector<Value>& values)
{
    if (spans.empty())
        return;
    m_gl->glBindBuffer(gl::copyWriteBuffer, buffer.id);
    const Value* next = values.data();
    for (const SlotSpan& span : spans) {
        const std::size_t first = span.first * sizeof(Value), bytes = span.count * sizeof(Value);
        assert(first + bytes <= buffer.capacity && next + span.count <= values.data() + values.size());
        m_gl->glBufferSubData(gl::copyWriteBuffer, static_cast<std::ptrdiff_t>(first),
                              static_cast<std::ptrdiff_t>(bytes), next);
        next += span.count;
        m_counters.bytes += bytes;
    }
}

template <class Gl> void MeshBuffer<Gl>::bindAttributes() const
{
    const auto stride = static_cast<int>(vertexBytes);
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    m_gl->glBindVertexArray(m_vertexArray);
    m_gl->glBindBuffer(gl::arrayBuffer, m_vertices.id);
    m_gl->glBindBuffer(gl::elementArrayBuffer, m_indices.id);
    m_gl->glVertexAttribPointer(0, 3, gl::singleFloat, 0, stride, offset(offsetof(DrawVertex, position)));
    m_gl->glVertexAttribPointer(1, 4, gl::signedByte, 1, stride, offset(offsetof(DrawVertex, normal)));
    m_gl->glVertexAttribPointer(2, 4, gl::unsignedByte, 1, stride, offset(offsetof(DrawVertex, color)));
    m_gl->glVertexAttribPointer(5, 4, gl::signedByte, 1, stride, offset(offsetof(DrawVertex, crease)));
    m_gl->glBindBuffer(gl::arrayBuffer, m_tint.id());
    m_gl->glVertexAttribPointer(3, 1, gl::unsignedByte, 1, 1, nullptr);
    m_gl->glBindBuffer(gl::arrayBuffer, m_shades.id());
    m_gl->glVertexAttribPointer(4, 1, gl::unsignedByte, 1, 1, nullptr);
    for (unsigned int i = 0; i < 6; ++i)
        m_gl->glEnableVertexAttribArray(i);
    m_gl->glBindVertexArray(0);
}
} // namespace core
