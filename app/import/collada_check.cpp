#include "app/import/collada_check.h"

#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/xml_reader.h"
#include "core/io/mesh/zip_reader.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace app
{
namespace
{
using core::FileError;
using core::FileErrorKind;
using core::FileFault;
using core::io::FileBytes;
using core::io::XmlAttributes;
using core::io::XmlReader;

constexpr int deepest = 4096; ///< of elements, and of nodes; Assimp recurses into both

void parse(const FileBytes& file, XmlReader& xml)
{
    constexpr std::size_t pieceSize = 1 << 16;
    std::string_view rest = file.bytes;
    for (; !rest.empty(); rest.remove_prefix(std::min(pieceSize, rest.size())))
        xml.take(rest.substr(0, pieceSize));
    xml.take({});
}

[[noreturn]] void refuseAt(std::uint64_t line, FileError error)
{
    error.place = {core::FilePlace::Unit::Line, line};
    throw error;
}

std::string_view withoutSpace(std::string_view name)
{
    return name.substr(name.rfind('|') + 1);
}

std::string_view withoutHash(std::string_view url)
{
    return url.substr(url.starts_with('#') ? 1 : 0);
}

/// The graph of nodes: which ones each contains or instantiates.
class NodeGraph
{
public:
    void begin(const XmlAttributes& attributes, std::uint64_t line)
    {
        const std::size_t node = m_nodes.size();
        m_nodes.push_back({std::string(attributes.text("id")), line, {}, {}});
        m_byId.emplace(attributes.text("id"), node);
        m_byName.emplace(attributes.text("name"), node);
        if (!m_open.empty())
            m_nodes[m_open.back()].below.push_back(node);
        m_open.push_back(node);
    }
    void end() { m_open.pop_back(); }
    bool isOpen() const { return !m_open.empty(); }
    void addInstance(std::string_view url) { m_nodes[m_open.back()].urls.emplace_back(withoutHash(url)); }

    /// Throws FileError if a node contains itself, or too many generations.
    void requireTree(const FileBytes& file)
    {
        for (std::size_t i = 0; i < m_nodes.size(); ++i)
            heightOf(i, 0, file);
    }
    /// Returns the number of instances of nodes that the file does not have.
    std::size_t missing() const
    {
        std::size_t missing = 0;
        for (const Node& node : m_nodes)
            missing += node.below.size() + node.urls.size() - nodesBelow(node).size();
        return missing;
    }

private:
    struct Node
    {
        std::string id;
        std::uint64_t line = 0;
        std::vector<std::size_t> below;
        std::vector<std::string> urls;
        bool isOnWay = false;
        int height = 0; ///< generations from this node down; 0: not known yet
    };

    std::vector<std::size_t> nodesBelow(const Node& node) const
    {
        std::vector<std::size_t> below = node.below;
        for (const std::string& url : node.urls)
            for (const auto* const named : {&m_byId, &m_byName})
                if (const auto found = named->find(url); found != named->end()) {
                    below.push_back(found->second);
                    break;
                }
        return below;
    }

    int heightOf(std::size_t index, int depth, const FileBytes& file)
    {
        if (m_nodes[index].isOnWay || depth + m_nodes[index].height > deepest)
            refuseAt(m_nodes[index].line,
                     core::io::malformed(FileFault::TooDeep,
                                         core::io::errorWithToken({}, file, "nodes below " + m_nodes[index].id)));
        if (m_nodes[index].height > 0)
            return m_nodes[index].height;
        m_nodes[index].isOnWay = true;
        int height = 0;
        for (const std::size_t below : nodesBelow(m_nodes[index]))
            height = std::max(height, heightOf(below, depth + 1, file));
        m_nodes[index].isOnWay = false;
        return m_nodes[index].height = height + 1;
    }

    std::vector<Node> m_nodes;
    std::vector<std::size_t> m_open;
    std::map<std::string, std::size_t, std::less<>> m_byId, m_byName;
};

class ColladaCheck
{
public:
    explicit ColladaCheck(const FileBytes& file)
        : m_file(file)
        , m_xml(
              file,
              [this](std::string_view name, const XmlAttributes& attributes) { begin(withoutSpace(name), attributes); },
              [this](std::string_view name) { end(withoutSpace(name)); },
              [this](std::string_view piece) { countWords(piece); }, deepest)
    {}

    /// Returns the number of instances of what the file does not have.
    std::size_t run()
    {
        parse(m_file, m_xml);
        m_nodes.requireTree(m_file);
        const auto isMissing = [&](const std::string& url) { return !m_meshes.contains(url); };
        return m_nodes.missing() + static_cast<std::size_t>(std::ranges::count_if(m_instances, isMissing));
    }

private:
    /// The accessor of a source: which values of an array it reads.
    struct Accessor
    {
        std::string array;
        std::uint64_t offset = 0, count = 0, params = 0, line = 0;
        std::uint64_t stride = 0; ///< 0: none is given, which means 1
    };
    /// A list of triangles, polygons or lines.
    struct Primitive
    {
        std::string name; ///< empty: none is open
        std::uint64_t count = 0, sizes = 0, paths = 0, indices = 0, stride = 1, vertexOffset = 0;
    };
    enum class Words { Ignored, Values, Counts, Indices };

    void begin(std::string_view name, const XmlAttributes& attributes)
    {
        m_words = Words::Ignored;
        if (name == "node")
            m_nodes.begin(attributes, m_xml.line());
        else if (name.starts_with("instance_") && m_nodes.isOpen())
            beginInstance(name, attributes);
        else if (name == "geometry" || name == "controller")
            m_meshes.emplace(attributes.text("id"));
        else if (name == "skew" && m_nodes.isOpen())
            attributes.refuse(FileFault::NotRead, "skew");
        else if (name == "unit")
            requireUnit(attributes);
        else if (isCounted(name))
            m_primitive = {std::string(name), attributes.whole("count")};
        else if (name == "tristrips" || name == "trifans" || name == "lines" || name == "linestrips")
            m_primitive = {std::string(name)};
        else if (!m_primitive.name.empty())
            beginInPrimitive(name, attributes);
        else
            beginInSource(name, attributes);
    }

    void beginInstance(std::string_view name, const XmlAttributes& attributes)
    {
        const bool isNode = name == "instance_node";
        if (!isNode && name != "instance_geometry" && name != "instance_controller")
            return;
        const std::string_view url = attributes.text("url");
        if (url.find('#', 1) != std::string_view::npos)
            attributes.refuse(FileFault::NotRead, url);
        if (isNode)
            m_nodes.addInstance(url);
        else
            m_instances.emplace_back(withoutHash(url));
    }

    static void requireUnit(const XmlAttributes& attributes)
    {
        std::string metres(attributes.text("meter"));
        std::ranges::replace(metres, ',', '.'); // some exporters write a decimal comma, which Assimp understands
        if (!metres.empty() && !(core::io::parseDouble(metres).value_or(0) > 0))
            attributes.refuse(FileFault::PositiveNumber, attributes.text("meter"));
    }

    /// Returns whether Assimp takes the number of primitives from the attribute.
    static bool isCounted(std::string_view name)
    {
        return name == "triangles" || name == "polylist" || name == "polygons";
    }

    void beginInSource(std::string_view name, const XmlAttributes& attributes)
    {
        if (name == "source") {
            m_arrays.clear();
            m_accessor = {};
        } else if (name == "float_array") {
            beginWords(Words::Values, m_arrays[std::string(attributes.text("id"))]);
        } else if (name == "accessor") {
            m_isInAccessor = true;
            m_accessor = {std::string(withoutHash(attributes.text("source"))),
                          attributes.wholeIfAny("offset").value_or(0),
                          attributes.whole("count"),
                          0,
                          m_xml.line(),
                          attributes.wholeIfAny("stride").value_or(0)};
        } else if (name == "param" && m_isInAccessor && ++m_accessor.params > 1 && m_accessor.stride == 0) {
            attributes.refuse(FileFault::Missing, "stride");
        }
    }

    void beginInPrimitive(std::string_view name, const XmlAttributes& attributes)
    {
        if (name == "input") {
            const std::uint64_t offset = attributes.wholeIfAny("offset").value_or(0);
            m_primitive.stride = std::max(m_primitive.stride, offset + 1);
            if (attributes.text("semantic") == "VERTEX")
                m_primitive.vertexOffset = offset;
        } else if (name == "vcount") {
            beginWords(Words::Counts, m_primitive.sizes);
        } else if (name == "p") {
            if (m_primitive.name == "polylist" && m_primitive.sizes == 0)
                attributes.refuse(FileFault::Missing, "vcount");
            ++m_primitive.paths;
            beginWords(Words::Indices, m_primitive.indices);
        }
    }

    void end(std::string_view name)
    {
        m_words = Words::Ignored;
        if (name == "node")
            m_nodes.end();
        else if (name == "accessor")
            m_isInAccessor = false;
        else if (name == "source")
            requireValues();
        else if (!m_primitive.name.empty() && name == m_primitive.name)
            endPrimitive();
    }

    /// Throws FileError if the accessor reads more values than its array has.
    void requireValues() const
    {
        const auto array = m_arrays.find(m_accessor.array);
        if (array == m_arrays.end() || m_accessor.count == 0)
            return;
        const std::uint64_t stride = std::max<std::uint64_t>(m_accessor.stride, 1);
        const std::uint64_t ofLast = std::clamp<std::uint64_t>(m_accessor.params, 1, stride);
        if (m_accessor.offset + (m_accessor.count - 1) * stride + ofLast > array->second)
            refuseAt(m_accessor.line,
                     core::io::malformed(FileFault::BeyondItsData,
                                         core::io::errorWithToken({}, m_file, "float_array " + m_accessor.array)));
    }

    void endPrimitive()
    {
        const Primitive primitive = std::exchange(m_primitive, {});
        if (!isCounted(primitive.name))
            return;
        if (primitive.count > 0 && primitive.paths == 0)
            throw core::io::malformed(FileFault::Missing, core::io::errorWithToken({}, m_file, "p"));
        const bool areTriangles = primitive.name == "triangles";
        const std::uint64_t found = areTriangles                   ? primitive.indices / primitive.stride / 3
                                    : primitive.name == "polygons" ? primitive.paths
                                                                   : primitive.count;
        const bool isIgnored = primitive.count == 0 && primitive.indices > 0;
        if (isIgnored || (areTriangles ? found < primitive.count : found != primitive.count))
            throw core::io::withCounts(core::io::errorWithToken(FileErrorKind::CountMismatch, m_file, {}),
                                       primitive.count, std::max<std::uint64_t>(found, isIgnored ? 1 : 0));
    }

    void beginWords(Words words, std::uint64_t& counter)
    {
        m_words = words;
        m_counter = &counter;
        m_isInWord = false;
    }

    void countWords(std::string_view piece)
    {
        constexpr std::string_view blanks = " \t\r\n";
        if (m_words == Words::Ignored)
            return;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const bool isBlank = blanks.find(piece[i]) != std::string_view::npos;
            if (!isBlank && !m_isInWord)
                beginWord(piece.substr(i, piece.find_first_of(blanks, i) - i));
            m_isInWord = !isBlank;
        }
    }

    void beginWord(std::string_view word)
    {
        const std::uint64_t number = (*m_counter)++;
        const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
        const bool isWhole = word.find_first_not_of("0123456789", sign) == std::string_view::npos;
        if (m_words != Words::Values && !isWhole) // Assimp never gets past such a word
            throw core::io::malformed(FileFault::WholeNumber, core::io::errorWithToken({}, m_file, word));
        if (m_words == Words::Indices && word.starts_with('-') &&
            number % m_primitive.stride == m_primitive.vertexOffset)
            throw core::io::malformed(FileFault::VertexIndex, core::io::errorWithToken({}, m_file, word));
    }

    FileBytes m_file;
    NodeGraph m_nodes;
    std::set<std::string, std::less<>> m_meshes; ///< ids of geometries and controllers
    std::vector<std::string> m_instances;        ///< ids of the geometries and controllers that nodes show
    std::map<std::string, std::uint64_t, std::less<>> m_arrays; ///< number of values of the source's arrays, by id
    Accessor m_accessor;
    Primitive m_primitive;
    Words m_words = Words::Ignored;
    std::uint64_t* m_counter = nullptr;
    bool m_isInWord = false, m_isInAccessor = false;
    XmlReader m_xml; ///< declared last, because its callbacks use the other members
};
} // namespace

std::size_t requireSoundCollada(const FileBytes& file)
{
    try {
        return ColladaCheck(file).run();
    } catch (const FileError& error) {
        const bool isOfXml = error.fault == FileFault::XmlSyntax || error.fault == FileFault::XmlDocumentType ||
                             error.fault == FileFault::XmlLongTag;
        if (!isOfXml)
            throw;
    }
    return 0;
}

std::size_t requireSoundZae(const FileBytes& package)
{
    std::size_t missing = 0;
    core::io::ZipReader zip(package);
    for (const std::string& name : zip.names()) {
        if (!name.ends_with(".dae"))
            continue;
        std::string text;
        zip.read(name, [&text](std::string_view piece) { text += piece; });
        try {
            missing += requireSoundCollada({package.path, text});
        } catch (FileError& error) {
            error.path /= std::filesystem::path(name).filename();
            throw;
        }
    }
    return missing;
}

void requireXml(const FileBytes& file)
{
    const auto nothing = [](auto&&...) {};
    XmlReader xml(file, nothing, nothing, {}, deepest);
    try {
        parse(file, xml);
    } catch (const FileError& error) {
        if (error.fault == FileFault::XmlSyntax)
            throw;
    }
}
} // namespace app
