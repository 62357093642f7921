#include "surface_distance.h"

#include "face_geometry.h"
#include "surface_query.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace core
{
namespace
{
constexpr double sampleCount = 200'000;

double areaOf(const std::array<Vec3, 3>& t)
{
    return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

class Nearest
{
public:
    explicit Nearest(const TriangleMesh& mesh) : m_mesh(mesh), m_tree(faceBoxes(mesh.points, mesh.triangles)) {}

    /// `hint`: no less than the distance; the smaller, the faster.
    double distance(const Vec3& p, double hint) const
    {
        double best = hint;
        const auto reach = [&](const FaceBox& box) {
            const Eigen::Array3d below = box.min.cast<double>() - p.array(), above = p.array() - box.max.cast<double>();
            return below.max(above).max(0.0).matrix().norm();
        };
        m_tree.forEachNear(reach, hint, [&](Slot position) {
            best = std::min(best, (nearestInTriangle(p, cornersOf(m_mesh, m_tree.at(position))) - p).norm());
            return best;
        });
        return best;
    }

private:
    const TriangleMesh& m_mesh;
    BoxTree m_tree;
};

/// Evenly in the triangle: the R2 sequence (Roberts 2018), folded.
Vec3 sampleIn(const std::array<Vec3, 3>& t, std::size_t i)
{
    constexpr double a = 0.7548776662466927, b = 0.5698402909980532;
    double u = 0.5 + a * static_cast<double>(i), v = 0.5 + b * static_cast<double>(i);
    u -= std::floor(u);
    v -= std::floor(v);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
}

struct Sums
{
    double largest = 0, sum = 0;
    std::size_t count = 0;

    void add(double distance)
    {
        largest = std::max(largest, distance);
        sum += distance;
        ++count;
    }
    void add(const Sums& other)
    {
        largest = std::max(largest, other.largest);
        sum += other.sum;
        count += other.count;
    }
};

/// Distances of points that lie near each other: none is farther than the last one's nearest point.
class Measuring
{
public:
    explicit Measuring(const Nearest& to) : m_to(to) {}

    double operator()(const Vec3& p)
    {
        constexpr double slack = 1 + 1e-9;
        m_distance = m_to.distance(p, slack * (m_distance + (p - m_last).norm()));
        m_last = p;
        return m_distance;
    }

private:
    const Nearest& m_to;
    Vec3 m_last = Vec3::Zero();
    double m_distance = std::numeric_limits<double>::infinity();
};

template <typename Measure>
Sums summed(std::size_t count, const Nearest& nearest, const JobWatch& watch, Measure measure)
{
    constexpr std::size_t perChunk = 512;
    std::vector<Sums> parts(chunksOf(count, perChunk));
    forEachChunk(count, perChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        Measuring measuring(nearest);
        for (std::size_t i = begin; i < end && !watch.stopped(); ++i)
            parts[chunk].add(measure(i, measuring));
    });
    Sums all;
    for (const Sums& part : parts)
        all.add(part);
    return all;
}
/// Evenly over the surface, face by face: how many samples there are in the faces up to and with each.
std::vector<std::size_t> samplesUpTo(const TriangleMesh& mesh)
{
    std::vector<double> area;
    double sum = 0;
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        area.push_back(sum += areaOf(cornersOf(mesh, f)));
    std::vector<std::size_t> samples;
    for (const double upTo : area)
        samples.push_back(sum > 0 ? static_cast<std::size_t>(sampleCount * (upTo / sum)) : 0);
    return samples;
}

/// The corners that the other surface does not have as they are.
std::vector<Vec3f> cornersBeside(const TriangleMesh& a, const TriangleMesh& b)
{
    const auto isLess = [](const Vec3f& p, const Vec3f& q) {
        return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z());
    };
    const auto cornersOf = [&](const TriangleMesh& mesh) {
        std::vector<bool> isUsed(mesh.points.size(), false);
        for (const Triangle& t : mesh.triangles)
            for (const Slot v : t)
                isUsed[v] = true;
        std::vector<Vec3f> points;
        for (std::size_t v = 0; v < isUsed.size(); ++v)
            if (isUsed[v])
                points.push_back(mesh.points[v]);
        std::ranges::sort(points, isLess);
        return points;
    };
    std::vector<Vec3f> result;
    std::ranges::set_difference(cornersOf(a), cornersOf(b), std::back_inserter(result), isLess);
    return result;
}
} // namespace

SurfaceDistance distanceFrom(const TriangleMesh& a, const TriangleMesh& b, const JobWatch& watch)
{
    const Nearest nearest(b);
    const std::vector<std::size_t> samples = samplesUpTo(a);
    const Sums over = summed(a.triangles.size(), nearest, watch, [&](std::size_t f, Measuring& measuring) {
        Sums face;
        const std::array<Vec3, 3> triangle = cornersOf(a, static_cast<Slot>(f));
        for (std::size_t i = f == 0 ? 0 : samples[f - 1]; i < samples[f]; ++i)
            face.add(measuring(sampleIn(triangle, i)));
        return face;
    });
    const std::vector<Vec3f> corners = cornersBeside(a, b);
    const Sums at = summed(corners.size(), nearest, watch, [&](std::size_t i, Measuring& measuring) {
        Sums corner;
        corner.add(measuring(corners[i].cast<double>()));
        return corner;
    });
    return {std::max(over.largest, at.largest), over.count > 0 ? over.sum / static_cast<double>(over.count) : 0};
}
} // namespace core
