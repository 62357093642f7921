#include "core/geometry/scale_mesh.h"

namespace core
{
bool scaleMesh(TriangleMesh& mesh, double factor)
{
    bool areNumbers = true;
    for (Vec3f& point : mesh.points) {
        point = (point.cast<double>() * factor).cast<float>();
        areNumbers = areNumbers && point.allFinite();
    }
    return areNumbers;
}
} // namespace core
