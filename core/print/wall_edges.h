#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"

#include <span>
#include <vector>

namespace core
{
/// Cosines between the normals of two faces. An edge that juts into the matter counts if it is bent by more than 20
/// degrees. An edge that juts out counts if the matter at it has less than 80 degrees.
constexpr double maxInwardCosine = 0.94, maxOutwardCosine = -0.17364817766693036;
/// Faces are opposite if the cosine between their normals is less: the normals are more than 120 degrees apart. The
/// margin exceeds the float error, so that the result for 60 degree edges does not depend on their position.
constexpr double maxOppositeCosine = -0.5 - 1e-4;

/// Bent edges and pointed corners of a solid, at which a wall may be thinnest. Their normals are all directions between
/// the normals of the faces that meet at them.
class WallEdges
{
public:
    /// A bent edge. Both faces are on one side of the edge, as seen along any of its normals.
    struct Edge
    {
        std::array<Slot, 2> vertices, faces;
        Vec3 along; ///< unit length
        /// Unit vectors in each face, across the edge; they point out of the face if the edge juts outwards.
        std::array<Vec3, 2> across;
        std::array<Vec3, 2> inward; ///< the faces' normals, turned into the matter
        bool isInward = false;      ///< the edge juts into the matter, as at the bottom of a groove
    };
    /// A corner whose edges are all on one side of it, as seen along its normals.
    struct Corner
    {
        Slot vertex, face;
        std::size_t first, count; ///< range of the corner's edges in m_star
        Vec3 inward;              ///< the mean normal
        bool isInward = false;
    };

    /// Finds edges and corners. In a mesh that is not closed only pairs of two faces form edges. Cost: a few passes
    /// over the faces.
    explicit WallEdges(const TriangleMesh& mesh);

    /// Returns whether the face has an edge or corner that may be opposite to faces that the face itself is not
    /// opposite to.
    bool isAt(Slot face) const { return m_isAt[face] != 0; }
    /// Returns whether a normal at a side of the face is more than 120 degrees away from the normal of another face.
    /// `inward`: inward normal of that other face. `side`: index of the corner across from the side.
    bool isOppositeSide(Slot face, std::size_t side, const Vec3& inward) const
    {
        const Slot edge = m_edgeOf[face][side];
        return edge != noSlot && isOpposite(m_edges[edge], inward);
    }
    /// Returns whether a normal at a vertex is exactly opposite to the normal of a face, whose inward normal is
    /// `inward`. Normals that are nearly opposite belong to the vertex's edges and faces.
    bool isOppositeCorner(Slot vertex, const Vec3& inward) const
    {
        const Slot corner = m_cornerOf[vertex];
        return corner != noSlot && isOpposite(m_corners[corner], inward);
    }

    /// Returns a box that bounds the inward normals at the edges and corners of a face; empty unless isAt(). Normals of
    /// an edge may be bounded by longer vectors of the same direction.
    FaceBox normalsAt(Slot face, const Triangle& corners) const;

    const std::vector<Edge>& edges() const { return m_edges; }
    const std::vector<Corner>& corners() const { return m_corners; }
    /// Returns unit vectors along all edges at a corner, pointing away from it; reversed if the corner juts outwards.
    std::span<const Vec3> edgesAt(const Corner& corner) const { return {m_star.data() + corner.first, corner.count}; }

private:
    static bool isOpposite(const Edge& edge, const Vec3& inward)
    {
        const double along = inward.dot(edge.along);
        return along * along < 1 - maxOppositeCosine * maxOppositeCosine && inward.dot(edge.across[0]) >= 0 &&
               inward.dot(edge.across[1]) >= 0;
    }
    bool isOpposite(const Corner& corner, const Vec3& inward) const;
    void findEdges(const TriangleMesh& mesh);
    void addEdge(const TriangleMesh& mesh, const std::array<Slot, 2>& faces, const std::array<Slot, 2>& sides);
    void findCorners(const TriangleMesh& mesh);
    void addStars(const TriangleMesh& mesh);

    std::vector<Edge> m_edges;
    std::vector<Corner> m_corners;
    std::vector<Vec3> m_star;                  ///< edge directions, grouped by corner
    std::vector<std::array<Slot, 3>> m_edgeOf; ///< edge at each side of each face, or noSlot
    std::vector<Slot> m_cornerOf;              ///< corner at each vertex, or noSlot
    std::vector<std::uint8_t> m_isAt;          ///< result of isAt() for each face
};
} // namespace core
