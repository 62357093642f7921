#pragma once

#include "core/io/mesh/gltf_primitive.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace core::io
{
/// The names of the attributes that bind a vertex to joints, four each.
inline constexpr const char* gltfBindings[][2] = {{"JOINTS_0", "WEIGHTS_0"}, {"JOINTS_1", "WEIGHTS_1"}};

/// Says where the joints of a skin take the vertices of a primitive. Throws FileError for bindings that are not as they
/// should be.
class GltfSkinning
{
public:
    /// `joints`: the transforms from the mesh to where each joint takes it; not owned. They may be none.
    GltfSkinning(const GltfDocument& gltf, const GltfPrimitive& primitive, std::span<const Eigen::Matrix4d> joints,
                 std::size_t vertices);

    /// Returns whether the primitive is bound to joints.
    bool isBound() const { return !m_bindings.empty(); }
    /// Returns the mean of the joints' transforms by the vertex's weights; where it has none, that of its first joint,
    /// or of the skin's where that is none. Precondition: isBound().
    Eigen::Matrix4d transformOf(std::size_t vertex) const;

private:
    struct Binding
    {
        LargeBuffer<float> joints, weights; ///< four of each vertex
    };

    std::span<const Eigen::Matrix4d> m_joints;
    std::vector<Binding> m_bindings;
};
} // namespace core::io
