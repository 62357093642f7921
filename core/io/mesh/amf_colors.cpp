#include "core/io/mesh/amf_colors.h"

#include "core/io/mesh/mean_color.h"

namespace core::io
{
void AmfColors::setVertex(std::size_t vertex, Rgb color)
{
    m_vertices.resize(std::max(m_vertices.size(), vertex + 1));
    m_vertices[vertex] = color;
}

void AmfColors::setTriangle(std::size_t triangle, Rgb color)
{
    m_triangles.emplace_back(triangle, color);
}

void AmfColors::removeTriangles(std::size_t first)
{
    while (!m_triangles.empty() && m_triangles.back().first >= first)
        m_triangles.pop_back();
}

void AmfColors::addVolume(std::size_t end, std::optional<Rgb> color, const std::string& material)
{
    if (end != (m_volumes.empty() ? 0 : m_volumes.back().end))
        m_volumes.push_back({end, color, material});
}

std::vector<Rgb> AmfColors::of(const TriangleMesh& mesh, const Materials& materials) const
{
    std::vector<MeanColor> means;
    auto own = m_triangles.begin();
    std::size_t i = 0;
    for (const Volume& volume : m_volumes) {
        const auto material = materials.find(volume.material);
        std::optional<Rgb> below = volume.color ? volume.color : m_object;
        if (!below && material != materials.end())
            below = material->second;
        for (; i < volume.end; ++i) {
            std::optional<Rgb> ofTriangle;
            for (; own != m_triangles.end() && own->first == i; ++own)
                ofTriangle = own->second;
            for (const Slot corner : mesh.triangles[i]) {
                const std::optional<Rgb> ofVertex = corner < m_vertices.size() ? m_vertices[corner] : std::nullopt;
                const std::optional<Rgb> color = ofTriangle ? ofTriangle : ofVertex ? ofVertex : below;
                if (!color)
                    continue;
                means.resize(mesh.points.size());
                means[corner].add(*color);
            }
        }
    }
    std::vector<Rgb> colors;
    colors.reserve(means.size());
    for (const MeanColor& mean : means)
        colors.push_back(mean.color());
    return colors;
}
} // namespace core::io
