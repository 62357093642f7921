// Places the objects of an AMF. An object or constellation that another one refers to is placed only by those
// references; all others are placed once, untransformed. Slicers write a constellation of all objects. Each instance of
// a constellation that no other refers to is therefore an object of the file.
#include "core/io/mesh/amf_document.h"
#include "core/io/mesh/mesh_assembly.h"
#include "core/io/mesh/zip_reader.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core::io
{
namespace
{
constexpr int maxDepth = 64;
constexpr std::size_t maxCopies = 1 << 16, pieceSize = 1 << 16;

/// Returns the first bytes of a zip entry; empty if it cannot be unpacked.
std::string startOf(const std::string& entry, ZipReader& package)
{
    struct Enough
    {};
    std::string start;
    try {
        package.read(entry, [&start](std::string_view piece) {
            start = piece.substr(0, startSize);
            throw Enough();
        });
    } catch (const Enough&) {
    } catch (const FileError&) {
        return {};
    }
    return start;
}

bool isXml(std::string_view start)
{
    const bool isUtf16 = start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff");
    const std::string_view text = withoutMark(start);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return isUtf16 || (first != std::string_view::npos && text[first] == '<');
}

bool isNamedAmf(std::string_view name)
{
    constexpr std::string_view ending = ".amf";
    return name.size() >= ending.size() &&
           std::equal(ending.begin(), ending.end(), name.end() - ending.size(),
                      [](char wanted, char c) { return wanted == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
}

/// Returns the zip entries that are AMF: XML with the extension .amf, or, if there is none, XML whose first bytes
/// contain "amf". Ignores macOS metadata folders, and all entries after the first hundred.
std::vector<std::string> modelsIn(const FileBytes& file, ZipReader& package)
{
    constexpr std::size_t maxEntries = 100;
    std::vector<std::string> names = package.names();
    names.erase(std::remove_if(names.begin(), names.end(),
                               [](const std::string& name) { return name.starts_with("__MACOSX/"); }),
                names.end());
    std::stable_partition(names.begin(), names.end(), isNamedAmf);
    names.resize(std::min(names.size(), maxEntries));
    std::vector<std::string> models, others;
    for (const std::string& name : names) {
        const std::string start = startOf(name, package);
        if (isNamedAmf(name) && isXml(start))
            models.push_back(name);
        else if (isXml(start) && start.find("amf") != std::string::npos)
            others.push_back(name);
    }
    for (const auto& found : {models, others})
        if (!found.empty())
            return found;
    const auto named = std::find_if(names.begin(), names.end(), isNamedAmf);
    if (named == names.end())
        throw malformed(FileFault::NotInPackage, errorWithToken({}, file, "*.amf"));
    return {*named}; // reading it will report what is wrong
}

AmfDocument documentIn(const FileBytes& file)
{
    AmfDocumentReader reader(file);
    if (!file.bytes.starts_with("PK")) {
        std::string_view rest = withoutPadding(file.bytes);
        for (; !rest.empty(); rest.remove_prefix(std::min(pieceSize, rest.size())))
            reader.take(rest.substr(0, pieceSize));
        reader.take({});
        return reader.document();
    }
    ZipReader package(file);
    const std::vector<std::string> models = modelsIn(file, package);
    package.read(models.front(), [&reader](std::string_view piece) { reader.take(piece); });
    AmfDocument document = reader.document();
    document.remarks.otherModels = models.size() - 1;
    return document;
}

/// Returns sine and cosine, exact for multiples of 90 degrees.
Eigen::Vector2d sineAndCosine(double degrees)
{
    const double turn = std::remainder(degrees, 360.0);
    if (std::remainder(turn, 90.0) == 0)
        return {turn == 90 ? 1 : turn == -90 ? -1 : 0, turn == 0 ? 1 : std::abs(turn) == 180 ? -1 : 0};
    const double angle = turn * std::numbers::pi / 180;
    return {std::sin(angle), std::cos(angle)};
}

/// Returns the rotation about x, then y, then z; all three axes are fixed.
Eigen::Matrix3d rotationOf(const Eigen::Vector3d& degrees)
{
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Eigen::Index from = (axis + 1) % 3, to = (axis + 2) % 3;
        const Eigen::Vector2d turn = sineAndCosine(degrees[axis]);
        Eigen::Matrix3d own = Eigen::Matrix3d::Identity();
        own(from, from) = own(to, to) = turn[1];
        own(to, from) = turn[0];
        own(from, to) = -turn[0];
        rotation = own * rotation;
    }
    return rotation;
}

class AmfReader
{
public:
    explicit AmfReader(const FileBytes& file)
        : m_file(file)
        , m_document(documentIn(file))
        , m_stopCheck(file.stop)
        , m_assembly(file)
    {}

    ReadResult read()
    {
        std::map<std::string_view, std::size_t> ids;
        for (const bool areConstellations : {false, true})
            for (std::size_t i = 0; i < m_document.nodes.size(); ++i)
                if (m_document.nodes[i].isConstellation == areConstellations)
                    ids.emplace(m_document.nodes[i].id, i);
        std::vector<bool> isNamed(m_document.nodes.size(), false);
        m_named.resize(m_document.nodes.size());
        for (std::size_t i = 0; i < m_document.nodes.size(); ++i) {
            AmfNode& node = m_document.nodes[i];
            node.mesh.colors = node.colors.of(node.mesh, m_document.materials);
            if (!node.isWhole)
                removeUnusedVertices(node.mesh); // unused vertices would distort the model's size
            for (const AmfInstance& instance : node.instances) {
                const auto found = ids.find(instance.object);
                if (found == ids.end())
                    throw at(instance,
                             malformed(FileFault::Missing, errorWithToken({}, m_file, "objectid " + instance.object)));
                m_named[i].push_back(found->second);
                isNamed[found->second] = true;
            }
        }
        m_progress.resize(m_document.nodes.size(), Progress::New);
        for (std::size_t i = 0; i < m_document.nodes.size(); ++i)
            refuseCycles(i, 0);
        const double unit = m_document.millimetres;
        for (std::size_t i = 0; i < m_document.nodes.size(); ++i)
            if (!isNamed[i])
                add(i, Eigen::Vector4d(unit, unit, unit, 1).asDiagonal(), 0);
        m_document.remarks.objects = std::max<std::size_t>(m_document.remarks.objects, 1);
        TriangleMesh mesh = m_assembly.take();
        return {std::move(mesh), m_document.remarks, m_assembly.parts()};
    }

private:
    enum class Progress : std::uint8_t { New, Begun, Done };

    FileError at(const AmfInstance& instance, FileError error) const
    {
        error.place = {FilePlace::Unit::Line, instance.line};
        return error;
    }

    void refuseCycles(std::size_t node, int depth)
    {
        if (m_progress[node] == Progress::Done)
            return;
        m_progress[node] = Progress::Begun;
        for (std::size_t i = 0; i < m_named[node].size(); ++i) {
            const std::size_t inner = m_named[node][i];
            if (m_progress[inner] == Progress::Begun || depth == maxDepth)
                throw at(m_document.nodes[node].instances[i],
                         malformed(FileFault::TooDeep, errorWithToken({}, m_file, "constellations")));
            refuseCycles(inner, depth + 1);
        }
        m_progress[node] = Progress::Done;
    }

    void beginObject(std::string_view name)
    {
        m_assembly.beginObject(name);
        m_hasFaces = false;
    }

    void add(std::size_t index, const Eigen::Matrix4d& transform, int depth)
    {
        m_stopCheck();
        const AmfNode& node = m_document.nodes[index];
        if (++m_copies > maxCopies)
            throw tooMany("instances", maxCopies, errorWithToken({}, m_file, {}));
        if (depth <= 1)
            beginObject(node.name);
        m_assembly.add(node.mesh, transform);
        m_document.remarks.objects += !m_hasFaces && !node.mesh.triangles.empty() ? 1 : 0;
        m_hasFaces = m_hasFaces || !node.mesh.triangles.empty();
        for (std::size_t i = 0; i < node.instances.size(); ++i) {
            if (depth == maxDepth)
                throw at(node.instances[i],
                         malformed(FileFault::TooDeep, errorWithToken({}, m_file, "constellations")));
            add(m_named[index][i], transform * transformOf(node.instances[i]), depth + 1);
        }
    }

    Eigen::Matrix4d transformOf(const AmfInstance& instance) const
    {
        const double degrees = m_document.isInRadians ? 180 / std::numbers::pi : 1;
        Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
        transform.topLeftCorner<3, 3>() = rotationOf(degrees * instance.rotation) * instance.scale.asDiagonal();
        transform.topRightCorner<3, 1>() = instance.move;
        return transform;
    }

    const FileBytes& m_file;
    AmfDocument m_document;
    StopCheck m_stopCheck;
    MeshAssembly m_assembly;
    /// Nodes that the instances of each node refer to, in the order of the instances.
    std::vector<std::vector<std::size_t>> m_named;
    std::vector<Progress> m_progress; ///< state of each node in the search for cycles
    std::size_t m_copies = 0;
    bool m_hasFaces = false; ///< whether the present object has faces
};
} // namespace

ReadResult readAmf(const FileBytes& file)
{
    return AmfReader(file).read();
}
} // namespace core::io
