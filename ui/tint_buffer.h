#pragma once

#include "core/footprint.h"

#include <vector>

class QOpenGLFunctions_3_3_Core;

namespace ui
{
/// One byte a vertex slot in OpenGL: the weight of a footprint, 0 outside. The context that was current at create() must be current
/// at every call.
class TintBuffer
{
public:
    void create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    unsigned int id() const { return m_id; }
    /// For so many slots, nothing tinted.
    void clear(std::size_t slots);
    void grow(std::size_t slots);
    /// In place of what was tinted before; null: nothing. Slots that there are not are left out. Cost: the pages of slots that
    /// either footprint lies in.
    void show(const core::Footprint* footprint);

private:
    void uploadAll();
    void uploadTouched();

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    unsigned int m_id = 0;
    std::vector<std::uint8_t> m_weights; ///< as they are in the buffer
    std::vector<core::Slot> m_tinted;
    std::vector<bool> m_touched; ///< pages
};
} // namespace ui
