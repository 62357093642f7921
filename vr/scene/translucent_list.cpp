#include "vr/scene/translucent_list.h"

#include "vr/scene/label_layout.h"
#include "vr/scene/light.h"

#include "core/stroke/radial_symmetry.h"
#include "core/stroke/symmetry_plane.h"

#include <algorithm>

namespace vr
{
namespace
{
const Eigen::Vector3f planeColor(0.15F, 0.33F, 0.66F), accentColor(0.22F, 0.56F, 1.0F), paleColor(0.85F, 0.88F, 0.92F);
const Eigen::Vector3f bladeColor(0.95F, 0.28F, 0.20F);
const Eigen::Vector3f holdColor(1.0F, 0.48F, 0.10F);
const Eigen::Vector3f spotlightColor(0.30F, 1.0F, 0.06F); ///< a colour that no other shape has

constexpr float thin = 0.0011F, thinner = 0.0008F; ///< widths of lines, metres
constexpr float mirrored = 0.45F; ///< strength of a brush's images by symmetry as a fraction of the brush's
constexpr double rayReach = 3, dotRadius = 0.0035, thumbRadius = 0.0042;
constexpr double offSurface = 0.0006; ///< distance above a surface at which shapes are drawn to be visible, metres
constexpr float bladeHole = 0.985F;
constexpr double bladeArrow = 0.05; ///< metres
constexpr double holdRadius = 0.026, holdLift = 0.030;
constexpr float holdHole = 0.80F, footprintHole = 0.97F;
/// Middle of the ring for holds in grip space, metres: between the side buttons.
const core::Vec3 holdPlace(0, 0, 0.012);
// Sizes of the light where somebody points, metres.
constexpr double spotlightRadius = 0.007, minWave = 0.012, maxWave = 0.036, beamHeight = 0.35;
constexpr float beamWidth = 0.003F, waveHole = 0.78F, hiddenOpacity = 0.45F;

Eigen::Vector3f toFloat(const core::Vec3& v)
{
    return v.cast<float>();
}

Rectangle rectangle(const core::Vec3& center, const core::Vec3& halfX, const core::Vec3& halfY)
{
    return {toFloat(center), toFloat(halfX), toFloat(halfY)};
}

/// Returns the square around a ring of this radius, perpendicular to a unit normal.
Rectangle acrossTo(const core::Vec3& center, const core::Vec3& normal, double radius)
{
    const core::Vec3 x = normal.unitOrthogonal();
    return rectangle(center, radius * x, radius * normal.cross(x));
}

class TranslucentListBuilder
{
public:
    TranslucentListBuilder(const SceneState& state, LabelTextures& labels, TranslucentList& list)
        : m_state(state)
        , m_labels(labels)
        , m_list(list)
    {}

    void addPlane();
    void addBrush(std::monostate) {}
    void addBrush(const BallBrush& brush);
    void addBrush(const RayBrush& brush);
    void addOutline(const Segment& edge);
    void addBlade(const Blade& blade, float strength = 1);
    void addWand(const ShownWand& wand);
    void addLaser(const Laser& laser);
    void addSpotlight(const Spotlight& spotlight);
    void addTeacher(const core::Sphere& brush);
    void addPanel(const Panel& panel);

private:
    template <class Shape> void add(const core::Vec3& middle, const Shape& shape)
    {
        m_list.others.push_back({static_cast<float>((middle - m_state.head.position).norm()), shape});
    }
    void addLine(const core::Vec3& from, const core::Vec3& to, const Line& look);
    void addDot(const core::Vec3& at, double radius, const Eigen::Vector3f& color);
    void addFootprint(const RayBrush::Hit& hit, float strength);
    void addLabels(const ShownWand& wand);
    void addHold(const ShownWand& wand);
    /// Visits the transforms from the brush to its images: in the other radial sectors, and mirrored by the plane of
    /// symmetry.
    template <class Visit> void forEachImage(Visit visit) const;

    const SceneState& m_state;
    LabelTextures& m_labels;
    TranslucentList& m_list;
};

void TranslucentListBuilder::addLine(const core::Vec3& from, const core::Vec3& to, const Line& look)
{
    Line line = look;
    line.from = toFloat(from);
    line.to = toFloat(to);
    add(0.5 * (from + to), line);
}

/// Adds a disc that faces the head.
void TranslucentListBuilder::addDot(const core::Vec3& at, double radius, const Eigen::Vector3f& color)
{
    const Eigen::Matrix3d axes = axesFacing(m_state.head, at);
    const core::Vec3 before = at + dotRadius / 2 * axes.col(2);
    add(before, Ring{.place = rectangle(before, radius * axes.col(0), radius * axes.col(1)), .color = color});
}

template <class Visit> void TranslucentListBuilder::forEachImage(Visit visit) const
{
    const core::Vec3 normal = core::planeNormal(m_state.symmetry);
    const Eigen::Matrix3d reflection = Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose();
    for (int k = 0; k < m_state.radial; ++k) {
        const core::Turn part = core::Turn::part(k, m_state.radial);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(std::atan2(part.sine, part.cosine), core::Vec3::UnitY()).toRotationMatrix();
        if (k > 0)
            visit(Eigen::Affine3d(m_state.model * Eigen::Affine3d(turn) * m_state.model.inverse()));
        if (m_state.symmetry != core::Symmetry::None)
            visit(Eigen::Affine3d(m_state.model * Eigen::Affine3d(reflection * turn) * m_state.model.inverse()));
    }
}

void TranslucentListBuilder::addPlane()
{
    if (m_state.symmetry == core::Symmetry::None || m_state.box.isEmpty())
        return;
    const core::SymmetryPlane plane = core::symmetryPlane(m_state.symmetry, m_state.box);
    const core::Vec3 center = m_state.model * plane.center;
    const core::Vec3 halfX = m_state.model.linear() * plane.halfX, halfY = m_state.model.linear() * plane.halfY;
    add(center, Plane{rectangle(center, halfX, halfY), planeColor});
}

void TranslucentListBuilder::addBrush(const BallBrush& brush)
{
    const Eigen::Vector3f color = linearFromSrgb(m_state.brushColor);
    const auto radius = static_cast<float>(brush.radius);
    add(brush.center, Shell{toFloat(brush.center), radius, color});
    forEachImage([&](const Eigen::Affine3d& image) {
        add(image * brush.center, Shell{toFloat(image * brush.center), radius, color, mirrored});
    });
}

void TranslucentListBuilder::addBrush(const RayBrush& brush)
{
    const Eigen::Vector3f color = linearFromSrgb(m_state.brushColor);
    const core::Vec3 from = brush.ray.origin;
    const core::Vec3 to = brush.hit ? brush.hit->point : core::Vec3(from + rayReach * brush.ray.direction.normalized());
    addLine(from, to, {.width = thin, .color = color, .alphas = {0.25F, brush.hit ? 0.9F : 0.0F}});
    if (!brush.hit)
        return;
    addDot(brush.hit->point, dotRadius, color);
    addFootprint(*brush.hit, 1);
    forEachImage([&](const Eigen::Affine3d& image) {
        addFootprint({image * brush.hit->point, image.linear() * brush.hit->normal, brush.hit->radius}, mirrored);
    });
}

void TranslucentListBuilder::addOutline(const Segment& edge)
{
    addLine(edge.from, edge.to,
            {.width = thinner, .color = linearFromSrgb(m_state.brushColor), .alphas = {0.8F, 0.8F}});
}

/// Adds a disc with a rim, and a line that points to the side that would be cut away.
void TranslucentListBuilder::addBlade(const Blade& blade, float strength)
{
    Ring ring{.place = acrossTo(blade.center, blade.normal, blade.radius),
              .color = bladeColor,
              .alpha = 0.28F * strength,
              .hiddenAlpha = 0.10F * strength};
    add(blade.center, ring);
    ring.hole = bladeHole;
    ring.alpha = 0.9F * strength;
    ring.hiddenAlpha = 0.4F * strength;
    add(blade.center + offSurface * blade.normal, ring);
    addLine(blade.center, blade.center + bladeArrow * blade.normal,
            {.width = thin, .color = bladeColor, .alphas = {0.9F * strength, 0.0F}});
}

void TranslucentListBuilder::addFootprint(const RayBrush::Hit& hit, float strength)
{
    const core::Vec3 center = hit.point + offSurface * hit.normal;
    add(center, Ring{.place = acrossTo(center, hit.normal, hit.radius),
                     .hole = footprintHole,
                     .color = linearFromSrgb(m_state.brushColor),
                     .alpha = strength,
                     .hiddenAlpha = 0.25F * strength});
}

void TranslucentListBuilder::addWand(const ShownWand& wand)
{
    if (!wand.isShown)
        return;
    if (wand.touch) {
        const core::Vec3 at = wand.grip * (placeOnPad(*wand.touch) + offSurface * core::Vec3::UnitY());
        const Eigen::Matrix3d axes = thumbRadius * wand.grip.rotation.toRotationMatrix();
        add(at, Ring{.place = rectangle(at, axes.col(0), -axes.col(2)), .color = paleColor, .alpha = 0.85F});
    }
    addHold(wand);
    addLabels(wand);
}

void TranslucentListBuilder::addHold(const ShownWand& wand)
{
    if (wand.holdProgress <= 0)
        return;
    const core::Vec3 middle = wand.grip * holdPlace;
    const Eigen::Matrix3d axes = axesFacing(m_state.head, middle);
    const core::Vec3 center = middle + holdLift * axes.col(2);
    Ring ring{.place = rectangle(center, holdRadius * axes.col(0), holdRadius * axes.col(1)),
              .hole = holdHole,
              .color = paleColor,
              .alpha = 0.22F,
              .hiddenAlpha = 0.08F};
    add(center, ring);
    ring.sweep = static_cast<float>(std::min(wand.holdProgress, 1.0));
    ring.color = holdColor;
    ring.alpha = 1;
    ring.hiddenAlpha = 0.4F;
    add(center + offSurface * axes.col(2), ring);
}

void TranslucentListBuilder::addLabels(const ShownWand& wand)
{
    LabelAspects aspects;
    std::array<unsigned int, wandSpotCount> textures{};
    for (std::size_t spot = 0; spot < wandSpotCount; ++spot) {
        if (wand.labels[spot].text.isEmpty() || wand.labels[spot].opacity <= 0)
            continue;
        if (const auto picture = m_labels.find(wand.labels[spot].text)) {
            aspects[spot] = picture->aspect;
            textures[spot] = picture->texture;
        }
    }
    const LabelPlaces places = labelPlaces(wand.grip, m_state.head, aspects);
    for (std::size_t spot = 0; spot < wandSpotCount; ++spot) {
        if (!places[spot])
            continue;
        const LabelPlace& place = *places[spot];
        const float opacity = wand.labels[spot].opacity;
        add(place.center, Picture{rectangle(place.center, place.halfX, place.halfY), textures[spot], opacity});
        addLine(place.button, place.edge,
                {.width = thinner, .color = paleColor, .alphas = {0.60F * opacity, 0.30F * opacity}});
    }
}

void TranslucentListBuilder::addLaser(const Laser& laser)
{
    addLine(laser.from, laser.to, {.width = thin, .color = accentColor, .alphas = {0.15F, 0.9F}});
    addDot(laser.to, dotRadius, accentColor);
}

/// Adds a glowing bead, a wave that spreads on the surface, and a beam from above. Their shapes make the place easy to
/// find, even through the clay.
void TranslucentListBuilder::addSpotlight(const Spotlight& spotlight)
{
    const core::Vec3 at = spotlight.center + offSurface * spotlight.normal;
    const Eigen::Matrix3d axes = axesFacing(m_state.head, at);
    // Smaller discs are in front of larger ones.
    const auto bead = [&](double radius, const Eigen::Vector3f& color, float alpha) {
        const core::Vec3 before = at + (spotlightRadius - radius / 4) * axes.col(2);
        add(before, Ring{.place = rectangle(before, radius * axes.col(0), radius * axes.col(1)),
                         .color = color,
                         .alpha = alpha,
                         .hiddenAlpha = hiddenOpacity * alpha});
    };
    const double wave = minWave + (maxWave - minWave) * spotlight.phase;
    const auto strength = static_cast<float>(1 - spotlight.phase);
    add(at, Ring{.place = acrossTo(at, spotlight.normal, wave),
                 .hole = waveHole,
                 .color = spotlightColor,
                 .alpha = strength,
                 .hiddenAlpha = hiddenOpacity * strength});
    addLine(at + beamHeight * core::Vec3::UnitY(), at,
            {.width = beamWidth, .color = spotlightColor, .alphas = {0.0F, 0.9F}});
    bead(2 * spotlightRadius, spotlightColor, 0.35F);
    bead(spotlightRadius, spotlightColor, 1);
    bead(0.45 * spotlightRadius, Eigen::Vector3f::Ones(), 1);
}

void TranslucentListBuilder::addTeacher(const core::Sphere& brush)
{
    add(brush.center, Shell{toFloat(brush.center), static_cast<float>(brush.radius), accentColor});
}

void TranslucentListBuilder::addPanel(const Panel& panel)
{
    const core::Vec3 center = panel.pose.position;
    const core::Vec3 halfX = panel.pose.rotation * core::Vec3(panel.size.x() / 2, 0, 0);
    const core::Vec3 halfY = panel.pose.rotation * core::Vec3(0, panel.size.y() / 2, 0);
    m_list.panels.push_back({static_cast<float>((center - m_state.head.position).norm()),
                             Picture{rectangle(center, halfX, halfY), panel.textureId, panel.opacity}});
}

/// Returns the mirror image of a blade in the model.
Blade imageOf(const Blade& blade, const Eigen::Affine3d& model)
{
    const core::Vec3 mirror = (model.linear() * core::planeNormal(blade.image)).normalized();
    Blade image = blade;
    image.center -= 2 * mirror.dot(blade.center - model.translation()) * mirror;
    image.normal -= 2 * mirror.dot(blade.normal) * mirror;
    return image;
}

void sortByDistance(std::vector<TranslucentShape>& list)
{
    std::ranges::sort(list, std::greater(), &TranslucentShape::distance);
}
} // namespace

void buildTranslucentList(const SceneState& state, LabelTextures& labels, TranslucentList& into)
{
    into.panels.clear();
    into.others.clear();
    TranslucentListBuilder builder(state, labels, into);
    builder.addPlane();
    std::visit([&](const auto& brush) { builder.addBrush(brush); }, state.brush);
    if (state.blade) {
        builder.addBlade(*state.blade);
        if (state.blade->image != core::Symmetry::None)
            builder.addBlade(imageOf(*state.blade, state.model), mirrored);
    }
    for (const Segment& edge : state.outline)
        builder.addOutline(edge);
    for (const ShownWand& wand : state.wands)
        builder.addWand(wand);
    for (const std::optional<Laser>& laser : state.lasers)
        if (laser)
            builder.addLaser(*laser);
    if (state.teacher)
        builder.addTeacher(*state.teacher);
    if (state.spotlight)
        builder.addSpotlight(*state.spotlight);
    for (const Panel& panel : state.panels)
        builder.addPanel(panel);
    sortByDistance(into.panels);
    sortByDistance(into.others);
}
} // namespace vr
