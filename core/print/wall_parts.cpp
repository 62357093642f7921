#include "core/print/wall_parts.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// The thickness at a face's centre holds for the whole face if the face's radius is at most this number of
/// thicknesses. Where two faces meet at 60 degrees, the extreme for a thin place, the thickness changes by the distance
/// moved; elsewhere it changes by little. Faces larger than `small` times the largest ball are always searched, and so
/// are smaller ones with a ridge opposite, such as the ground of a groove. At the centre the ridge may be more than 30
/// degrees off the normal, unless it is farther away than radius / `compact`.
constexpr double small = 0.05, smallOfMany = 0.35;
/// The thickness at the centre holds for a face that is nowhere thinner than the share sameThickness of it. A part is
/// divided if its least thickness is below the share evenThickness of its largest.
constexpr double sameThickness = 0.97, evenThickness = 0.9, evenThicknessOfMany = 0.8;
/// A face whose radius is at most `compact` thicknesses is taken for one of many that approximate a round surface.
/// Its corners are off its normal, so the matter there would seem too thin. The thickness at the centre is used for the
/// whole face, unless a smaller ball, compactThickness times as large, touches an opposite face somewhere in the face.
constexpr double compact = 0.1, compactOfMany = 0.5, compactThickness = 0.9;
/// Factor from the size of the face, or of the ball at its centre, to the start diameter of balls elsewhere in the
/// face.
constexpr double many = 4;
/// Parts are not divided further where the matter is thinner than this, in the model's unit, as towards a sharp edge.
/// In mm this is thinner than any printed wall.
constexpr double finest = 0.1;
/// Barycentric weights of the places at which a part is measured: its middle, and near its corners.
constexpr std::array<std::array<double, 3>, 4> places = {
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.94, 0.03, 0.03}, {0.03, 0.94, 0.03}, {0.03, 0.03, 0.94}}};

Vec3 weightsAt(const WallCell& cell, const std::array<double, 3>& place)
{
    return place[0] * cell.weights[0] + place[1] * cell.weights[1] + place[2] * cell.weights[2];
}

std::array<WallCell, 2> halves(const WallCell& cell, const std::array<Vec3, 3>& corners)
{
    std::size_t longest = 0;
    double max = -1;
    for (std::size_t i = 0; i < 3; ++i)
        if (const double side = (corners[(i + 1) % 3] - corners[i]).squaredNorm(); side > max) {
            max = side;
            longest = i;
        }
    const Vec3 middle = (cell.weights[longest] + cell.weights[(longest + 1) % 3]) / 2;
    std::array<WallCell, 2> result = {cell, cell};
    result[0].weights[(longest + 1) % 3] = middle;
    result[1].weights[longest] = middle;
    return result;
}
} // namespace

/// Returns the distance from the centre to the farthest corner.
double WallParts::radiusOf(Slot position) const
{
    const std::array<Vec3, 3> corners = m_surface.cornersOf(position);
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3;
    double radius2 = 0;
    for (const Vec3& corner : corners)
        radius2 = std::max(radius2, (corner - centre).squaredNorm());
    return std::sqrt(radius2);
}

bool WallParts::isLarge(Slot position, double centre, double reach) const
{
    if (!m_surface.hasArea(position))
        return false;
    const double share = m_surface.hasMany() ? smallOfMany : small, radius = radiusOf(position);
    if (radius > std::min(share * std::min(centre, reach), small * m_limits.largestBall))
        return true;
    const double farthest = std::min({centre, radius / std::max(share, compact), m_limits.largestBall});
    return m_ridges.mayBeOpposite(m_surface.cornersOf(position), m_surface.inwardOf(position), farthest);
}

std::vector<WallPart> WallParts::divide(Slot position, double centre, const JobControl& control) const
{
    const double radius = radiusOf(position);
    const double start = std::max(m_limits.largestBall, centre < noBall ? centre : many * radius);
    const double atPlaces =
        centre < noBall ? std::min(m_limits.largestBall, many * std::max(centre, radius)) : m_limits.largestBall;
    const double seen =
        centre < noBall ? centre : m_rays.depthBehind(position, m_surface.pointOf(position, WallCell().centre()));
    if (radius <= (m_surface.hasMany() ? compactOfMany : compact) * seen) {
        const ThinnestPlace place =
            m_balls.thinnestIn(position, {}, std::min(compactThickness * seen, m_limits.largestBall));
        if (place.diameter == noBall && place.hidden == noBall)
            return {};
    }
    std::priority_queue<Cell> cells;
    Cell whole = measured(position, {}, 1, {start, atPlaces});
    whole.least = std::min(whole.least, centre);
    if (whole.doubt == 0 && whole.least >= sameThickness * centre)
        return {};
    cells.push(whole);
    for (std::size_t number = 1; cells.top().doubt > 0 && cells.size() < m_limits.parts && !control.isCancelled();) {
        const Cell cell = cells.top();
        cells.pop();
        std::array<Vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = m_surface.pointOf(position, cell.cell.weights[i]);
        for (const WallCell& half : halves(cell.cell, corners)) {
            Cell next = measured(position, half, cell.share / 2, {start, atPlaces});
            next.number = number++;
            cells.push(next);
        }
    }
    std::vector<WallPart> parts;
    for (; !cells.empty(); cells.pop())
        addParts(position, cells.top(), parts);
    return parts;
}

bool WallParts::isEven(Slot position, double centre) const
{
    return radiusOf(position) <= compact * centre;
}

std::optional<WallPart> WallParts::thinnerThan(Slot position, double centre, double below) const
{
    const ThinnestPlace place = m_balls.thinnestIn(position, {}, below);
    if (place.diameter >= below)
        return {};
    return partOf(position, {{}, 1, {}, place.diameter, centre, place.point, 0, 0});
}

/// Measures a cell at its places and then as a whole, starting from the least diameter found: between the places it may
/// be thinner.
WallParts::Cell WallParts::measured(Slot position, const WallCell& cell, double share, const Starts& starts) const
{
    Cell result{cell, share, {}, noBall, 0, m_surface.pointOf(position, cell.centre()), 0, 0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3 p = m_surface.pointOf(position, weightsAt(cell, places[i]));
        const double diameter = result.atPlaces[i] = m_balls.byBall(position, p, starts.atPlaces);
        result.most = std::max(result.most, diameter);
        if (diameter < result.least) {
            result.least = diameter;
            result.thinnest = p;
        }
    }
    const double below = result.least < noBall ? sameThickness * result.least : starts.inCell;
    const ThinnestPlace place = m_balls.thinnestIn(position, cell, below);
    if (place.diameter < result.least) {
        result.least = place.diameter;
        result.thinnest = place.point;
    }
    result.doubt = doubtOf(result, position, place.hidden);
    return result;
}

double WallParts::doubtOf(const Cell& cell, Slot position, double hidden) const
{
    const double least = std::min(cell.least, hidden), most = std::min(cell.most, 2 * m_limits.largestBall);
    if (least >= m_limits.largestBall || least >= even() * most || most <= finest)
        return 0;
    const double doubt = m_surface.areaOf(position) * cell.share * (1 - least / most);
    return doubt < m_limits.area ? 0 : doubt;
}

double WallParts::even() const
{
    return m_surface.hasMany() ? evenThicknessOfMany : evenThickness;
}

/// Adds a cell as one part if its thickness is even. A cell that is uneven but was not divided further, as where the
/// thickness jumps, becomes four quarters, each with the thickness of its place.
void WallParts::addParts(Slot position, const Cell& cell, std::vector<WallPart>& parts) const
{
    if (cell.least >= m_limits.largestBall || cell.least >= even() * cell.most) {
        parts.push_back(partOf(position, cell));
        return;
    }
    const auto& [a, b, c] = cell.cell.weights;
    const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    const std::array<std::array<Vec3, 3>, 4> quarters = {{{ab, bc, ca}, {a, ab, ca}, {ab, b, bc}, {ca, bc, c}}};
    const auto thinnest = std::ranges::min_element(cell.atPlaces) - cell.atPlaces.begin();
    for (std::size_t i = 0; i < quarters.size(); ++i) {
        const bool isThinnest = static_cast<std::ptrdiff_t>(i) == thinnest;
        Cell quarter{{quarters[i]}, cell.share / 4, {}, cell.atPlaces[i], cell.atPlaces[i], {}, 0, 0};
        quarter.least = isThinnest ? cell.least : cell.atPlaces[i];
        quarter.thinnest = isThinnest ? cell.thinnest : m_surface.pointOf(position, weightsAt(cell.cell, places[i]));
        parts.push_back(partOf(position, quarter));
    }
}

WallPart WallParts::partOf(Slot position, const Cell& cell) const
{
    WallPart part;
    part.face = m_surface.faceAt(position);
    for (std::size_t i = 0; i < 3; ++i)
        part.corners[i] = m_surface.pointOf(position, cell.cell.weights[i]).cast<float>();
    part.share = static_cast<float>(cell.share);
    const double least =
        cell.least < noBall ? cell.least : m_rays.byRays(position, cell.thinnest, m_limits.largestBall);
    part.least = static_cast<float>(least);
    part.most = std::max(part.least, static_cast<float>(cell.most));
    part.thinnest = cell.thinnest.cast<float>();
    return part;
}
} // namespace core
