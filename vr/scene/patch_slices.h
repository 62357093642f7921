#pragma once

#include "core/mesh/mesh_patch.h"

namespace vr
{
/// Returns the number of bytes that a patch uploads to OpenGL.
std::size_t bytesOf(const core::MeshPatch& patch);

/// Cuts a whole patch into patches to be applied one after another: first an empty whole one, then the values in order.
/// The mesh can be drawn only after the last one. Memory is freed as soon as it is not needed.
class PatchSlices
{
public:
    explicit PatchSlices(core::MeshPatch whole);

    bool atEnd() const { return m_isBegun && m_vertices.left == 0 && m_faces.left == 0; }
    /// Returns the next patch, of at most about `bytes` bytes. It is valid until the next call.
    const core::MeshPatch& next(std::size_t bytes);

private:
    /// Progress of cutting one array of the patch.
    struct Cut
    {
        std::size_t left = 0, value = 0, span = 0;
        core::Slot inSpan = 0;
    };
    template <class Value> struct Values
    {
        std::vector<core::SlotSpan>& spans;
        std::vector<Value>& values;
    };
    template <class Value> static void cut(Cut& at, std::size_t max, Values<Value> from, Values<Value> to);

    core::MeshPatch m_patch, m_slice;
    Cut m_vertices, m_faces;
    bool m_isBegun = false;
};
} // namespace vr
