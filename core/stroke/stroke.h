#pragma once

#include "core/stroke/tool.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace core
{
class Alpha;
class BrushModel;

/// Largest number of sectors of a radially symmetric stroke.
inline constexpr int maxRadial = 32;
/// Range and default of StrokeSettings::airbrush, dabs per second.
inline constexpr double minAirbrush = 0.1, maxAirbrush = 60, defaultAirbrush = 10;
/// Airbrush rate of each tool, in dabs per second while the pointer is at rest; 0: none.
using AirbrushRates = std::array<double, toolNames().size()>;
/// Returns the default airbrush rates: defaultAirbrush for tools that can use an airbrush (canAirbrush()), else 0.
constexpr AirbrushRates defaultAirbrushRates()
{
    AirbrushRates rates{};
    for (std::size_t i = 0; i < rates.size(); ++i)
        rates[i] = canAirbrush(static_cast<Tool>(i)) ? defaultAirbrush : 0;
    return rates;
}

/// The settings that stay the same during a stroke. Units: lengths in mm, the document's unit.
struct StrokeSettings
{
    PartId part = 0; ///< the part that the stroke changes; others do not exist for it
    Tool tool = Tool::Pull;
    BrushShape brush = BrushShape::Sphere;
    Placement place = Placement::Point; ///< source of the dab centres of a spherical brush
    Topology topology = Topology::Adaptive;
    Symmetry symmetry = Symmetry::None;
    /// Number of sectors about the document's Y axis in which each dab is repeated, 1 to maxRadial. With a plane of
    /// symmetry, the dab of each sector is also mirrored.
    int radial = 1;
    double radius = info(Parameter::Radius).defaultValue;
    double strength = info(Parameter::Strength).defaultValue;
    /// exponent n of the falloff weight, see falloff(); 0: all vertices have weight 1
    int falloff = static_cast<int>(info(Parameter::Falloff).defaultValue);
    double detail = info(Parameter::Detail).defaultValue; ///< factor on the d_detail that follows from the radius
    /// d_detail of Topology::Uniform, mm; 0: the mesh's own, Mesh::uniformDetail()
    double detailLength = 0;
    /// Distance between dabs, in radii; at least 2 for Stamp. 0: each sample is one dab; of a drag tool, up to 20.
    double spacing = info(Parameter::Spacing).defaultValue;
    /// Dabs per second while the pointer is at rest, 0 to maxAirbrush; 0: none. Needs a spacing and a tool that can use
    /// it (canAirbrush()).
    double airbrush = 0;
    /// Joins surfaces that meet, cuts thin necks and removes specks (paper, section 3.4). If false, surfaces stop at
    /// contact.
    bool fusion = true;
    /// Inverts tools that have an inverse (hasInverse()): inflate shrinks, clay and layer dig, scrape fills, pinch
    /// spreads, crease raises a ridge, twist turns the other way, stamp raises, mask erases.
    bool inverted = false;
    /// Lets the first dab of Pull or Stamp add a sphere, or `model`, if it is centred at a point and nothing is under
    /// the brush (paper, section 3.5.1). Later dabs deform as usual, even if the first was refused. A stamp that was
    /// added ends the stroke.
    bool add = false;
    /// Lets each dab add a solid, whatever is under the brush; the solid becomes part of the model if their surfaces
    /// cross.
    bool join = false;
    Rgb color;                          ///< the colour that Paint applies
    std::shared_ptr<const Alpha> alpha; ///< image for tools that use one (usesAlpha()); null: no alpha
    /// the up direction of the alpha, or of Stamp's model, follows the stroke; otherwise it stays upright
    bool alphaFollows = false;
    /// Makes the stroke a single dab at the first sample, for tools that allow it (canAnchor()). The displacement of
    /// the pointer from there sets the dab's radius and up direction. A click leaves radius and up direction unchanged.
    bool anchored = false;
    std::shared_ptr<const BrushModel> model; ///< shape of Stamp and of the solids that `add` adds; null: a ball
};

/// Returns whether samples are used as rays, and not as positions.
constexpr bool isByRay(const StrokeSettings& settings)
{
    return settings.brush == BrushShape::Ray || settings.place == Placement::Ray;
}
/// Returns whether the stroke is a single dab that the user drags to its size.
constexpr bool isAnchored(const StrokeSettings& settings)
{
    return settings.anchored && canAnchor(settings.tool);
}

/// Shortest displacement of the pointer, in radii of the brush, that counts as dragging an anchored dab. Less is a
/// click.
inline constexpr double minDragged = 0.05;

/// Returns the settings for a stroke with Ctrl pressed: Pull and Push are exchanged; other tools are inverted if they
/// have an inverse.
StrokeSettings opposite(StrokeSettings settings);

/// Returns settings whose dab only adds a ball of the radius, or the model. With fusion on, a solid that crosses the
/// surface becomes part of the model.
StrokeSettings addingSolid(StrokeSettings settings);

/// Returns how many of the sectors, the first included, differ from the first by a multiple of a quarter turn about Y:
/// 4, 2 or 1. Such turns map the lattice onto itself, so these sectors can stay exact images of each other, bit for
/// bit.
constexpr int exactTurns(int radial)
{
    return radial % 4 == 0 ? 4 : radial % 2 == 0 ? 2 : 1;
}

/// Returns whether pushing through a wall makes a hole in it. Otherwise the two sides of the wall stop the motion when
/// they meet.
bool pushes(const StrokeSettings& settings);

/// One reading of a mouse, pen or VR controller. Nothing after this type depends on which device it came from.
struct StrokeSample
{
    double time = 0; ///< time stamp, seconds; affects the geometry only through StrokeSettings::airbrush
    Vec3 position = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();
    double pressure = 1; ///< pen pressure, 0 to 1
    /// The model's orientation in the world at the time of the sample. Position and direction are turned into model
    /// space by its inverse.
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    std::optional<double> radius;   ///< brush radius for this sample only, mm
    std::optional<double> strength; ///< strength for this sample only
    /// Up vector of the hand that holds the brush, in world space, of any length above minDirection. Orients alphas and
    /// Stamp's model, even in empty space. nullopt: the world's up.
    std::optional<Vec3> up;
};

/// Largest absolute value of a sample's coordinates and times. Its square is finite, and it is far outside every
/// lattice.
inline constexpr double maxSampleMagnitude = 1e9;
/// A direction whose coordinates are all smaller than this in magnitude counts as undefined.
inline constexpr double minDirection = 1e-9;
/// Largest deviation of a rotation's squared length from 1.
inline constexpr double rotationTolerance = 1e-3;

/// Returns whether all values that a dab would use are finite and within the ranges that stroke files allow.
bool isUsable(const StrokeSettings& settings, const StrokeSample& sample);

/// A file that a stroke file refers to. Whoever plays the stroke must load it into the settings.
struct StrokeNeed
{
    std::string file;        ///< path; empty: no file is needed
    std::string fingerprint; ///< fingerprint of the file when the stroke was recorded; empty: not compared
};

struct Stroke
{
    StrokeSettings settings;
    std::vector<StrokeSample> samples;
    StrokeNeed alpha, model; ///< files to load; used if the settings do not contain the alpha or model
};

/// Ways to end an open stroke. Kept: it becomes one undo step. TakenBack: the model is restored, without an undo step.
enum class StrokeEnd { Kept, TakenBack };

/// One application of the brush. Positions and directions are in model space, lengths in mm.
struct Dab
{
    Vec3 position = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();
    double radius = 0;
    double strength = 0; ///< the sample's strength times its pressure
    /// displacement of the dab centre, or with a drag tool of the pointer, since the previous dab
    Vec3 motion = Vec3::Zero();
    /// SnakeHook: direction of its recent motion, of unit length; zero before the first motion
    Vec3 heading = Vec3::Zero();
    double way = 0;           ///< SnakeHook: distance from where the stroke took hold, mm
    double turn = 0;          ///< Twist: angle, radians, anticlockwise about `axis`
    Vec3 axis = Vec3::Zero(); ///< Twist: axis of rotation, of unit length; zero until a region is grabbed
    Vec3 up = Vec3::UnitY();  ///< the world's or the hand's up vector in model space, of unit length
    /// Direction away from a viewer in front of the model. If the sample has an up vector: the part of the sample's
    /// direction across `up`, of unit length.
    Vec3 ahead = -Vec3::UnitZ();
    bool isMirrored = false;    ///< the dab is a mirror image of the user's dab
    Vec3 normal = Vec3::Zero(); ///< Stamp: mean normal of the surface before its outline was cut; zero until then
};

/// Returns the heading of Snake Hook after a dab: the direction of its motion over about the last half radius, of unit
/// length, or zero.
Vec3 headingAfter(const Dab& dab);

enum class DabOutcome { Committed, Fallback, EndedEarly, Empty, Added, Refused };
/// The names of outcomes in the statistics of `replay --stats`.
template <>
inline constexpr std::array<std::string_view, 6> valueNames<DabOutcome>{"committed", "careful", "ended_early",
                                                                        "empty",     "added",   "refused"};

/// The reason why a sphere, or the brush's model, was not added. Unfit: the model, rounded to the lattice, is not sound
/// at that size. Masked: a masked surface would change.
enum class Refusal { None, Inside, TooClose, Wall, Unfit, Masked };

/// The effect and the cost of a dab.
struct DabReport
{
    double selectMs = 0, optimiseMs = 0, deformMs = 0, fuseMs = 0, verifyMs = 0, totalMs = 0;
    std::uint32_t touchedVertices = 0; ///< number of distinct vertices selected after optimisation
    std::uint32_t touchedFaces = 0;
    std::uint32_t substeps = 0;
    /// largest displacement planned and reached, mm; vertices that were joined or collapsed on the way are not tracked
    /// further
    double asked = 0, reached = 0;
    DabOutcome outcome = DabOutcome::Empty;
    Refusal refusal = Refusal::None;
    /// The motion was stopped by surfaces that must not be joined: fusion is off, they are masked, or they are the two
    /// sides of a wall and the tool does not push.
    bool contact = false;
    bool wall = false;   ///< ended early: a vertex would have left the working volume
    bool capped = false; ///< ended early: too many operations, sub-steps or moved vertices
    /// mirrored stroke: the model is not symmetric here, so the dab and its image were applied one after the other
    bool asymmetric = false;

    /// Radial stroke: sectors that could be exact images of each other were done one after the other. Either the model,
    /// colours included, is not symmetric under the turn here, or the sectors overlap, as they do on the axis.
    bool sequential = false;

    /// Returns whether the dab reached at least 95 % of the displacement asked. Users do not notice the rest.
    bool isWhole() const { return reached >= 0.95 * asked; }
    /// Combines the reports of a dab done in several parts. Costs are added, except verifyMs and totalMs, which are
    /// measured for the whole dab. Of parts that did something, the worse outcome and the smaller share reached count.
    DabReport& operator+=(const DabReport& second);
};

/// The reason why a dab did less than was asked, or None. Of several dabs, the largest value is reported to the user.
enum class Shortfall { None, Blocked, Contact, Wall, Capped, Inside, TooClose, NoRoom, Unfit, Masked };
Shortfall shortfallOf(const DabReport& dab);
} // namespace core
