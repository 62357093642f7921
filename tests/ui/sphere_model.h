#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/mesh/mesh_patch.h"
#include "core/sculpt/sculptor.h"

#include <cmath>
#include <numeric>

/// A ball about the origin in the form a viewer gets: patches for drawing, and hits found by testing each face.
struct SphereModel
{
    explicit SphereModel(double radius = 50, int subdivisions = 4) : mesh(core::icosphere(subdivisions, radius)) {}

    static core::DrawVertex draw(const core::Vec3f& p)
    {
        const core::Vec3f n = p.normalized() * 127;
        const auto byte = [](float x) { return static_cast<std::int8_t>(std::lround(x)); };
        return {p, {byte(n.x()), byte(n.y()), byte(n.z()), 0}, {200, 200, 200, core::DrawVertex::flat}};
    }

    core::Slot vertices() const { return static_cast<core::Slot>(mesh.points.size()); }
    core::Slot faces() const { return static_cast<core::Slot>(mesh.triangles.size()); }

    core::Box box() const
    {
        core::Box all;
        for (const core::Vec3f& p : mesh.points)
            all.extend(p.cast<double>());
        return all;
    }

    core::MeshPatch whole() const
    {
        core::MeshPatch patch = nothing();
        patch.whole = true;
        for (const core::Vec3f& p : mesh.points)
            patch.vertices.push_back(draw(p));
        patch.faces = mesh.triangles;
        patch.vertexSpans = {{0, vertices()}};
        patch.faceSpans = {{0, faces()}};
        return patch;
    }

    /// Returns an empty patch with the present slot counts.
    core::MeshPatch nothing() const
    {
        core::MeshPatch patch;
        patch.vertexSlots = patch.liveVertices = vertices();
        patch.faceSlots = patch.liveFaces = faces();
        return patch;
    }

    std::optional<core::SurfaceHit> hit(const core::Ray& ray) const
    {
        std::optional<core::SurfaceHit> nearest;
        for (core::Slot f = 0; f < faces(); ++f) {
            const core::Triangle& t = mesh.triangles[f];
            const core::Vec3 a = mesh.points[t[0]].cast<double>();
            const core::Vec3 ab = mesh.points[t[1]].cast<double>() - a, ac = mesh.points[t[2]].cast<double>() - a;
            const core::Vec3 h = ray.direction.cross(ac);
            const double d = ab.dot(h);
            if (d < 1e-12)
                continue;
            const core::Vec3 s = ray.origin - a, q = s.cross(ab);
            const double u = s.dot(h) / d, v = ray.direction.dot(q) / d, along = ac.dot(q) / d;
            if (u >= 0 && v >= 0 && u + v <= 1 && along > 0 && (!nearest || along < nearest->distance))
                nearest = core::SurfaceHit{ray.origin + along * ray.direction, ab.cross(ac).normalized(), along, f};
        }
        return nearest;
    }

    core::TriangleMesh mesh;
};
