#pragma once

#include "core/mesh/footprint.h"
#include "core/render/gl_constants.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace core
{
/// One byte per vertex slot in an OpenGL buffer: the weight of a footprint, 0 outside it. `Gl`: as for MeshBuffer.
/// Thread: the OpenGL context that was current at create() must be current at every call.
template <class Gl> class VertexWeightBuffer
{
public:
    void create(Gl* gl);
    void destroy();

    unsigned int id() const { return m_id; }
    /// Resizes to this number of slots, all with weight 0.
    void clear(std::size_t slots);
    void grow(std::size_t slots);
    /// Replaces the weights by those of a footprint; null: all 0. Slots beyond the buffer are ignored. Cost: uploads
    /// the pages of 1024 slots that the old or the new footprint touches.
    void show(const Footprint* footprint);

private:
    static constexpr std::size_t page = 1024; ///< slots per page; touched pages are uploaded whole

    void uploadAll();
    void uploadTouched();

    Gl* m_gl = nullptr;
    unsigned int m_id = 0;
    std::vector<std::uint8_t> m_weights; ///< copy of the buffer's contents
    std::vector<Slot> m_tinted;
    std::vector<bool> m_touched; ///< one flag per page: changed since the last upload
};

template <class Gl> void VertexWeightBuffer<Gl>::create(Gl* gl)
{
    m_gl = gl;
    m_gl->glGenBuffers(1, &m_id);
}

template <class Gl> void VertexWeightBuffer<Gl>::destroy()
{
    m_gl->glDeleteBuffers(1, &m_id);
    *this = {};
}

template <class Gl> void VertexWeightBuffer<Gl>::clear(std::size_t slots)
{
    m_tinted.clear();
    m_weights.assign(slots, 0);
    uploadAll();
}

template <class Gl> void VertexWeightBuffer<Gl>::grow(std::size_t slots)
{
    m_weights.resize(std::max(slots, m_weights.size()), 0);
    uploadAll();
}

template <class Gl> void VertexWeightBuffer<Gl>::show(const Footprint* footprint)
{
    for (const Slot slot : m_tinted) {
        m_weights[slot] = 0;
        m_touched[slot / page] = true;
    }
    m_tinted.clear();
    for (std::size_t i = 0; footprint && i < footprint->slots.size(); ++i) {
        const Slot slot = footprint->slots[i];
        if (slot >= m_weights.size())
            continue;
        m_weights[slot] = std::max(m_weights[slot], footprint->weights[i]);
        m_touched[slot / page] = true;
        m_tinted.push_back(slot);
    }
    uploadTouched();
}

template <class Gl> void VertexWeightBuffer<Gl>::uploadAll()
{
    m_touched.assign(m_weights.size() / page + 1, false);
    m_gl->glBindBuffer(gl::copyWriteBuffer, m_id);
    m_gl->glBufferData(gl::copyWriteBuffer, static_cast<std::ptrdiff_t>(m_weights.size()), m_weights.data(),
                       gl::dynamicDraw);
}

/// Uploads the touched pages. Adjacent pages are sent in one call.
template <class Gl> void VertexWeightBuffer<Gl>::uploadTouched()
{
    m_gl->glBindBuffer(gl::copyWriteBuffer, m_id);
    for (auto first = std::ranges::find(m_touched, true); first != m_touched.end();) {
        const auto last = std::find(first, m_touched.end(), false);
        const auto from = static_cast<std::size_t>(first - m_touched.begin()) * page;
        const auto to = std::min(static_cast<std::size_t>(last - m_touched.begin()) * page, m_weights.size());
        m_gl->glBufferSubData(gl::copyWriteBuffer, static_cast<std::ptrdiff_t>(from),
                              static_cast<std::ptrdiff_t>(to - from), m_weights.data() + from);
        std::fill(first, last, false);
        first = std::find(last, m_touched.end(), true);
    }
}
} // namespace core
