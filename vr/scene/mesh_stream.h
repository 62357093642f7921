#pragma once

#include "vr/scene/patch_slices.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace vr
{
/// A large model that comes during a visit is sent so much a frame, or its frames would be late.
inline constexpr std::size_t sliceBytes = 2'000'000;

/// The mesh as it is drawn. A large model comes in slices beside the one before, which is shown until the new one is
/// there whole; what is sculpted meanwhile follows it, in order. Before the first step(), and for small models, all is
/// there at once. `Buffer`: as MeshBuffer.
template <class Buffer> class MeshStream
{
public:
    template <class Gl> void create(Gl* gl)
    {
        for (Buffer& buffer : m_buffers)
            buffer.create(gl);
    }
    void destroy()
    {
        for (Buffer& buffer : m_buffers)
            buffer.destroy();
        *this = {};
    }

    /// Patches of one mesh in order, a whole one first.
    void apply(core::MeshPatch patch);
    /// Once a frame.
    void step();
    bool isLoading() const { return m_slices.has_value(); }

    Buffer& shown() { return m_buffers[m_shown]; }
    const Buffer& shown() const { return m_buffers[m_shown]; }
    std::uint64_t bytes() const { return m_buffers[0].counters().bytes + m_buffers[1].counters().bytes; }
    /// Models that came whole and were not given up for a newer one.
    std::uint64_t wholeUploads() const { return m_wholeUploads; }

private:
    Buffer& coming() { return m_buffers[1 - m_shown]; }
    void applyWhole(core::MeshPatch&& patch);
    void finish();
    void clearHidden();

    std::array<Buffer, 2> m_buffers;
    std::size_t m_shown = 0;
    std::optional<PatchSlices> m_slices;              ///< of the model that is coming
    std::optional<core::MeshPatch> m_pending;         ///< of it, too, and newer
    bool m_hasStepped = false, m_hasOldModel = false; ///< the other buffer still has a model that nobody will see
    std::uint64_t m_wholeUploads = 0;
};

template <class Buffer> void MeshStream<Buffer>::apply(core::MeshPatch patch)
{
    if (patch.whole)
        applyWhole(std::move(patch));
    else if (!isLoading())
        shown().apply(patch);
    else if (m_pending)
        m_pending->merge(std::move(patch));
    else
        m_pending = std::move(patch);
}

template <class Buffer> void MeshStream<Buffer>::step()
{
    m_hasStepped = true;
    if (m_slices && !m_slices->atEnd())
        coming().apply(m_slices->next(sliceBytes));
    else if (m_slices)
        finish();
    else if (std::exchange(m_hasOldModel, false))
        clearHidden();
}

template <class Buffer> void MeshStream<Buffer>::applyWhole(core::MeshPatch&& patch)
{
    m_hasOldModel = m_hasOldModel || isLoading();
    m_pending.reset();
    m_slices.reset();
    if (m_hasStepped && bytesOf(patch) > sliceBytes) {
        m_slices.emplace(std::move(patch));
        return;
    }
    shown().apply(patch);
    ++m_wholeUploads;
}

template <class Buffer> void MeshStream<Buffer>::finish()
{
    m_slices.reset();
    if (m_pending)
        coming().apply(*m_pending);
    m_pending.reset();
    m_shown = 1 - m_shown;
    m_hasOldModel = true;
    ++m_wholeUploads;
}

template <class Buffer> void MeshStream<Buffer>::clearHidden()
{
    core::MeshPatch nothing;
    nothing.whole = true;
    coming().apply(nothing);
}
} // namespace vr
