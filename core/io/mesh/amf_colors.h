#pragma once

#include "core/geometry/triangle_mesh.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace core::io
{
/// Collects the colours of one AMF object while it is read. A corner takes the first colour that exists of: its
/// triangle, its vertex, its volume, the object, the volume's material. A vertex gets the mean of its corners' colours.
class AmfColors
{
public:
    using Materials = std::map<std::string, Rgb, std::less<>>;

    /// Sets a vertex's colour. Vertices and triangles are numbered throughout the object and must be passed in
    /// ascending order.
    void setVertex(std::size_t vertex, Rgb color);
    void setTriangle(std::size_t triangle, Rgb color);
    void setObject(Rgb color) { m_object = color; }
    /// Forgets the colours of the triangles from `first` on.
    void removeTriangles(std::size_t first);
    /// Ends a volume. `end`: the object's number of triangles including this volume.
    void addVolume(std::size_t end, std::optional<Rgb> color, const std::string& material);

    /// Returns one colour for each of the object's points, or an empty list if nothing has a colour. A vertex without a
    /// colour gets the default colour. Precondition: the mesh has the triangles of the added volumes.
    std::vector<Rgb> of(const TriangleMesh& mesh, const Materials& materials) const;

private:
    struct Volume
    {
        std::size_t end;
        std::optional<Rgb> color;
        std::string material;
    };
    std::optional<Rgb> m_object;
    std::vector<std::optional<Rgb>> m_vertices; ///< up to the last vertex that has a colour
    std::vector<std::pair<std::size_t, Rgb>> m_triangles;
    std::vector<Volume> m_volumes;
};
} // namespace core::io
