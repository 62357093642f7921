#include "core/analysis/space_difference.h"

#include "core/analysis/nesting.h"
#include "core/analysis/winding_number.h"
#include "core/geometry/box_tree.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
SolidAngles anglesOf(const TriangleMesh& mesh)
{
    std::vector<Vec3> points;
    points.reserve(mesh.points.size());
    for (const Vec3f& p : mesh.points)
        points.push_back(p.cast<double>());
    return {points, mesh.triangles};
}

void addComponentBoxes(const TriangleMesh& mesh, std::vector<FaceBox>& boxes)
{
    const Components components = componentsOf(mesh.points.size(), mesh.triangles);
    const std::size_t first = boxes.size();
    boxes.resize(first + components.count);
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        for (const Slot v : mesh.triangles[f])
            boxes[first + components.ofFace[f]].extend(mesh.points[v].array());
}

std::vector<FaceBox> componentBoxes(const TriangleMesh& a, const TriangleMesh& b)
{
    std::vector<FaceBox> boxes;
    addComponentBoxes(a, boxes);
    addComponentBoxes(b, boxes);
    return boxes;
}

double volumeOf(const FaceBox& box)
{
    return (box.max - box.min).cast<double>().prod();
}

/// Samples the common box of two surfaces. Most points are in the boxes of components, which may be small and far
/// apart.
class SpaceSamples
{
public:
    struct Sample
    {
        Vec3 point;
        double space; ///< volume that the sample represents, up to a constant factor
    };

    SpaceSamples(const TriangleMesh& a, const TriangleMesh& b) : m_boxes(componentBoxes(a, b)), m_tree(m_boxes)
    {
        for (const FaceBox& box : m_boxes) {
            m_all.extend(box);
            m_ends.push_back(m_volume += volumeOf(box));
        }
    }

    /// Returns sample i of an evenly spread sequence, the R4 sequence (Roberts 2018).
    Sample at(std::size_t i) const
    {
        constexpr double inAll = 0.25; // share of the samples in the common box
        const Eigen::Array4d steps(0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101);
        const Eigen::Array4d turns = 0.5 + static_cast<double>(i) * steps, unit = turns - turns.floor();
        const bool isInAll = unit[3] < inAll || m_volume == 0;
        const double place = (unit[3] - inAll) / (1 - inAll) * m_volume;
        const auto end = std::min(std::ranges::upper_bound(m_ends, place), m_ends.end() - 1);
        const FaceBox& box = isInAll ? m_all : m_boxes[static_cast<std::size_t>(end - m_ends.begin())];
        const Vec3 p = (box.min + unit.head<3>().cast<float>() * (box.max - box.min)).matrix().cast<double>();
        FaceBox here;
        here.extend(p.array().cast<float>());
        double boxes = 0;
        m_tree.forEachMeeting(here, [&](Slot) { ++boxes; });
        return {p, 1 / (inAll + (m_volume > 0 ? (1 - inAll) * boxes * volumeOf(m_all) / m_volume : 0))};
    }

private:
    std::vector<FaceBox> m_boxes; ///< boxes of the components
    BoxTree m_tree;
    FaceBox m_all;
    std::vector<double> m_ends; ///< running sums of the boxes' volumes
    double m_volume = 0;        ///< sum of the boxes' volumes
};

/// Sums of the weights of sample points.
struct Sums
{
    double lost = 0, gained = 0, inEither = 0;
    std::size_t inside = 0; ///< number of points inside either surface

    /// Adds a point where the old surface has this winding number.
    void add(double winding, bool isInside, double space)
    {
        const bool wasInside = winding > 0.5;
        const double weight = space * std::min(1.0, std::abs(2 * winding - 1));
        lost += wasInside && !isInside ? weight : 0;
        gained += isInside && !wasInside ? weight : 0;
        inEither += wasInside || isInside ? weight : 0;
        inside += wasInside || isInside ? 1 : 0;
    }
    void add(const Sums& other)
    {
        lost += other.lost;
        gained += other.gained;
        inEither += other.inEither;
        inside += other.inside;
    }
    bool areEnough() const
    {
        constexpr std::size_t enough = 16'384, enoughIfSame = 4096;
        return inside >= (lost == 0 && gained == 0 ? enoughIfSame : enough);
    }
    SpaceDifference difference() const
    {
        return inEither == 0 ? SpaceDifference{} : SpaceDifference{lost / inEither, gained / inEither};
    }
};

/// Sums for both readings of the old surface.
struct SumsOfReadings
{
    Sums eitherWay, outwards;
};
} // namespace

SpaceDifferences spaceDifferences(const TriangleMesh& faces, const TriangleMesh& solid, const JobControl& control)
{
    constexpr std::size_t maxSamples = 65'536, perStep = 8192, perChunk = 256;
    // By solid angles: exact numbers put the loss of some coarse borders just over the limit of repairs, which was set
    // for the sum of solid angles.
    const SolidAngles ofFaces = anglesOf(faces);
    const WindingNumber ofSolid(solid);
    const SpaceSamples samples(faces, solid);
    SumsOfReadings all;
    std::vector<SumsOfReadings> sums(chunksOf(perStep, perChunk));
    const auto areEnough = [&] { return all.eitherWay.areEnough() && all.outwards.areEnough(); };
    for (std::size_t first = 0; first < maxSamples && !areEnough() && !control.isCancelled(); first += perStep) {
        std::ranges::fill(sums, SumsOfReadings{});
        forEachChunk(perStep, perChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto [p, space] = samples.at(first + i);
                const double winding = ofFaces.at(p);
                const bool isInside = ofSolid.at(p) > 0.5;
                sums[chunk].eitherWay.add(std::abs(winding), isInside, space);
                sums[chunk].outwards.add(winding, isInside, space);
            }
        });
        for (const SumsOfReadings& part : sums) {
            all.eitherWay.add(part.eitherWay);
            all.outwards.add(part.outwards);
        }
        control.reportProgress(static_cast<double>(first + perStep) / maxSamples);
    }
    return {all.eitherWay.difference(), all.outwards.difference()};
}
} // namespace core
