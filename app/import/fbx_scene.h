#pragma once

#include "app/import/scene_mesh.h"

namespace app
{
/// Adds all that an FBX file places, in millimetres and with Y up, by the file's own unit and axes. It has to be read
/// as fbx_models.h makes it, with AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS: what Assimp makes of a model's transforms is
/// right only in their parts. Throws std::runtime_error where its unit is none.
void addFbxScene(const aiScene& scene, SceneMesh& mesh);
} // namespace app
