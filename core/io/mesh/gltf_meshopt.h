#pragma once

#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/meshopt.h"

namespace core::io
{
/// A compressed buffer view and the location of its data.
struct GltfMeshopt
{
    MeshoptView view; ///< `data` is not set
    std::size_t buffer = 0, offset = 0, length = 0;
};

/// Returns the compression of a buffer view; nothing if it is not compressed. `name`: name of the view, for errors.
/// Throws FileError::Malformed if the extension does not allow its values.
std::optional<GltfMeshopt> gltfMeshoptIn(const GltfDocument& gltf, const GltfDocument::Json& view,
                                         const std::string& name);
/// Returns whether the buffer is only a fallback for programs that cannot unpack meshopt.
bool isGltfFallback(const GltfDocument::Json& buffer);
} // namespace core::io
