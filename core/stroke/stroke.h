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

/// The largest number of sectors.
inline constexpr int maxRadial = 32;
inline constexpr double minAirbrush = 0.1, maxAirbrush = 60, defaultAirbrush = 10; ///< dabs a second
/// Dabs a second of each tool's strokes where the hand rests; 0: none.
using AirbrushRates = std::array<double, toolNames().size()>;
/// Returns the default rate for each tool that can go on where the hand rests.
constexpr AirbrushRates defaultAirbrushRates()
{
    AirbrushRates rates{};
    for (std::size_t i = 0; i < rates.size(); ++i)
        rates[i] = canAirbrush(static_cast<Tool>(i)) ? defaultAirbrush : 0;
    return rates;
}

/// The settings that stay the same during a stroke. Units: lengths in the document's unit.
struct StrokeSettings
{
    Tool tool = Tool::Pull;
    BrushShape brush = BrushShape::Sphere;
    Placement place = Placement::Point; ///< of the spherical brush
    Topology topology = Topology::Adaptive;
    Symmetry symmetry = Symmetry::None;
    /// Sectors about the document's Y axis in which each dab is done, and mirrored if there is a symmetry; 1 to
    /// maxRadial.
    int radial = 1;
    double radius = info(Parameter::Radius).defaultValue;
    double strength = info(Parameter::Strength).defaultValue;
    int falloff = static_cast<int>(info(Parameter::Falloff).defaultValue); ///< n of b(x); 0: no weighting
    double detail = info(Parameter::Detail).defaultValue;                  ///< scales d_detail
    double detailLength = 0; ///< d_detail of the uniform topology; 0: 4/3 of the model's mean edge when it was opened
    /// The distance between dabs, in radii; Stamp takes 2 at least. 0: each sample is exactly one dab.
    double spacing = info(Parameter::Spacing).defaultValue;
    /// Dabs a second of a hand that rests, with a spacing and a tool that can (canAirbrush); 0: a hand that rests does
    /// nothing. At most maxAirbrush.
    double airbrush = 0;
    /// Surfaces that meet join, necks part, specks vanish (paper, section 3.4); else they stop at contact.
    bool fusion = true;
    /// The other way round, where that has a meaning (hasInverse): inflate shrinks, clay and layer dig, scrape fills,
    /// pinch spreads, crease raises a ridge, twist turns back, stamp raises, mask is wiped away.
    bool inverted = false;
    /// Lets the first dab of Pull or Stamp, at a point with nothing under the brush, add a sphere, or the model (paper,
    /// section 3.5.1). The dabs after it pull, also where the first was refused; a stamp that was added ends the
    /// stroke.
    bool add = false;
    /// Lets each dab add one wherever it is; it becomes part of the model where their surfaces cross.
    bool join = false;
    Rgb color;                          ///< of Paint
    std::shared_ptr<const Alpha> alpha; ///< of tools that use one (usesAlpha); null: none
    bool alphaFollows = false; ///< up in the alpha, or in Stamp's model, is the stroke's way; else it stands upright
    /// Makes the stroke one dab, where its first sample is, with a tool that can (canAnchor). The way of the hand since
    /// then is its radius, and the direction of that way its up. A click leaves both as they are.
    bool anchored = false;
    std::shared_ptr<const BrushModel> model; ///< of Stamp, and of what `add` adds; null: a ball
};

/// Returns whether samples are rays that lead the hand, and not the hand's own places.
constexpr bool isByRay(const StrokeSettings& settings)
{
    return settings.brush == BrushShape::Ray || settings.place == Placement::Ray;
}
/// Returns whether the stroke is one dab that the hand drags out.
constexpr bool isAnchored(const StrokeSettings& settings)
{
    return settings.anchored && canAnchor(settings.tool);
}

/// The shortest way, in radii of the brush, by which the hand drags an anchored dab out: less is a click.
inline constexpr double minDragged = 0.05;

/// Returns the settings that Ctrl makes of these: Pull becomes Push and Push Pull, others are inverted where that has a
/// meaning.
StrokeSettings opposite(StrokeSettings settings);

/// Returns the settings of a dab that adds a ball of the radius, or the model, and does nothing else. Where it crosses
/// the surface it becomes part of the model, with fusion on.
StrokeSettings addingSolid(StrokeSettings settings);

/// Turns about Y by the parts that this many sectors share with a quarter turn take the lattice to itself: 4, 2 or 1.
/// Sectors that lie so to each other stay each other's images bit for bit; with 2 and 4 these are all.
constexpr int exactTurns(int radial)
{
    return radial % 4 == 0 ? 4 : radial % 2 == 0 ? 2 : 1;
}

/// Returns whether the two sides of a wall that meet under the brush make a hole, instead of stopping it.
bool pushes(const StrokeSettings& settings);

/// One reading of mouse, pen or wand. After this nobody asks which it was.
struct StrokeSample
{
    double time = 0; ///< seconds; without influence on geometry, except for StrokeSettings::airbrush
    Vec3 position = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();
    double pressure = 1; ///< 0 to 1
    /// The model's orientation in the world at that moment; its inverse is applied to position and direction.
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    std::optional<double> radius;   ///< of this sample only
    std::optional<double> strength; ///< of this sample only
    /// Up vector of the hand that holds the brush, in world space, of any length. It orients alphas and Stamp's model,
    /// also where the brush meets no surface. Nothing: the world's up.
    std::optional<Vec3> up;
};

/// Positions, directions, times and speeds: squares stay finite, and every lattice ends long before.
inline constexpr double maxSampleMagnitude = 1e9;
/// The largest coordinate of a direction: what is shorter has none.
inline constexpr double minDirection = 1e-9;
/// The largest difference of a rotation's squared length from 1.
inline constexpr double rotationTolerance = 1e-3;

/// Returns whether all values that a dab would use are finite and in the ranges that stroke files have.
bool isUsable(const StrokeSettings& settings, const StrokeSample& sample);

/// A file that a stroke file names: whoever plays it reads it into the settings.
struct StrokeNeed
{
    std::string file;        ///< empty: nothing
    std::string fingerprint; ///< that it had when the stroke was recorded; empty: any
};

struct Stroke
{
    StrokeSettings settings;
    std::vector<StrokeSample> samples;
    StrokeNeed alpha, model; ///< while settings have none
};

/// How an open stroke ends: it stays, or the model becomes again what it was before, and there is no step.
enum class StrokeEnd { Kept, TakenBack };

/// One application of the brush, in the model's space.
struct Dab
{
    Vec3 position = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();
    double radius = 0;
    double strength = 0;         ///< times pressure
    Vec3 motion = Vec3::Zero();  ///< of the dab centre, or of the hand (isDragTool), since the dab before
    Vec3 heading = Vec3::Zero(); ///< of SnakeHook: which way it came, of unit length, or zero at first
    double way = 0;              ///< of SnakeHook: how far from where it took hold, in mm
    double turn = 0;             ///< of Twist: radians, anticlockwise about the axis
    Vec3 axis = Vec3::Zero();    ///< of Twist: of unit length, or zero as long as nothing is held
    Vec3 up = Vec3::UnitY();     ///< the world's, or the hand's, in the model's space; of unit length
    /// Away from who stands before the model, or holds the brush, there; the same, and across up.
    Vec3 ahead = -Vec3::UnitZ();
    bool isMirrored = false;    ///< the image of what the hand does
    Vec3 normal = Vec3::Zero(); ///< of Stamp: the surface's mean normal before its outline was cut, or zero
};

/// Returns the heading of Snake Hook after a dab: its way over the last half radius or so, of unit length, or zero.
Vec3 headingAfter(const Dab& dab);

enum class DabOutcome { Committed, Fallback, EndedEarly, Empty, Added, Refused };
/// The names of outcomes in the statistics of `replay --stats`.
template <>
inline constexpr std::array<std::string_view, 6> valueNames<DabOutcome>{"committed", "careful", "ended_early",
                                                                        "empty",     "added",   "refused"};

/// Why a sphere, or the brush's model, was not added. Unfit: on the lattice the model is not sound at that size.
/// Masked: a surface would change that is masked.
enum class Refusal { None, Inside, TooClose, Wall, Unfit, Masked };

/// The effect of a dab, and its cost.
struct DabReport
{
    double selectMs = 0, optimiseMs = 0, deformMs = 0, fuseMs = 0, verifyMs = 0, totalMs = 0;
    std::uint32_t touchedVertices = 0; ///< distinct vertices selected after optimisation
    std::uint32_t touchedFaces = 0;
    std::uint32_t substeps = 0;
    double asked = 0, reached = 0; ///< peak displacement; of what joined or collapsed meanwhile, as far as it was there
    DabOutcome outcome = DabOutcome::Empty;
    Refusal refusal = Refusal::None;
    /// Surfaces stood in the way that may not be joined: fusion is off, they are masked, or the two sides of a wall
    /// that nobody pushes.
    bool contact = false;
    bool wall = false;       ///< ended early: at the wall of the working volume
    bool capped = false;     ///< ended early: too many operations, steps or vertices to move
    bool asymmetric = false; ///< of a symmetric stroke: the model is not symmetric here, so it was done as two dabs

    /// The sectors of a radial stroke that can be exact were done one after the other: the model is not its own image
    /// under the turn here, its colours included, or the sectors meet, as over the axis.
    bool sequential = false;

    /// Whether the dab reached at least 95 % of the displacement asked, a difference that a hand does not notice.
    bool isWhole() const { return reached >= 0.95 * asked; }
    /// For a dab done as several: costs add up; of two that did something the worse outcome and the smaller share
    /// reached count.
    DabReport& operator+=(const DabReport& second);
};

/// Why a dab did less than was asked, if it did; of several dabs the last of these is worth telling.
enum class Shortfall { None, Blocked, Contact, Wall, Capped, Inside, TooClose, NoRoom, Unfit, Masked };
Shortfall shortfallOf(const DabReport& dab);
} // namespace core
