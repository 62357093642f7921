#pragma once

#include "core/io/mesh/format.h"

#include <deque>
#include <string>
#include <vector>

namespace core::io
{
/// A node of an X3D scene, as its XML has it.
struct X3dNode
{
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes; ///< name and value
    std::vector<const X3dNode*> children;
    const X3dNode* used = nullptr; ///< the node that it stands for, by USE
    std::uint64_t line = 0;

    /// Returns the node that it stands for: itself, unless it has a USE.
    const X3dNode& meant() const { return used ? *used : *this; }
    /// Returns the value, or an empty text.
    std::string_view text(std::string_view attribute) const;
    /// Returns whether the value is false, as isX3dFalse() has it.
    bool isFalse(std::string_view attribute) const;
};

/// An X3D file in its XML encoding, parsed as a tree by a library (expat). Elements lie at most 256 deep; a document
/// type is passed over, unless it declares something. Elements with the root's prefix go without it, and so do those
/// with a prefix of the root's namespace or of X3D's. Throws FileError with the line, also where a USE names nothing.
class X3dDocument
{
public:
    explicit X3dDocument(const FileBytes& file);

    const X3dNode& scene() const { return *m_scene; }
    /// Returns the metres in the unit of its lengths.
    double metres() const { return m_metres; }
    /// Returns whether it is of version 4 or later.
    bool isOfVersion4() const { return m_isOfVersion4; }
    /// Returns the radians in the unit of its angles.
    double radians() const { return m_radians; }

private:
    struct Parser;

    std::deque<X3dNode> m_nodes;
    const X3dNode* m_scene = nullptr;
    double m_metres = 1, m_radians = 1;
    bool m_isOfVersion4 = false;
};

/// Returns whether the text is false, in either case, blanks around it or not.
bool isX3dFalse(std::string_view text);

/// Throws a FileError that tells of the node's line.
[[noreturn]] void refuseX3d(const FileBytes& file, const X3dNode& node, FileFault fault, std::string_view token);
} // namespace core::io
