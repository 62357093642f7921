#pragma once

#include "core/geometry/triangle_mesh.h"

class StrokeFuzzer;

/// Small named meshes for tests. Closed ones face outwards unless their name says otherwise. core::icosphere is the
/// ball.
namespace shapes
{
using core::Slot;
using core::TriangleMesh;
using core::Vec3f;

TriangleMesh tetrahedron();
TriangleMesh cube(float side);

struct TorusSize
{
    double ring = 3; ///< radius of the centre line
    double tube = 1;
    Slot around = 24; ///< vertices along the ring
    Slot across = 12; ///< vertices around the tube
};
TriangleMesh torus(const TorusSize& size = {});

/// A ball in a ball: the inner one faces inwards (a shell with a cavity, right) or outwards (wrong).
TriangleMesh nestedSpheres(bool innerFacesInwards);
/// A cone without its base.
TriangleMesh openCone(Slot corners);
/// Two tetrahedra that share one vertex.
TriangleMesh bowTie();
/// Three triangles at one edge.
TriangleMesh threeFacesAtEdge();
/// A cube one of whose faces runs the wrong way.
TriangleMesh cubeWithFlippedFace();
/// A tetrahedron whose apex went through its base: embedded, but inside out.
TriangleMesh pushedThroughTetrahedron();
/// Two cubes, a corner of one touching a face of the other from outside, without a common vertex.
TriangleMesh touchingCubes();
TriangleMesh sphereThroughSphere();

TriangleMesh moved(TriangleMesh mesh, const Vec3f& by);
TriangleMesh scaled(TriangleMesh mesh, float by);
/// Every face turned over.
TriangleMesh reversed(TriangleMesh mesh);
/// Both, with no vertex in common.
TriangleMesh together(TriangleMesh a, const TriangleMesh& b);
/// Takes the faces apart: nine tenths as large, with corners of their own, and moved along their normals by `distance`.
TriangleMesh takenApart(const TriangleMesh& mesh, float distance = 0);
/// Each coordinate moved by up to `amount`, by the seed.
TriangleMesh noisy(TriangleMesh mesh, float amount, unsigned seed);
/// Returns the same surface with vertices and triangles in another order, triangles with another corner first.
TriangleMesh shuffled(const TriangleMesh& mesh, StrokeFuzzer& random);
} // namespace shapes
