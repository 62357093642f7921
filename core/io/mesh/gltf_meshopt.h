#pragma once

#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/meshopt.h"

namespace core::io
{
/// A compressed buffer view, and where its data are.
struct GltfMeshopt
{
    MeshoptView view; ///< without its data
    std::size_t buffer = 0, offset = 0, length = 0;
};

/// Returns how a buffer view is compressed; nothing if it is not. `name` is the view's, for errors. Throws
/// FileError::Malformed for what the extension does not allow.
std::optional<GltfMeshopt> gltfMeshoptIn(const GltfDocument& gltf, const GltfDocument::Json& view,
                                         const std::string& name);
/// Returns whether a buffer only stands for what programs read that cannot unpack.
bool isGltfFallback(const GltfDocument::Json& buffer);
} // namespace core::io
