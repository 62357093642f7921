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
/// Properties of a model that a checkpoint may require in addition to a target shape. Height is along y, width along x,
/// depth along z. Widest, Feet, BaseArea and Grooves are defined in model_facts.h.
enum class Fact { Genus, Components, Height, Width, Depth, Widest, Feet, BaseArea, Grooves, Volume, Faces, PrintReady };

struct FactInfo
{
    std::string_view key; ///< the fact's key in lesson files
    double max;           ///< largest bound that a checkpoint may require; the smallest is 0
    bool isWhole;         ///< bounds must be whole numbers
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

/// The range that a fact must be in, including both bounds. For PrintReady both are 1.
struct FactBounds
{
    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    Fact fact = Fact::Genus;
    double min = 0;
    double max = unbounded;

    friend bool operator==(const FactBounds&, const FactBounds&) = default;
};

/// A shape that the pupil's model must resemble.
struct CheckpointTarget
{
    /// Share of each surface's area that must be within the tolerance of the other surface.
    static constexpr double nearShare = 0.95;

    std::string file;     ///< model file in the lesson; empty: the result of the step's own strokes
    double tolerance = 0; ///< mm, above 0; nearShare of the area must be within this distance
};

/// The conditions for the pupil's model at the end of a step. Without facts and target every model passes.
struct Checkpoint
{
    std::vector<FactBounds> facts;
    std::optional<CheckpointTarget> target;

    bool asksNothing() const { return facts.empty() && !target; }
};

struct FactVerdict
{
    FactBounds asked;
    std::optional<double> measured; ///< empty: the fact is not defined for this model
    bool holds = false;
};

struct TargetVerdict
{
    double tolerance = 0;         ///< tolerance from the checkpoint, mm
    double nearDistance = 0;      ///< mm; nearShare of each surface is within this distance of the other surface
    double largest = 0;           ///< largest distance of any corner of either surface, mm
    std::vector<float> distances; ///< distance of each of the model's points to the target, mm; for a colour map
    bool holds = false;
};

struct CheckpointVerdict
{
    std::vector<FactVerdict> facts; ///< one verdict for each fact, in the order of the checkpoint
    std::optional<TargetVerdict> target;

    bool isMet() const;
};

/// Evaluates a checkpoint on a model (mm, Y up). `target`: the shape if the checkpoint has a target, else null.
/// Precondition: with a target, both meshes have at least one face. Neither mesh is moved to fit the other. Distances
/// are measured at the corners. The result is the same on any machine; if it is cancelled, the result is not usable.
/// Cost: checkMesh() if there are facts, and with a target 2 to 50 us for each corner of both meshes; uses all cores.
CheckpointVerdict evaluate(const Checkpoint& checkpoint, const TriangleMesh& model, const TriangleMesh* target,
                           const JobControl& control = {});
} // namespace core
