#pragma once

#include "vr/openxr/wand_state.h"
#include "vr/scene/wand_model.h"
#include "vr/util/pose.h"

#include "core/render/shading.h"
#include "core/stroke/tool.h"

#include <QString>

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace vr
{
/// A short text at a wand's button; empty: none.
struct WandLabel
{
    QString text;
    float opacity = 1;
};

/// A wand as it is drawn.
struct ShownWand
{
    /// Control of the thumb; None: the wand has a trigger and a menu button only.
    enum class Thumb { Pad, Stick, None };

    bool isShown = false; ///< false while it is not tracked
    Thumb thumb = Thumb::Pad;
    Pose grip;
    std::array<bool, wandPartCount> isLit{};         ///< by WandPart: what is pressed
    double trigger = 0;                              ///< share that it is pulled, 0 to 1
    std::optional<Eigen::Vector2d> touch;            ///< where a thumb lies on the pad, as in WandState
    Eigen::Vector2d stick = Eigen::Vector2d::Zero(); ///< where it pushes the thumbstick, as in WandState
    double holdProgress = 0; ///< share of the ring between the side buttons that is full, 0 to 1; 0: no ring
    std::array<WandLabel, wandSpotCount> labels; ///< by WandSpot
    std::optional<core::Rgb> tip;                ///< the colour of the bead at the front end
};

/// The spherical brush at a wand's tip. Units: metres, in room space.
struct BallBrush
{
    core::Vec3 center = core::Vec3::Zero();
    double radius = 0.03;
    int falloff = 4; ///< n of b(x), by which the mesh within the brush is tinted
    double core = 0; ///< part of the radius within which its weight is 1
};

/// The ray brush. Units: metres, in room space.
struct RayBrush
{
    struct Hit
    {
        core::Vec3 point, normal; ///< the normal has length 1
        double radius;            ///< of the footprint
    };
    core::Ray ray;
    std::optional<Hit> hit; ///< of the ray and the mesh
};

/// A beam from a wand to a panel, in room space.
struct Laser
{
    core::Vec3 from, to;
};

/// The place on the surface at which somebody beside the headset points.
struct Spotlight
{
    core::Vec3 center = core::Vec3::Zero(), normal = core::Vec3::UnitY(); ///< of the surface; the normal has length 1
    double phase = 0;                                                     ///< phase of its wave, 0 to 1, repeating
};

/// A rectangle with a texture. Its back is a dark plate.
struct Panel
{
    Pose pose;                      ///< of its middle: +X to its right, +Y up, +Z towards its reader
    Eigen::Vector2d size{0.4, 0.3}; ///< metres
    unsigned int textureId = 0;     ///< id of a Texture
    float opacity = 1;
};

/// Everything that a frame shows except the mesh itself. In room space, except where a member says otherwise.
struct SceneState
{
    Pose head; ///< midway between the eyes
    /// Transform from document to room: scaled uniformly, rotated and translated, never mirrored.
    Eigen::Affine3d model = Eigen::Affine3d(Eigen::UniformScaling(1e-3));
    core::Box box; ///< of the model, mm; empty: no model
    core::Shading shading;
    bool isFlat = false;    ///< shades each triangle evenly
    bool hasTint = true;    ///< colours what the brush would move
    bool hasCavity = false; ///< darkens valleys, lightens ridges
    core::Symmetry symmetry = core::Symmetry::None;
    int radial = 1; ///< sectors about the model's y axis
    std::variant<std::monostate, BallBrush, RayBrush> brush;
    core::Rgb brushColor{235, 240, 248};
    std::array<ShownWand, sideCount> wands; ///< by Side
    std::optional<Spotlight> spotlight;
    std::optional<core::Sphere> teacher; ///< brush of somebody beside the headset
    std::vector<Panel> panels;
    std::array<std::optional<Laser>, sideCount> lasers; ///< by Side
    bool hasFloor = true;
};
} // namespace vr
