#pragma once

#include "core/mesh/mesh_patch.h"

namespace vr
{
/// What a patch sends to OpenGL.
std::size_t bytesOf(const core::MeshPatch& patch);

/// A whole patch, cut into patches that follow one another: first an empty whole one, then its values in order. Only
/// the last leaves a mesh that can be drawn. Gives back memory as soon as it is not needed.
class PatchSlices
{
public:
    explicit PatchSlices(core::MeshPatch whole);

    bool atEnd() const { return m_isBegun && m_vertices.left == 0 && m_faces.left == 0; }
    /// Good until the next call. `bytes`: about that much, at most.
    const core::MeshPatch& next(std::size_t bytes);

private:
    /// How far one of the patch's arrays has been cut.
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
