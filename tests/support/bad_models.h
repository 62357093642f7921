#pragma once

#include "core/geometry/triangle_mesh.h"

#include <string>
#include <vector>

/// A defective model as users might import it: one kind of defect, given by its name, in a mesh of about 100 units.
struct BadModel
{
    std::string name;
    core::TriangleMesh mesh;
};
std::vector<BadModel> badModels();
