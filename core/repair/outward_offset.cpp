#include "core/repair/outward_offset.h"

#include "core/analysis/nesting.h"
#include "core/analysis/winding_number.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/face_geometry.h"
#include "core/util/parallel.h"

#include <Eigen/Eigenvalues>

#include <atomic>
#include <functional>
#include <map>
#include <numeric>

namespace core::repair
{
namespace
{
constexpr float touching = 2;      ///< distance within which walls touch, lattice units
constexpr double clearHeight = 64; ///< of faces whose normals rounding hardly changes, lattice units

/// The planes of a point's faces: weighted sums of n n^T and n over the normals n.
struct PlaneFit
{
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero();
    Slot component = 0;
    double shortestEdge = std::numeric_limits<double>::infinity();

    /// Returns the displacement that moves each plane by about 1. Has no component in directions that the planes hardly
    /// determine.
    Vec3 move() const
    {
        constexpr double least = 0.05; // share of the largest eigenvalue
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
        Vec3 result = Vec3::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = solver.eigenvectors().col(i);
            const double value = solver.eigenvalues()[i];
            if (value > least * solver.eigenvalues()[2])
                result += axis * (axis.dot(sum) / value);
        }
        return result;
    }
};

/// `counts`: whether the face's plane moves.
void addFace(std::map<Slot, PlaneFit>& fits, const std::vector<bool>& isMoved, const TriangleSoup& surface,
             const Triangle& t, Slot component, bool counts)
{
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    const Vec3 normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const double area = normal.norm();
    if (area == 0)
        return;
    const double longest =
        std::max({(at(t[1]) - at(t[0])).norm(), (at(t[2]) - at(t[0])).norm(), (at(t[1]) - at(t[2])).norm()});
    const Vec3 n = normal / area;
    const double weight = counts ? std::min(1.0, area / longest / clearHeight) : 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!isMoved[t[i]])
            continue;
        PlaneFit& fit = fits[t[i]];
        fit.matrix += weight * n * n.transpose();
        fit.sum += weight * n;
        fit.component = component;
        for (const std::size_t k : {i + 1, i + 2})
            fit.shortestEdge = std::min(fit.shortestEdge, (at(t[k % 3]) - at(t[i])).norm());
    }
}

/// Moves the points so that the planes of those of their faces that count move by about `distance`.
void offsetPlanes(TriangleSoup& surface, const std::vector<bool>& isMoved, double distance,
                  const std::function<bool(Slot face)>& counts)
{
    constexpr double farthest = 3, ofShortestEdge = 0.25;
    const Components components = componentsOf(surface.points.size(), surface.triangles);
    std::map<Slot, PlaneFit> fits;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Triangle& t = surface.triangles[f];
        if (isMoved[t[0]] || isMoved[t[1]] || isMoved[t[2]])
            addFace(fits, isMoved, surface, t, components.ofFace[f], counts(f));
    }
    for (const auto& [v, fit] : fits) {
        const double wanted = distance * (1 + 0.5 * (fit.component % 3));
        const double most = std::min(farthest * std::abs(wanted), ofShortestEdge * fit.shortestEdge);
        Vec3 move = wanted * fit.move();
        if (const double length = move.norm(); length > most)
            move *= most / length;
        const LatticePoint to = surface.points[v] + LatticePoint(move.array().round().cast<int>());
        surface.points[v] = to.cwiseMax(-Lattice::limit).cwiseMin(Lattice::limit);
    }
}

/// Moves the planes of these faces. Others move only as far as they share corners.
void offsetFaces(TriangleSoup& surface, const std::vector<bool>& isMeant, double distance)
{
    std::vector<bool> isMoved(surface.points.size(), false);
    for (Slot f = 0; f < surface.triangles.size(); ++f)
        for (const Slot v : surface.triangles[f])
            isMoved[v] = isMoved[v] || isMeant[f];
    offsetPlanes(surface, isMoved, distance, [&](Slot f) { return isMeant[f]; });
}

/// Returns the signed volume, lattice units^3.
double volumeOf(const TriangleSoup& surface)
{
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const auto at = [&](Slot v) { return Vec3((surface.points[v] - surface.points[0]).cast<double>()); };
        sum += at(a).dot(at(b).cross(at(c))) / 6;
    }
    return sum;
}

/// A face seen as a wall of a body.
struct Wall
{
    std::array<Vec3, 3> corners;
    Vec3 normal = Vec3::Zero(); ///< 0 for slivers, whose normals change with rounding

    Wall(const TriangleSoup& surface, const Triangle& t)
    {
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = surface.points[t[i]].cast<double>();
        const auto& [a, b, c] = corners;
        const Vec3 doubleArea = (b - a).cross(c - a);
        const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
        if (doubleArea.norm() > clearHeight * longest)
            normal = doubleArea.normalized();
    }

    /// Returns the part of this wall that is over the other one, as a polygon.
    std::vector<Vec3> over(const Wall& other) const
    {
        std::vector<Vec3> polygon(corners.begin(), corners.end()), clipped;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &from = other.corners[i], inwards = other.normal.cross(other.corners[(i + 1) % 3] - from);
            const auto depth = [&](const Vec3& p) { return inwards.dot(p - from); };
            clipped.clear();
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const Vec3 &p = polygon[k], &next = polygon[(k + 1) % polygon.size()];
                const double here = depth(p), there = depth(next);
                if (here >= 0)
                    clipped.push_back(p);
                if ((here < 0) != (there < 0))
                    clipped.push_back(p + here / (here - there) * (next - p));
            }
            polygon.swap(clipped);
        }
        return polygon;
    }
};

double areaOf(const std::vector<Vec3>& polygon)
{
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 2; k < polygon.size(); ++k)
        area += (polygon[k - 1] - polygon[0]).cross(polygon[k] - polygon[0]) / 2;
    return area.norm();
}

/// Returns whether a polygon is wider than rounding errors.
bool isBroad(const std::vector<Vec3>& polygon)
{
    constexpr double narrow = 16; // lattice units; area by perimeter
    double perimeter = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        perimeter += (polygon[(k + 1) % polygon.size()] - polygon[k]).norm();
    return areaOf(polygon) > narrow * perimeter;
}

/// Returns the area where two walls face opposite ways and are within 2 lattice units of each other, as a polygon.
/// Returns an empty polygon if it is narrow or if the walls are coplanar.
std::vector<Vec3> contactOf(const Wall& a, const Wall& b)
{
    constexpr double opposite = -0.999, coplanar = 1e-3;
    if (a.normal.dot(b.normal) > opposite)
        return {};
    std::vector<Vec3> polygon = a.over(b);
    double apart = 0;
    for (const Vec3& p : polygon)
        apart = std::max(apart, std::abs(b.normal.dot(p - b.corners[0])));
    if (apart < coplanar || apart > touching || !isBroad(polygon))
        polygon.clear();
    return polygon;
}

/// Returns the pairs of faces in contact. Returns none if there are more than `most`.
std::vector<FacePair> contactsIn(const TriangleSoup& surface, std::size_t most)
{
    std::vector<FaceBox> boxes = faceBoxes(surface.points, std::span<const Triangle>(surface.triangles));
    for (FaceBox& box : boxes) {
        box.min -= touching / 2;
        box.max += touching / 2;
    }
    const BoxTree tree(boxes);
    std::atomic<std::size_t> count = 0;
    const auto add = [&](std::vector<FacePair>& contacts, Slot first, Slot second) {
        const Triangle &a = surface.triangles[first], &b = surface.triangles[second];
        const auto isInBoth = [&](Slot v) { return std::ranges::find(b, v) != b.end(); };
        const bool areNeighbours = std::ranges::count_if(a, isInBoth) >= 2;
        if (areNeighbours || count > most || contactOf(Wall(surface, a), Wall(surface, b)).empty())
            return;
        ++count;
        contacts.emplace_back(first, second);
    };
    auto contacts = joinChunks<std::vector<FacePair>>(
        tree.blocks(), 1, [&](std::size_t begin, std::size_t end, std::vector<FacePair>& found) {
            for (std::size_t block = begin; block < end && count <= most; ++block)
                tree.forEachMeetingPair(static_cast<Slot>(block),
                                        [&](Slot i, Slot j) { add(found, tree.at(i), tree.at(j)); });
        });
    if (count > most)
        contacts.clear();
    return contacts;
}

/// The space on both sides of two walls in contact.
enum class Space { Solid, Empty, Unclear };

/// `area`: the polygon of the contact. `normal`: that of one of the walls.
Space spaceBeside(const std::vector<Vec3>& area, const Vec3& normal, const WindingNumber& solid)
{
    constexpr double nearCorner = 0.9;
    constexpr double depthOfBody = 16, depthOfFilm = 4; // lattice units
    const Vec3 middle = std::accumulate(area.begin(), area.end(), Vec3(0, 0, 0)) / static_cast<double>(area.size());
    bool isSolid = true, isEmpty = true;
    for (const Vec3& corner : area)
        for (const double side : {-1., 1.}) {
            const Vec3 place = middle + nearCorner * (corner - middle);
            isSolid = isSolid && solid.at(place + side * depthOfBody * normal) > 0.5;
            isEmpty = isEmpty && std::abs(solid.at(place + side * depthOfFilm * normal)) < 0.5;
            if (!isSolid && !isEmpty)
                return Space::Unclear;
        }
    return isSolid ? Space::Solid : Space::Empty;
}
} // namespace

void offsetOutwards(TriangleSoup& surface, std::span<const Slot> points, double distance)
{
    std::vector<bool> isMoved(surface.points.size(), false);
    for (const Slot v : points)
        isMoved[v] = true;
    offsetPlanes(surface, isMoved, distance, [](Slot) { return true; });
}

ContactOffset offsetContacts(TriangleSoup& surface, const std::stop_token& stop)
{
    constexpr double overlap = 6, inwards = 4; // lattice units
    constexpr double muchLess = 0.9;           // share of the covered share of another face
    constexpr std::size_t perFace = 4, perChunk = 64;
    const std::size_t faces = surface.triangles.size();
    const std::vector<FacePair> contacts = contactsIn(surface, perFace * faces);
    if (contacts.empty())
        return {};
    const WindingNumber solid(surface.places(), surface.triangles);
    std::vector<Space> spaces(contacts.size(), Space::Unclear);
    std::vector<double> area(contacts.size(), 0);
    forEachChunk(contacts.size(), perChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) {
            const Wall first(surface, surface.triangles[contacts[i].first]);
            const std::vector<Vec3> polygon = contactOf(first, {surface, surface.triangles[contacts[i].second]});
            area[i] = areaOf(polygon);
            spaces[i] = spaceBeside(polygon, first.normal, solid);
        }
    });
    std::vector<double> covered(faces, 0); // share of each face
    const auto areaOfFace = [&](Slot f) {
        const auto& corners = Wall(surface, surface.triangles[f]).corners;
        return areaOf({corners.begin(), corners.end()});
    };
    for (std::size_t i = 0; i < contacts.size(); ++i)
        if (spaces[i] == Space::Solid)
            for (const Slot f : {contacts[i].first, contacts[i].second})
                covered[f] += area[i] / areaOfFace(f);
    ContactOffset result;
    std::vector<bool> isOfBody(faces, false), isOfFilm(faces, false);
    double moved = 0, hidden = 0; // areas
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto [first, second] = contacts[i];
        result.pairs += spaces[i] != Space::Unclear ? 1 : 0;
        for (const auto& [f, other] : {std::pair(first, second), std::pair(second, first)}) {
            isOfFilm[f] = isOfFilm[f] || spaces[i] == Space::Empty;
            if (isOfBody[f] || spaces[i] != Space::Solid || covered[f] < muchLess * covered[other])
                continue;
            isOfBody[f] = true;
            moved += areaOfFace(f);
            hidden += std::min(1., covered[f]) * areaOfFace(f);
        }
    }
    const double before = volumeOf(surface);
    offsetFaces(surface, isOfBody, overlap);
    const double between = volumeOf(surface);
    offsetFaces(surface, isOfFilm, -inwards);
    result.addedVolume = moved > 0 ? (1 - hidden / moved) * (between - before) : 0;
    result.invertedVolume = between - volumeOf(surface);
    return result;
}
} // namespace core::repair
