// Sources: Khronos, EXT_meshopt_compression and the draft of KHR_meshopt_compression, "JSON schema updates".
#include "core/io/mesh/gltf_meshopt.h"

#include <array>

namespace core::io
{
namespace
{
using Json = GltfDocument::Json;

/// Returns the object of either meshopt extension; null if there is none.
const Json* extensionIn(const Json& object)
{
    const Json* const ofKhronos = gltfExtension(object, "KHR_meshopt_compression");
    return ofKhronos ? ofKhronos : gltfExtension(object, "EXT_meshopt_compression");
}

/// Returns the index in `words` of the object's value at the key; nothing if the value is not in `words`.
template <std::size_t Count>
std::optional<std::size_t> wordIn(const Json& object, const char* key, const std::array<std::string_view, Count>& words)
{
    const auto found = object.find(key);
    for (std::size_t i = 0; found != object.end() && i < Count; ++i)
        if (found->is_string() && found->get_ref<const std::string&>() == words[i])
            return i;
    return std::nullopt;
}

bool isAllowed(const MeshoptView& view)
{
    constexpr std::size_t maxSize = std::size_t(1) << 31;
    if (view.stride == 0 || view.count > maxSize / view.stride)
        return false;
    if (view.mode != MeshoptView::Mode::Attributes)
        return (view.stride == 2 || view.stride == 4) && view.filter == MeshoptView::Filter::None &&
               (view.mode == MeshoptView::Mode::Indices || view.count % 3 == 0);
    switch (view.filter) {
    case MeshoptView::Filter::Octahedral:
    case MeshoptView::Filter::Color:
        return view.stride == 4 || view.stride == 8;
    case MeshoptView::Filter::Quaternion:
        return view.stride == 8;
    case MeshoptView::Filter::Exponential:
    case MeshoptView::Filter::None:
        return view.stride % 4 == 0 && view.stride <= 256;
    }
    return false;
}
} // namespace

std::optional<GltfMeshopt> gltfMeshoptIn(const GltfDocument& gltf, const Json& view, const std::string& name)
{
    const Json* const extension = extensionIn(view);
    if (!extension)
        return std::nullopt;
    if (!extension->is_object())
        gltf.refuse(FileFault::NotAnObject, name);
    const auto required = [&](const char* key) {
        const auto value = gltf.indexIn(*extension, key);
        if (!value)
            gltf.refuse(FileFault::Missing, key);
        return *value;
    };
    constexpr std::array<std::string_view, 3> modes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
    constexpr std::array<std::string_view, 5> filters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
    const auto mode = wordIn(*extension, "mode", modes);
    const auto filter = extension->contains("filter") ? wordIn(*extension, "filter", filters) : 0;
    GltfMeshopt packed{.view = {.data = {},
                                .mode = static_cast<MeshoptView::Mode>(mode.value_or(0)),
                                .filter = static_cast<MeshoptView::Filter>(filter.value_or(0)),
                                .count = required("count"),
                                .stride = required("byteStride"),
                                .name = name},
                       .buffer = required("buffer"),
                       .offset = gltf.sizeIn(*extension, "byteOffset", 0),
                       .length = required("byteLength")};
    if (!mode || !filter || !isAllowed(packed.view))
        gltf.refuse(FileFault::CompressedWrong, name);
    return packed;
}

bool isGltfFallback(const Json& buffer)
{
    const Json* const extension = extensionIn(buffer);
    return extension && extension->is_object() && extension->value("fallback", Json(false)) == true;
}
} // namespace core::io
