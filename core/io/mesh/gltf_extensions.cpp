// Source: Khronos, glTF extension registry.
#include "core/io/mesh/gltf_extensions.h"

#include <algorithm>
#include <array>

namespace core::io
{
bool isWithoutShape(std::string_view extension)
{
    constexpr std::array<std::string_view, 21> names{"KHR_mesh_quantization",
                                                     "KHR_draco_mesh_compression",
                                                     "EXT_meshopt_compression",
                                                     "KHR_meshopt_compression",
                                                     "EXT_mesh_gpu_instancing",
                                                     "KHR_node_visibility",
                                                     "KHR_animation_pointer",
                                                     "KHR_xmp",
                                                     "KHR_xmp_json_ld",
                                                     "KHR_techniques_webgl",
                                                     "KHR_environment_map",
                                                     "EXT_mesh_features",
                                                     "EXT_mesh_manifold",
                                                     "EXT_structural_metadata",
                                                     "EXT_feature_metadata",
                                                     "AGI_articulations",
                                                     "AGI_stk_metadata",
                                                     "CESIUM_primitive_outline",
                                                     "FB_ngon_encoding",
                                                     "MSFT_packing_normalRoughnessMetallic",
                                                     "MSFT_packing_occlusionRoughnessMetallic"};
    constexpr std::array<std::string_view, 14> beginnings{"KHR_materials_",    "EXT_materials_",
                                                          "MSFT_materials_",   "ADOBE_materials_",
                                                          "NV_materials_",     "KHR_texture_",
                                                          "EXT_texture_",      "MSFT_texture_",
                                                          "GODOT_single_root", "KHR_lights_",
                                                          "EXT_lights_",       "KHR_audio",
                                                          "MSFT_audio_",       "VRM"};
    return std::ranges::find(names, extension) != names.end() ||
           std::ranges::any_of(beginnings, [extension](std::string_view b) { return extension.starts_with(b); });
}
} // namespace core::io
