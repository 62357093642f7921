#pragma once

#include "core/geometry/triangle_mesh.h"

#include <string>
#include <vector>

/// What strangers make: each model is wrong in one way that its name tells, some 100 units large.
struct BadModel
{
    std::string name;
    core::TriangleMesh mesh;
};
std::vector<BadModel> badModels();
