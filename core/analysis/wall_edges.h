#pragma once

#include "core/geometry/triangle_mesh.h"

#include <span>
#include <vector>

namespace core
{
/// Cosines between the normals of two faces: an edge that juts into the matter counts if it is bent by more than 20
/// degrees, one that juts out of it if the matter at it has less than 80 degrees.
constexpr double maxInwardCosine = 0.94, maxOutwardCosine = -0.17364817766693036;
/// Faces are opposite if the cosine between their normals is less: they look more than 120 degrees away from each
/// other, by more than what floats are off by, so that 60 degree edges are the same whichever way they are turned.
constexpr double maxOppositeCosine = -0.5 - 1e-4;

/// Bent edges and pointed corners of a solid, at which a wall may be thinnest. Their normals are all directions between
/// those of the faces that meet there.
class WallEdges
{
public:
    /// A bent edge. Its faces lie on one side of it, as seen along any of its normals.
    struct Edge
    {
        std::array<Slot, 2> vertices, faces;
        Vec3 along;                 ///< unit length
        std::array<Vec3, 2> across; ///< in each face, across the edge, unit length; out of it if the edge juts outwards
        std::array<Vec3, 2> inward; ///< the faces' normals, turned into the matter
        bool isInward = false;      ///< juts into the matter, as that at the ground of a groove does
    };
    /// A corner all of whose edges lie on one side, as seen along its normals.
    struct Corner
    {
        Slot vertex, face;
        std::size_t first, count; ///< of its edges
        Vec3 inward;              ///< the mean normal
        bool isInward = false;
    };

    /// Costs: a few passes over the faces. A mesh that is not closed has edges only where two faces meet.
    explicit WallEdges(const TriangleMesh& mesh);

    /// Returns whether a face has an edge or corner that may be opposite to faces which it is not opposite to itself.
    bool isAt(Slot face) const { return m_isAt[face] != 0; }
    /// Returns whether one of the normals at a side of the face, named by the corner across from it, is opposite: more
    /// than 120 degrees away from the normal of the face that looks `inward`.
    bool isOppositeSide(Slot face, std::size_t side, const Vec3& inward) const
    {
        const Slot edge = m_edgeOf[face][side];
        return edge != noSlot && isOpposite(m_edges[edge], inward);
    }
    /// Returns whether one of the normals at a vertex is `inward` itself; what is near to it is an edge's or a face's.
    bool isOppositeCorner(Slot vertex, const Vec3& inward) const
    {
        const Slot corner = m_cornerOf[vertex];
        return corner != noSlot && isOpposite(m_corners[corner], inward);
    }

    const std::vector<Edge>& edges() const { return m_edges; }
    const std::vector<Corner>& corners() const { return m_corners; }
    /// The edges at a corner, bent or not, from it; turned round at one that juts outwards.
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
    std::vector<Vec3> m_star;                  ///< by corner
    std::vector<std::array<Slot, 3>> m_edgeOf; ///< by face and side
    std::vector<Slot> m_cornerOf;              ///< by vertex
    std::vector<std::uint8_t> m_isAt;          ///< by face
};
} // namespace core
