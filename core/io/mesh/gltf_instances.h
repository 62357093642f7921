#pragma once

#include "core/io/mesh/gltf_document.h"

#include <Eigen/Core>

#include <vector>

namespace core::io
{
/// Largest number of instances in one file.
inline constexpr std::size_t maxGltfInstances = std::size_t(1) << 18;

/// Returns the transforms from the node's mesh to the node, one for each instance in EXT_mesh_gpu_instancing; the
/// identity without that extension or without its lists. Throws FileError if the lists are not valid or differ in
/// length, and TooManyElements. Memory: 128 bytes an instance.
std::vector<Eigen::Matrix4d> gltfInstances(const FileBytes& file, const GltfDocument& gltf,
                                           const GltfDocument::Json& node);

/// Returns whether a node and its descendants are visible (KHR_node_visibility). Throws FileError.
bool isGltfVisible(const GltfDocument& gltf, const GltfDocument::Json& node);
} // namespace core::io
