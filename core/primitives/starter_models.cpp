// Starter models. Each is a closed grid, or an icosphere whose points are moved along their rays. Only + - x / and sqrt
// are used, so that the bits are the same on every machine.

#include "core/primitives/starter_models.h"

#include "core/primitives/grid_box.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr double half = 50; ///< half of the longest side, mm
constexpr int sphereSubdivisions = 5;

/// Names in the order of Starter.
constexpr std::string_view names[] = {"ball", "cube", "torus", "slab", "vase", "head", "tablet"};
static_assert(std::size(names) == std::size(starters));

/// Returns a box of `cells` cubic cells along each axis, each `cell` mm wide.
TriangleMesh box(const std::array<int, 3>& cells, double cell)
{
    return gridBox(cells, cell * Vec3(cells[0], cells[1], cells[2]));
}

/// Returns 4 times 2^halvings points of the unit circle, by repeatedly halving the angles between its 4 axis points.
std::vector<Eigen::Vector2d> circle(int halvings)
{
    std::vector<Eigen::Vector2d> points = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int n = 0; n < halvings; ++n) {
        std::vector<Eigen::Vector2d> finer;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector2d middle = points[i] + points[(i + 1) % points.size()];
            finer.push_back(points[i]);
            finer.push_back(middle / std::sqrt(middle.x() * middle.x() + middle.y() * middle.y()));
        }
        points = std::move(finer);
    }
    return points;
}

/// Returns a horizontal torus around the y axis.
TriangleMesh torus(double ring, double tube)
{
    const std::vector<Eigen::Vector2d> along = circle(5), around = circle(4);
    const auto columns = static_cast<Slot>(along.size()), rows = static_cast<Slot>(around.size());
    TriangleMesh mesh;
    for (const Eigen::Vector2d& a : along) {
        for (const Eigen::Vector2d& t : around) {
            const double out = ring + tube * t.x();
            mesh.points.push_back(Vec3(out * a.x(), tube * t.y(), out * a.y()).cast<float>());
        }
    }
    for (Slot i = 0; i < columns; ++i) {
        for (Slot j = 0; j < rows; ++j) {
            const Slot nextColumn = (i + 1) % columns * rows, nextRow = (j + 1) % rows;
            addQuad(mesh, {i * rows + j, i * rows + nextRow, nextColumn + nextRow, nextColumn + j}, (i + j) % 2 == 0);
        }
    }
    return mesh;
}

/// Returns (a^8 + b^8)^(1/8), a smooth maximum of the magnitudes of a and b.
double softMax(double a, double b)
{
    const double a2 = a * a, b2 = b * b, a4 = a2 * a2, b4 = b2 * b2;
    return std::sqrt(std::sqrt(std::sqrt(a4 * a4 + b4 * b4)));
}

/// Position of a point of the unit sphere: along the y axis, and its distance from the y axis.
struct Profile
{
    double up, out;
};

Profile profileOf(const Vec3& p)
{
    return {p.y(), std::sqrt(p.x() * p.x() + p.z() * p.z())};
}

/// Maps a point of the unit sphere to the vase: a cylinder with round rims that narrows to a foot and a neck.
Vec3 vasePoint(const Vec3& p)
{
    const Profile profile = profileOf(p);
    const Vec3 q = half / softMax(profile.up, profile.out) * p;
    const double height = q.y() / half; // -1 to 1
    const double width = 0.62 - 0.10 * height - 0.16 * height * height;
    return {width * q.x(), q.y(), width * q.z()};
}

/// Maps a point of the unit sphere to the head: an egg, narrow at the chin, on a neck, facing +z. Not yet scaled or
/// centred.
Vec3 headPoint(const Vec3& p)
{
    const Profile profile = profileOf(p);
    const double chin = profile.up < 0 ? 1 - 0.22 * profile.up * profile.up : 1;
    const double forward = p.z() > 0 && profile.up < 0 ? 1 + 0.25 * profile.up * profile.up : 1;
    const double egg = 1 / std::sqrt(profile.up * profile.up + profile.out * profile.out / (chin * chin));
    const double neck = profile.up < 0 ? 1 / softMax(profile.up / 1.5, profile.out / 0.48) : 0;
    const double length = softMax(egg, neck);
    return {0.74 * length * p.x(), length * p.y(), 0.86 * forward * length * p.z()};
}

template <class Place> TriangleMesh onRays(Place place)
{
    TriangleMesh mesh = icosphere(sphereSubdivisions, 1);
    for (Vec3f& p : mesh.points)
        p = place(p.cast<double>()).template cast<float>();
    return mesh;
}

/// Scales the mesh to a longest side of 100 mm and moves the centre of its box to the origin.
TriangleMesh fitted(TriangleMesh mesh)
{
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : mesh.points)
        box.extend(p);
    const Vec3 middle = 0.5 * (box.min().cast<double>() + box.max().cast<double>());
    const double scale = 2 * half / box.sizes().cast<double>().maxCoeff();
    for (Vec3f& p : mesh.points)
        p = (scale * (p.cast<double>() - middle)).cast<float>();
    return mesh;
}
} // namespace

std::string_view name(Starter starter)
{
    return names[static_cast<std::size_t>(starter)];
}

std::optional<Starter> starterNamed(std::string_view name)
{
    const auto found = std::ranges::find(names, name);
    return found == std::end(names) ? std::nullopt : std::optional(static_cast<Starter>(found - std::begin(names)));
}

TriangleMesh starterModel(Starter starter)
{
    switch (starter) {
    case Starter::Ball:
        break;
    case Starter::Cube:
        return box({40, 40, 40}, half / 20);
    case Starter::Torus:
        return torus(0.68 * half, 0.32 * half);
    case Starter::Slab:
        return box({64, 12, 64}, half / 32);
    case Starter::Vase:
        return onRays(vasePoint);
    case Starter::Head:
        return fitted(onRays(headPoint));
    case Starter::Tablet:
        return box({60, 80, 6}, half / 40);
    }
    return icosphere(sphereSubdivisions, half);
}
} // namespace core
