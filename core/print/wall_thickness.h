#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <vector>

namespace core
{
/// A triangle within a face of varying thickness.
struct WallPart
{
    Slot face = 0;
    std::array<Vec3f, 3> corners;
    float share = 1; ///< share of the face's area, 0 to 1
    /// Thickness at the thinnest place, at most 4 % too large, and approximately the largest thickness. `most` is
    /// infinity if somewhere no face is opposite or the opposite face is much farther away.
    float least = 0, most = 0;
    Vec3f thinnest = Vec3f::Zero();

    /// Returns the share of the part, 0 to 1, that is thinner than `thickness`. Assumes a linear increase from least to
    /// most.
    double shareBelow(double thickness) const;
};

/// A piece of an edge, or a corner, that juts into the matter. Its distance to another ridge is smaller than the
/// thickness at its faces.
struct WallRidge
{
    Slot face = 0; ///< a face at the ridge
    std::array<Vec3f, 2> ends;
    float least = 0; ///< thickness at the thinnest place, at most 1 % too large
    Vec3f thinnest = Vec3f::Zero();

    /// Returns the area of a strip along the ridge that is as wide as the wall is thick: balls of that size touch it.
    double area() const;
};

/// Thickness of the matter, in the model's unit. It is the diameter of a ball that touches a point of the surface from
/// within, along a normal. On the other side the ball reaches a visible point whose normal is more than 120 degrees
/// away. The chord between the two points is within 30 degrees of the normal at the first point.
///   - A face has one normal. An edge has all normals between those of its faces, and so has a corner all of whose
///     edges are on one side.
///   - An edge counts if it juts into the matter and is bent by more than 20 degrees, as the bottom of a groove is. It
///     also counts if the matter at it has less than 80 degrees, as at the edges of a thin three-sided spike.
///   - A corner counts if it juts in and its edges rise by more than 6 degrees, as the tip of a pit. It also counts if
///     it juts out at an edge of less than 80 degrees.
///   - Faces are measured against faces, edges and corners. Edges and corners that jut into the matter are also
///     measured against each other; then the chord must be within 30 degrees of a normal at both ends.
///   - An edge sharper than 60 degrees is a thin place, and so is the tip of a sharp spike. The thickness falls towards
///     it and is followed down to about 0.1, in the model's unit.
/// Infinity where nothing is opposite, and for a face without area.
struct WallThickness
{
    /// Thickness of each face at its centre: the ball that no visible opposite face reaches into, at most 4 % too large
    /// (7 % for meshes of more than 100,000 faces).
    std::vector<float> atCentres;
    /// Parts of faces whose thickness at the centre is not enough, because they are large for it or have a ridge
    /// opposite. Sorted by face; together the parts of a face cover it. A face is divided where it is thinner than the
    /// largest ball. Division ends when the thickness within a part differs by less than a tenth (a fifth for more than
    /// 100,000 faces), or when the face has 200,000 / (number of faces) parts, at least 4 and at most 4096. Of more
    /// than 100,000 faces those at the thinnest place are parts, too, if they are thinner than at their centres.
    std::vector<WallPart> parts;
    /// Ridges that are thinner than the faces at them, sorted by face. Those thicker than the largest ball are missing
    /// if any face is thinner.
    std::vector<WallRidge> ridges;
};

/// Measures wall thickness. Precondition: the model bounds a solid. Balls at centres are at most `largestBall` in
/// diameter; where none is found, the result of the rays is used. Uses all cores; the result does not depend on their
/// number. The result of a cancelled call must not be used. Cost: see fettle_bench; memory: 200 bytes per face.
WallThickness wallThickness(const TriangleMesh& mesh, double largestBall, const JobControl& control = {});
} // namespace core
