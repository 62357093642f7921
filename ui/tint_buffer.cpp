#include "tint_buffer.h"

#include <QOpenGLFunctions_3_3_Core>

#include <algorithm>

namespace ui
{
namespace
{
constexpr std::size_t page = 1024; ///< slots; one call sends it
} // namespace

void TintBuffer::create(QOpenGLFunctions_3_3_Core* gl)
{
    m_gl = gl;
    m_gl->glGenBuffers(1, &m_id);
}

void TintBuffer::destroy()
{
    m_gl->glDeleteBuffers(1, &m_id);
    *this = {};
}

void TintBuffer::clear(std::size_t slots)
{
    m_tinted.clear();
    m_weights.assign(slots, 0);
    uploadAll();
}

void TintBuffer::grow(std::size_t slots)
{
    m_weights.resize(std::max(slots, m_weights.size()), 0);
    uploadAll();
}

void TintBuffer::show(const core::Footprint* footprint)
{
    for (const core::Slot slot : m_tinted) {
        m_weights[slot] = 0;
        m_touched[slot / page] = true;
    }
    m_tinted.clear();
    for (std::size_t i = 0; footprint && i < footprint->slots.size(); ++i) {
        const core::Slot slot = footprint->slots[i];
        if (slot >= m_weights.size())
            continue;
        m_weights[slot] = std::max(m_weights[slot], footprint->weights[i]);
        m_touched[slot / page] = true;
        m_tinted.push_back(slot);
    }
    uploadTouched();
}

void TintBuffer::uploadAll()
{
    m_touched.assign(m_weights.size() / page + 1, false);
    m_gl->glBindBuffer(GL_COPY_WRITE_BUFFER, m_id);
    m_gl->glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(m_weights.size()), m_weights.data(), GL_DYNAMIC_DRAW);
}

/// Pages that lie side by side go at once.
void TintBuffer::uploadTouched()
{
    m_gl->glBindBuffer(GL_COPY_WRITE_BUFFER, m_id);
    for (auto first = std::ranges::find(m_touched, true); first != m_touched.end();) {
        const auto last = std::find(first, m_touched.end(), false);
        const auto from = static_cast<std::size_t>(first - m_touched.begin()) * page;
        const auto to = std::min(static_cast<std::size_t>(last - m_touched.begin()) * page, m_weights.size());
        m_gl->glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(from), static_cast<GLsizeiptr>(to - from), m_weights.data() + from);
        std::fill(first, last, false);
        first = std::find(last, m_touched.end(), true);
    }
}
} // namespace ui
