// Measures chords between ridges. A ball touches p on one ridge, along a normal there, and reaches q on another ridge.
// Its diameter is |q - p| / c, where c is the cosine between chord and normal. Pairs of segments are halved until the
// shortest chord of a pair leaves both within the allowed angle (branch and bound).

#include "core/print/wall_ridges.h"

#include "core/geometry/triangle_distance.h"

#include "core/util/parallel.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// Least cosine between a chord and a normal at each of its ends: 30 degrees. Its square is (1 - maxOppositeCosine) /
/// 2.
const double minChordCosine = std::sqrt((1 - maxOppositeCosine) / 2);
/// straight: a chord counts as parallel to the normal if the cosine between them exceeds this. pointLike: segments
/// count as points if they are no longer than this share of their distance.
constexpr double straight = 0.99, pointLike = 0.05;
/// Largest number of pairs of pieces that are tested for two ridges.
constexpr int maxPairs = 256;
constexpr std::size_t ridgesAtOnce = 16;
/// evenRidge: a piece is divided if its thinnest place is below this share of the thickness at one of its ends or its
/// middle. shortPiece: length, in thicknesses, up to which a piece is not divided.
constexpr double evenRidge = 0.8, shortPiece = 0.5;
constexpr int maxHalvings = 7;
/// A ridge is reported only if it is thinner than this share of the thickness at its faces. The margin exceeds the
/// error of that thickness.
constexpr double thinnerThanFaces = 0.97;

/// Returns the cosine of an angle that is 30 degrees larger; -1 if that angle is more than 90 degrees.
double widened(double cosine)
{
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double sum = cosine * minChordCosine - sine * std::sqrt(1 - minChordCosine * minChordCosine);
    return sum >= 0 ? sum : -1;
}

/// Returns the box of all chords that leave a face within 30 degrees of its normal, up to a length.
FaceBox boxOfChords(const std::array<Vec3, 3>& face, const Vec3& inward, double length)
{
    const double minChordSine = std::sqrt(1 - minChordCosine * minChordCosine);
    const auto longest = [&](double cosine) { // of a chord along a direction at this cosine from the normal
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        return length * (cosine > minChordCosine ? 1 : std::max(0.0, cosine * minChordCosine + sine * minChordSine));
    };
    FaceBox box;
    for (const Vec3& corner : face) {
        box.extend((corner + inward.unaryExpr(longest)).cast<float>().array());
        box.extend((corner - (-inward).unaryExpr(longest)).cast<float>().array());
    }
    return box;
}
} // namespace

Box WallRidges::Segment::box() const
{
    Box box(from);
    box.extend(to);
    return box;
}

WallRidges::WallRidges(const TriangleMesh& mesh, const WallEdges& edges, const WallRays& rays)
    : m_edges(edges)
    , m_rays(rays)
    , m_tree(addRidges(mesh))
{}

std::vector<FaceBox> WallRidges::addRidges(const TriangleMesh& mesh)
{
    const auto at = [&](Slot vertex) { return Vec3(mesh.points[vertex].cast<double>()); };
    for (Slot i = 0; i < m_edges.edges().size(); ++i) {
        const WallEdges::Edge& edge = m_edges.edges()[i];
        if (!edge.isInward)
            continue;
        const Vec3 mean = (edge.inward[0] + edge.inward[1]).normalized();
        m_ridges.push_back({{at(edge.vertices[0]), at(edge.vertices[1])},
                            i,
                            noSlot,
                            edge.vertices,
                            edge.faces,
                            mean,
                            widened(mean.dot(edge.inward[0]))});
    }
    for (Slot i = 0; i < m_edges.corners().size(); ++i) {
        const WallEdges::Corner& corner = m_edges.corners()[i];
        const Vec3 p = at(corner.vertex);
        if (corner.isInward)
            m_ridges.push_back(
                {{p, p}, noSlot, i, {corner.vertex, corner.vertex}, {corner.face, corner.face}, corner.inward, 0});
    }
    std::vector<FaceBox> boxes;
    for (const Ridge& ridge : m_ridges) {
        FaceBox& box = boxes.emplace_back();
        box.extend(ridge.segment.from.cast<float>().array());
        box.extend(ridge.segment.to.cast<float>().array());
    }
    return boxes;
}

bool WallRidges::mayBeOpposite(const std::array<Vec3, 3>& face, const Vec3& inward, double farthest) const
{
    if (m_ridges.empty())
        return false;
    const FaceBox chords = boxOfChords(face, inward, farthest);
    const auto reach = [&](const FaceBox& box) { return box.meets(chords) ? 0 : noBall; };
    bool isFound = false;
    m_tree.forEachNear(reach, noBall, [&](Slot position) {
        const Ridge& ridge = m_ridges[m_tree.at(position)];
        const auto& [from, to] = ridge.segment;
        const double ahead = std::max(inward.dot(from - face[0]), inward.dot(to - face[0]));
        if (ahead > 0 && cosineOf(ridge, -inward) >= -maxOppositeCosine) {
            const double distance = std::sqrt(nearestOfTriangleAndSegment(face, from, to).squaredDistance);
            isFound = distance <= std::min(farthest, ahead / minChordCosine);
        }
        return isFound ? 0 : noBall;
    });
    return isFound;
}

std::vector<WallRidge> WallRidges::measure(const std::vector<float>& ofFaces, double thickest,
                                           const JobControl& control) const
{
    auto found = joinChunks<std::vector<WallRidge>>(
        m_ridges.size(), ridgesAtOnce, [&](std::size_t begin, std::size_t end, std::vector<WallRidge>& some) {
            for (std::size_t i = begin; i < end && !control.isCancelled(); ++i)
                measure(m_tree.at(static_cast<Slot>(i)), ofFaces, thickest, some);
        });
    std::ranges::stable_sort(found, {}, &WallRidge::face);
    return found;
}

/// Halves the ridge until each piece is about evenly thick or short compared with its thickness.
void WallRidges::measure(Slot number, const std::vector<float>& ofFaces, double thickest,
                         std::vector<WallRidge>& found) const
{
    const Ridge& ridge = m_ridges[number];
    const auto atFaces = static_cast<double>(std::min(ofFaces[ridge.faces[0]], ofFaces[ridge.faces[1]]));
    thickest = std::min(thickest, thinnerThanFaces * atFaces);
    std::vector<std::pair<Segment, int>> pieces{{ridge.segment, 0}};
    while (!pieces.empty()) {
        const auto [piece, halvings] = pieces.back();
        pieces.pop_back();
        const Place place = thinnestOf(ridge, piece, thickest);
        if (place.diameter >= thickest)
            continue;
        const double enough = place.diameter / evenRidge;
        const auto isAsThin = [&](const Vec3& p) { return thinnestOf(ridge, {p, p}, enough).diameter < enough; };
        if (halvings == maxHalvings || piece.length() <= shortPiece * place.diameter ||
            (isAsThin(piece.from) && isAsThin(piece.middle()) && isAsThin(piece.to))) {
            found.push_back({ridge.faces[0],
                             {piece.from.cast<float>(), piece.to.cast<float>()},
                             static_cast<float>(place.diameter),
                             place.point.cast<float>()});
            continue;
        }
        pieces.push_back({{piece.middle(), piece.to}, halvings + 1});
        pieces.push_back({{piece.from, piece.middle()}, halvings + 1});
    }
}

WallRidges::Place WallRidges::thinnestOf(const Ridge& ridge, const Segment& piece, double thickest) const
{
    const Box box = piece.box();
    const Vec3 mean = ridge.mean;
    const double behind = std::min(mean.dot(piece.from), mean.dot(piece.to));
    const auto reach = [&](const FaceBox& other) {
        const Vec3 min = other.min.cast<double>(), max = other.max.cast<double>();
        const double gap2 = (min - box.max()).cwiseMax(box.min() - max).cwiseMax(0.0).squaredNorm();
        if (ridge.minCosine < 0)
            return gap2;
        const double ahead = mean.dot((min + max) / 2) + mean.cwiseAbs().dot((max - min) / 2) - behind;
        return ahead < 0 || ahead * ahead < ridge.minCosine * ridge.minCosine * gap2 ? noBall : gap2;
    };
    Place thinnest{thickest};
    m_tree.forEachNear(reach, thickest * thickest, [&](Slot position) {
        const Ridge& other = m_ridges[m_tree.at(position)];
        const bool doTouch = std::ranges::find_first_of(ridge.vertices, other.vertices) != ridge.vertices.end();
        if (!doTouch)
            search(ridge, piece, other, thinnest);
        return thinnest.diameter * thinnest.diameter;
    });
    return thinnest;
}

void WallRidges::search(const Ridge& ridge, const Segment& piece, const Ridge& other, Place& thinnest) const
{
    struct Pair
    {
        Segment a, b;
    };
    std::vector<Pair> pairs{{piece, other.segment}};
    for (int looked = 0; !pairs.empty() && looked < maxPairs; ++looked) {
        const Pair pair = pairs.back();
        pairs.pop_back();
        const NearestPair nearest = nearestOfSegments(pair.a.from, pair.a.to, pair.b.from, pair.b.to);
        const double distance = std::sqrt(nearest.squaredDistance);
        if (!(distance > 0) || distance >= thinnest.diameter || !mayLook(ridge, pair.a, pair.b, 1, distance) ||
            !mayLook(other, pair.a, pair.b, -1, distance))
            continue;
        const Vec3 chord = (nearest.b - nearest.a) / distance;
        const double own = cosineOf(ridge, chord), others = cosineOf(other, -chord), cosine = std::max(own, others);
        bool isWall = std::min(own, others) >= minChordCosine;
        if (isWall && distance / cosine < thinnest.diameter) {
            isWall = m_rays.areInSight(nearest.a, nearest.b);
            if (isWall)
                thinnest = {distance / cosine, nearest.a};
        }
        const double a = pair.a.length(), b = pair.b.length();
        if ((isWall && cosine > straight) || std::max(a, b) <= pointLike * distance)
            continue;
        const Segment& longer = a > b ? pair.a : pair.b;
        std::array<Segment, 2> halves = {{{longer.from, longer.middle()}, {longer.middle(), longer.to}}};
        const Vec3& near = a > b ? nearest.a : nearest.b;
        if ((halves[0].middle() - near).squaredNorm() < (halves[1].middle() - near).squaredNorm())
            std::swap(halves[0], halves[1]); // the nearer half on top of the stack
        for (const Segment& half : halves)
            pairs.push_back(a > b ? Pair{half, pair.b} : Pair{pair.a, half});
    }
}

/// Returns whether some chord between two segments may leave the ridge within 30 degrees of one of its normals.
bool WallRidges::mayLook(const Ridge& ridge, const Segment& from, const Segment& to, double sign, double distance) const
{
    if (ridge.minCosine < 0)
        return true;
    const Vec3 mean = sign * ridge.mean;
    const double ahead =
        std::max(mean.dot(to.from), mean.dot(to.to)) - std::min(mean.dot(from.from), mean.dot(from.to));
    return ahead >= ridge.minCosine * distance;
}

/// Returns the cosine between a chord that leaves the ridge and the nearest of the ridge's normals. For a
/// corner it is 1 if the chord is a normal of the corner, otherwise 0; normals near the chord belong to its edges.
double WallRidges::cosineOf(const Ridge& ridge, const Vec3& chord) const
{
    if (ridge.edge == noSlot) {
        const auto isBehind = [&](const Vec3& edge) { return chord.dot(edge) <= 0; };
        return std::ranges::all_of(m_edges.edgesAt(m_edges.corners()[ridge.corner]), isBehind) ? 1 : 0;
    }
    const WallEdges::Edge& edge = m_edges.edges()[ridge.edge];
    if (chord.dot(edge.across[0]) <= 0 && chord.dot(edge.across[1]) <= 0) {
        const double along = chord.dot(edge.along);
        return std::sqrt(std::max(0.0, 1 - along * along));
    }
    return std::max(chord.dot(edge.inward[0]), chord.dot(edge.inward[1]));
}
} // namespace core
