// GLB: a node for each part that scales mm to glTF's metres, with one mesh of one primitive. Colours are linear with 16
// bits. The mask is a custom attribute, 0 to 1.

#include "core/io/mesh/binary.h"
#include "core/io/mesh/file_parts.h"
#include "core/io/mesh/glb_metadata.h"
#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/record_writer.h"
#include "core/io/mesh/srgb.h"

#include "core/io/mesh/format.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace core::io
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr int floatType = 5126, shortType = 5123, indexType = 5125, vertexTarget = 34962, indexTarget = 34963;

/// Limit of the buffer's size, because sizes in a GLB have 32 bits.
constexpr std::size_t maxBytes = 4'000'000'000;

/// Returns area-weighted vertex normals of unit length. Vertices without area get (0, 0, 1), because glTF requires unit
/// length.
std::vector<Vec3f> normalsOf(const TriangleMesh& mesh)
{
    std::vector<Vec3f> normals(mesh.points.size());
    const std::size_t chunkSize = chunksOf(mesh.points.size(), minChunks); // each core scans all triangles
    forEachChunk(mesh.points.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        std::vector<Vec3> sums(end - begin, Vec3::Zero());
        const auto isOwn = [begin, end](Slot corner) { return corner >= begin && corner < end; };
        for (const Triangle& t : mesh.triangles) {
            if (!isOwn(t[0]) && !isOwn(t[1]) && !isOwn(t[2]))
                continue;
            const Vec3 a = mesh.points[t[0]].cast<double>();
            const Vec3 area = (mesh.points[t[1]].cast<double>() - a).cross(mesh.points[t[2]].cast<double>() - a);
            for (const Slot corner : t)
                if (isOwn(corner))
                    sums[corner - begin] += area;
        }
        for (std::size_t v = begin; v < end; ++v) {
            const Vec3& sum = sums[v - begin];
            const double length = sum.norm();
            normals[v] = length > 0 && std::isfinite(length) ? Vec3f((sum / length).cast<float>()) : Vec3f(0, 0, 1);
        }
    });
    return normals;
}

/// Returns the linear 16-bit light of each 8-bit sRGB value.
std::array<std::uint16_t, 256> lights()
{
    std::array<std::uint16_t, 256> table;
    for (std::size_t seen = 0; seen < table.size(); ++seen)
        table[seen] = static_cast<std::uint16_t>(std::lround(65535 * linearFromSrgb(static_cast<std::uint8_t>(seen))));
    return table;
}

/// Collects buffer views that follow each other, each with one accessor.
class Layout
{
public:
    int add(std::size_t count, std::size_t bytesEach, int componentType, const char* type, int target)
    {
        m_views.push_back(
            {{"buffer", 0}, {"byteOffset", m_bytes}, {"byteLength", count * bytesEach}, {"target", target}});
        m_accessors.push_back(
            {{"bufferView", m_views.size() - 1}, {"componentType", componentType}, {"count", count}, {"type", type}});
        m_bytes += count * bytesEach;
        return static_cast<int>(m_accessors.size()) - 1;
    }
    Json& accessor(int index) { return m_accessors[static_cast<std::size_t>(index)]; }
    std::size_t bytes() const { return m_bytes; }
    void moveTo(Json& document)
    {
        document["accessors"] = std::move(m_accessors);
        document["bufferViews"] = std::move(m_views);
        document["buffers"] = {{{"byteLength", m_bytes}}};
    }

private:
    Json m_views = Json::array(), m_accessors = Json::array();
    std::size_t m_bytes = 0;
};

/// Adds the accessors of a part, and returns its mesh.
Json meshOf(const TriangleMesh& mesh, Layout& layout)
{
    Json attributes;
    const int positions = layout.add(mesh.points.size(), 12, floatType, "VEC3", vertexTarget);
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : mesh.points)
        box.extend(p);
    const auto corner = [](const Vec3f& p) { return Json{p.x(), p.y(), p.z()}; };
    layout.accessor(positions)["min"] = corner(box.min());
    layout.accessor(positions)["max"] = corner(box.max());
    attributes["POSITION"] = positions;
    attributes["NORMAL"] = layout.add(mesh.points.size(), 12, floatType, "VEC3", vertexTarget);
    if (!mesh.colors.empty()) {
        attributes["COLOR_0"] = layout.add(mesh.points.size(), 8, shortType, "VEC4", vertexTarget);
        layout.accessor(attributes["COLOR_0"])["normalized"] = true;
    }
    if (!mesh.masks.empty())
        attributes["_MASK"] = layout.add(mesh.points.size(), 4, floatType, "SCALAR", vertexTarget);
    const int indices = layout.add(3 * mesh.triangles.size(), 4, indexType, "SCALAR", indexTarget);
    return {{"primitives", {{{"attributes", attributes}, {"indices", indices}, {"material", 0}}}}};
}

Json documentOf(const FileParts& parts, Layout& layout)
{
    Json document;
    document["asset"] = {{"version", "2.0"}, {"generator", "Fettle"}};
    document["scene"] = 0;
    document["scenes"] = Json::array({Json{{"nodes", Json::array()}}});
    document["nodes"] = Json::array();
    document["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}}};
    document["meshes"] = Json::array();
    for (const FilePart& part : parts.all()) {
        const std::size_t index = document["nodes"].size();
        document["scenes"][0]["nodes"].push_back(index);
        Json node = {{"mesh", index}, {"scale", {0.001, 0.001, 0.001}}};
        if (!part.name.empty())
            node["name"] = part.name;
        document["nodes"].push_back(std::move(node));
        document["meshes"].push_back(meshOf(part.mesh, layout));
    }
    return document;
}

void writePoints(AtomicFile& out, const std::vector<Vec3f>& points)
{
    writeRecords(out, points.size(), 12, [&points](std::size_t i, char* into) {
        for (int k = 0; k < 3; ++k)
            store(into, points[i][k]);
    });
}
void writeBinary(AtomicFile& out, const TriangleMesh& mesh)
{
    writePoints(out, mesh.points);
    writePoints(out, normalsOf(mesh));
    writeRecords(out, mesh.colors.size(), 8, [&mesh, table = lights()](std::size_t i, char* into) {
        for (const std::uint8_t part : {mesh.colors[i].r, mesh.colors[i].g, mesh.colors[i].b})
            store(into, table[part]);
        store(into, std::uint16_t(65535));
    });
    writeRecords(out, mesh.masks.size(), 4,
                 [&mesh](std::size_t i, char* into) { store(into, static_cast<float>(mesh.masks[i]) / 255); });
    writeRecords(out, mesh.triangles.size(), 12, [&mesh](std::size_t i, char* into) {
        for (const Slot corner : mesh.triangles[i])
            store(into, static_cast<std::uint32_t>(corner));
    });
}
} // namespace

void writeGlb(AtomicFile& out, const TriangleMesh& mesh, const DocumentMetadata& metadata, const PartList& parts)
{
    const FileParts pieces(mesh, parts);
    Layout layout;
    Json document = documentOf(pieces, layout);
    addMetadata(document, metadata, parts);
    const std::size_t bytes = layout.bytes();
    layout.moveTo(document);
    std::string json = document.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    if (bytes > maxBytes)
        throw FileError(FileErrorKind::WriteFailed, out.path());
    std::string head;
    append(head, glbMagic);
    append(head, glbVersion);
    append(head, static_cast<std::uint32_t>(28 + json.size() + bytes));
    append(head, static_cast<std::uint32_t>(json.size()));
    append(head, glbJsonChunk);
    head += json;
    append(head, static_cast<std::uint32_t>(bytes));
    append(head, glbBinaryChunk);
    out.write(head);
    for (const FilePart& part : pieces.all())
        writeBinary(out, part.mesh);
}
} // namespace core::io
