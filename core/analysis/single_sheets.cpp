#include "core/analysis/single_sheets.h"

#include "core/geometry/box_tree.h"
#include "core/geometry/face_geometry.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
using FaceCorners = std::array<Vec3, 3>;

/// Divides a triangle into n x n equal ones.
std::vector<FaceCorners> piecesOf(const FaceCorners& corners, int n)
{
    const Vec3 u = (corners[1] - corners[0]) / n, v = (corners[2] - corners[0]) / n;
    const auto at = [&](int i, int j) -> Vec3 { return corners[0] + i * u + j * v; };
    std::vector<FaceCorners> pieces;
    for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
            pieces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (i + j + 1 < n)
                pieces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return pieces;
}

/// Finds the sheets of a mesh at a place.
class Sheets
{
public:
    Sheets(const TriangleMesh& mesh, double nearby)
        : m_mesh(mesh)
        , m_nearby(nearby)
        , m_tree(faceBoxes(mesh.points, mesh.triangles))
    {}

    /// Returns whether, of all sheets that coincide at a piece of the face, the face itself is the one to keep.
    bool keeps(Slot face, const FaceCorners& piece) const
    {
        const Vec3 p = 0.31 * piece[0] + 0.24 * piece[1] + 0.45 * piece[2]; // not on an edge of another face's pieces
        const Vec3 normal = (piece[1] - piece[0]).cross(piece[2] - piece[0]).normalized();
        FaceBox box;
        box.extend((p.array() - m_nearby).cast<float>());
        box.extend((p.array() + m_nearby).cast<float>());
        int net = 1; // sheets that face this way less those that face the other way
        bool isFirst = true;
        m_tree.forEachMeeting(box, [&](Slot position) {
            const Slot other = m_tree.at(position);
            const int way = other == face ? 0 : wayAt(other, p, normal);
            net += way;
            isFirst = isFirst && (way <= 0 || other > face);
        });
        return net > 0 && isFirst;
    }

private:
    /// Returns 1 if a face coincides with a plane at a point of it, -1 if it does but faces the other way, otherwise 0.
    int wayAt(Slot face, const Vec3& p, const Vec3& normal) const
    {
        constexpr double parallel = 0.9; // cosine
        FaceCorners corners = cornersOf(m_mesh, face);
        for (Vec3& corner : corners)
            corner -= p;
        const auto& [a, b, c] = corners;
        const Vec3 across = (b - a).cross(c - a);
        if (!(std::abs(across.dot(normal)) > parallel * across.norm()))
            return 0;
        const double ofA = b.cross(c).dot(normal), ofB = c.cross(a).dot(normal), ofC = a.cross(b).dot(normal);
        const double sum = ofA + ofB + ofC;
        const bool isAbove = ofA * sum >= 0 && ofB * sum >= 0 && ofC * sum >= 0;
        const double height = (ofA * a + ofB * b + ofC * c).dot(normal) / sum;
        return !isAbove || std::abs(height) > m_nearby ? 0 : sum > 0 ? 1 : -1;
    }

    const TriangleMesh& m_mesh;
    double m_nearby;
    BoxTree m_tree;
};

/// Appends the part of a face that is kept.
void appendKept(const Sheets& sheets, Slot face, const FaceCorners& corners, bool isSmall,
                std::vector<FaceCorners>& kept)
{
    constexpr int coarse = 4, fine = 16; // a face is cut into 16 pieces for the test, 256 for the result
    std::vector<FaceCorners> pieces = isSmall ? std::vector{corners} : piecesOf(corners, coarse);
    const auto isKept = [&](const FaceCorners& piece) { return sheets.keeps(face, piece); };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(pieces, isKept));
    if (count == pieces.size())
        kept.push_back(corners);
    else if (count > 0)
        std::ranges::copy_if(piecesOf(corners, fine), std::back_inserter(kept), isKept);
}
} // namespace

TriangleMesh singleSheets(const TriangleMesh& mesh, double nearby)
{
    constexpr double small = 0.02; // share of the mesh's size
    constexpr std::size_t perChunk = 64;
    const double size = boxOf(mesh).sizes().maxCoeff();
    const Sheets sheets(mesh, nearby);
    const std::vector<FaceCorners> kept = joinChunks<std::vector<FaceCorners>>(
        mesh.triangles.size(), perChunk, [&](std::size_t begin, std::size_t end, std::vector<FaceCorners>& part) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto face = static_cast<Slot>(i);
                const FaceCorners corners = cornersOf(mesh, face);
                const auto& [a, b, c] = corners;
                const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
                appendKept(sheets, face, corners, longest < small * size, part);
            }
        });
    TriangleMesh single;
    for (const FaceCorners& corners : kept) {
        const auto first = static_cast<Slot>(single.points.size());
        for (const Vec3& corner : corners)
            single.points.push_back(corner.cast<float>());
        single.triangles.push_back({first, first + 1, first + 2});
    }
    return single;
}
} // namespace core
