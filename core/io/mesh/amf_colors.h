#pragma once

#include "core/geometry/triangle_mesh.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace core::io
{
/// The colours of one object of an AMF, as they are read. A corner has the colour of its triangle, else of its vertex,
/// of its volume, of the object, or of the volume's material; a vertex has the mean of its corners.
class AmfColors
{
public:
    using Materials = std::map<std::string, Rgb, std::less<>>;

    /// Vertices and triangles are numbered through the object, and come in order.
    void setVertex(std::size_t vertex, Rgb color);
    void setTriangle(std::size_t triangle, Rgb color);
    void setObject(Rgb color) { m_object = color; }
    /// Forgets the colours of the triangles from `first` on.
    void removeTriangles(std::size_t first);
    /// `end`: the number of triangles that the object has with this volume.
    void addVolume(std::size_t end, std::optional<Rgb> color, const std::string& material);

    /// Returns one for each of the object's points, or none where nothing has a colour. A vertex without one gets the
    /// default colour. Precondition: the mesh has the triangles of the volumes that were added.
    std::vector<Rgb> of(const TriangleMesh& mesh, const Materials& materials) const;

private:
    struct Volume
    {
        std::size_t end;
        std::optional<Rgb> color;
        std::string material;
    };
    std::optional<Rgb> m_object;
    std::vector<std::optional<Rgb>> m_vertices; ///< as far as one has a colour
    std::vector<std::pair<std::size_t, Rgb>> m_triangles;
    std::vector<Volume> m_volumes;
};
} // namespace core::io
