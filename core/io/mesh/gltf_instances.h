#pragma once

#include "core/io/mesh/gltf_document.h"

#include <Eigen/Core>

#include <vector>

namespace core::io
{
/// The number of instances that one file may have.
inline constexpr std::size_t maxGltfInstances = std::size_t(1) << 18;

/// Returns the transforms to a node from the places of its mesh: EXT_mesh_gpu_instancing lists them. Without it the
/// identity. Throws FileError for lists that are no such transforms or not equally long, and TooManyElements. Memory:
/// 128 bytes for each.
std::vector<Eigen::Matrix4d> gltfInstances(const FileBytes& file, const GltfDocument& gltf,
                                           const GltfDocument::Json& node);

/// Returns whether a node is shown, with all below it (KHR_node_visibility). Throws FileError.
bool isGltfVisible(const GltfDocument& gltf, const GltfDocument::Json& node);
} // namespace core::io
