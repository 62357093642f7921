#include "core/mesh/openmesh_version.h"

#include <OpenMesh/Core/System/config.h>

namespace core
{
std::string openMeshVersion()
{
    return std::to_string(OM_GET_VER) + '.' + std::to_string(OM_GET_MAJ);
}
} // namespace core
