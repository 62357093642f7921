#pragma once

#include "vr/scene/patch_slices.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace vr
{
/// Bytes of a large model that are uploaded in one frame. The whole model would delay the frame.
inline constexpr std::size_t sliceBytes = 2'000'000;

/// The mesh as it is drawn. A large model is uploaded in slices while the last model is shown; changes made meanwhile
/// are applied after the upload, in order. Before the first step(), and for small models, the upload is done at once.
/// `Buffer`: MeshBuffer or a class like it.
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

    /// Applies a patch. Precondition: patches of one mesh come in order, a whole one first.
    void apply(core::MeshPatch patch);
    /// Uploads the next slice. To be called once a frame.
    void step();
    bool isLoading() const { return m_slices.has_value(); }

    Buffer& shown() { return m_buffers[m_shown]; }
    const Buffer& shown() const { return m_buffers[m_shown]; }
    std::uint64_t bytes() const { return m_buffers[0].counters().bytes + m_buffers[1].counters().bytes; }
    /// Returns the number of models uploaded completely. A model that a newer one replaced during its upload does not
    /// count.
    std::uint64_t wholeUploads() const { return m_wholeUploads; }

private:
    Buffer& coming() { return m_buffers[1 - m_shown]; }
    void applyWhole(core::MeshPatch&& patch);
    void finish();
    void clearHidden();

    std::array<Buffer, 2> m_buffers;
    std::size_t m_shown = 0;
    /// Slices of the model that is being uploaded; none: no upload is in progress.
    std::optional<PatchSlices> m_slices;
    std::optional<core::MeshPatch> m_pending;         ///< changes of the model that is being uploaded
    bool m_hasStepped = false, m_hasOldModel = false; ///< m_hasOldModel: the buffer that is not shown still has a model
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
