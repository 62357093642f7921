#pragma once

#include "core/analysis/mesh_check.h"
#include "core/area/view_area.h"
#include "core/boolean/mesh_boolean.h"
#include "core/mesh/mesh_delta.h"
#include "core/parts/part_transform.h"
#include "core/primitives/model_limits.h"
#include "core/primitives/primitives.h"
#include "core/stroke/tool.h"
#include "core/util/job_control.h"

#include <memory>
#include <optional>
#include <variant>

namespace core
{
class Mesh;

// Commands on the whole model. Lengths are in the document's unit. Planes, axes and pivots pass through the document's
// origin.

struct Move
{
    Vec3 by = Vec3::Zero();
};
struct Rotate
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); ///< unit length
};
/// Scales the model and also its place in its file, as a change of unit would.
struct Scale
{
    double factor = 1; ///< above 0
};
/// Mirrors at the plane x = 0, y = 0 or z = 0.
struct Mirror
{
    int axis = 0;
};
/// Moves the centre of the bounding box, snapped to the lattice, to the origin. Files written later also have it there.
struct Recentre
{};
/// Moves the lowest point to y = 0, where a printer's bed is. Files written later also have it there.
struct PlaceOnBed
{};
/// Cuts a flat base: removes everything below a level plane and closes the cut.
struct FlattenBase
{
    double height = 0; ///< height of the plane above the lowest point; above 0 and below the model's height
};
/// Adds another model, or combines this one with it.
struct Insert
{
    enum class Place {
        Beside, ///< in +x direction with a gap, on the same floor, box centres level in z
        AsItIs, ///< where the inserted model's file has it; a tube where its path is
        Centre, ///< centre of its bounding box at `centre`; of a primitive, its own middle
        Floor   ///< centre of the bottom of its bounding box at `centre`
    };
    /// Ways of combining the solids. Join, Subtract and Intersect are exact (mesh_boolean.h). All but Apart allow any
    /// overlap.
    enum class Combination {
        Apart,     ///< the inserted solid must be outside this one or wholly in one of its voids, without touching it
        Join,      ///< space in either solid
        Subtract,  ///< space in this solid and not in the inserted one
        Intersect, ///< space in both solids
        Part       ///< the inserted solid becomes a part of its own, the last one of the list
    };
    TriangleMesh model; ///< ignored if there is a primitive
    Place place = Place::Beside;
    Vec3 centre = Vec3::Zero(); ///< used by Place::Centre and Place::Floor only
    Combination combination = Combination::Apart;
    std::optional<Primitive> primitive = std::nullopt; ///< inserted in place of `model`
    /// Name of the part, UTF-8; used by Combination::Part only. If another part has it, a number is appended.
    std::string name = {};
    /// Plane through the document's origin at which the solid is mirrored: its union with its image is inserted. A
    /// model that was symmetric, bit for bit, remains so.
    Symmetry symmetry = Symmetry::None;
};
struct Fill
{
    Rgb color;
};
/// Changes the mask (see mask_operations.cpp). Cavity, Color and Part add vertices to the mask.
struct MaskOperation
{
    enum class Kind { Invert, Clear, Blur, Sharpen, Grow, Shrink, Cavity, Color, Part };
    Kind how = Kind::Invert;
    Rgb color = {}; ///< used by Kind::Color only
};
/// Hides vertices of the part, or shows all of all parts. Hidden vertices stay as they are until they are shown.
struct Hide
{
    enum class What { Masked, Unmasked, Nothing, NoPart };
    What what = What::Masked; ///< Nothing: shows all hidden vertices; NoPart: shows all hidden parts, too
    bool showsAll() const { return what == What::Nothing || what == What::NoPart; }
};
/// Remeshes so that all edges are between d and d_detail = 2 d, as far as shape and mask allow.
struct RemeshUniformly
{
    double detailLength = 0; ///< d_detail, mm; 0: the mesh's own, Mesh::uniformDetail()
};

enum class Half { Positive, Negative };
/// Keeps one half of the model and replaces the other by its mirror image.
struct Symmetrize
{
    Symmetry plane = Symmetry::X; ///< must not be None
    Half keep = Half::Positive;   ///< sign of the coordinate in the half that is kept
};

/// Cuts away what lies in an area of the view, through the whole depth of the model. The mask does not protect from the
/// cut. ViewArea::isFrontOnly: of the pieces into which the area cuts the model, only those go that are seen first; see
/// CutPieces.
struct Trim
{
    ViewArea area;
    std::optional<Rgb> color = std::nullopt; ///< of the cut; without it, that of the model, if it has only one
};

/// Masks what lies in an area of the view, or removes the mask there; see verticesIn().
struct MaskArea
{
    ViewArea area;
    bool isErasing = false;
};
/// Hides what lies in an area of the view; see verticesIn().
struct HideArea
{
    ViewArea area;
};

/// Copy of a mesh without the data needed for editing: 40 bytes per vertex.
struct Snapshot
{
    TriangleMesh surface; ///< vertices and faces in the order of the slots
    MeshFrame frame;
};
/// Returns a copy of the mesh's surface and frame. Precondition, if slots matter: the mesh was not edited since it was
/// built; then meshOf() restores it slot for slot.
std::shared_ptr<const Snapshot> snapshotOf(const Mesh& mesh);

/// Restores the model as it was when opened. It was sound then, so it is not checked again.
struct Reset
{
    std::shared_ptr<const Snapshot> start;
};

// Commands on parts. All but ShowParts refer to the part given to applyToCopy(), "the part" below.

/// Changes the part's name, lock, tag and position in the list. Works on hidden and locked parts, too.
struct EditPart
{
    std::string name; ///< UTF-8, at most PartList::maxNameBytes
    bool isLocked = false;
    std::optional<Rgb> tag;
    /// Index in the list, from 0; a larger one than the last means the last. Missing: the part stays in its place.
    std::optional<std::size_t> position = {};
};
/// Shows these parts and hides all others. Ids that no part has are ignored.
struct ShowParts
{
    std::vector<PartId> visible;
};
/// Adds a copy of the part at the same place.
struct DuplicatePart
{
    std::string name; ///< name of the copy
};
struct DeletePart
{};
/// Makes each connected piece of the part a part of its own. The largest piece remains the part.
struct SeparatePart
{};
/// Replaces the part by its union with, difference from or intersection with other parts, which are removed.
struct CombineParts
{
    SetOperation operation = SetOperation::Union;
    std::vector<PartId> others; ///< at least one; without the part itself
};

/// Makes a part of its own of what Trim would cut away. Both parts are closed, and their cuts coincide to a few lattice
/// units.
struct SplitPart
{
    ViewArea area;
    std::string name;                        ///< name of the new part
    std::optional<Rgb> color = std::nullopt; ///< of the cut; see Trim
};

using ModelCommand =
    std::variant<Move, Rotate, Scale, Mirror, Recentre, Insert, Fill, RemeshUniformly, Symmetrize, Reset, PlaceOnBed,
                 FlattenBase, MaskOperation, EditPart, ShowParts, DuplicatePart, DeletePart, SeparatePart, CombineParts,
                 Hide, Trim, MaskArea, HideArea, SplitPart, Transform>;

/// Reasons why a command left the model unchanged.
enum class ModelRefusal {
    None,
    FacesMeet,   ///< faces intersect on every lattice point tried; `faces`: their number
    TooFar,      ///< too far from the origin for the model's size
    TooLarge,    ///< coordinates too large or too small (see ModelLimits)
    Unsound,     ///< the inserted model does not bound a solid; `report` has the reason
    Inside,      ///< one of the models would be inside the other's material
    Touching,    ///< the inserted model would touch the present one
    EmptyHalf,   ///< the half to keep is empty
    HalvesMeet,  ///< the halves touch, or intersect at `faces` places: no sound solid
    NoBase,      ///< nothing to cut at this height, or the remainder is no sound solid
    NoSuchPart,  ///< the document has no such part
    NotEditable, ///< the part is hidden or locked
    LastPart,    ///< a document has at least one part
    OnePiece,    ///< the part is in one piece
    TooManyParts,
    AllMasked,   ///< the part is masked or hidden, so nothing of it would move
    NoOtherPart, ///< no part to combine the part with, or it is itself among them
    PartsApart,  ///< no two of the parts to combine overlap, so nothing would be subtracted
    Folded,      ///< a transformation of a part of the surface would bring it through itself, at `faces`
    NoOutline,   ///< the curve to cut along has fewer than three corners, or no area
    NoCut,       ///< the cut would not leave one sound surface
    NothingLeft, ///< nothing would be left
    Uncut,       ///< the solids nearly coincide, and no sound result was found
    Primitive,   ///< the primitive's measures are not possible; `primitive` has the reason
    TooFine      ///< the mesh would need too many faces (`faces`), or edges too short for the lattice
};

/// Result of a command.
struct ModelChange
{
    ModelRefusal refusal = ModelRefusal::None;
    std::size_t faces = 0;           ///< number of faces at fault, for refusals that mention `faces`
    MeshReport report;               ///< check of the inserted model; Insert only
    PrimitiveResult primitive;       ///< reason why a primitive was not made, without its mesh; Insert only
    std::optional<PartId> addedPart; ///< the part that an Insert or DuplicatePart added
    MeshDelta delta;                 ///< the change; Mesh::swap applies it, and swaps it back
    bool changes = false; ///< true if the command was neither refused nor cancelled and the delta alters anything
};

/// Applies the command to a copy of the mesh and checks the result completely and exactly. Swapping the returned delta
/// into the original mesh makes the change; until then the original must not change. Thread: any. Cost: whole mesh, on
/// all cores.
///
/// `part`: the part that the command changes; nothing: all parts. Scale, Recentre, PlaceOnBed, Reset, ShowParts and an
/// Insert that adds a part always concern all parts. Precondition: a document of several parts is given a part unless
/// the command is one of these or moves all parts (Move, Rotate, Mirror, Transform).
ModelChange applyToCopy(Mesh copy, const ModelCommand& command, const JobControl& control = {},
                        std::optional<PartId> part = {});

/// Returns whether the command concerns all parts, whichever part is given to applyToCopy().
bool isOnAllParts(const ModelCommand& command);
/// Returns whether the command changes only the mesh's frame, so that applyInFrame() can apply it.
bool isInFrame(const ModelCommand& command);
/// Does the same as applyToCopy() for such a command. Cost: the list of parts.
ModelChange applyInFrame(const Mesh& mesh, const ModelCommand& command, PartId part);

/// Returns the approximate number of faces of a uniform mesh with this d_detail on a surface of this area.
double uniformFaces(double area, double detailLength);
} // namespace core
