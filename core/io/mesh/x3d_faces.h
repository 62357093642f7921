#pragma once

#include "core/io/mesh/x3d_document.h"

#include <optional>
#include <unordered_map>

namespace core::io
{
/// Faces as an IndexedFaceSet has them.
struct X3dFaces
{
    std::string coordIndex;     ///< with -1 behind each face
    std::string points;         ///< if they are not those of the node's Coordinate
    std::vector<double> colors; ///< one for each point, or empty
    int colorNumbers = 3;       ///< of each colour: 3 or 4
};

/// Returns the parts of a list of numbers or indices, which blanks and commas divide.
std::vector<std::string_view> x3dWords(std::string_view text);

/// Returns the numbers of an attribute, or of `usual` where it is missing. Throws FileError with the node's line.
std::vector<double> x3dNumbers(const FileBytes& file, const X3dNode& node, std::string_view name,
                               std::string_view usual = {});

/// Returns what x3dNumbers() returns. Throws FileError where it is not one number.
double x3dNumber(const FileBytes& file, const X3dNode& node, std::string_view name, std::string_view usual);

/// Returns whether the node has the points of a face set.
bool isX3dCoordinate(const X3dNode& node);

/// Reads the lists of Coordinate and Color nodes, each node once: many face sets may use it.
class X3dLists
{
public:
    /// `file`: not owned.
    explicit X3dLists(const FileBytes& file) : m_file(file) {}

    /// Returns the numbers of a node that isX3dCoordinate(), three for each point. Throws FileError with its line.
    const std::vector<double>& points(const X3dNode& coordinate);
    /// Returns the numbers of a Color or a ColorRGBA. Throws FileError with its line.
    const std::vector<double>& colors(const X3dNode& color) { return read(color, "color"); }

private:
    const std::vector<double>& read(const X3dNode& node, std::string_view attribute);

    const FileBytes& m_file;
    std::unordered_map<const X3dNode*, std::vector<double>> m_numbers;
};

/// Returns the faces of a node that has some by lists of points: IndexedFaceSet, triangles and quads in sets, strips
/// and fans, and ElevationGrid. They are wound anticlockwise. Faces of fewer than three corners are left out. Where
/// they use less than half of the Coordinate's points, they have those as their own. Empty if it is no such node, or if
/// its points are on the globe (GeoCoordinate). Throws FileError with its line, also where an index is out of range, or
/// heights are missing.
std::optional<X3dFaces> facesOfX3d(const FileBytes& file, const X3dNode& node, X3dLists& lists);
} // namespace core::io
