// Sources: 3MF Consortium, Core Specification 1.3; Materials and Properties Extension 1.2 (colour groups); Production
// Extension 1.1 (paths); Beam Lattice Extension 1.2. As the specification requires, an object must be defined
// before it is referenced.
#include "core/io/mesh/threemf_part.h"

#include "core/io/mesh/mean_color.h"
#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/palette.h"

#include <algorithm>
#include <array>

namespace core::io
{
namespace
{
// firstCoreSpace was used before version 1.0 of the core specification.
constexpr std::string_view coreSpace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|",
                           firstCoreSpace = "http://schemas.microsoft.com/3dmanufacturing/2013/01|",
                           materialSpace = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02|",
                           productionSpace = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|",
                           pathAttribute = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path",
                           beamName = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02|beam";

/// Namespaces that a file may require: the supported ones, and those that do not change the shape. Slices accompany a
/// mesh, triangle sets name parts of it, and slicers' own say how it is painted and printed.
constexpr std::string_view knownSpaces[] = {coreSpace,
                                            firstCoreSpace,
                                            materialSpace,
                                            productionSpace,
                                            "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|",
                                            "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07|",
                                            "http://schemas.slic3r.org/3mf/2017/06|",
                                            "http://schemas.bambulab.com/package/2021|"};

/// Elements of extensions that replace an object's mesh by another shape.
constexpr std::string_view otherShapes[] = {
    "http://schemas.3mf.io/3dmanufacturing/booleanoperations/2023/07|booleanshape",
    "http://schemas.microsoft.com/3dmanufacturing/displacement/2022/07|"
    "displacementmesh",
    "http://schemas.3mf.io/3dmanufacturing/displacement/2023/10|displacementmesh",
    "http://schemas.3mf.io/3dmanufacturing/volumetric/2022/01|levelset"};

/// Settings of Cura for objects that are no material.
constexpr std::string_view curaSpace = "http://software.ultimaker.com/xml/cura/3mf/2015/10|",
                           otherUses[] = {"support_mesh", "anti_overhang_mesh", "infill_mesh", "cutting_mesh"};

/// Returns an extension's name for users: its namespace without the common beginning.
std::string_view extensionName(std::string_view space)
{
    for (const std::string_view common :
         {"http://schemas.microsoft.com/3dmanufacturing/", "http://schemas.3mf.io/3dmanufacturing/", "http://"})
        if (space.starts_with(common))
            space.remove_prefix(common.size());
    return space;
}

/// Throws NeedsExtension with the name of the extension if the model requires one that is not supported.
void requireKnownExtensions(const XmlAttributes& attributes)
{
    std::string_view rest = attributes.text("requiredextensions");
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n,"), rest.size()));
        if (rest.empty())
            return;
        const std::string_view prefix = rest.substr(0, rest.find_first_of(" \t\r\n,"));
        rest.remove_prefix(prefix.size());
        std::string_view space = attributes.spaceOf(prefix);
        if (space.empty())
            space = prefix; // some files contain the namespace instead of its prefix
        const bool isKnown =
            std::any_of(std::begin(knownSpaces), std::end(knownSpaces),
                        [space](std::string_view known) { return space == known.substr(0, known.size() - 1); });
        if (isKnown)
            continue;
        attributes.refuse(FileFault::NeedsExtension, extensionName(space));
    }
}

/// Returns the name without the core namespace, in its current or oldest form; empty if the name is in another
/// namespace.
std::string_view coreName(std::string_view name)
{
    for (const std::string_view space : {coreSpace, firstCoreSpace})
        if (name.starts_with(space))
            return name.substr(space.size());
    return {};
}

/// Returns whether an object of this type is part of the model; supports are not. Throws if the specification does not
/// have the type.
bool isSolidType(std::string_view type, const XmlAttributes& attributes)
{
    if (type.empty() || type == "model" || type == "surface")
        return true;
    if (type != "support" && type != "solidsupport" && type != "other")
        attributes.refuse(FileFault::None, "type " + std::string(type));
    return false;
}

double millimetresOf(std::string_view unit, const XmlAttributes& attributes)
{
    constexpr std::pair<std::string_view, double> units[] = {{"millimeter", 1}, {"micron", 0.001}, {"centimeter", 10},
                                                             {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
    for (const auto& [name, millimetres] : units)
        if (unit == name || (unit.empty() && millimetres == 1))
            return millimetres;
    attributes.refuse(FileFault::LengthUnit, unit);
}

/// Parses #rrggbb or #rrggbbaa.
std::optional<Rgb> displayColor(std::string_view text)
{
    const bool isColor = (text.size() == 7 || text.size() == 9) && text.front() == '#';
    return isColor ? colorOf(text.substr(1, 6)) : std::nullopt;
}

/// Parses the twelve numbers of the transform attribute. They are the rows of a matrix for row vectors; the result is
/// for column vectors.
Eigen::Matrix4d transformOf(const XmlAttributes& attributes)
{
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
    std::string_view rest = attributes.text("transform");
    if (rest.empty())
        return transform;
    for (int i = 0; i < 12; ++i) {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
        const auto value = parseDouble(word);
        if (!value)
            attributes.refuse(FileErrorKind::NotANumber, word);
        transform(i % 3, i / 3) = *value;
        rest.remove_prefix(word.size());
    }
    return transform;
}
} // namespace

/// The colour groups of the part, and the colours of the object that is being read.
struct ThreeMfPartReader::Colors
{
    std::map<std::uint32_t, std::vector<std::optional<Rgb>>> groups;
    std::vector<std::optional<Rgb>>* openGroup = nullptr;
    std::optional<std::uint32_t> objectGroup, objectIndex;
    std::vector<MeanColor> means; ///< one for each vertex, filled from the first coloured triangle on

    std::optional<Rgb> find(std::optional<std::uint32_t> group, std::optional<std::uint32_t> index) const
    {
        const auto found = group && index ? groups.find(*group) : groups.end();
        return found != groups.end() && *index < found->second.size() ? found->second[*index] : std::nullopt;
    }

    void add(const Triangle& triangle, std::size_t vertices, const XmlAttributes& attributes)
    {
        const auto group = attributes.wholeIfAny("pid"), first = attributes.wholeIfAny("p1");
        const auto ofObject = group ? group : objectGroup;
        for (std::size_t i = 0; i < 3; ++i) {
            constexpr std::array<std::string_view, 3> names{"p1", "p2", "p3"};
            const auto own = i == 0 ? first : attributes.wholeIfAny(names[i]);
            const auto color = first ? find(ofObject, own ? own : first) : find(objectGroup, objectIndex);
            if (!color)
                continue;
            means.resize(vertices);
            means[triangle[i]].add(*color);
        }
    }
};

std::string threeMfPath(const FileBytes& file, std::string_view path)
{
    std::string within;
    for (std::string_view rest = path; !rest.empty();) {
        const std::string_view step = rest.substr(0, rest.find_first_of("/\\"));
        rest.remove_prefix(std::min(step.size() + 1, rest.size()));
        if (step == "..")
            throw malformed(FileFault::OutsidePackage, errorWithToken({}, file, path));
        if (step.empty() || step == ".")
            continue;
        within += (within.empty() ? "" : "/") + std::string(step);
    }
    return within;
}

ThreeMfPartReader::ThreeMfPartReader(const FileBytes& file)
    : m_file(file)
    , m_stopCheck(file.stop)
    , m_colors(std::make_unique<Colors>())
    , m_xml(
          file, [this](std::string_view name, const XmlAttributes& attributes) { begin(name, attributes); },
          [this](std::string_view name) { end(name); },
          [this](std::string_view piece) {
              if (m_isInOtherUse)
                  m_otherUse += piece;
          })
{}

ThreeMfPartReader::~ThreeMfPartReader() = default;

void ThreeMfPartReader::begin(std::string_view name, const XmlAttributes& attributes)
{
    m_stopCheck();
    if (const std::string_view ofCore = coreName(name); !ofCore.empty())
        beginCore(ofCore, attributes);
    else if (name == std::string(curaSpace) + "setting" && m_object)
        beginSetting(attributes.text("key"));
    if (name == beamName)
        ++m_part.beams;
    if (m_object && std::find(std::begin(otherShapes), std::end(otherShapes), name) != std::end(otherShapes))
        m_object->otherShape = extensionName(name.substr(0, name.find('|')));
    if (!name.starts_with(materialSpace))
        return;
    name.remove_prefix(materialSpace.size());
    if (name == "colorgroup")
        m_colors->openGroup = &m_colors->groups[attributes.whole("id")];
    else if (name == "texture2dgroup")
        m_part.hasTextures = true;
    else if (name == "color" && m_colors->openGroup)
        m_colors->openGroup->push_back(displayColor(attributes.text("color")));
}

void ThreeMfPartReader::beginCore(std::string_view name, const XmlAttributes& attributes)
{
    if (name == "triangle")
        addTriangle(attributes);
    else if (name == "vertex" && m_object)
        m_object->mesh.points.emplace_back(attributes.number("x"), attributes.number("y"), attributes.number("z"));
    else if (name == "component" && m_object)
        m_object->components.push_back(componentOf(attributes));
    else if (name == "item")
        m_part.build.push_back(componentOf(attributes));
    else if (name == "object")
        beginObject(attributes);
    else if (name == "metadata" && m_object && attributes.text("name").starts_with("cura:"))
        beginSetting(attributes.text("name").substr(std::string_view("cura:").size()));
    else if (name == "basematerials")
        m_colors->openGroup = &m_colors->groups[attributes.whole("id")];
    else if (name == "base" && m_colors->openGroup)
        m_colors->openGroup->push_back(displayColor(attributes.text("displaycolor")));
    else if (name == "model")
        beginModel(attributes);
}

void ThreeMfPartReader::beginModel(const XmlAttributes& attributes)
{
    requireKnownExtensions(attributes);
    m_part.millimetres = millimetresOf(attributes.text("unit"), attributes);
}

void ThreeMfPartReader::beginObject(const XmlAttributes& attributes)
{
    m_object = &m_part.objects[attributes.whole("id")];
    if (!m_object->mesh.points.empty() || !m_object->components.empty())
        attributes.refuse(FileFault::Repeated, "id"); // another object has this id
    m_object->name = cleanName(attributes.text("name"));
    m_object->isSolid = isSolidType(attributes.text("type"), attributes);
    m_colors->objectGroup = attributes.wholeIfAny("pid");
    m_colors->objectIndex = attributes.wholeIfAny("pindex");
    m_colors->means.clear();
}

void ThreeMfPartReader::beginSetting(std::string_view name)
{
    m_isInOtherUse = std::find(std::begin(otherUses), std::end(otherUses), name) != std::end(otherUses);
    m_otherUse.clear();
}

void ThreeMfPartReader::addTriangle(const XmlAttributes& attributes)
{
    if (!m_object)
        return;
    const Triangle triangle{attributes.whole("v1"), attributes.whole("v2"), attributes.whole("v3")};
    const std::size_t vertices = m_object->mesh.points.size();
    for (const Slot corner : triangle)
        if (corner >= vertices)
            throw withCounts(errorWithToken(FileErrorKind::IndexOutOfRange, m_file, std::to_string(corner)), vertices);
    m_object->mesh.triangles.push_back(triangle);
    m_colors->add(triangle, vertices, attributes);
}

void ThreeMfPartReader::end(std::string_view name)
{
    if (name.ends_with("|colorgroup") || name.ends_with("|basematerials"))
        m_colors->openGroup = nullptr;
    if (m_isInOtherUse && m_otherUse == "True")
        m_object->isSolid = false;
    m_isInOtherUse = false;
    if (!m_object || coreName(name) != "object")
        return;
    TriangleMesh& mesh = m_object->mesh;
    for (const MeanColor& mean : m_colors->means)
        mesh.colors.push_back(mean.color());
    if (!mesh.colors.empty())
        mesh.colors.resize(mesh.points.size(), Rgb());
    m_colors->means = {};
    m_object = nullptr;
}

ThreeMfComponent ThreeMfPartReader::componentOf(const XmlAttributes& attributes) const
{
    return {threeMfPath(m_file, attributes.text(pathAttribute)), attributes.whole("objectid"), transformOf(attributes)};
}
} // namespace core::io
