#pragma once

#include "vr/openxr/hand_joints.h"
#include "vr/openxr/wand_state.h"
#include "vr/scene/wand_model.h"
#include "vr/util/pose.h"

#include "core/mesh/draw_arrays.h"
#include "core/parts/part_transform.h"
#include "core/render/shading.h"
#include "core/stroke/tool.h"

#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace vr
{
/// A short text at a wand's button; an empty text: no label.
struct WandLabel
{
    QString text;
    float opacity = 1;
};

/// A wand as it is drawn.
struct ShownWand
{
    /// The wand's control for the thumb. None: the wand has only a trigger and a menu button, or is a bare hand.
    enum class Thumb { Pad, Stick, None };

    bool isShown = false; ///< the wand is tracked
    /// Point between thumb and index finger of a bare hand, room space; none: a wand. The bead is drawn there.
    std::optional<core::Vec3> pinch;
    std::optional<HandJoints> joints; ///< joints of a bare hand, which are drawn with the bones between them
    Thumb thumb = Thumb::Pad;
    Pose grip;
    std::array<bool, wandPartCount> isLit{};         ///< indexed by WandPart: whether the part is pressed
    double trigger = 0;                              ///< fraction that the trigger is pulled, 0 to 1
    std::optional<Eigen::Vector2d> touch;            ///< position of a thumb on the pad, as in WandState
    Eigen::Vector2d stick = Eigen::Vector2d::Zero(); ///< position of the thumbstick, as in WandState
    double holdProgress = 0; ///< filled fraction of the ring between the side buttons, 0 to 1; 0: no ring
    std::array<WandLabel, wandSpotCount> labels; ///< indexed by WandSpot
    std::optional<core::Rgb> tip;                ///< colour of the bead at the front end
};

/// The spherical brush at a wand's tip. Units: metres, in room space.
struct BallBrush
{
    core::Vec3 center = core::Vec3::Zero();
    double radius = 0.03;
    int falloff = 4; ///< exponent n of the weight b(x) (core/stroke/tool.h) that tints the mesh in the brush
    double core = 0; ///< fraction of the radius within which the brush's weight is 1
};

/// The ray brush. Units: metres, in room space.
struct RayBrush
{
    struct Hit
    {
        core::Vec3 point, normal; ///< the normal has length 1
        double radius;            ///< radius of the footprint
    };
    core::Ray ray;
    std::optional<Hit> hit; ///< point where the ray meets the mesh
};

/// A straight line, in room space.
struct Segment
{
    core::Vec3 from, to;
};

/// A blade, which is shown as a disc, and its cut through the mesh. Units: metres, in room space.
struct Blade
{
    core::Vec3 center, normal; ///< the normal, of length 1, points to the side that would be cut away
    double radius;
    bool tints = false; ///< what would be cut away is tinted
    /// About which the mirror image cuts as well; None: it does not.
    core::Symmetry image = core::Symmetry::None;
};

/// A beam from a wand to a panel, in room space.
struct Laser
{
    core::Vec3 from, to;
};

/// The point on the surface at which somebody at the window points.
struct Spotlight
{
    /// A point of the surface and its normal of length 1.
    core::Vec3 center = core::Vec3::Zero(), normal = core::Vec3::UnitY();
    /// Phase of the spreading wave, 0 to 1, repeating.
    double phase = 0;
};

/// A textured rectangle, whose back is a dark plate.
struct Panel
{
    Pose pose;                      ///< pose of the middle: +X to the right, +Y up, +Z towards the reader
    Eigen::Vector2d size{0.4, 0.3}; ///< metres
    unsigned int textureId = 0;     ///< id of a Texture
    float opacity = 1;
};

/// Everything that a frame shows, except the mesh itself. Members are in room space unless they say otherwise.
struct SceneState
{
    Pose head; ///< pose of the point midway between the eyes
    /// Transform from document to room: scaled uniformly, rotated and translated, never mirrored.
    Eigen::Affine3d model = Eigen::Affine3d(Eigen::UniformScaling(1e-3));
    core::Box box; ///< bounding box of the model, mm; empty: no model
    core::Shading shading;
    bool isFlat = false;    ///< shades each triangle evenly
    bool hasTint = true;    ///< colours what the brush would move
    bool hasCavity = false; ///< darkens valleys, lightens ridges
    core::Symmetry symmetry = core::Symmetry::None;
    int radial = 1; ///< number of sectors about the model's y axis
    std::variant<std::monostate, BallBrush, RayBrush> brush;
    core::Rgb brushColor{235, 240, 248};
    std::vector<Segment> outline; ///< edges of a shape that is about to be placed
    std::optional<Blade> blade;
    /// Transform of the mesh that is shown before it is made, of the vertices that Scene::tint() marks. Units: mm.
    std::optional<core::Transform> move;
    std::shared_ptr<const core::DrawArrays> translucent; ///< a translucent mesh in document space, mm; null: none
    std::array<ShownWand, sideCount> wands;              ///< indexed by Side
    std::optional<Spotlight> spotlight;
    std::optional<core::Sphere> teacher; ///< brush of a lesson's teacher
    std::vector<Panel> panels;
    std::array<std::optional<Laser>, sideCount> lasers; ///< indexed by Side
    bool hasFloor = true;
};
} // namespace vr
