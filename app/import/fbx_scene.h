#pragma once

#include "app/import/fbx_models.h"
#include "app/import/scene_mesh.h"

namespace app
{
/// Adds everything that an FBX file places and shows, in millimetres with Y up, converted from the file's unit and
/// axes. Of levels of detail, adds the finest one that shows anything.
/// Precondition: the file was modified by fbxForAssimp(), which also returned `models`. It was read with
/// AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, because Assimp's combined transforms are wrong; only their factors are right.
/// Returns the number of meshes missing from the scene. Throws std::runtime_error if the unit is invalid or a node
/// matches no model.
std::size_t addFbxScene(const aiScene& scene, const std::vector<FbxModel>& models, SceneMesh& mesh);
} // namespace app
