// Sources: Web3D Consortium, ISO/IEC 19775-1: 10 (grouping), 23 (navigation: Billboard, Collision, LOD), 9 (networking:
// Anchor), 32 (CAD), 35 (layering). The expansion avoids errors of Assimp 5.2 to 6.0. Assimp loses its
// position in the scene at a group that is empty or used again. Assimp ignores ccw, and skips Collision, LOD, Anchor
// and others with their children. Its cones and cylinders are not closed, and the caps of its extrusions differ in
// orientation. All inlined files share one scope of names.
#include "core/io/mesh/x3d_expansion.h"

#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/x3d_faces.h"
#include "core/io/mesh/x3d_solids.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace core::io
{
namespace
{
constexpr std::size_t maxNodes = std::size_t(1) << 18;
/// Bytes of text that may be written for any file, in addition to 16 times its size.
constexpr std::size_t minText = std::size_t(1) << 26;

/// Groups whose children belong to the scene.
constexpr std::array<std::string_view, 12> groups{"Group",     "StaticGroup", "Collision", "Anchor",
                                                  "Billboard", "CADAssembly", "CADLayer",  "CADFace",
                                                  "Layer",     "LayerSet",    "Viewport",  "PickableGroup"};
constexpr std::array<std::string_view, 2> transforms{"Transform", "CADPart"};
/// The attributes that place a group, and their number of values: three, or four for an axis with an angle.
constexpr std::array<std::pair<std::string_view, std::size_t>, 5> placing{
    {{"center", 3}, {"rotation", 4}, {"scale", 3}, {"scaleOrientation", 4}, {"translation", 3}}};
/// A numeric attribute of a primitive. Primitives are copied to the output, and the program that reads it makes their
/// surfaces.
struct Shaping
{
    std::string_view node, attribute;
    std::size_t numbers = 0; ///< number of values in the list; 0: any
};
constexpr std::array<Shaping, 9> primitives{{{"Box", "size", 3},
                                             {"Sphere", "radius", 1},
                                             {"ArcClose2D", "startAngle", 1},
                                             {"ArcClose2D", "endAngle", 1},
                                             {"ArcClose2D", "radius", 1},
                                             {"Disk2D", "innerRadius", 1},
                                             {"Disk2D", "outerRadius", 1},
                                             {"Rectangle2D", "size", 2},
                                             {"TriangleSet2D", "vertices", 0}}};
constexpr std::array<std::string_view, 11> noSurfaces{"Appearance", "LineSet",      "IndexedLineSet",    "PointSet",
                                                      "Arc2D",      "Circle2D",     "Polyline2D",        "Polypoint2D",
                                                      "ROUTE",      "ProtoDeclare", "ExternProtoDeclare"};

template <class Names> bool isIn(const Names& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

void dropBlanksBefore(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
}

/// Returns the non-empty strings of a list without their quotes, which Assimp does not handle, and without the blanks
/// and commas before them. A string without quotes extends to the end of the list.
std::vector<std::string_view> textsOf(std::string_view list)
{
    std::vector<std::string_view> texts;
    while (true) {
        dropBlanksBefore(list);
        if (list.empty())
            return texts;
        const bool isQuoted = list.front() == '"';
        list.remove_prefix(isQuoted ? 1 : 0);
        const std::size_t end = isQuoted ? std::min(list.find('"'), list.size()) : list.size();
        std::string_view text = list.substr(0, end);
        dropBlanksBefore(text);
        if (!text.empty())
            texts.push_back(text);
        list.remove_prefix(std::min(end + 1, list.size()));
    }
}

bool isMetadata(const X3dNode& node)
{
    return std::string_view(node.name).starts_with("Metadata");
}

/// Returns whether the node hides its children one by one, as a CADLayer does before version 4.
bool hidesEach(const X3dDocument& document, const X3dNode& node)
{
    return node.name == "CADLayer" && !document.isOfVersion4();
}

/// The nodes of a scene that would show a surface: surface nodes, and all nodes that contain or use one.
class NodesWithShapes
{
public:
    /// `scene`: not owned.
    explicit NodesWithShapes(const X3dNode& scene) : m_scene(scene) {}

    /// Returns whether the node would show a surface. The first call searches the scene.
    bool contains(const X3dNode& node)
    {
        if (!m_found)
            find();
        return m_found->contains(&node);
    }

private:
    void find()
    {
        m_found.emplace();
        std::unordered_map<const X3dNode*, std::vector<const X3dNode*>> holders;
        std::vector<const X3dNode*> unfollowed;
        for (std::vector<const X3dNode*> open{&m_scene}; !open.empty();) {
            const X3dNode& node = *open.back();
            open.pop_back();
            if ((node.name == "Shape" || node.name == "ProtoInstance" || node.name == "GeoElevationGrid") &&
                m_found->insert(&node).second)
                unfollowed.push_back(&node);
            for (const X3dNode* child : node.children)
                holders[&child->meant()].push_back(&node);
            open.insert(open.end(), node.children.begin(), node.children.end());
        }
        while (!unfollowed.empty()) {
            const X3dNode* const node = unfollowed.back();
            unfollowed.pop_back();
            for (const X3dNode* holder : holders[node])
                if (m_found->insert(holder).second)
                    unfollowed.push_back(holder);
        }
    }

    const X3dNode& m_scene;
    std::optional<std::unordered_set<const X3dNode*>> m_found;
};

/// Returns the name without what an earlier expansion put before it, so that expanding a file again changes nothing.
std::string_view originalName(std::string_view name)
{
    constexpr std::string_view digits = "0123456789";
    std::string_view rest = name;
    for (const std::string_view before : {"n", "_"}) {
        const std::size_t end = rest.starts_with(before) ? rest.find_first_not_of(digits, 1) : rest.npos;
        if (end == rest.npos || end == 1)
            return name;
        rest.remove_prefix(end);
    }
    return rest.starts_with('_') ? rest.substr(1) : name;
}

/// The output text, and the names of the nodes that it contains.
class X3dText
{
public:
    X3dText(const FileBytes& file, std::size_t fileNumber)
        : m_file(file)
        , m_names("n" + std::to_string(fileNumber) + "_")
    {}

    void add(std::string_view text) { m_text += text; }
    std::size_t size() const { return m_text.size(); }
    /// Removes the text written since the output had this size.
    void shrink(std::size_t size) { m_text.resize(size); }
    /// Removes text as shrink(size), and the name that addDefinition() gave last, to this node.
    void shrink(std::size_t size, const X3dNode& named)
    {
        m_text.resize(size);
        m_named.erase(&named);
        --m_nextName;
    }
    /// Removes text as shrink(size), and the names of nodes that are not used, given since there were so many.
    void shrink(std::size_t size, std::size_t names)
    {
        m_text.resize(size);
        m_nextName = names;
    }
    std::size_t names() const { return m_nextName; }
    std::string take() { return std::move(m_text); }

    void begin(const X3dNode& node, std::string_view name)
    {
        if (++m_nodes > maxNodes) {
            FileError error = tooMany("nodes", maxNodes, errorWithToken({}, m_file, {}));
            error.place = {FilePlace::Unit::Line, node.line};
            throw error;
        }
        const std::size_t maxText = minText + 16 * m_file.bytes.size();
        if (m_text.size() > maxText)
            throw withCounts(errorWithToken(FileErrorKind::UnpacksTooLarge, m_file, {}), maxText);
        m_text.append("<").append(name);
    }

    void beginScale(double factor)
    {
        add("<Transform");
        addNumbers("scale", {factor, factor, factor});
        add(">");
    }

    /// Writes a reference to a node that was already written under that element name. Returns false if it was not.
    bool addUse(const X3dNode& node, std::string_view name)
    {
        const auto found = m_named.find(&node);
        if (found == m_named.end() || found->second.second != name)
            return false;
        begin(node, name);
        m_text += " USE=\"" + m_names + std::to_string(found->second.first) + "\"/>";
        return true;
    }

    /// Gives the node being written a name, so that addUse() finds it. `name`: element name as written; only a view is
    /// kept.
    void addDefinition(const X3dNode& node, std::string_view name)
    {
        m_named.insert_or_assign(&node, std::pair(m_nextName, name));
        addName();
    }

    void addAttribute(const X3dNode& node, std::string_view name)
    {
        const std::string_view value = node.text(name);
        if (!value.empty())
            m_text.append(" ").append(name).append("=\"").append(escaped(value)).append("\"");
    }

    void addNumbers(std::string_view name, const std::vector<double>& numbers)
    {
        m_text.append(" ").append(name).append("=\"");
        std::array<char, 32> digits;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            m_text.append(i > 0 ? " " : "")
                .append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), numbers[i]).ptr);
        m_text += '"';
    }

    /// Writes a DEF attribute with a new, unique name.
    void addName() { m_text += " DEF=\"" + m_names + std::to_string(m_nextName++) + "\""; }
    /// Writes a DEF attribute with a new, unique name that ends with the node's own, if it has one.
    void addName(const X3dNode& node)
    {
        if (const std::string_view own = originalName(node.text("DEF")); !own.empty())
            m_text += " DEF=\"" + m_names + std::to_string(m_nextName++) + '_' + escaped(cleanName(own)) + '"';
    }

    static std::string escaped(std::string_view text)
    {
        std::string result;
        for (const char c : text)
            switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\n':
            case '\r':
            case '\t':
                result += ' ';
                break;
            default:
                result += c;
            }
        return result;
    }

private:
    const FileBytes& m_file;
    std::string m_names; ///< prefix of the names of this file's nodes
    std::string m_text;
    std::size_t m_nodes = 0, m_nextName = 0;
    /// Nodes that were written, with their numbers and element names.
    std::unordered_map<const X3dNode*, std::pair<std::size_t, std::string_view>> m_named;
};

class X3dWriter
{
public:
    /// `file`, `document`, `around`: not owned.
    X3dWriter(const FileBytes& file, const X3dDocument& document, const X3dSurroundings& around)
        : m_file(file)
        , m_document(document)
        , m_around(around)
        , m_to(file, around.fileNumber)
    {}

    X3dExpansion write()
    {
        m_to.add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D version=\"3.3\"><Scene>");
        const std::size_t scene = m_to.size();
        const bool isInMetres = m_document.metres() == 1;
        if (!isInMetres)
            m_to.beginScale(m_document.metres());
        const std::size_t before = m_to.size();
        addChildren(m_document.scene());
        if (!isInMetres && m_to.size() == before)
            m_to.shrink(scene); // some readers do not expect an empty transform
        else if (!isInMetres)
            m_to.add("</Transform>");
        m_to.add("</Scene></X3D>\n");
        return {m_to.take(), m_hidden, m_unread};
    }

private:
    void addChildren(const X3dNode& node)
    {
        std::vector<std::string_view> visible;
        if (hidesEach(m_document, node))
            visible = x3dWords(node.text("visible"));
        std::size_t number = 0;
        for (const X3dNode* child : node.children) {
            const bool isCounted = !isMetadata(*child) && !isIn(noSurfaces, child->name);
            const std::size_t at = isCounted ? number++ : visible.size();
            if (at >= visible.size() || !isX3dFalse(visible[at]))
                add(*child);
            else
                m_hidden += m_withShapes.contains(child->meant()) ? 1 : 0;
        }
    }

    void add(const X3dNode& node)
    {
        const X3dNode& meant = node.meant();
        if (node.text("containerField") == "proxy") // a Collision's shape for collisions, which is not visible
            return;
        if (meant.isFalse("visible") && !hidesEach(m_document, meant)) {
            m_hidden += m_withShapes.contains(meant) ? 1 : 0;
            return;
        }
        if (meant.name == "Shape")
            addShape(meant);
        else if (isIn(groups, meant.name) || isIn(transforms, meant.name) || meant.name == "Switch" ||
                 meant.name == "LOD")
            addGroup(node, meant);
        else if (meant.name == "Inline")
            addInline(meant);
        else if (meant.name != "ProtoDeclare")
            m_unread += m_withShapes.contains(meant) ? 1 : 0;
    }

    void addGroup(const X3dNode& node, const X3dNode& meant)
    {
        if (m_open.size() >= maxX3dDepth || !m_open.insert(&meant).second)
            refuseX3d(m_file, node, FileFault::TooDeep, "nodes of USE=" + std::string(node.text("USE")));
        const std::size_t before = m_to.size(), names = m_to.names();
        const bool isTransform = isIn(transforms, meant.name);
        m_to.begin(node, isTransform ? "Transform" : "Group");
        m_to.addName(meant);
        if (isTransform)
            for (const auto& [name, count] : placing)
                addPlacing(meant, name, count);
        m_to.add(">");
        const std::size_t inside = m_to.size();
        if (meant.name == "Switch" || meant.name == "LOD")
            addChosen(meant);
        else
            addChildren(meant);
        if (m_to.size() == inside)
            m_to.shrink(before, names);
        else
            m_to.add(isTransform ? "</Transform>" : "</Group>");
        m_open.erase(&meant);
    }

    /// Writes an attribute of a transform. Normalises its axis, if it has one, because Assimp uses it unchanged. A
    /// rotation about an axis of length 0 is omitted.
    void addPlacing(const X3dNode& node, std::string_view name, std::size_t count)
    {
        std::vector<double> numbers = x3dNumbers(m_file, node, name);
        if (numbers.empty())
            return;
        if (numbers.size() != count)
            refuseX3d(m_file, node, FileFault::Number, node.text(name));
        if (count == 4) {
            const double length = std::hypot(numbers[0], numbers[1], numbers[2]);
            constexpr double tolerance = 1e-12; // an axis that is already normalised is not changed
            if (length == 0)
                return;
            for (std::size_t i = 0; i < 3 && std::abs(length - 1) > tolerance; ++i)
                numbers[i] /= length;
            numbers[3] *= m_document.radians();
        }
        m_to.addNumbers(name, numbers);
    }

    /// Adds the visible child: for a Switch the chosen one, for a LOD the first that shows anything, which is the
    /// finest.
    void addChosen(const X3dNode& node)
    {
        std::int64_t choice = 0;
        if (node.name == "Switch") {
            const std::vector<std::string_view> which = x3dWords(node.text("whichChoice"));
            choice = which.empty() ? -1 : parseInteger(which.front()).value_or(-1);
        }
        if (choice < 0)
            return; // nothing is visible
        const std::size_t before = m_to.size();
        for (const X3dNode* child : node.children) {
            if (isMetadata(*child) || isIn(noSurfaces, child->name) || choice-- > 0)
                continue;
            add(*child);
            if (node.name == "Switch" || m_to.size() > before)
                return;
        }
    }

    void addShape(const X3dNode& shape)
    {
        if (m_to.addUse(shape, "Shape"))
            return;
        const std::size_t before = m_to.size();
        m_to.begin(shape, "Shape");
        m_to.addDefinition(shape, "Shape");
        m_to.add(">");
        for (const X3dNode* child : shape.children)
            if (child->meant().name == "Appearance")
                addAppearance(child->meant());
        bool hasSurface = false;
        for (const X3dNode* child : shape.children)
            hasSurface = hasSurface || addGeometry(child->meant());
        if (hasSurface) {
            m_to.add("</Shape>");
            return;
        }
        m_to.shrink(before, shape);
    }

    /// Adds only the information whether there are materials and textures.
    void addAppearance(const X3dNode& appearance)
    {
        std::string inside;
        for (const X3dNode* child : appearance.children) {
            const X3dNode& node = child->meant();
            if (node.name == "Material")
                inside += "<Material/>";
            else if (node.name == "ImageTexture")
                inside += "<ImageTexture url=\"image\"/>";
        }
        if (!inside.empty())
            m_to.add("<Appearance>" + inside + "</Appearance>");
    }

    bool addGeometry(const X3dNode& node)
    {
        if (isMetadata(node) || isIn(noSurfaces, node.name))
            return false;
        if (std::any_of(primitives.begin(), primitives.end(),
                        [&node](const Shaping& list) { return list.node == node.name; })) {
            addPrimitive(node);
            return true;
        }
        if (m_to.addUse(node, "IndexedFaceSet"))
            return true;
        auto faces = facesOfX3d(m_file, node, m_lists);
        if (!faces)
            faces = facesOfX3dSolid(m_file, node, m_document.radians());
        if (!faces)
            ++m_unread;
        if (!faces || faces->coordIndex.empty())
            return false;
        m_to.begin(node, "IndexedFaceSet");
        m_to.addDefinition(node, "IndexedFaceSet");
        m_to.add(" coordIndex=\"" + faces->coordIndex + "\">");
        if (!faces->points.empty()) {
            m_to.add("<Coordinate");
            m_to.addName();
            m_to.add(" point=\"" + faces->points + "\"/>");
        } else
            for (const X3dNode* child : node.children)
                if (isX3dCoordinate(child->meant()))
                    addPoints(child->meant());
        if (!faces->colors.empty()) {
            m_to.add(faces->colorNumbers == 3 ? "<Color" : "<ColorRGBA");
            m_to.addNumbers("color", faces->colors);
            m_to.add("/>");
        }
        m_to.add("</IndexedFaceSet>");
        return true;
    }

    void addPrimitive(const X3dNode& node)
    {
        m_to.begin(node, node.name);
        for (const Shaping& list : primitives) {
            std::vector<double> numbers =
                list.node == node.name ? x3dNumbers(m_file, node, list.attribute) : std::vector<double>();
            if (numbers.empty())
                continue;
            if (list.numbers != 0 && numbers.size() != list.numbers)
                refuseX3d(m_file, node, FileFault::NotNumbers, list.attribute);
            for (double& number : numbers)
                number *= list.attribute.ends_with("Angle") ? m_document.radians() : 1;
            m_to.addNumbers(list.attribute, numbers);
        }
        m_to.addAttribute(node, "closureType");
        m_to.add("/>");
    }

    void addPoints(const X3dNode& node)
    {
        if (m_to.addUse(node, "Coordinate"))
            return;
        m_to.begin(node, "Coordinate");
        m_to.addDefinition(node, "Coordinate");
        m_to.addNumbers("point", m_lists.points(node));
        m_to.add("/>");
    }

    void addInline(const X3dNode& node)
    {
        const std::vector<std::string_view> urls = textsOf(node.text("url"));
        if (node.isFalse("load") || urls.empty())
            return;
        std::optional<std::string> name;
        for (std::size_t i = 0; i < urls.size() && !name; ++i)
            name = m_around.find ? m_around.find(urls[i]) : std::string(urls[i]);
        if (!name) {
            ++m_unread;
            return;
        }
        const bool isInMetres = m_document.metres() == 1;
        if (!isInMetres)
            m_to.beginScale(1 / m_document.metres()); // the inlined file has its own unit
        m_to.begin(node, "Inline");
        m_to.add(" url=\"" + X3dText::escaped(*name) + "\"/>");
        if (!isInMetres)
            m_to.add("</Transform>");
    }

    const FileBytes& m_file;
    const X3dDocument& m_document;
    const X3dSurroundings& m_around;
    X3dText m_to;
    X3dLists m_lists{m_file};
    std::size_t m_hidden = 0, m_unread = 0;
    NodesWithShapes m_withShapes{m_document.scene()};
    std::unordered_set<const X3dNode*> m_open; ///< groups that are being written, to find cycles
};
} // namespace

X3dExpansion expandX3d(const FileBytes& file, const X3dSurroundings& around)
{
    const X3dDocument document(file);
    return X3dWriter(file, document, around).write();
}

std::string_view x3dNameIn(std::string_view written)
{
    constexpr char end = '_';
    const std::size_t file = written.find(end), number = file == written.npos ? file : written.find(end, file + 1);
    return number == written.npos ? std::string_view() : written.substr(number + 1);
}
} // namespace core::io
