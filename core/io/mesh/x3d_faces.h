#pragma once

#include "core/io/mesh/x3d_document.h"

#include <charconv>
#include <iterator>
#include <optional>
#include <unordered_map>

namespace core::io
{
/// Faces in the form of an IndexedFaceSet.
struct X3dFaces
{
    std::string coordIndex;     ///< vertex indices with -1 after each face
    std::string points;         ///< own points; empty: the points of the node's Coordinate are used
    std::vector<double> colors; ///< colours of the points, colorNumbers values each; may be empty
    int colorNumbers = 3;       ///< numbers of each colour: 3 or 4
};

/// Splits a list of numbers or indices at blanks and commas.
std::vector<std::string_view> x3dWords(std::string_view text);

/// Returns the numbers in an attribute, or in `usual` if it is missing. Throws FileError with the node's line.
std::vector<double> x3dNumbers(const FileBytes& file, const X3dNode& node, std::string_view name,
                               std::string_view usual = {});

/// Returns the only number in an attribute, as x3dNumbers(). Throws FileError if there is not exactly one.
double x3dNumber(const FileBytes& file, const X3dNode& node, std::string_view name, std::string_view usual);

/// Returns whether the node contains the points of a face set.
bool isX3dCoordinate(const X3dNode& node);

/// Reads the lists of Coordinate and Color nodes. Each node is read once, since many face sets may use it.
class X3dLists
{
public:
    /// `file`: not owned.
    explicit X3dLists(const FileBytes& file) : m_file(file) {}

    /// Returns the numbers of a node for which isX3dCoordinate() is true, three for each point. Throws FileError with
    /// its line.
    const std::vector<double>& points(const X3dNode& coordinate);
    /// Returns the numbers of a Color or ColorRGBA node. Throws FileError with its line.
    const std::vector<double>& colors(const X3dNode& color) { return read(color, "color"); }

private:
    const std::vector<double>& read(const X3dNode& node, std::string_view attribute);

    const FileBytes& m_file;
    std::unordered_map<const X3dNode*, std::vector<double>> m_numbers;
};

/// Returns the faces of an IndexedFaceSet, of sets, strips and fans of triangles or quads, or of an ElevationGrid. They
/// are oriented anticlockwise. Faces with fewer than three corners are left out. If they use less than half of the
/// Coordinate's points, those points are copied to the result. Empty for another node, or if the points are on the
/// globe (GeoCoordinate). Throws FileError with the node's line, also if an index is out of range or heights are
/// missing.
std::optional<X3dFaces> facesOfX3d(const FileBytes& file, const X3dNode& node, X3dLists& lists);

/// Appends a number to a list of numbers with blanks between them.
template <class Number> void appendNumber(std::string& text, Number number)
{
    char digits[32];
    text.append(text.empty() ? "" : " ");
    text.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
}
} // namespace core::io
