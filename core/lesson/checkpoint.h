#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace core
{
/// Measures that a checkpoint may ask of a model besides its shape. Height is along y, width along x, depth along z;
/// the four from Widest on are those of model_facts.h.
enum class Fact { Genus, Components, Height, Width, Depth, Widest, Feet, BaseArea, Grooves, Volume, Faces, PrintReady };

struct FactInfo
{
    std::string_view key; ///< in lesson files
    double max;           ///< that may be asked for; the least is 0
    bool isWhole;         ///< a number without fraction
};
inline constexpr FactInfo factTable[] = {
    {"genus", 1e4, true},     {"components", 1e4, true},   {"height_mm", 1e6, false}, {"width_mm", 1e6, false},
    {"depth_mm", 1e6, false}, {"widest_mm", 1e6, false},   {"feet", 1e4, true},       {"base_mm2", 1e12, false},
    {"grooves", 1e4, true},   {"volume_mm3", 1e18, false}, {"faces", 1e9, true},      {"print_ready", 1, true},
};
constexpr const FactInfo& info(Fact fact)
{
    return factTable[static_cast<int>(fact)];
}

/// Of a fact, both bounds included. Of PrintReady: 1 and 1.
struct FactBounds
{
    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    Fact fact = Fact::Genus;
    double min = 0;
    double max = unbounded;

    friend bool operator==(const FactBounds&, const FactBounds&) = default;
};

/// A shape that the model is to come near to.
struct CheckpointTarget
{
    /// So much of both surfaces must be within the tolerance of the other one.
    static constexpr double nearShare = 0.95;

    std::string file;     ///< of the lesson; empty: what the teacher's strokes leave
    double tolerance = 0; ///< mm, above 0
};

/// What the pupil's model is to be like when a step is done. Without facts and target anything will do.
struct Checkpoint
{
    std::vector<FactBounds> facts;
    std::optional<CheckpointTarget> target;

    bool asksNothing() const { return facts.empty() && !target; }
};

struct FactVerdict
{
    FactBounds asked;
    std::optional<double> measured; ///< missing: of this model the fact has no meaning
    bool holds = false;
};

struct TargetVerdict
{
    double tolerance = 0;         ///< mm, as asked
    double nearDistance = 0;      ///< mm: so near the other surface is nearShare of each of the two
    double largest = 0;           ///< mm: of all corners of both
    std::vector<float> distances; ///< mm, of each point of the model to the target: for a map in colours
    bool holds = false;
};

struct CheckpointVerdict
{
    std::vector<FactVerdict> facts; ///< in the order of the checkpoint
    std::optional<TargetVerdict> target;

    bool isMet() const;
};

/// Evaluates a checkpoint on a model (mm, Y up). `target`: the shape, if the checkpoint has a target, with at least one
/// face, like the model. Both lie where they lie: nothing is moved onto the other. Distances are measured at the
/// corners. Cost: checkMesh() if there are facts, and with a target 2 to 50 us a corner of both; all cores, the same on
/// any machine. If it is cancelled, the result is not usable.
CheckpointVerdict evaluate(const Checkpoint& checkpoint, const TriangleMesh& model, const TriangleMesh* target,
                           const JobControl& control = {});
} // namespace core
