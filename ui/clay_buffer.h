#pragma once

#include "tint_buffer.h"

#include "core/mesh_patch.h"

class QOpenGLFunctions_3_3_Core;

namespace ui
{
/// The clay's vertices and triangles in OpenGL, slot by slot as patches give them. No copy is kept on the CPU.
/// The context that was current at create() must be current at every call.
class ClayBuffer
{
public:
    /// Bytes sent since create(), and how often a whole patch came or a buffer had to grow.
    struct Counters
    {
        std::uint64_t bytes = 0, wholeUploads = 0, growths = 0;
    };

    void create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    /// Cost: one glBufferSubData a span. Past the capacity, which has half as much again in reserve, the buffer's
    /// contents are copied within the GPU once.
    void apply(const core::MeshPatch& patch);

    /// Marks the vertices of a footprint, in place of those before; null: none. A whole patch takes the marks away.
    void tint(const core::Footprint* footprint) { m_tint.show(footprint); }

    /// Colours vertices by shades (see PrintScale), likewise; where there are none they keep their own.
    void shade(const core::Footprint* shades)
    {
        m_shades.show(shades);
        m_isShaded = shades != nullptr;
    }
    bool isShaded() const { return m_isShaded; }

    /// Every face slot; free ones (0,0,0) cover no pixel. Attributes: 0 position, 1 normal, 2 colour, 3 the footprint's weight, 4 the shade.
    void draw() const;

    bool empty() const { return m_faceSlots == 0; }
    core::Slot vertexSlots() const { return m_vertexSlots; }
    core::Slot faceSlots() const { return m_faceSlots; }
    const Counters& counters() const { return m_counters; }

private:
    struct Buffer
    {
        unsigned int id = 0;
        std::size_t capacity = 0; ///< bytes
    };

    void allocate(Buffer& buffer, std::size_t bytes);
    void grow(Buffer& buffer, std::size_t usedBytes, std::size_t neededBytes);
    template <class Value>
    void upload(const Buffer& buffer, const std::vector<core::SlotSpan>& spans, const std::vector<Value>& values);
    void bindAttributes() const;

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    unsigned int m_vertexArray = 0;
    Buffer m_vertices, m_indices;
    TintBuffer m_tint, m_shades;
    bool m_isShaded = false;
    core::Slot m_vertexSlots = 0, m_faceSlots = 0;
    Counters m_counters;
};
} // namespace ui
