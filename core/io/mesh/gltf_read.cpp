// Reads glTF: the triangles of each primitive, transformed by its nodes and converted from metres to mm.

#include "core/io/mesh/glb_metadata.h"
#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/gltf_draco.h"
#include "core/io/mesh/gltf_primitive.h"
#include "core/io/mesh/gltf_scene.h"
#include "core/io/mesh/gltf_skin.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/srgb.h"
#include "core/util/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace core::io
{
namespace
{
using Json = GltfDocument::Json;

/// Largest numbers of vertices and triangles for each byte of the file, since a scene may use a mesh many times.
/// `alwaysTaken` vertices and twice as many triangles are always allowed.
constexpr std::size_t maxCopies = 16, maxFaceCopies = 32, alwaysTaken = std::size_t(1) << 20;
constexpr double millimetres = 1000;
constexpr std::size_t chunkSize = 1 << 15;

class GltfReader
{
public:
    GltfReader(const FileBytes& file, bool isBinary)
        : m_file(file)
        , m_gltf(file, isBinary)
        , m_stopCheck(file.stop)
        , m_parts(isBinary ? partsIn(m_gltf.document()) : std::nullopt)
        , m_labels(file.keepsObjects || m_parts)
    {}

    ReadResult read()
    {
        const auto add = [&](std::size_t mesh, const GltfPlace& place) { addMesh(mesh, place); };
        const Eigen::Matrix4d root = Eigen::Vector4d(millimetres, millimetres, millimetres, 1).asDiagonal();
        GltfScene scene(m_file, m_gltf, m_stopCheck);
        scene.forEachMesh(root, add);
        m_hidden = scene.hiddenObjects();
        if (m_hasColors)
            m_mesh.colors.resize(m_mesh.points.size(), Rgb());
        if (m_hasMasks)
            m_mesh.masks.resize(m_mesh.points.size());
        PartList parts;
        if (m_parts && m_labels.finishAs(*m_parts, m_mesh))
            parts = *m_parts;
        else if (m_file.keepsObjects)
            parts = m_labels.finish(m_mesh);
        else
            m_mesh.parts.clear();
        return {std::move(m_mesh), remarks(), std::move(parts)};
    }

private:
    ReadRemarks remarks() const
    {
        const Json& document = m_gltf.document();
        return {.objects = std::max<std::size_t>(m_objects, 1),
                .textures = !m_gltf.arrayIn(document, "textures").empty(),
                .poses = m_hasTargets || !m_gltf.arrayIn(document, "skins").empty(),
                .hiddenObjects = m_hidden};
    }

    void addMesh(std::size_t index, const GltfPlace& place)
    {
        ++m_objects;
        m_labels.begin(place.name);
        for (const Json& primitive : m_gltf.arrayIn(m_gltf.element("meshes", index), "primitives"))
            addPrimitive(primitive, place);
    }

    void addPrimitive(const Json& json, const GltfPlace& place)
    {
        const GltfPrimitive primitive(m_file, m_gltf, m_draco, json);
        m_hasTargets = m_hasTargets || json.contains("targets");
        if (!primitive.hasTriangles())
            return; // points or lines
        const auto first = static_cast<Slot>(m_mesh.points.size());
        const LargeBuffer<float> numbers = primitive.numbersOf("POSITION", 3, 3).values;
        const std::size_t count = numbers.size() / 3;
        if (const std::size_t max = std::min(maxVertices, std::max(alwaysTaken, maxCopies * m_gltf.bytes()));
            m_mesh.points.size() + count > max)
            throw tooMany("vertices", max, errorAtByte({}, m_file, m_file.bytes.data()));
        const GltfSkinning skinning(m_file, m_gltf, primitive, place.joints, count);
        addPoints(numbers, place.transform, skinning);
        m_labels.label(m_mesh);
        if (primitive.has("COLOR_0"))
            addColors(first, count, primitive);
        if (primitive.has("_MASK"))
            addMasks(first, count, primitive);
        const LargeBuffer<std::uint32_t> corners = primitive.cornersOf(count);
        const bool isAllMirrored = place.transform.topLeftCorner<3, 3>().determinant() < 0;
        const auto isMirrored = [&](std::size_t a, std::size_t b, std::size_t c) {
            return skinning.isBound() ? skinning.isMirrored(corners[a], corners[b], corners[c]) : isAllMirrored;
        };
        addTriangles(corners, primitive.mode(), first, isMirrored);
    }

    void addPoints(const LargeBuffer<float>& numbers, const Eigen::Matrix4d& transform, const GltfSkinning& skinning)
    {
        const bool isPlain = !skinning.isBound() && transform == Eigen::Matrix4d::Identity();
        const std::size_t first = m_mesh.points.size(), count = numbers.size() / 3;
        resizeInLargePages(m_mesh.points, first + count);
        forEachChunk(count, chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Vec3f& point = m_mesh.points[first + i];
                point = Vec3f(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
                if (!isPlain)
                    point = ((skinning.isBound() ? skinning.transformOf(i) : transform) *
                             point.cast<double>().homogeneous())
                                .head<3>()
                                .cast<float>();
                if (!point.allFinite())
                    throw errorWithToken(FileErrorKind::NotANumber, m_file, {});
            }
        });
    }

    /// Adds vertex colours, which are linear, with or without alpha.
    void addColors(Slot first, std::size_t count, const GltfPrimitive& primitive)
    {
        const GltfPrimitive::Numbers numbers = primitive.numbersOf("COLOR_0", 3, 4);
        const float* const values = numbers.values.data();
        const std::size_t size = numbers.components;
        if (numbers.values.size() != count * size)
            m_gltf.refuse(FileFault::WrongAccessor, "COLOR_0");
        m_hasColors = true;
        m_mesh.colors.resize(first + count, Rgb());
        forEachChunk(count, chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const float* const color = values + i * size;
                const auto seen = [color](std::size_t k) { return srgbFromLinear(static_cast<double>(color[k])); };
                m_mesh.colors[first + i] = {seen(0), seen(1), seen(2)};
            }
        });
    }

    /// Adds masks in the form that writeGlb() writes.
    void addMasks(Slot first, std::size_t count, const GltfPrimitive& primitive)
    {
        const LargeBuffer<float> numbers = primitive.numbersOf("_MASK", 1, 1).values;
        if (numbers.size() != count)
            m_gltf.refuse(FileFault::WrongAccessor, "_MASK");
        m_hasMasks = true;
        m_mesh.masks.resize(first + count);
        for (std::size_t i = 0; i < count; ++i)
            m_mesh.masks[first + i] =
                static_cast<std::uint8_t>(numbers[i] > 0 ? std::min(numbers[i], 1.0f) * 255 + 0.5f : 0);
    }

    /// Adds triangles. isMirrored(a, b, c) is called with the positions of a triangle's corners in `corners`; mirrored
    /// triangles are reversed.
    template <class IsMirrored>
    void addTriangles(const LargeBuffer<std::uint32_t>& corners, std::size_t mode, Slot first,
                      const IsMirrored& isMirrored)
    {
        const std::size_t before = m_mesh.triangles.size(), count = mode == GltfTriangles
                                                                        ? corners.size() / 3
                                                                        : std::max<std::size_t>(corners.size(), 2) - 2;
        if (const std::size_t max = std::min(maxFaces, std::max(2 * alwaysTaken, maxFaceCopies * m_gltf.bytes()));
            before + count > max)
            throw tooMany("faces", max, errorAtByte({}, m_file, m_file.bytes.data()));
        resizeInLargePages(m_mesh.triangles, before + count);
        const auto add = [&](std::size_t at, std::size_t a, std::size_t b, std::size_t c) {
            if (isMirrored(a, b, c))
                std::swap(b, c);
            m_mesh.triangles[before + at] = {first + corners[a], first + corners[b], first + corners[c]};
        };
        forEachChunk(count, chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                switch (mode) {
                case GltfTriangles:
                    add(i, 3 * i, 3 * i + 1, 3 * i + 2);
                    break;
                case GltfTriangleStrip:
                    add(i, i, i + 1 + i % 2, i + 2 - i % 2);
                    break;
                case GltfTriangleFan:
                    add(i, 0, i + 1, i + 2);
                    break;
                }
        });
        if (mode == GltfTriangles)
            return;
        const auto isSeam = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
        const auto begin = m_mesh.triangles.begin() + static_cast<std::ptrdiff_t>(before);
        // Strips are connected by degenerate triangles, which are removed here.
        m_mesh.triangles.erase(std::remove_if(begin, m_mesh.triangles.end(), isSeam),
                               m_mesh.triangles.end()); // Clang 14, which the fuzzers need, knows no ranges::remove_if
    }

    const FileBytes& m_file;
    GltfDocument m_gltf;
    GltfDraco m_draco{m_gltf};
    StopCheck m_stopCheck;
    std::optional<PartList> m_parts; ///< the list of a Fettle document of several parts
    ObjectLabels m_labels;
    TriangleMesh m_mesh;
    bool m_hasColors = false, m_hasMasks = false, m_hasTargets = false;
    std::size_t m_objects = 0, m_hidden = 0;
};
} // namespace

ReadResult readGltf(const FileBytes& file, bool isBinary)
{
    return GltfReader(file, isBinary).read();
}
} // namespace core::io
