#pragma once

#include "app/import/fbx_models.h"
#include "app/import/scene_mesh.h"

namespace app
{
/// Numbers of what an FBX file has, but addFbxScene() does not add.
struct FbxLeftOut
{
    std::size_t missing = 0; ///< meshes that Assimp did not read
    std::size_t hidden = 0;  ///< models with meshes that are hidden, or not connected to the scene
};

/// Adds everything that an FBX file places and shows, in millimetres with Y up, converted from the file's unit and
/// axes. Of levels of detail, adds the finest one that shows anything.
/// Precondition: the file was modified by fbxForAssimp(), which also returned `models`. It was read with
/// AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, because Assimp's combined transforms are wrong; only their factors are right.
/// Returns what was left out. Throws std::runtime_error if the unit is invalid or a node
/// matches no model.
FbxLeftOut addFbxScene(const aiScene& scene, const std::vector<FbxModel>& models, SceneMesh& mesh);
} // namespace app
