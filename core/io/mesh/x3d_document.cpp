// Sources: Web3D Consortium, ISO/IEC 19775-1 (X3D architecture; 4.3.4 "Standard units", 4.4.3 "DEF/USE semantics"),
// 19776-1 (XML encoding).
#include "core/io/mesh/x3d_document.h"

#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/xml_namespaces.h"

#include <expat.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <new>

namespace core::io
{
std::string_view X3dNode::text(std::string_view attribute) const
{
    for (const auto& [key, value] : attributes)
        if (key == attribute)
            return value;
    return {};
}

bool X3dNode::isFalse(std::string_view attribute) const
{
    return isX3dFalse(text(attribute));
}

bool isX3dFalse(std::string_view text)
{
    constexpr std::string_view word = "false", blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    return std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

void refuseX3d(const FileBytes& file, const X3dNode& node, FileFault fault, std::string_view token)
{
    FileError error = malformed(fault, errorWithToken({}, file, token));
    error.place = {FilePlace::Unit::Line, node.line};
    throw error;
}

/// The callbacks for expat. An exception must not pass through expat: it is stored, and parsing stops.
struct X3dDocument::Parser
{
    Parser(const FileBytes& bytes, X3dDocument& to)
        : file(bytes)
        , document(to)
        , parser(XML_ParserCreate(nullptr), &XML_ParserFree)
    {
        if (!parser)
            throw std::bad_alloc();
        XML_SetUserData(parser.get(), this);
        XML_SetElementHandler(parser.get(), &Parser::begin, &Parser::end);
        XML_SetStartDoctypeDeclHandler(parser.get(), &Parser::documentType);
    }

    void parse()
    {
        constexpr std::size_t pieceSize = 1 << 20;
        for (std::size_t at = 0; at <= file.bytes.size(); at += pieceSize) {
            const std::string_view piece = file.bytes.substr(at, pieceSize);
            const bool isLast = at + pieceSize > file.bytes.size();
            const XML_Status status =
                XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), isLast ? 1 : 0);
            if (problem)
                std::rethrow_exception(problem);
            if (status != XML_STATUS_OK && XML_GetErrorCode(parser.get()) == XML_ERROR_NO_MEMORY)
                throw std::bad_alloc();
            if (status != XML_STATUS_OK)
                refuse(FileFault::XmlSyntax, XML_ErrorString(XML_GetErrorCode(parser.get())));
        }
    }

    [[noreturn]] void refuse(FileFault fault, std::string_view token = {}) const
    {
        X3dNode here;
        here.line = XML_GetCurrentLineNumber(parser.get());
        refuseX3d(file, here, fault, token);
    }

    template <class Work> void guarded(const Work& work)
    {
        if (problem)
            return;
        try {
            work();
        } catch (...) {
            problem = std::current_exception();
            XML_StopParser(parser.get(), XML_FALSE);
        }
    }

    static void begin(void* self, const char* name, const char** pairs)
    {
        auto& parser = *static_cast<Parser*>(self);
        parser.guarded([&] { parser.beginNode(name, pairs); });
    }
    static void end(void* self, const char*)
    {
        auto& parser = *static_cast<Parser*>(self);
        parser.guarded([&] { parser.endNode(); });
    }
    static void documentType(void* self, const char*, const char*, const char*, int declaresSomething)
    {
        auto& parser = *static_cast<Parser*>(self);
        parser.guarded([&] {
            if (declaresSomething != 0)
                parser.refuse(FileFault::XmlDocumentType);
        });
    }

    void beginNode(const char* name, const char** pairs)
    {
        if (open.size() >= maxX3dDepth)
            refuse(FileFault::XmlTooDeep);
        spaces.begin(pairs);
        X3dNode& node = document.m_nodes.emplace_back();
        node.name = withoutPrefix(name);
        node.line = XML_GetCurrentLineNumber(parser.get());
        for (; *pairs; pairs += 2)
            node.attributes.emplace_back(pairs[0], pairs[1]);
        if (open.empty())
            document.m_isOfVersion4 = parseDouble(node.text("version")).value_or(0) >= 4;
        else
            open.back()->children.push_back(&node);
        open.push_back(&node);
        if (node.name == "ProtoDeclare")
            outside.push_back(defined); // names defined in a prototype are valid only inside of it
        if (const std::string_view used = node.text("USE"); !used.empty()) {
            const auto found = defined.find(used);
            if (found == defined.end())
                refuse(FileFault::Missing, "DEF=" + std::string(used));
            node.used = found->second;
        } else if (const std::string_view own = node.text("DEF"); !own.empty()) {
            defined.insert_or_assign(std::string(own), &node);
        }
        if (node.name == "Scene" && !document.m_scene)
            document.m_scene = &node;
        if (node.name == "unit" && node.text("category") == "length")
            document.m_metres = factorOf(node);
        if (node.name == "unit" && node.text("category") == "angle")
            document.m_radians = factorOf(node);
    }

    /// Returns the name of an element, without its prefix if it is an X3D element. The root's prefix is valid for the
    /// whole file.
    std::string_view withoutPrefix(std::string_view name)
    {
        constexpr std::string_view ofX3d = "web3d.org/specifications/x3d"; // followed by a version
        const std::size_t colon = name.find(':'), size = colon == std::string_view::npos ? 0 : colon + 1;
        const std::string_view space = spaces.spaceOf(name.substr(0, size > 0 ? colon : 0));
        if (open.empty()) {
            rootPrefix = name.substr(0, size);
            rootSpace = space;
        }
        const bool isX3d = name.substr(0, size) == rootPrefix ||
                           (!space.empty() && (space == rootSpace || space.find(ofX3d) != std::string_view::npos));
        return isX3d ? name.substr(size) : name;
    }

    void endNode()
    {
        if (open.back()->name == "ProtoDeclare") {
            defined = std::move(outside.back());
            outside.pop_back();
        }
        open.pop_back();
        spaces.end();
    }

    /// Returns the conversion factor of a unit element to the format's standard unit.
    double factorOf(const X3dNode& unit) const
    {
        const std::string_view text = unit.text("conversionFactor");
        const auto factor = parseDouble(text);
        if (!factor || !std::isfinite(*factor) || *factor <= 0)
            refuse(FileFault::Number, text);
        return *factor;
    }

    const FileBytes& file;
    X3dDocument& document;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> parser;
    std::vector<X3dNode*> open; ///< open elements, beginning with the root
    std::map<std::string, const X3dNode*, std::less<>> defined;
    /// Names defined outside of each open prototype.
    std::vector<std::map<std::string, const X3dNode*, std::less<>>> outside;
    XmlNamespaces spaces;
    std::string rootPrefix, rootSpace; ///< rootPrefix includes the colon
    std::exception_ptr problem;
};

X3dDocument::X3dDocument(const FileBytes& file)
{
    Parser(file, *this).parse();
    if (!m_scene)
        throw malformed(FileFault::Missing, errorWithToken({}, file, "Scene"));
}
} // namespace core::io
