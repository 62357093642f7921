// Steps of distanceFrom():
//   1. same      skip faces that both surfaces have: their distance is 0
//   2. inside    sample the other faces; each search is bounded by the result of the previous one
//   3. corners   find only the largest distance: a search ends as soon as a corner is known to be nearer than that

#include "core/analysis/surface_distance.h"

#include "core/analysis/winding_number.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/point_triangle.h"
#include "core/util/parallel_progress.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace core
{
namespace
{
constexpr double samplesPerFace = 100, minSamples = 20'000, maxSamples = 200'000;
constexpr std::size_t perChunk = 512;

double areaOf(const std::array<Vec3, 3>& t)
{
    return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

std::size_t mixed(std::size_t hash, std::uint32_t bits)
{
    return (hash ^ bits) * 0x9E3779B97F4A7C15 >> 7 ^ hash << 23;
}

/// Points and faces of a surface, found by coordinates.
class Parts
{
public:
    explicit Parts(const TriangleMesh& mesh)
    {
        m_points.reserve(mesh.points.size());
        m_faces.reserve(mesh.triangles.size());
        for (const Triangle& t : mesh.triangles) {
            Triangle places;
            for (std::size_t i = 0; i < 3; ++i)
                places[i] = m_points.try_emplace(mesh.points[t[i]], static_cast<Slot>(m_points.size())).first->second;
            m_faces.insert(sorted(places));
        }
    }

    bool hasPoint(const Vec3f& p) const { return m_points.contains(p); }
    /// Returns whether the surface has this face, in either orientation.
    bool hasFace(const TriangleMesh& mesh, Slot face) const
    {
        Triangle places;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto found = m_points.find(mesh.points[mesh.triangles[face][i]]);
            if (found == m_points.end())
                return false;
            places[i] = found->second;
        }
        return m_faces.contains(sorted(places));
    }

private:
    struct PointHash
    {
        std::size_t operator()(const Vec3f& p) const
        {
            std::size_t hash = 0;
            for (int i = 0; i < 3; ++i)
                hash = mixed(hash, std::bit_cast<std::uint32_t>(p[i] + 0.0f)); // + 0.0f turns -0 into 0
            return hash;
        }
    };
    struct FaceHash
    {
        std::size_t operator()(const Triangle& t) const { return mixed(mixed(mixed(0, t[0]), t[1]), t[2]); }
    };

    static Triangle sorted(Triangle t)
    {
        std::ranges::sort(t);
        return t;
    }

    std::unordered_map<Vec3f, Slot, PointHash> m_points;
    std::unordered_set<Triangle, FaceHash> m_faces;
};

/// A face of the surface, as its position in the tree, and the squared distance of the queried point from it.
struct Found
{
    double squared = std::numeric_limits<double>::infinity();
    Slot position = 0;
};

class Nearest
{
public:
    explicit Nearest(const TriangleMesh& mesh)
        : m_tree(faceBoxes(mesh.points, mesh.triangles))
        , m_corners(mesh.triangles.size())
    {
        forEachChunk(m_corners.size(), perChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    m_corners[i][k] = mesh.points[mesh.triangles[m_tree.at(static_cast<Slot>(i))][k]];
        });
    }

    Found at(Slot position, const Vec3& p) const
    {
        const auto& [a, b, c] = m_corners[position];
        const Vec3 q = nearestInTriangle(p, {a.cast<double>(), b.cast<double>(), c.cast<double>()});
        return {(q - p).squaredNorm(), position};
    }

    /// Returns the face nearest to p. `known`: any face; a nearer one makes the search faster. The search ends early at
    /// a face whose squared distance is at most `enough`.
    Found nearest(const Vec3& p, const Found& known, double enough) const
    {
        constexpr double slack = 1 + 1e-9; // so that the search finds the known face again despite rounding
        Found best = known;
        const Eigen::Array3d place = p.array();
        const auto reach = [&](const FaceBox& box) {
            return (box.min.cast<double>() - place).max(place - box.max.cast<double>()).max(0.0).matrix().squaredNorm();
        };
        if (known.squared <= enough)
            return best;
        m_tree.forEachNear(reach, slack * known.squared, [&](Slot position) {
            if (const Found found = at(position, p); found.squared < best.squared)
                best = found;
            return best.squared <= enough ? -1 : best.squared;
        });
        return best;
    }

private:
    BoxTree m_tree;
    std::vector<std::array<Vec3f, 3>> m_corners; ///< corners of the face at each position in the tree
};

/// Measures distances of successive points that are near each other: the face nearest to one bounds the next search.
class Measuring
{
public:
    explicit Measuring(const Nearest& to) : m_to(to) {}

    /// Returns the distance from p to the surface; exact only if it is larger than `enough`.
    double operator()(const Vec3& p, double enough = 0)
    {
        if (m_last.squared < std::numeric_limits<double>::infinity())
            m_last = m_to.at(m_last.position, p);
        m_last = m_to.nearest(p, m_last, enough * enough);
        return std::sqrt(m_last.squared);
    }

private:
    const Nearest& m_to;
    Found m_last;
};

/// Returns evenly spread sample i of the triangle: the R2 sequence (Roberts 2018), folded at the diagonal.
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

struct DistanceSums
{
    double largest = 0, sum = 0;
    std::size_t count = 0;

    void add(const DistanceSums& other)
    {
        largest = std::max(largest, other.largest);
        sum += other.sum;
        count += other.count;
    }
};

/// Returns running sums of the number of samples, for each face including it. Samples are spread evenly over the area.
std::vector<std::size_t> samplesUpTo(const TriangleMesh& mesh, double wanted)
{
    std::vector<double> area;
    area.reserve(mesh.triangles.size());
    double sum = 0;
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        area.push_back(sum += areaOf(cornersOf(mesh, f)));
    std::vector<std::size_t> samples;
    samples.reserve(area.size());
    for (const double upTo : area)
        samples.push_back(sum > 0 ? static_cast<std::size_t>(wanted * (upTo / sum)) : 0);
    return samples;
}

/// `counted`: a function that maps a sample and its distance to the distance that counts.
template <typename Counted>
DistanceSums measureInside(const TriangleMesh& mesh, const Parts& parts, const Nearest& nearest, double wanted,
                           const JobControl& control, Counted counted)
{
    const std::vector<std::size_t> samples = samplesUpTo(mesh, wanted);
    std::vector<DistanceSums> sums(chunksOf(samples.size(), perChunk));
    forEachChunkWithProgress(samples.size(), perChunk, control,
                             [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                                 Measuring measuring(nearest);
                                 DistanceSums& here = sums[chunk];
                                 for (std::size_t f = begin; f < end && !control.isCancelled(); ++f) {
                                     const std::size_t first = f == 0 ? 0 : samples[f - 1];
                                     here.count += samples[f] - first;
                                     if (first == samples[f] || parts.hasFace(mesh, static_cast<Slot>(f)))
                                         continue;
                                     const std::array<Vec3, 3> triangle = cornersOf(mesh, static_cast<Slot>(f));
                                     for (std::size_t i = first; i < samples[f]; ++i) {
                                         const Vec3 sample = sampleIn(triangle, i);
                                         const double distance = counted(sample, measuring(sample));
                                         here.largest = std::max(here.largest, distance);
                                         here.sum += distance;
                                     }
                                 }
                             });
    DistanceSums all;
    for (const DistanceSums& part : sums)
        all.add(part);
    return all;
}

/// Returns the largest of `known` and the distances of the corners that the other surface does not have.
double farthestCorner(const TriangleMesh& mesh, const Parts& parts, const Nearest& nearest, double known,
                      const JobControl& control)
{
    std::vector<bool> isUsed(mesh.points.size(), false);
    for (const Triangle& t : mesh.triangles)
        for (const Slot v : t)
            isUsed[v] = true;
    std::atomic<double> largest = known;
    forEachChunkWithProgress(
        mesh.points.size(), perChunk, control, [&](std::size_t, std::size_t begin, std::size_t end) {
            Measuring measuring(nearest);
            for (std::size_t v = begin; v < end && !control.isCancelled(); ++v) {
                if (!isUsed[v] || parts.hasPoint(mesh.points[v]))
                    continue;
                double soFar = largest.load(std::memory_order_relaxed);
                const Vec3 p = mesh.points[v].cast<double>();
                if (measuring(p, soFar) <= soFar)
                    continue;
                const double distance =
                    // Searched from scratch: the result must not depend on earlier points
                    std::sqrt(nearest.nearest(p, {}, 0).squared);
                while (distance > soFar && !largest.compare_exchange_weak(soFar, distance, std::memory_order_relaxed)) {
                }
            }
        });
    return largest;
}
} // namespace

SurfaceDistance distanceFrom(const TriangleMesh& a, const TriangleMesh& b, const JobControl& control)
{
    constexpr double afterPreparing = 0.1, afterInside = 0.8; // progress, 0 to 1, at the end of each step
    const Parts parts(b);
    const Nearest nearest(b);
    control.reportProgress(afterPreparing);
    const double samples = std::clamp(samplesPerFace * static_cast<double>(a.triangles.size()), minSamples, maxSamples);
    const DistanceSums inside = measureInside(a, parts, nearest, samples, control.part(afterPreparing, afterInside),
                                              [](const Vec3&, double distance) { return distance; });
    const double largest = farthestCorner(a, parts, nearest, inside.largest, control.part(afterInside, 1));
    return {largest, inside.count > 0 ? inside.sum / static_cast<double>(inside.count) : 0};
}

double meanDistanceOutside(const TriangleMesh& a, const TriangleMesh& b, double reach, const JobControl& control)
{
    constexpr double fewerSamples = 25'000;
    const WindingNumber solid(b);
    const auto outside = [&](const Vec3& sample, double distance) {
        return distance > reach && solid.at(sample) > 0.5 ? 0 : distance;
    };
    const DistanceSums sums = measureInside(a, Parts(b), Nearest(b), fewerSamples, control, outside);
    return sums.count > 0 ? sums.sum / static_cast<double>(sums.count) : 0;
}

std::vector<float> distancesTo(const TriangleMesh& surface, std::span<const Vec3f> points, const JobControl& control)
{
    const Nearest nearest(surface);
    std::vector<float> distances(points.size());
    forEachChunkWithProgress(points.size(), perChunk, control, [&](std::size_t, std::size_t begin, std::size_t end) {
        Measuring measuring(nearest);
        for (std::size_t v = begin; v < end && !control.isCancelled(); ++v)
            distances[v] = static_cast<float>(measuring(points[v].cast<double>()));
    });
    return distances;
}
} // namespace core
