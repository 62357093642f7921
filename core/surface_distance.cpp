#include "surface_distance.h"

#include "box_tree.h"
#include "parallel.h"
#include "surface_query.h"

#include <cmath>

namespace core
{
namespace
{
constexpr double fewestSamples = 200'000;

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, Slot face)
{
    const Triangle& t = mesh.triangles[face];
    return {mesh.points[t[0]].cast<double>(), mesh.points[t[1]].cast<double>(), mesh.points[t[2]].cast<double>()};
}

double areaOf(const std::array<Vec3, 3>& t)
{
    return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

class Nearest
{
public:
    explicit Nearest(const TriangleMesh& mesh) : m_mesh(mesh), m_tree(boxesOf(mesh)) {}

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
    static std::vector<FaceBox> boxesOf(const TriangleMesh& mesh)
    {
        std::vector<FaceBox> boxes(mesh.triangles.size());
        for (std::size_t f = 0; f < boxes.size(); ++f)
            for (const Slot corner : mesh.triangles[f])
                boxes[f].extend(mesh.points[corner].array());
        return boxes;
    }

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
    double largest = 0, weighted = 0, area = 0;

    void add(const Sums& other)
    {
        largest = std::max(largest, other.largest);
        weighted += other.weighted;
        area += other.area;
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

Sums measureFace(const std::array<Vec3, 3>& t, double areaPerSample, Measuring& measure)
{
    Sums sums;
    sums.area = areaOf(t);
    const auto samples = static_cast<std::size_t>(std::ceil(std::max(1.0, sums.area / areaPerSample)));
    for (std::size_t i = 0; i < samples; ++i) {
        const double distance = measure(sampleIn(t, i));
        sums.largest = std::max(sums.largest, distance);
        sums.weighted += distance * sums.area / static_cast<double>(samples);
    }
    return sums;
}

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
} // namespace

SurfaceDistance distanceFrom(const TriangleMesh& a, const TriangleMesh& b, const JobWatch& watch)
{
    const Nearest nearest(b);
    double area = 0;
    std::vector<bool> isUsed(a.points.size(), false);
    for (Slot f = 0; f < a.triangles.size(); ++f) {
        area += areaOf(cornersOf(a, f));
        for (const Slot v : a.triangles[f])
            isUsed[v] = true;
    }
    const double areaPerSample = std::max(area / fewestSamples, std::numeric_limits<double>::min());
    Sums sums = summed(a.triangles.size(), nearest, watch, [&](std::size_t f, Measuring& measuring) {
        return measureFace(cornersOf(a, static_cast<Slot>(f)), areaPerSample, measuring);
    });
    sums.add(summed(a.points.size(), nearest, watch, [&](std::size_t v, Measuring& measuring) {
        return isUsed[v] ? Sums{measuring(a.points[v].cast<double>()), 0, 0} : Sums();
    }));
    return {sums.largest, sums.area > 0 ? sums.weighted / sums.area : 0};
}
} // namespace core
