#pragma once

#include "core/print/wall_rays.h"
#include "core/print/wall_thickness.h"

namespace core
{
/// Measures walls between ridges: edges and corners that jut into the matter, as the bottoms of two grooves on both
/// sides of a plate do. The faces at the ridges need not be opposite.
class WallRidges
{
public:
    /// Keeps references to the edges and the rays.
    WallRidges(const TriangleMesh& mesh, const WallEdges& edges, const WallRays& rays);

    /// Returns whether a ridge may be opposite some point of a face, at most `farthest` away from it. Does not test
    /// whether it is visible. `inward`: unit normal of the face, turned into the matter.
    bool mayBeOpposite(const std::array<Vec3, 3>& face, const Vec3& inward, double farthest) const;
    /// Returns pieces of ridges, and corners, that are thinner than their faces, sorted by face. `ofFaces`: thickness
    /// of each face. `thickest`: walls thicker than this are not searched, in the model's unit. Uses all cores; the
    /// result does not depend on their number. Cost: a few microseconds for each pair of ridges that face each other
    /// within the thickest wall.
    std::vector<WallRidge> measure(const std::vector<float>& ofFaces, double thickest, const JobControl& control) const;

private:
    struct Segment
    {
        Vec3 from, to;

        double length() const { return (to - from).norm(); }
        Vec3 middle() const { return (from + to) / 2; }
        Box box() const;
    };
    /// An edge or a corner, and roughly the direction of its normals.
    struct Ridge
    {
        Segment segment;
        Slot edge = noSlot, corner = noSlot; ///< one of the two is noSlot
        std::array<Slot, 2> vertices, faces;
        Vec3 mean; ///< mean of the ridge's normals
        /// Lower bound of the cosine between `mean` and the chords that may leave the ridge; negative: no bound.
        double minCosine;
    };
    struct Place
    {
        double diameter;
        Vec3 point = Vec3::Zero();
    };

    std::vector<FaceBox> addRidges(const TriangleMesh& mesh);
    void measure(Slot ridge, const std::vector<float>& ofFaces, double thickest, std::vector<WallRidge>& found) const;
    Place thinnestOf(const Ridge& ridge, const Segment& piece, double thickest) const;
    void search(const Ridge& ridge, const Segment& piece, const Ridge& other, Place& thinnest) const;
    bool mayLook(const Ridge& ridge, const Segment& from, const Segment& to, double sign, double distance) const;
    double cosineOf(const Ridge& ridge, const Vec3& chord) const;

    const WallEdges& m_edges;
    const WallRays& m_rays;
    std::vector<Ridge> m_ridges;
    BoxTree m_tree;
};
} // namespace core
