#pragma once

#include "app/import/fbx_models.h"
#include "app/import/scene_mesh.h"

namespace app
{
/// Adds all that an FBX file places and shows, of levels of detail the finest one that shows anything, in millimetres
/// and with Y up, by the file's own unit and axes. It has to be read as fbx_models.h makes it, with
/// AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS: what Assimp makes of a model's transforms is right only in their parts.
/// `models`: of fbxForAssimp(). Returns how many meshes the models lack that they should have. Throws
/// std::runtime_error where its unit is none, or where a node of the scene is none of the models.
std::size_t addFbxScene(const aiScene& scene, const std::vector<FbxModel>& models, SceneMesh& mesh);
} // namespace app
