#include "welder.h"

namespace core::mesh_io
{
void weld(TriangleMesh& mesh, StopCheck stopCheck)
{
    Welder welder(mesh.points.size());
    std::vector<Slot> welded;
    welded.reserve(mesh.points.size());
    std::vector<Rgb> colors;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        stopCheck();
        welded.push_back(welder.add(mesh.points[i]));
        if (!mesh.colors.empty() && colors.size() < welder.size())
            colors.push_back(mesh.colors[i]);
    }
    if (welder.size() == mesh.points.size())
        return;
    mesh.points = welder.takePoints();
    mesh.colors = std::move(colors);
    for (Triangle& triangle : mesh.triangles) {
        stopCheck();
        for (Slot& corner : triangle)
            corner = welded[corner];
    }
}
} // namespace core::mesh_io
