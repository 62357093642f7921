// Sources: ISO/ASTM 52915:2016, Additive Manufacturing File Format 1.2. Scale, mirror, radians and metadata names that
// begin with slic3r: source code of Slic3r and PrusaSlicer.
#include "core/io/mesh/amf_document.h"

#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/object_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core::io
{
/// Kinds of elements. Those that contain one number are last, in the order of the members that store the numbers.
enum class AmfDocumentReader::Element : std::uint8_t {
    Outside,
    Other,
    Amf,
    Object,
    Constellation,
    Mesh,
    Vertices,
    Vertex,
    Coordinates,
    Volume,
    Triangle,
    Color,
    Material,
    Composite,
    Texture,
    Curve,
    Instance,
    Metadata,
    X,
    Y,
    Z,
    V1,
    V2,
    V3,
    Red,
    Green,
    Blue,
    MoveX,
    MoveY,
    MoveZ,
    RotateX,
    RotateY,
    RotateZ,
    ScaleX,
    ScaleY,
    ScaleZ,
    Scale
};

/// An element that is read inside of the given parent. Frequent elements are listed first, because the search is
/// linear.
struct AmfDocumentReader::Rule
{
    Element parent;
    std::string_view name;
    Element element;

    static const std::array<Rule, 48> all;
};

const std::array<AmfDocumentReader::Rule, 48> AmfDocumentReader::Rule::all{{
    {Element::Vertices, "vertex", Element::Vertex},
    {Element::Vertex, "coordinates", Element::Coordinates},
    {Element::Volume, "triangle", Element::Triangle},
    {Element::Coordinates, "x", Element::X},
    {Element::Coordinates, "y", Element::Y},
    {Element::Coordinates, "z", Element::Z},
    {Element::Triangle, "v1", Element::V1},
    {Element::Triangle, "v2", Element::V2},
    {Element::Triangle, "v3", Element::V3},
    {Element::Amf, "object", Element::Object},
    {Element::Amf, "constellation", Element::Constellation},
    {Element::Amf, "material", Element::Material},
    {Element::Amf, "texture", Element::Texture},
    {Element::Amf, "metadata", Element::Metadata},
    {Element::Object, "mesh", Element::Mesh},
    {Element::Object, "instance", Element::Instance},
    {Element::Object, "color", Element::Color},
    {Element::Object, "metadata", Element::Metadata},
    {Element::Constellation, "instance", Element::Instance},
    {Element::Constellation, "metadata", Element::Metadata},
    {Element::Mesh, "vertices", Element::Vertices},
    {Element::Mesh, "volume", Element::Volume},
    {Element::Vertices, "edge", Element::Curve},
    {Element::Vertex, "normal", Element::Curve},
    {Element::Vertex, "color", Element::Color},
    {Element::Volume, "color", Element::Color},
    {Element::Volume, "metadata", Element::Metadata},
    {Element::Triangle, "color", Element::Color},
    {Element::Triangle, "texmap", Element::Texture},
    {Element::Triangle, "map", Element::Texture},
    {Element::Material, "color", Element::Color},
    {Element::Material, "composite", Element::Composite},
    {Element::Color, "r", Element::Red},
    {Element::Color, "g", Element::Green},
    {Element::Color, "b", Element::Blue},
    {Element::Instance, "deltax", Element::MoveX},
    {Element::Instance, "deltay", Element::MoveY},
    {Element::Instance, "deltaz", Element::MoveZ},
    {Element::Instance, "rx", Element::RotateX},
    {Element::Instance, "ry", Element::RotateY},
    {Element::Instance, "rz", Element::RotateZ},
    {Element::Instance, "scalex", Element::ScaleX},
    {Element::Instance, "scaley", Element::ScaleY},
    {Element::Instance, "scalez", Element::ScaleZ},
    {Element::Instance, "mirrorx", Element::ScaleX},
    {Element::Instance, "mirrory", Element::ScaleY},
    {Element::Instance, "mirrorz", Element::ScaleZ},
    {Element::Instance, "scale", Element::Scale},
}};

namespace
{
constexpr std::size_t maxInstances = 1 << 16, maxNodes = 1 << 16, maxText = 4096;

double millimetresOf(std::string_view unit, const XmlAttributes& attributes)
{
    constexpr std::pair<std::string_view, double> units[] = {
        {"millimeter", 1}, {"inch", 25.4}, {"feet", 304.8},       {"foot", 304.8},   {"meter", 1000},
        {"micron", 0.001}, {"", 1},        {"micrometer", 0.001}, {"centimeter", 10}};
    std::string lower(unit);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const auto& [name, millimetres] : units)
        if (lower == name)
            return millimetres;
    attributes.refuse(FileFault::LengthUnit, unit);
}

std::string_view trimmed(std::string_view text)
{
    constexpr const char* blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::uint8_t byteOf(double share)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

/// Returns the three values. Throws FileError::Malformed with the name of the first missing value.
template <class Number>
std::array<Number, 3> required(const FileBytes& file, const std::array<std::optional<Number>, 3>& values,
                               const std::array<std::string_view, 3>& names)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (!values[i])
            throw malformed(FileFault::Missing, errorWithToken({}, file, names[i]));
    return {*values[0], *values[1], *values[2]};
}
} // namespace

AmfDocumentReader::AmfDocumentReader(const FileBytes& file)
    : m_file(file)
    , m_stopCheck(file.stop)
    , m_xml(
          file, [this](std::string_view name, const XmlAttributes& attributes) { begin(elementOf(name), attributes); },
          [this](std::string_view) { end(); },
          [this](std::string_view piece) {
              if (m_open.back() >= Element::Metadata && m_text.size() <= maxText)
                  m_text += piece.substr(0, maxText + 1 - m_text.size()); // longer texts cannot be numbers
          })
{}

AmfDocumentReader::Element AmfDocumentReader::elementOf(std::string_view name)
{
    if (m_open.empty()) {
        m_prefix = name.substr(0, name.rfind('|') + 1);
        if (name.substr(m_prefix.size()) != "amf")
            throw malformed(FileFault::Keyword, errorWithToken({}, m_file, name), "amf");
        return Element::Amf;
    }
    const std::string_view local = name.starts_with(m_prefix) ? name.substr(m_prefix.size()) : name;
    for (const Rule& rule : Rule::all)
        if (rule.parent == m_open.back() && rule.name == local)
            return rule.element;
    return Element::Other;
}

void AmfDocumentReader::begin(Element element, const XmlAttributes& attributes)
{
    m_stopCheck();
    m_open.push_back(element);
    m_text.clear();
    m_document.remarks.materials |= element == Element::Composite;
    m_document.remarks.textures |= element == Element::Texture;
    m_document.remarks.curves |= element == Element::Curve;
    if (element == Element::Amf)
        m_document.millimetres = millimetresOf(attributes.text("unit"), attributes);
    else if (element == Element::Object || element == Element::Constellation)
        beginNode(element == Element::Constellation, attributes);
    else if (element == Element::Instance)
        beginInstance(attributes);
    else if (element == Element::Mesh)
        m_firstVertex = m_document.nodes.back().mesh.points.size(), m_farthest = {};
    else if (element == Element::Vertex)
        m_point = {};
    else if (element == Element::Triangle)
        m_corners = {};
    else if (element == Element::Color)
        m_color = {};
    else if (element == Element::Volume)
        m_volume = {m_document.nodes.back().mesh.triangles.size(),
                    std::string(attributes.text("materialid")),
                    {},
                    attributes.text("type") == "support" ? Matter::Other : Matter::Model,
                    {}};
    else if (element == Element::Material)
        m_material = attributes.text("id");
    else if (element == Element::Metadata)
        m_key = attributes.text("type");
}

void AmfDocumentReader::beginNode(bool isConstellation, const XmlAttributes& attributes)
{
    const std::string id(attributes.text("id"));
    if (!id.empty() && !(isConstellation ? m_constellationIds : m_objectIds).insert(id).second)
        attributes.refuse(FileFault::Repeated, "id"); // another of its kind has this id
    if (m_document.nodes.size() == maxNodes)
        throw tooMany("objects", maxNodes, errorWithToken({}, m_file, {}));
    AmfNode& node = m_document.nodes.emplace_back();
    node.id = id;
    node.isConstellation = isConstellation;
}

void AmfDocumentReader::beginInstance(const XmlAttributes& attributes)
{
    AmfInstance instance{.object = std::string(attributes.text("objectid")), .line = m_xml.line()};
    if (instance.object.empty())
        attributes.refuse(FileFault::Missing, "objectid");
    if (++m_instances > maxInstances)
        throw tooMany("instances", maxInstances, errorWithToken({}, m_file, {}));
    m_document.nodes.back().instances.push_back(std::move(instance));
}

void AmfDocumentReader::end()
{
    const Element element = m_open.back();
    if (element == Element::Vertex)
        addVertex();
    else if (element == Element::Triangle)
        addTriangle();
    else if (element == Element::Volume)
        endVolume();
    else if (element == Element::Mesh)
        endMesh();
    else if (element == Element::Color)
        takeColor();
    else if (element == Element::Metadata)
        takeMetadata();
    else if (element > Element::Metadata)
        takeNumber(element);
    m_open.pop_back();
    m_text.clear();
}

void AmfDocumentReader::takeNumber(Element element)
{
    const std::string_view word = m_text.size() > maxText ? std::string_view() : trimmed(m_text);
    const auto require = [&](auto value) {
        if (!value)
            throw errorWithToken(FileErrorKind::NotANumber, m_file, trimmed(m_text));
        return *value;
    };
    const auto indexFrom = [element](Element first) {
        return static_cast<std::size_t>(element) - static_cast<std::size_t>(first);
    };
    if (element <= Element::Z) {
        m_point[indexFrom(Element::X)] = require(parseFloat(word));
    } else if (element <= Element::V3) {
        const std::int64_t corner = require(parseInteger(word));
        const bool fits = corner >= 0 && corner <= std::numeric_limits<std::uint32_t>::max();
        m_corners[indexFrom(Element::V1)] =
            require(fits ? std::optional(static_cast<std::uint32_t>(corner)) : std::nullopt);
    } else if (element <= Element::Blue) {
        m_color[indexFrom(Element::Red)] = parseDouble(word);
        // A colour may be a formula of the position: reported, not read.
        m_document.remarks.materials |= !parseDouble(word);
    } else {
        AmfInstance& instance = m_document.nodes.back().instances.back();
        const double value = require(parseDouble(word));
        const auto axis = static_cast<Eigen::Index>(indexFrom(Element::MoveX) % 3);
        if (element <= Element::MoveZ)
            instance.move[axis] = value;
        else if (element <= Element::RotateZ)
            instance.rotation[axis] = value;
        else if (element <= Element::ScaleZ)
            instance.scale[axis] *= value;
        else
            instance.scale *= value;
    }
}

void AmfDocumentReader::takeColor()
{
    if (!m_color[0] || !m_color[1] || !m_color[2])
        return;
    const Rgb color{byteOf(*m_color[0]), byteOf(*m_color[1]), byteOf(*m_color[2])};
    const Element owner = m_open[m_open.size() - 2];
    if (owner == Element::Material) {
        m_document.materials.insert_or_assign(m_material, color);
        return;
    }
    AmfNode& node = m_document.nodes.back();
    if (owner == Element::Vertex)
        node.colors.setVertex(node.mesh.points.size(), color);
    else if (owner == Element::Triangle)
        node.colors.setTriangle(node.mesh.triangles.size(), color);
    else if (owner == Element::Volume)
        m_volume.color = color;
    else
        node.colors.setObject(color);
}

/// Reads the names of objects, and metadata of slicers: whether a slicer wrote the file (then angles are in radians),
/// and whether a volume is solid.
void AmfDocumentReader::takeMetadata()
{
    const std::string_view value = trimmed(m_text);
    const Element owner = m_open[m_open.size() - 2];
    if (owner == Element::Object || owner == Element::Constellation) {
        if (m_key == "name" || m_key == "Name") // the standard's word has a capital letter
            m_document.nodes.back().name = cleanName(value);
        return;
    }
    if (owner == Element::Volume) {
        if (m_key == "name" || m_key == "Name")
            m_volume.name = value;
        else if (m_key == "slic3r.modifier" && value == "1")
            m_volume.matter = Matter::Other;
        else if (m_key == "slic3r.volume_type")
            m_volume.matter = value == "ModelPart"        ? Matter::Model
                              : value == "NegativeVolume" ? Matter::Negative
                                                          : Matter::Other;
        return;
    }
    const bool isOfSlicer =
        value.starts_with("Slic3r") || value.starts_with("PrusaSlicer") || value.starts_with("SuperSlicer");
    m_document.isInRadians |= m_key == "slic3rpe_amf_version" || (m_key == "cad" && isOfSlicer);
}

void AmfDocumentReader::addVertex()
{
    const auto [x, y, z] = required(m_file, m_point, {"x", "y", "z"});
    m_document.nodes.back().mesh.points.emplace_back(x, y, z);
}

void AmfDocumentReader::addTriangle()
{
    const auto corners = required(m_file, m_corners, {"v1", "v2", "v3"});
    if (const std::uint32_t corner = *std::max_element(corners.begin(), corners.end());
        corner > m_farthest.corner || m_farthest.line == 0)
        m_farthest = {corner, m_xml.line()};
    const auto first = static_cast<Slot>(m_firstVertex);
    m_document.nodes.back().mesh.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
}

void AmfDocumentReader::endVolume()
{
    AmfNode& node = m_document.nodes.back();
    if (m_volume.matter == Matter::Model) {
        node.colors.addVolume(node.mesh.triangles.size(), m_volume.color, m_volume.material);
        return;
    }
    leaveOutPart(m_document.remarks, m_volume.matter == Matter::Negative, m_volume.name);
    node.isWhole = false;
    node.mesh.triangles.resize(m_volume.firstTriangle);
    node.colors.removeTriangles(m_volume.firstTriangle);
}

/// Checks the vertex indices of the triangles. This needs all vertices, which may follow the triangles.
void AmfDocumentReader::endMesh()
{
    const std::size_t vertices = m_document.nodes.back().mesh.points.size() - m_firstVertex;
    if (m_farthest.line == 0 || m_farthest.corner < vertices)
        return;
    FileError error = errorWithToken(FileErrorKind::IndexOutOfRange, m_file, std::to_string(m_farthest.corner));
    error.place = {FilePlace::Unit::Line, m_farthest.line};
    throw withCounts(error, vertices);
}
} // namespace core::io
