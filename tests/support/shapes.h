#pragma once

#include "core/geometry/triangle_mesh.h"

class StrokeFuzzer;

/// Small named meshes for tests. Closed ones face outwards unless their name says otherwise. For a ball, use
/// core::icosphere.
namespace shapes
{
using core::Slot;
using core::TriangleMesh;
using core::Vec3f;

TriangleMesh tetrahedron();
TriangleMesh cube(float side);

struct TorusSize
{
    double ring = 3; ///< radius of the centre line of the ring
    double tube = 1;
    Slot around = 24; ///< vertices along the ring
    Slot across = 12; ///< vertices around the tube
};
TriangleMesh torus(const TorusSize& size = {});

/// Returns a ball inside a ball. The inner one faces inwards (a correct cavity) or outwards (a defect).
TriangleMesh nestedSpheres(bool innerFacesInwards);
/// Returns a cone without its base.
TriangleMesh openCone(Slot corners);
/// Returns two tetrahedra that share one vertex.
TriangleMesh bowTie();
/// Returns three triangles that share one edge.
TriangleMesh threeFacesAtEdge();
/// Returns a cube in which one face has reversed orientation.
TriangleMesh cubeWithFlippedFace();
/// Returns a tetrahedron whose apex was pushed through its base: free of self-intersections, but inside out.
TriangleMesh pushedThroughTetrahedron();
/// Returns two cubes without a common vertex. A corner of one touches a face of the other from outside.
TriangleMesh touchingCubes();
TriangleMesh sphereThroughSphere();

TriangleMesh moved(TriangleMesh mesh, const Vec3f& by);
TriangleMesh scaled(TriangleMesh mesh, float by);
/// Returns the mesh with every face's orientation reversed.
TriangleMesh reversed(TriangleMesh mesh);
/// Returns one mesh that contains both meshes, without common vertices.
TriangleMesh together(TriangleMesh a, const TriangleMesh& b);
/// Returns unconnected triangles: each face scaled by 0.9 about its centre and moved along its normal by `distance`.
TriangleMesh takenApart(const TriangleMesh& mesh, float distance = 0);
/// Returns the mesh with each coordinate displaced by up to `amount`. The seed determines the displacements.
TriangleMesh noisy(TriangleMesh mesh, float amount, unsigned seed);
/// Returns the same surface with vertices and triangles in random order, and with a random first corner in each
/// triangle.
TriangleMesh shuffled(const TriangleMesh& mesh, StrokeFuzzer& random);
} // namespace shapes
