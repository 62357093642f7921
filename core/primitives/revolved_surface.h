#pragma once

#include "core/geometry/triangle_mesh.h"

#include <vector>

namespace core
{
/// A point of a profile that is turned around the y axis.
struct ProfilePoint
{
    double radius = 0, height = 0; ///< distance from the axis, and y; mm

    friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

/// Returns the surface that a profile makes when it turns around the y axis, facing outwards. Each point becomes a ring
/// with edges of about `edge` mm; a point on the axis becomes one vertex. The number of vertices of a ring is a
/// multiple of 4, at least 8. Neighbouring points of the profile should be about `edge` apart.
///
/// `isClosed`: the last point is joined to the first, and none is on the axis. Otherwise only the first and the last
/// point are on the axis, and both must be. Precondition: the profile does not cross itself.
///
/// Symmetric about the planes x = 0 and z = 0 bit for bit; also about y = 0 if the profile is, and has points there.
/// The result has the same bits on every machine.
TriangleMesh revolvedSurface(const std::vector<ProfilePoint>& profile, bool isClosed, double edge);
} // namespace core
