// Measures walls: every face at its centre, and faces that are large for their thickness in parts.

#include "core/print/wall_thickness.h"

#include "core/print/wall_balls.h"
#include "core/print/wall_parts.h"
#include "core/print/wall_ridges.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr std::size_t centresAtOnce = 256, facesPerPart = 1 << 14, largeFacesAtOnce = 8;

/// A face is divided into at most allParts / (number of faces) parts, limited to minParts to maxParts.
constexpr std::size_t allParts = 200'000, minParts = 4, maxParts = 4096;
/// Factor from the depth of the matter to the start diameter of a ball, so that the ball contains what is straight
/// ahead.
constexpr double beyond = 1.25;
/// Area that is ignored, as a share of the whole area.
constexpr double smallShare = 5e-7;
/// Faces this factor thicker at their centres than the thinnest place are not searched for thinner places.
constexpr double centreError = 1.15;

double leastOf(const WallThickness& walls)
{
    double least = noBall;
    for (const float centre : walls.atCentres)
        least = std::min(least, static_cast<double>(centre));
    for (const WallPart& part : walls.parts)
        least = std::min(least, static_cast<double>(part.least));
    return least;
}

class Thickness
{
public:
    Thickness(const TriangleMesh& mesh, double largestBall)
        : m_surface(mesh)
        , m_rays(m_surface)
        , m_balls(mesh, m_surface, m_rays)
        , m_ridges(mesh, m_surface.edges(), m_rays)
        , m_largestBall(largestBall)
        , m_parts(m_surface, m_rays, m_balls, m_ridges, limits(m_surface, largestBall))
        , m_isLarge(m_surface.size(), 0)
    {}

    void measure(std::size_t first, std::size_t count, const JobControl& control, WallThickness& result)
    {
        forEachChunk(count, centresAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i)
                measureCentre(static_cast<Slot>(i), result);
        });
        std::vector<Slot> large;
        for (std::size_t i = first; i < first + count; ++i)
            if (m_isLarge[i] != 0)
                large.push_back(static_cast<Slot>(i));
        const std::size_t atOnce = large.size() < centresAtOnce ? 1 : largeFacesAtOnce;
        const auto parts = joinChunks<std::vector<WallPart>>(
            large.size(), atOnce, [&](std::size_t begin, std::size_t end, std::vector<WallPart>& some) {
                for (std::size_t i = begin; i < end && !control.isCancelled(); ++i) {
                    const double centre = static_cast<double>(result.atCentres[m_surface.faceAt(large[i])]);
                    const std::vector<WallPart> divided = m_parts.divide(large[i], centre, control);
                    some.insert(some.end(), divided.begin(), divided.end());
                }
            });
        result.parts.insert(result.parts.end(), parts.begin(), parts.end());
    }

    /// Searches the faces that may be thinner than the thinnest place found, of those that are not divided. Begins with
    /// the thinnest at their centres, and ends with the first slice that has nothing thinner.
    void measureThinnest(const JobControl& control, WallThickness& result) const
    {
        double least = leastOf(result);
        if (!m_surface.hasMany() || least == noBall)
            return;
        const std::vector<Thin> faces = thinFaces(result, centreError * least);
        for (std::size_t first = 0; first < faces.size() && !control.isCancelled(); first += facesPerPart) {
            const auto parts = joinChunks<std::vector<WallPart>>(
                std::min(facesPerPart, faces.size() - first), centresAtOnce,
                [&](std::size_t begin, std::size_t end, std::vector<WallPart>& some) {
                    for (std::size_t i = first + begin; i < first + end; ++i)
                        if (const auto part = m_parts.thinnerThan(faces[i].position, faces[i].centre, least))
                            some.push_back(*part);
                });
            if (parts.empty())
                return;
            result.parts.insert(result.parts.end(), parts.begin(), parts.end());
            least = static_cast<double>(std::ranges::min_element(parts, {}, &WallPart::least)->least);
        }
    }

    void measureRidges(const JobControl& control, WallThickness& result) const
    {
        std::vector<float> least = result.atCentres;
        for (const WallPart& part : result.parts)
            least[part.face] = std::min(least[part.face], part.least);
        const auto thinnest = std::ranges::min_element(least);
        const bool hasWalls = thinnest != least.end() && std::isfinite(*thinnest);
        const double thickest = hasWalls ? std::max(m_largestBall, static_cast<double>(*thinnest)) : m_largestBall;
        result.ridges = m_ridges.measure(least, thickest, control);
    }

    std::size_t size() const { return m_surface.size(); }

private:
    struct Thin
    {
        double centre; ///< thickness at the centre of the face
        Slot position;

        auto operator<=>(const Thin&) const = default;
    };

    /// Returns the faces that are not divided, at most `most` thick at their centres, and uneven. The thinnest is
    /// first.
    std::vector<Thin> thinFaces(const WallThickness& walls, double most) const
    {
        std::vector<std::uint8_t> isDivided(walls.atCentres.size(), 0);
        for (const WallPart& part : walls.parts)
            isDivided[part.face] = 1;
        std::vector<Thin> faces;
        for (Slot position = 0; position < m_surface.size(); ++position) {
            const Slot face = m_surface.faceAt(position);
            const auto centre = static_cast<double>(walls.atCentres[face]);
            if (isDivided[face] == 0 && centre <= most && !m_parts.isEven(position, centre))
                faces.push_back({centre, position});
        }
        std::ranges::sort(faces);
        return faces;
    }

    static WallParts::Limits limits(const WallSurface& surface, double largestBall)
    {
        double area = 0;
        for (Slot position = 0; position < surface.size(); ++position)
            area += surface.areaOf(position);
        return {largestBall, std::clamp(allParts / std::max<std::size_t>(1, surface.size()), minParts, maxParts),
                smallShare * area};
    }

    /// Measures a face at its centre. The ball starts from the rays' result or from the depth of the matter, but not
    /// above the largest ball.
    void measureCentre(Slot position, WallThickness& result)
    {
        double rays = noBall, ball = noBall;
        if (m_surface.hasArea(position)) {
            const Vec3 centre = m_surface.pointOf(position, Vec3::Constant(1.0 / 3));
            rays = m_rays.byRays(position, centre, m_largestBall);
            const double depth = rays < noBall ? rays : beyond * m_rays.depthBehind(position, centre);
            ball = std::min(rays, m_balls.byBall(position, centre, std::min(m_largestBall, depth)));
            m_isLarge[position] = m_parts.isLarge(position, ball, depth) ? 1 : 0;
        }
        result.atCentres[m_surface.faceAt(position)] = static_cast<float>(ball);
    }

    WallSurface m_surface;
    WallRays m_rays;
    WallBalls m_balls;
    WallRidges m_ridges;
    double m_largestBall;
    WallParts m_parts;
    /// Flags by position in the tree; bytes, because threads write neighbouring elements.
    std::vector<std::uint8_t> m_isLarge;
};
} // namespace

double WallPart::shareBelow(double thickness) const
{
    const auto from = static_cast<double>(least), to = static_cast<double>(most);
    if (thickness <= from)
        return 0;
    return thickness >= to ? 1 : (thickness - from) / (std::min(to, 2 * thickness) - from);
}

double WallRidge::area() const
{
    const auto length = static_cast<double>((ends[1] - ends[0]).norm()), width = static_cast<double>(least);
    return width * (length > 0 ? length : width);
}

/// Works slice by slice, so that other threads get the cores between slices.
WallThickness wallThickness(const TriangleMesh& mesh, double largestBall, const JobControl& control)
{
    WallThickness result;
    const std::size_t faces = mesh.triangles.size();
    result.atCentres.resize(faces);
    Thickness thickness(mesh, largestBall);
    for (std::size_t first = 0; first < faces && !control.isCancelled(); first += facesPerPart) {
        const std::size_t count = std::min(facesPerPart, faces - first);
        thickness.measure(first, count, control, result);
        control.reportProgress(static_cast<double>(first + count) / static_cast<double>(faces));
    }
    thickness.measureThinnest(control, result);
    std::ranges::stable_sort(result.parts, {}, &WallPart::face);
    if (!control.isCancelled())
        thickness.measureRidges(control, result);
    return result;
}
} // namespace core
