#pragma once

#include "core/io/mesh/gltf_primitive.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace core::io
{
/// Computes the transforms by which a skin's joints move the vertices of a primitive, from all its joint sets. Throws
/// FileError if the bindings are not valid or too many.
class GltfSkinning
{
public:
    /// `joints`: for each joint the transform from the mesh to the scene; may be empty; not owned.
    GltfSkinning(const FileBytes& file, const GltfDocument& gltf, const GltfPrimitive& primitive,
                 std::span<const Eigen::Matrix4d> joints, std::size_t vertices);

    /// Returns whether the primitive is bound to joints.
    bool isBound() const { return !m_bindings.empty(); }
    /// Returns the weighted mean of the transforms of the vertex's joints. Without weights it is the transform of the
    /// vertex's first joint, or of the skin's first joint if the index is not valid. Precondition: isBound().
    Eigen::Matrix4d transformOf(std::size_t vertex) const;
    /// Returns whether the mean transform of a triangle's vertices mirrors the triangle. Precondition: isBound().
    bool isMirrored(std::size_t a, std::size_t b, std::size_t c) const;

private:
    struct Binding
    {
        LargeBuffer<float> joints, weights; ///< four values for each vertex
    };

    std::span<const Eigen::Matrix4d> m_joints;
    std::vector<Binding> m_bindings;
};
} // namespace core::io
