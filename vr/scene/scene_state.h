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
    bool isShown = false; ///< false while it is not tracked
    Pose grip;
    std::array<bool, wandPartCount> isLit{}; ///< by WandPart: what is pressed
    double trigger = 0;                      ///< 0 to 1, how far it is pulled
    std::optional<Eigen::Vector2d> touch;    ///< where a thumb lies on the pad, as in WandState
    /// Of the side button: the share of the ring that is full, 0 to 1; 0: no ring.
    double hold = 0;
    std::array<WandLabel, wandSpotCount> labels; ///< by WandSpot
    std::optional<core::Rgb> tip;                ///< the colour of the bead at the front end
};

/// The spherical brush, at a wand's tip. Metres of the room.
struct BallBrush
{
    core::Vec3 center = core::Vec3::Zero();
    double radius = 0.03;
    int falloff = 4; ///< n of b(x): what it would change of the mesh is tinted
};

/// The ray brush. Metres of the room.
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

/// From a wand to a panel.
struct Laser
{
    core::Vec3 from, to;
};

/// Where somebody beside the headset points.
struct Spotlight
{
    core::Vec3 center = core::Vec3::Zero(), normal = core::Vec3::UnitY(); ///< of the surface; the normal has length 1
    /// 0 to 1, over and over: how far its wave has come.
    double pulse = 0;
};

/// A rectangle with a picture. Seen from behind it is a dark plate.
struct Panel
{
    Pose pose;                      ///< of its middle: +X to its right, +Y up, +Z towards who reads it
    Eigen::Vector2d size{0.4, 0.3}; ///< metres
    unsigned int picture = 0;       ///< a Texture's id
    float opacity = 1;
};

/// All that a frame shows except the mesh itself. Room space where nothing else is said.
struct SceneState
{
    Pose head; ///< midway between the eyes
    /// Document to room: evenly scaled, turned and moved, never mirrored.
    Eigen::Affine3d model = Eigen::Affine3d(Eigen::UniformScaling(1e-3));
    core::Box box; ///< of the model, mm; empty: no model
    core::Shading shading;
    bool isFlat = false; ///< each triangle in one shade
    core::Symmetry symmetry = core::Symmetry::None;
    int radial = 1; ///< sectors about the model's y axis
    std::variant<std::monostate, BallBrush, RayBrush> brush;
    core::Rgb brushColor{235, 240, 248};
    std::array<ShownWand, sideCount> wands; ///< by Side
    std::optional<Spotlight> spotlight;
    std::optional<core::Sphere> teacher; ///< a brush that nobody in the headset holds
    std::vector<Panel> panels;
    std::array<std::optional<Laser>, sideCount> lasers; ///< by Side
    bool hasFloor = true;
};
} // namespace vr
