// Sources: Web3D Consortium, ISO/IEC 19775-1, clauses 11 (rendering: triangle sets), 13 (geometry: ElevationGrid,
// IndexedFaceSet), 32 (CAD: quad sets).
#include "core/io/mesh/x3d_faces.h"

#include "core/io/mesh/number_parsing.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <unordered_map>

namespace core::io
{
namespace
{
using Index = std::int32_t;
using Face = std::vector<Index>;

constexpr std::string_view blanks = " \t\r\n,";

[[noreturn]] void refuseIndex(const FileBytes& file, const X3dNode& node, std::string_view index, std::size_t count)
{
    FileError error = withCounts(errorWithToken(FileErrorKind::IndexOutOfRange, file, index), count);
    error.place = {FilePlace::Unit::Line, node.line};
    throw error;
}

/// Returns the indices in an attribute, each -1 or less than `count`.
std::vector<Index> indicesIn(const FileBytes& file, const X3dNode& node, std::string_view attribute, std::size_t count)
{
    std::vector<Index> indices;
    for (const std::string_view word : x3dWords(node.text(attribute))) {
        const auto value = parseInteger(word);
        if (!value || *value < -1)
            refuseX3d(file, node, FileFault::VertexIndex, word);
        if (*value >= static_cast<std::int64_t>(count))
            refuseIndex(file, node, word, count);
        indices.push_back(static_cast<Index>(*value));
    }
    return indices;
}

/// Returns the node's child with this name; null if there is none.
const X3dNode* childOf(const X3dNode& node, std::string_view name)
{
    for (const X3dNode* child : node.children)
        if (child->meant().name == name)
            return &child->meant();
    return nullptr;
}

/// Returns `count` consecutive indices.
std::vector<Index> numbersOf(std::size_t count, std::size_t first = 0)
{
    std::vector<Index> numbers(count);
    std::iota(numbers.begin(), numbers.end(), static_cast<Index>(first));
    return numbers;
}

/// Splits the list at each -1.
std::vector<Face> runsOf(const std::vector<Index>& indices)
{
    std::vector<Face> runs(1);
    for (const Index index : indices)
        if (index < 0)
            runs.emplace_back();
        else
            runs.back().push_back(index);
    return runs;
}

std::vector<Face> inPieces(const std::vector<Index>& indices, std::size_t corners)
{
    std::vector<Face> faces;
    for (std::size_t i = 0; i + corners <= indices.size(); i += corners)
        faces.emplace_back(indices.begin() + static_cast<std::ptrdiff_t>(i),
                           indices.begin() + static_cast<std::ptrdiff_t>(i + corners));
    return faces;
}

/// Splits consecutive points into runs with the lengths in the attribute.
std::vector<Face> countedRuns(const FileBytes& file, const X3dNode& node, std::string_view attribute, std::size_t count)
{
    std::vector<Face> runs;
    std::size_t first = 0;
    for (const std::string_view word : x3dWords(node.text(attribute))) {
        const std::int64_t length = parseInteger(word).value_or(-1);
        if (length < 0)
            refuseX3d(file, node, FileFault::Count, word);
        if (static_cast<std::uint64_t>(length) > count - first)
            refuseIndex(file, node, std::to_string(count), count);
        runs.push_back(numbersOf(static_cast<std::size_t>(length), first));
        first += runs.back().size();
    }
    return runs;
}

std::vector<Face> trianglesOf(const std::vector<Face>& runs, bool areFans)
{
    std::vector<Face> triangles;
    for (const Face& run : runs)
        for (std::size_t i = 2; i < run.size(); ++i) {
            if (areFans)
                triangles.push_back({run[0], run[i - 1], run[i]});
            else if (i % 2 == 0)
                triangles.push_back({run[i - 2], run[i - 1], run[i]});
            else
                triangles.push_back({run[i - 1], run[i - 2], run[i]});
        }
    return triangles;
}

std::optional<std::vector<Face>> facesOf(const FileBytes& file, const X3dNode& node, std::size_t points)
{
    const std::string_view name = node.name;
    const auto indices = [&] { return indicesIn(file, node, "index", points); };
    if (name == "IndexedFaceSet")
        return runsOf(indicesIn(file, node, "coordIndex", points));
    if (name == "IndexedTriangleSet")
        return inPieces(indices(), 3);
    if (name == "IndexedQuadSet")
        return inPieces(indices(), 4);
    if (name == "TriangleSet")
        return inPieces(numbersOf(points), 3);
    if (name == "QuadSet")
        return inPieces(numbersOf(points), 4);
    if (name == "IndexedTriangleStripSet" || name == "IndexedTriangleFanSet")
        return trianglesOf(runsOf(indices()), name == "IndexedTriangleFanSet");
    if (name == "TriangleStripSet")
        return trianglesOf(countedRuns(file, node, "stripCount", points), false);
    if (name == "TriangleFanSet")
        return trianglesOf(countedRuns(file, node, "fanCount", points), true);
    return std::nullopt;
}

std::size_t countIn(const FileBytes& file, const X3dNode& node, std::string_view name)
{
    const std::vector<std::string_view> words = x3dWords(node.text(name));
    const auto count = words.empty() ? 0 : parseInteger(words.front()).value_or(-1);
    if (count < 0)
        refuseX3d(file, node, FileFault::Count, words.front());
    if (words.size() > 1)
        refuseX3d(file, node, FileFault::NotNumbers, name);
    return static_cast<std::size_t>(count);
}

/// The points of an ElevationGrid as text, and its quads, row by row along x.
struct Grid
{
    std::string points;
    std::vector<Face> faces;
    std::size_t count = 0; ///< number of points
};

Grid gridOf(const FileBytes& file, const X3dNode& node)
{
    const std::vector<double> heights = x3dNumbers(file, node, "height");
    const std::size_t alongX = countIn(file, node, "xDimension"), alongZ = countIn(file, node, "zDimension");
    const double stepX = x3dNumber(file, node, "xSpacing", "1"), stepZ = x3dNumber(file, node, "zSpacing", "1");
    Grid grid;
    if (alongX < 2 || alongZ < 2)
        return grid;
    if (alongZ > heights.size() / alongX)
        refuseX3d(file, node, FileFault::NotNumbers, "height");
    grid.count = alongX * alongZ;
    for (std::size_t i = 0; i < grid.count; ++i)
        for (const double number :
             {stepX * static_cast<double>(i % alongX), heights[i], stepZ * static_cast<double>(i / alongX)})
            appendNumber(grid.points, number);
    const auto row = static_cast<Index>(alongX);
    for (std::size_t i = 0; i + alongX < grid.count; ++i)
        if (const auto first = static_cast<Index>(i); (i + 1) % alongX != 0)
            grid.faces.push_back({first, first + row, first + row + 1, first + 1});
    return grid;
}

std::string written(const std::vector<Face>& faces, bool isReversed)
{
    std::string text;
    const auto add = [&text](Index index) { appendNumber(text, index); };
    for (const Face& face : faces) {
        if (face.size() < 3)
            continue;
        if (isReversed)
            std::for_each(face.rbegin(), face.rend(), add);
        else
            std::for_each(face.begin(), face.end(), add);
        add(-1);
    }
    return text;
}

/// Returns for each point the index of its colour, or -1. An index in the node applies to a corner of a face, or to a
/// whole face. If a point has several colours, the last one counts. `used`: the result of keepUsed().
std::vector<Index> colorsOfPoints(const FileBytes& file, const X3dNode& node, const std::vector<Face>& faces,
                                  const std::vector<Index>& used, std::size_t points, std::size_t colors)
{
    std::vector<Index> result(points, -1);
    const bool isOfFaces = node.isFalse("colorPerVertex");
    const std::vector<Index> indices = indicesIn(file, node, "colorIndex", colors);
    const std::vector<Face> corners = isOfFaces ? std::vector<Face>() : runsOf(indices);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t k = 0; k < faces[i].size() && faces[i].size() >= 3; ++k) { // smaller faces are left out
            const Index point = faces[i][k];
            if (indices.empty())
                result[point] = isOfFaces ? static_cast<Index>(i) : used.empty() ? point : used[point];
            else if (isOfFaces)
                result[point] = i < indices.size() ? indices[i] : -1;
            else if (i < corners.size() && k < corners[i].size())
                result[point] = corners[i][k];
        }
    return result;
}

void addColors(const FileBytes& file, const X3dNode& node, const std::vector<Face>& faces,
               const std::vector<Index>& used, std::size_t points, X3dLists& lists, X3dFaces& to)
{
    const X3dNode* const plain = childOf(node, "Color");
    const X3dNode* const color = plain ? plain : childOf(node, "ColorRGBA");
    if (!color)
        return;
    const std::vector<double>& numbers = lists.colors(*color);
    to.colorNumbers = plain ? 3 : 4;
    const std::size_t each = plain ? 3 : 4, count = numbers.size() / each;
    if (count == 0)
        return;
    for (const Index index : colorsOfPoints(file, node, faces, used, points, count))
        for (std::size_t k = 0; k < each; ++k) {
            const bool isKnown = index >= 0 && static_cast<std::size_t>(index) < count;
            to.colors.push_back(isKnown ? numbers[static_cast<std::size_t>(index) * each + k] : 1);
        }
}

/// Renumbers the faces' points if they use less than half of `count` points, and returns the used points. Otherwise
/// returns an empty list and changes nothing. Cost: linear in the faces only, because many sets may share a large list
/// of points.
std::vector<Index> keepUsed(std::vector<Face>& faces, std::size_t count)
{
    std::unordered_map<Index, Index> own;
    std::vector<Index> used;
    for (const Face& face : faces)
        for (const Index point : face)
            if (face.size() >= 3 && own.try_emplace(point, static_cast<Index>(used.size())).second)
                used.push_back(point);
    if (2 * used.size() >= count)
        return {};
    for (Face& face : faces)
        for (Index& point : face)
            if (face.size() >= 3)
                point = own.at(point);
    return used;
}
} // namespace

std::vector<std::string_view> x3dWords(std::string_view text)
{
    std::vector<std::string_view> words;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (text.empty())
            return words;
        words.push_back(text.substr(0, text.find_first_of(blanks)));
        text.remove_prefix(words.back().size());
    }
}

std::vector<double> x3dNumbers(const FileBytes& file, const X3dNode& node, std::string_view name,
                               std::string_view usual)
{
    std::vector<double> numbers;
    const std::string_view text = node.text(name);
    for (const std::string_view word : x3dWords(text.empty() ? usual : text)) {
        const auto value = parseDouble(word);
        if (!value || !std::isfinite(*value))
            refuseX3d(file, node, FileFault::Number, word);
        numbers.push_back(*value);
    }
    return numbers;
}

double x3dNumber(const FileBytes& file, const X3dNode& node, std::string_view name, std::string_view usual)
{
    const std::vector<double> numbers = x3dNumbers(file, node, name, usual);
    if (numbers.size() != 1)
        refuseX3d(file, node, FileFault::NotNumbers, name);
    return numbers.front();
}

bool isX3dCoordinate(const X3dNode& node)
{
    return node.name == "Coordinate" || node.name == "CoordinateDouble";
}

const std::vector<double>& X3dLists::points(const X3dNode& coordinate)
{
    const std::vector<double>& numbers = read(coordinate, "point");
    if (numbers.size() % 3 != 0)
        refuseX3d(m_file, coordinate, FileFault::NotNumbers, "point");
    return numbers;
}

const std::vector<double>& X3dLists::read(const X3dNode& node, std::string_view attribute)
{
    const auto [found, isNew] = m_numbers.try_emplace(&node);
    if (isNew)
        found->second = x3dNumbers(m_file, node, attribute);
    return found->second;
}

std::optional<X3dFaces> facesOfX3d(const FileBytes& file, const X3dNode& node, X3dLists& lists)
{
    if (childOf(node, "GeoCoordinate"))
        return std::nullopt;
    const auto coordinate = std::find_if(node.children.begin(), node.children.end(),
                                         [](const X3dNode* child) { return isX3dCoordinate(child->meant()); });
    std::span<const double> numbers;
    if (coordinate != node.children.end())
        numbers = lists.points((*coordinate)->meant());
    X3dFaces result;
    std::size_t count = numbers.size() / 3;
    std::optional<std::vector<Face>> faces;
    std::vector<Index> used; // empty: all points are used
    if (node.name == "ElevationGrid") {
        Grid grid = gridOf(file, node);
        count = grid.count;
        faces = std::move(grid.faces);
        result.points = std::move(grid.points);
    } else if ((faces = facesOf(file, node, count))) {
        used = keepUsed(*faces, count);
    }
    if (!faces)
        return std::nullopt;
    for (const Index point : used)
        for (std::size_t k = 0; k < 3; ++k)
            appendNumber(result.points, numbers[3 * static_cast<std::size_t>(point) + k]);
    const auto isNone = [](const Face& face) { return face.size() < 3; };
    if (!std::all_of(faces->begin(), faces->end(), isNone))
        addColors(file, node, *faces, used, used.empty() ? count : used.size(), lists, result);
    result.coordIndex = written(*faces, node.isFalse("ccw"));
    return result;
}
} // namespace core::io
