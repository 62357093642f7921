#include "clay_buffer.h"

#include <QOpenGLFunctions_3_3_Core>

#include <cassert>
#include <cstddef>

namespace ui
{
namespace
{
constexpr std::size_t vertexBytes = sizeof(core::DrawVertex);
constexpr std::size_t faceBytes = sizeof(core::Triangle);

/// Half as much again: strokes refine, and a copy a thousand strokes is nothing.
constexpr std::size_t withReserve(std::size_t bytes)
{
    return bytes + bytes / 2;
}

const void* offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}
} // namespace

void ClayBuffer::create(QOpenGLFunctions_3_3_Core* gl)
{
    m_gl = gl;
    m_gl->glGenVertexArrays(1, &m_vertexArray);
    m_tint.create(gl);
    m_shades.create(gl);
}

void ClayBuffer::destroy()
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

void ClayBuffer::apply(const core::MeshPatch& patch)
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

void ClayBuffer::draw() const
{
    if (empty())
        return;
    m_gl->glBindVertexArray(m_vertexArray);
    m_gl->glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(m_faceSlots * 3), GL_UNSIGNED_INT, nullptr);
    m_gl->glBindVertexArray(0);
}

void ClayBuffer::allocate(Buffer& buffer, std::size_t bytes)
{
    if (!buffer.id)
        m_gl->glGenBuffers(1, &buffer.id);
    m_gl->glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.id);
    m_gl->glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
    buffer.capacity = bytes;
}

void ClayBuffer::grow(Buffer& buffer, std::size_t usedBytes, std::size_t neededBytes)
{
    if (neededBytes <= buffer.capacity)
        return;
    Buffer larger;
    allocate(larger, withReserve(neededBytes));
    if (usedBytes > 0) {
        m_gl->glBindBuffer(GL_COPY_READ_BUFFER, buffer.id);
        m_gl->glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(usedBytes));
    }
    m_gl->glDeleteBuffers(1, &buffer.id);
    buffer = larger;
    ++m_counters.growths;
}

template <class Value>
void ClayBuffer::upload(const Buffer& buffer, const std::vector<core::SlotSpan>& spans,
                        const std::vector<Value>& values)
{
    if (spans.empty())
        return;
    m_gl->glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.id);
    const Value* next = values.data();
    for (const core::SlotSpan& span : spans) {
        const std::size_t first = span.first * sizeof(Value), bytes = span.count * sizeof(Value);
        assert(first + bytes <= buffer.capacity && next + span.count <= values.data() + values.size());
        m_gl->glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first), static_cast<GLsizeiptr>(bytes), next);
        next += span.count;
        m_counters.bytes += bytes;
    }
}

void ClayBuffer::bindAttributes() const
{
    m_gl->glBindVertexArray(m_vertexArray);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, m_vertices.id);
    m_gl->glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id);
    const auto stride = static_cast<GLsizei>(vertexBytes);
    m_gl->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(core::DrawVertex, position)));
    m_gl->glVertexAttribPointer(1, 4, GL_BYTE, GL_TRUE, stride, offset(offsetof(core::DrawVertex, normal)));
    m_gl->glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(core::DrawVertex, color)));
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, m_tint.id());
    m_gl->glVertexAttribPointer(3, 1, GL_UNSIGNED_BYTE, GL_TRUE, 1, nullptr);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, m_shades.id());
    m_gl->glVertexAttribPointer(4, 1, GL_UNSIGNED_BYTE, GL_TRUE, 1, nullptr);
    for (GLuint i = 0; i < 5; ++i)
        m_gl->glEnableVertexAttribArray(i);
    m_gl->glBindVertexArray(0);
}
} // namespace ui
