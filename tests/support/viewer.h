#pragma once

#include "core/mesh/mesh_patch.h"

#include <algorithm>
#include <vector>

/// A viewer that receives only patches. Its draw arrays are updated by code independent of the program's.
struct Viewer
{
    std::vector<core::DrawVertex> vertices;
    std::vector<core::Triangle> faces;

    void apply(const core::MeshPatch& patch)
    {
        // garbage until a patch sets them
        vertices.resize(patch.vertexSlots, {core::Vec3f::Constant(-77), {1, 2, 3, 4}, {}, {}});
        faces.resize(patch.faceSlots, {7, 7, 7});
        put(patch.vertexSpans, patch.vertices, vertices);
        put(patch.faceSpans, patch.faces, faces);
    }

    bool operator==(const Viewer& other) const
    {
        return std::ranges::equal(vertices, other.vertices, same) && faces == other.faces;
    }

    /// Returns whether the live faces look the same. The values of unused vertices do not count.
    bool drawsLike(const Viewer& other) const
    {
        const auto cornersDrawAlike = [&](const core::Triangle& face) {
            return std::ranges::all_of(face, [&](core::Slot v) { return same(vertices[v], other.vertices[v]); });
        };
        return faces == other.faces && std::ranges::all_of(faces, cornersDrawAlike);
    }

private:
    static bool same(const core::DrawVertex& a, const core::DrawVertex& b)
    {
        return a.position == b.position && a.normal == b.normal && a.color == b.color && a.crease == b.crease;
    }

    template <class Value>
    static void put(const std::vector<core::SlotSpan>& spans, const std::vector<Value>& values,
                    std::vector<Value>& array)
    {
        std::size_t at = 0;
        for (const core::SlotSpan& span : spans)
            for (core::Slot i = 0; i < span.count; ++i)
                array.at(span.first + i) = values.at(at++);
    }
};

inline Viewer viewerOf(const core::MeshPatch& whole)
{
    Viewer viewer;
    viewer.apply(whole);
    return viewer;
}
