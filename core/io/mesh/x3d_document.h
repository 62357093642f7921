#pragma once

#include "core/io/mesh/format.h"

#include <deque>
#include <string>
#include <vector>

namespace core::io
{
/// Levels of elements, and of groups including those nested by USE, that a file may nest.
inline constexpr std::size_t maxX3dDepth = 256;

/// A node of an X3D scene, as written in the XML.
struct X3dNode
{
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes; ///< name and value
    std::vector<const X3dNode*> children;
    const X3dNode* used = nullptr; ///< the node that a USE attribute refers to
    std::uint64_t line = 0;

    /// Returns the node that a USE attribute refers to; without one, this node.
    const X3dNode& meant() const { return used ? *used : *this; }
    /// Returns the attribute's value; empty if there is none.
    std::string_view text(std::string_view attribute) const;
    /// Returns whether the value means false, see isX3dFalse().
    bool isFalse(std::string_view attribute) const;
};

/// An X3D file in XML encoding, parsed by the library expat to a tree. Elements may be nested maxX3dDepth deep. A
/// document type is ignored unless it declares something. Element names lose their prefix if it is the root's, or
/// denotes the root's or X3D's namespace. Throws FileError with the line; an undefined USE is an error.
class X3dDocument
{
public:
    explicit X3dDocument(const FileBytes& file);

    const X3dNode& scene() const { return *m_scene; }
    /// Returns the length of the file's unit in metres.
    double metres() const { return m_metres; }
    /// Returns whether the file has X3D version 4 or later.
    bool isOfVersion4() const { return m_isOfVersion4; }
    /// Returns the file's unit of angles in radians.
    double radians() const { return m_radians; }

private:
    struct Parser;

    std::deque<X3dNode> m_nodes;
    const X3dNode* m_scene = nullptr;
    double m_metres = 1, m_radians = 1;
    bool m_isOfVersion4 = false;
};

/// Returns whether the text is "false" in upper or lower case, with or without blanks around it.
bool isX3dFalse(std::string_view text);

/// Throws a FileError with the node's line.
[[noreturn]] void refuseX3d(const FileBytes& file, const X3dNode& node, FileFault fault, std::string_view token);
} // namespace core::io
