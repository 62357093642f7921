#pragma once

#include "core/io/mesh/gltf_primitive.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace core::io
{
/// Says where the joints of a skin take the vertices of a primitive, by all of its sets of joints. Throws FileError for
/// bindings that are not as they should be, or too many.
class GltfSkinning
{
public:
    /// `joints`: the transforms from the mesh to where each joint takes it; not owned. They may be none.
    GltfSkinning(const FileBytes& file, const GltfDocument& gltf, const GltfPrimitive& primitive,
                 std::span<const Eigen::Matrix4d> joints, std::size_t vertices);

    /// Returns whether the primitive is bound to joints.
    bool isBound() const { return !m_bindings.empty(); }
    /// Returns the mean of the joints' transforms by the vertex's weights; where it has none, that of its first joint,
    /// or of the skin's where that is none. Precondition: isBound().
    Eigen::Matrix4d transformOf(std::size_t vertex) const;
    /// Returns whether the mean of the transforms of a triangle's vertices mirrors it. Precondition: isBound().
    bool isMirrored(std::size_t a, std::size_t b, std::size_t c) const;

private:
    struct Binding
    {
        LargeBuffer<float> joints, weights; ///< four of each vertex
    };

    std::span<const Eigen::Matrix4d> m_joints;
    std::vector<Binding> m_bindings;
};
} // namespace core::io
