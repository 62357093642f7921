// 3MF: the package names its model part. The build items of that part place objects; objects may consist of components,
// which are objects, too. Other parts are read when a component refers to them.
#include "core/io/mesh/mesh_assembly.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/threemf_part.h"
#include "core/io/mesh/threemf_slicer_parts.h"
#include "core/io/mesh/zip_reader.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace core::io
{
namespace
{
constexpr int maxDepth = 64;
constexpr std::size_t maxInstances = 1 << 16, maxParts = 1 << 12;

/// Returns the path of the model part; empty if the package names none.
std::string modelPathOf(const FileBytes& file, ZipReader& package)
{
    constexpr std::string_view modelType = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
    std::string path;
    XmlReader xml(
        file,
        [&](std::string_view name, const XmlAttributes& attributes) {
            if (name.ends_with("|Relationship") && attributes.text("Type") == modelType &&
                attributes.text("TargetMode") != "External")
                path = threeMfPath(file, attributes.text("Target"));
        },
        [](std::string_view) {});
    constexpr const char* relationships = "_rels/.rels";
    package.read(package.find(relationships).value_or(relationships),
                 [&xml](std::string_view piece) { xml.take(piece); });
    return path;
}

/// Returns whether the transform reduces every object to a point or a line.
bool isPoint(const Eigen::Matrix4d& transform)
{
    const Eigen::Matrix3d m = transform.topLeftCorner<3, 3>();
    return m.col(0).cross(m.col(1)).isZero(0) && m.col(1).cross(m.col(2)).isZero(0) &&
           m.col(2).cross(m.col(0)).isZero(0);
}

class ThreeMfReader
{
public:
    explicit ThreeMfReader(const FileBytes& file)
        : m_file(file)
        , m_package(file)
        , m_stopCheck(file.stop)
        , m_assembly(file)
    {}

    ReadResult read()
    {
        const std::string path = modelPathOf(m_file, m_package);
        if (path.empty())
            throw malformed(FileFault::NoModelPart, errorWithToken({}, m_file, "_rels/.rels"));
        const ThreeMfPart& root = part(path);
        m_slicerParts = ThreeMfSlicerParts::in(m_file, m_package);
        auto& objects = m_parts[path].objects;
        for (const auto& [id, parts] : m_slicerParts.triangles) {
            const auto object = objects.find(id);
            if (object == objects.end())
                continue;
            leaveOut(parts, object->second.mesh.triangles);
            removeUnusedVertices(object->second.mesh); // unused vertices would distort the model's size
        }
        const Eigen::Matrix4d unit =
            Eigen::Vector4d(root.millimetres, root.millimetres, root.millimetres, 1).asDiagonal();
        for (const ThreeMfComponent& item : root.build) {
            m_assembly.beginObject(nameOf(path, item));
            add(path, item, {unit, 0, item.object});
        }
        m_remarks.objects = std::max<std::size_t>(m_remarks.objects, 1);
        for (const auto& [name, part] : m_parts)
            for (const auto& [id, object] : part.objects)
                m_remarks.hiddenObjects +=
                    object.isSolid && !object.mesh.triangles.empty() && !m_built.contains({name, id}) ? 1 : 0;
        core::TriangleMesh mesh = m_assembly.take();
        if (root.build.empty() && !objects.empty())
            throw malformed(FileFault::Missing, errorWithToken({}, m_file, "build item"));
        if (mesh.triangles.empty() && m_remarks.beams > 0)
            throw malformed(FileFault::NeedsExtension, errorWithToken({}, m_file, "beamlattice"));
        if (mesh.triangles.empty() && !m_otherShape.empty())
            throw malformed(FileFault::NeedsExtension, errorWithToken({}, m_file, m_otherShape));
        if (m_hasPoint && !m_hasExtent)
            throw malformed(FileFault::None, errorWithToken({}, m_file, "transform"));
        return {std::move(mesh), m_remarks, m_assembly.parts()};
    }

private:
    const ThreeMfPart& part(const std::string& path)
    {
        const auto [found, isNew] = m_parts.try_emplace(path);
        if (isNew) {
            if (m_parts.size() > maxParts)
                throw tooMany("parts", maxParts, errorWithToken({}, m_file, {}));
            found->second = readPart(path);
            m_remarks.textures = m_remarks.textures || found->second.hasTextures;
            m_remarks.beams += found->second.beams;
        }
        return found->second;
    }

    /// Reads a part. Throws FileError. An error with a line also names the part, unless it is the first part.
    ThreeMfPart readPart(const std::string& path)
    {
        ThreeMfPartReader reader(m_file);
        try {
            m_package.read(m_package.find(path).value_or(path),
                           [&reader](std::string_view piece) { reader.take(piece); });
        } catch (FileError& error) {
            if (m_parts.size() > 1 && error.place.unit == FilePlace::Unit::Line)
                error.path /= path;
            throw;
        }
        return reader.part();
    }

    /// Returns the name of the object that an item of the build places; empty if it has none.
    std::string nameOf(const std::string& root, const ThreeMfComponent& item)
    {
        const auto& objects = part(item.part.empty() ? root : item.part).objects;
        const auto object = objects.find(item.object);
        return object == objects.end() ? std::string() : object->second.name;
    }

    /// The placement of a component in the build.
    struct Place
    {
        Eigen::Matrix4d above;   ///< transform of the object that contains the component
        int depth = 0;           ///< 0: the component is itself a build item
        std::uint32_t built = 0; ///< id of the object that the build item refers to
    };

    void add(const std::string& from, const ThreeMfComponent& component, const Place& place)
    {
        m_stopCheck();
        if (place.depth > maxDepth)
            throw malformed(FileFault::TooDeep, errorWithToken({}, m_file, "components"));
        if (++m_instances > maxInstances)
            throw tooMany("components", maxInstances, errorWithToken({}, m_file, {}));
        const std::string& path = component.part.empty() ? from : component.part;
        const double ofOther = part(path).millimetres / part(from).millimetres;
        const auto& objects = part(path).objects;
        const auto object = objects.find(component.object);
        if (object == objects.end())
            throw malformed(FileFault::Missing,
                            errorWithToken({}, m_file, "objectid " + std::to_string(component.object)));
        m_built.emplace(path, component.object);
        const auto slicers = m_slicerParts.objects.find({place.built, component.object});
        const bool isSlicers = place.depth > 0 && slicers != m_slicerParts.objects.end();
        if (isSlicers || !object->second.isSolid) {
            const bool isNamed = isSlicers && !slicers->second.name.empty();
            leaveOutPart(m_remarks, isSlicers && slicers->second.isNegative,
                         isNamed ? slicers->second.name : object->second.name);
            return;
        }
        if (!object->second.otherShape.empty()) {
            ++m_remarks.unreadNodes;
            m_otherShape = object->second.otherShape;
        }
        const Eigen::Matrix4d transform =
            place.above * component.transform * Eigen::Vector4d(ofOther, ofOther, ofOther, 1).asDiagonal();
        m_assembly.add(object->second.mesh, transform);
        if (!object->second.mesh.triangles.empty())
            (isPoint(transform) ? m_hasPoint : m_hasExtent) = true;
        m_remarks.objects += object->second.mesh.triangles.empty() ? 0 : 1;
        for (const ThreeMfComponent& inner : object->second.components)
            add(path, inner, {transform, place.depth + 1, place.built});
    }

    /// Removes the triangles of parts that are not solid.
    void leaveOut(const std::vector<ThreeMfSlicerParts::Triangles>& parts, std::vector<Triangle>& triangles)
    {
        std::vector<int> changes(triangles.size() + 1,
                                 0); // at each triangle: change in the number of parts that contain it
        for (const ThreeMfSlicerParts::Triangles& part : parts) {
            m_stopCheck();
            if (part.first > part.last || part.first >= triangles.size())
                continue;
            ++changes[part.first];
            --changes[std::min(part.last, triangles.size() - 1) + 1];
            leaveOutPart(m_remarks, part.part.isNegative, part.part.name);
        }
        std::vector<Triangle> left;
        int owners = 0;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            owners += changes[i];
            if (owners == 0)
                left.push_back(triangles[i]);
        }
        triangles = std::move(left);
    }

    const FileBytes& m_file;
    ZipReader m_package;
    StopCheck m_stopCheck;
    std::map<std::string, ThreeMfPart> m_parts;
    ThreeMfSlicerParts m_slicerParts;
    std::set<std::pair<std::string, std::uint32_t>> m_built; ///< parts and ids of the objects that the build places
    MeshAssembly m_assembly;
    std::string m_otherShape; ///< extension of a shape that was left out
    std::size_t m_instances = 0;
    /// Some object is a point or a line after its transform; some other object is not.
    bool m_hasPoint = false, m_hasExtent = false;
    ReadRemarks m_remarks{.objects = 0};
};
} // namespace

ReadResult readThreeMf(const FileBytes& file)
{
    return ThreeMfReader(file).read();
}
} // namespace core::io
