#pragma once

#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_delta.h"
#include "core/stroke/tool.h"
#include "core/util/job_control.h"

#include <memory>
#include <optional>
#include <variant>

namespace core
{
class Mesh;

// What may be asked of the whole model. Lengths in the document's unit; planes, axes and pivots are the document's own:
// they go through the origin.

struct Move
{
    Vec3 by = Vec3::Zero();
};
struct Rotate
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); ///< unit length
};
/// The place that the file gives the model is scaled, too, as by another unit.
struct Scale
{
    double factor = 1; ///< above 0
};
/// At x = 0, y = 0 or z = 0.
struct Mirror
{
    int axis = 0;
};
/// The middle of the bounding box, snapped, goes to the origin, also in files that are written from now on.
struct Recentre
{};
/// The lowest point goes to y = 0, where a printer's bed is, also in files that are written from now on.
struct PlaceOnBed
{};
/// What lies below a level plane goes, and the cut is closed: a flat base.
struct FlattenBase
{
    double height = 0; ///< of the plane above the lowest point; above 0, below the model's height
};
/// Another model becomes part of this one: outside it, or wholly in one of its voids, and touching nothing.
struct Insert
{
    enum class Place {
        Beside, ///< in +x direction, clear of the present model, the boxes' middles level
        AsItIs, ///< where its file has it
        Centre  ///< the middle of its box at `centre`
    };
    TriangleMesh model;
    Place place = Place::Beside;
    Vec3 centre = Vec3::Zero();
};
struct Fill
{
    Rgb color;
};
/// See mask_operations.cpp. What is hollow, of the colour, or in one piece with what is masked is added to the mask.
struct MaskOperation
{
    enum class Kind { Invert, Clear, Blur, Sharpen, Grow, Shrink, Cavity, Color, Part };
    Kind how = Kind::Invert;
    Rgb color = {}; ///< of Kind::Color
};
/// All edges between d and d_detail = 2 d, as far as the shape and the mask allow.
struct RemeshUniformly
{
    double detailLength = 0; ///< d_detail; 0: 4/3 of the mean edge
};

enum class Half { Positive, Negative };
/// One half of the model, and its mirror image in place of the other.
struct Symmetrize
{
    Symmetry plane = Symmetry::X; ///< not None
    Half keep = Half::Positive;   ///< where the coordinate is so
};

/// A mesh as it once was, without what it needs for editing: 40 bytes a vertex.
struct Snapshot
{
    TriangleMesh surface; ///< in the order of the slots
    MeshFrame frame;
};
/// Of a mesh that was built and not edited since: then it comes back slot for slot.
std::shared_ptr<const Snapshot> snapshotOf(const Mesh& mesh);

/// The model as it was when it was opened. It was sound then, so it is not checked again.
struct Reset
{
    std::shared_ptr<const Snapshot> start;
};

using ModelCommand = std::variant<Move, Rotate, Scale, Mirror, Recentre, Insert, Fill, RemeshUniformly, Symmetrize,
                                  Reset, PlaceOnBed, FlattenBase, MaskOperation>;

/// Why the model was left as it is.
enum class ModelRefusal {
    None,
    FacesMeet,  ///< on the lattice, whatever was tried: `faces` of them
    TooFar,     ///< from the origin, for its size
    TooLarge,   ///< or too small: `ModelLimits`
    Unsound,    ///< the inserted model does not bound a solid: `report` says why
    Inside,     ///< one of the models would lie inside the other
    Touching,   ///< the inserted model would touch the present one
    EmptyHalf,  ///< nothing of the model lies on that side of the plane
    HalvesMeet, ///< the half and its image do not make a sound solid: they touch, or meet at `faces` pairs of faces
    NoBase,     ///< there is nothing to cut at that height, or what is left makes no sound solid
    TooFine     ///< the mesh would need too many faces (`faces`), or edges that the lattice cannot hold
};

/// What a command comes to.
struct ModelChange
{
    ModelRefusal refusal = ModelRefusal::None;
    std::size_t faces = 0; ///< see ModelRefusal
    MeshReport report;     ///< see ModelRefusal::Unsound
    MeshDelta delta;       ///< Mesh::swap makes the change, and takes it back
    bool changes = false;  ///< the delta does anything: neither refused nor stopped, and something is different
};

struct ModelLimits
{
    static constexpr double minExtent = 1e-6, maxExtent = 1e7; ///< of the largest |coordinate|
    static constexpr std::size_t maxFaces = 20'000'000;        ///< that a remeshing may aim at
};

/// Tries the command on a copy of the mesh and checks the outcome wholly and exactly. The mesh itself changes when the
/// delta is swapped in: until then it must stay in the state of which `copy` is a copy. Any thread; whole-mesh cost, on
/// all cores.
ModelChange applyToCopy(Mesh copy, const ModelCommand& command, const JobControl& control = {});

/// Faces that a uniform mesh of that d_detail has on a surface of that area, about.
double uniformFaces(double area, double detailLength);
} // namespace core
