#include "core/analysis/space_difference.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/winding_number.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
WindingNumber windingOf(const TriangleMesh& mesh)
{
    std::vector<Vec3> points;
    points.reserve(mesh.points.size());
    for (const Vec3f& p : mesh.points)
        points.push_back(p.cast<double>());
    return {points, mesh.triangles};
}

/// Returns a point of the unit cube, evenly spread: the R3 sequence (Roberts 2018).
Eigen::Array3d sampleAt(std::size_t i)
{
    const Eigen::Array3d steps(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    const Eigen::Array3d sample = 0.5 + static_cast<double>(i) * steps;
    return sample - sample.floor();
}

/// Sums of what the points count.
struct Sums
{
    double lost = 0, gained = 0, inEither = 0;
    std::size_t inside = 0; ///< points
};
} // namespace

SpaceDifference spaceDifference(const TriangleMesh& faces, const TriangleMesh& solid, const JobControl& control)
{
    constexpr std::size_t maxSamples = 65'536, perStep = 8192, perChunk = 256;
    constexpr std::size_t enough = 4096; // of points inside
    const WindingNumber ofFaces = windingOf(faces), ofSolid = windingOf(solid);
    Box box = boxOf(faces);
    box.extend(boxOf(solid));
    Sums all;
    std::vector<Sums> sums(chunksOf(perStep, perChunk));
    for (std::size_t first = 0; first < maxSamples && all.inside < enough && !control.isCancelled(); first += perStep) {
        std::ranges::fill(sums, Sums{});
        forEachChunk(perStep, perChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Vec3 p = box.min() + (sampleAt(first + i) * box.sizes().array()).matrix();
                const double winding = std::abs(ofFaces.at(p));
                const bool wasInside = winding > 0.5, isInside = ofSolid.at(p) > 0.5;
                const double weight = std::min(1.0, std::abs(2 * winding - 1));
                sums[chunk].lost += wasInside && !isInside ? weight : 0;
                sums[chunk].gained += isInside && !wasInside ? weight : 0;
                sums[chunk].inEither += wasInside || isInside ? weight : 0;
                sums[chunk].inside += wasInside || isInside ? 1 : 0;
            }
        });
        for (const Sums& part : sums) {
            all.lost += part.lost;
            all.gained += part.gained;
            all.inEither += part.inEither;
            all.inside += part.inside;
        }
        control.reportProgress(static_cast<double>(first + perStep) / maxSamples);
    }
    if (all.inEither == 0)
        return {};
    return {all.lost / all.inEither, all.gained / all.inEither};
}
} // namespace core
