#pragma once

#include "vr/input/headset_settings.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_placement.h"
#include "vr/util/pose.h"

#include "core/mesh/draw_arrays.h"
#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"
#include "core/mesh/surface_hit.h"
#include "core/operations/model_command.h"
#include "core/render/shading.h"
#include "core/stroke/stroke.h"

#include <array>
#include <memory>
#include <optional>
#include <variant>

namespace vr
{
/// A point on the surface, in document space, mm.
struct PointedPlace
{
    core::Vec3 position = core::Vec3::Zero();
    core::Vec3 normal = core::Vec3::UnitY(); ///< normal of the surface, unit length

    bool operator==(const PointedPlace&) const = default;
};

/// State of the document and of the window that the headset needs. A newer update replaces all older ones.
struct DocumentUpdate
{
    quint64 model = 0; ///< number of models opened so far; a new model is placed in front of the head
    core::Box box;     ///< bounding box of the model, mm
    core::Shading shading;
    bool isFlat = false;    ///< flat shading: each triangle has one shade
    bool hasTint = true;    ///< the part that the brush would move is tinted
    bool hasCavity = false; ///< cavity shading: valleys are darkened, ridges lightened
    /// Brush of the window. The headset takes it over, except its radius, when `brushChange` has changed. The count
    /// rises with changes made at the window; changes that the headset requested are reported back with the old count.
    core::StrokeSettings brush;
    quint64 brushChange = 0;
    core::AirbrushRates airbrush = core::defaultAirbrushRates();
    bool smooths = true;        ///< Smooth is offered: as a tool, and by a trigger while another tool is chosen
    double smoothStrength = 1;  ///< strength when a trigger makes strokes smooth
    bool reducesMotion = false; ///< reduced motion: no animations
    /// Number of times that a radius was chosen at the window. When it changes, the headset takes brush.radius, mm.
    /// Otherwise the headset keeps its own radius, in metres of the room.
    quint64 radiusChange = 0;
    std::optional<core::Symmetry> plane; ///< plane used when symmetry is on; none: no plane was chosen yet
    bool canUndo = false, canRedo = false;
    bool isModified = false; ///< opening another file would discard changes
    /// The model is being opened, saved or changed as a whole; no other such operation can begin.
    bool isBusy = false;
    QList<core::Rgb> swatches;
    QList<PartRow> parts;
    core::PartId activePart = 0;
    /// How parts are combined in the result that is shown before it becomes a step; none: no preview. No stroke can
    /// begin meanwhile.
    std::optional<core::SetOperation> preview;
    std::shared_ptr<const core::DrawArrays> translucent; ///< the parts that the preview has taken away, mm; null: none
    QString folder;                                      ///< name of the folder of `files`, for display
    QList<FileTile> files;
    QString saved;                       ///< name that the last save of this visit used, for display
    QString notice;                      ///< sentence to be shown in the headset too
    quint64 noticeCount = 0;             ///< a changed number makes the notice appear again
    std::optional<PointedPlace> pointed; ///< point that the user at the window points at
    /// Lesson that is open in the window; the headset turns its pages independently.
    std::optional<LessonPanel> lesson;
    std::optional<core::Sphere> teacher; ///< brush of the lesson's teacher, mm
};

/// A query where a brush of these settings meets the surface: a ray brush along the ray, a spherical one near the ray's
/// origin.
struct SurfaceQuery
{
    core::Ray ray;
    core::StrokeSettings brush;
    bool wantsFootprint = true; ///< asks for the footprint of a ray brush, which is costly
};

/// Answer to querySurface(). `hit`: the point where a ray brush meets the surface; for a spherical brush the nearest
/// point of the surface, if it is within the radius.
struct SurfaceQueryResult
{
    std::optional<core::SurfaceHit> hit;
    std::shared_ptr<const core::Footprint> footprint; ///< footprint of a ray brush that hits; else null
};

/// The vertices that move with the active part, as core::transformRegionOf() finds them. Space: document, mm.
struct MovablePart
{
    core::Vec3 centre = core::Vec3::Zero();          ///< place about which to turn
    std::shared_ptr<const core::Footprint> vertices; ///< vertices that move, weighted by how far they are not masked
};

/// Effects of this visit's strokes since the last call of takeEffect().
struct StrokeEffect
{
    int fusions = 0;  ///< number of times that surfaces joined or parted
    int refusals = 0; ///< number of samples that could not be applied and of strokes that were refused or cut short
};

/// The user's position in the room, for display in the window. Units: room space.
struct AvatarState
{
    std::optional<Pose> head;
    std::array<std::optional<Pose>, sideCount> hands;    ///< grips, indexed by Side
    std::optional<core::Sphere> brush;                   ///< the brush, if it is spherical; else none
    double radius = 0;                                   ///< radius of the brush of any shape, metres
    Eigen::Affine3d model = Eigen::Affine3d::Identity(); ///< document space to room space
    std::vector<PanelTarget> panels;
};

/// Sets the window's tool, brush shape, symmetries and colour, and whether its topology is uniform.
struct ChooseBrush
{
    core::StrokeSettings brush;
};

/// Opens another model. `discardsChanges`: the user held the button that warns of unsaved changes.
struct OpenModel
{
    QString path;
    bool discardsChanges = false;
};

struct ActivatePart
{
    core::PartId part = 0;
};

/// Makes the visible part active that the ray meets first. Units: document space.
struct PickPart
{
    core::Ray ray;
};

/// Shows only the active part, or again those that were shown before.
struct IsolatePart
{};

/// Applies a command to a part of the model, or to the parts that it concerns.
struct ChangePart
{
    core::PartId part = 0;
    core::ModelCommand command;
};

/// Shows the result of combining a part with others, until EndPreview.
struct PreviewParts
{
    core::PartId part = 0;
    core::CombineParts command;
};

/// Shows the result of another operation on the parts of the preview.
struct PreviewInstead
{
    core::SetOperation operation = core::SetOperation::Union;
};

/// Makes the preview a step, or takes it back.
struct EndPreview
{
    bool isApplied = false;
};

/// A request to the gui thread. Requests and strokes are executed in the order in which they were made.
using DocumentRequest = std::variant<ChooseBrush, Undo, Redo, SaveModel, RestoreModel, OpenModel, core::MaskOperation,
                                     HeadsetSettings, LessonRequest, ActivatePart, PickPart, IsolatePart, ChangePart,
                                     PreviewParts, PreviewInstead, EndPreview>;

/// The document as the headset's thread sees it. Thread: the headset's; no function waits for another thread, or
/// allocates more than it passes on. Units: mm in document space.
class DocumentPort
{
public:
    virtual ~DocumentPort() = default;

    /// Returns the newest data that was not taken yet. The first patch of a visit is the whole mesh.
    virtual std::optional<core::MeshPatch> takePatch() = 0;
    virtual std::optional<DocumentUpdate> takeUpdate() = 0;

    /// Begins a stroke. Returns false if it is refused, for example because another stroke is open or another model is
    /// being opened. addSample() and endStroke() then have no effect.
    virtual bool beginStroke(const core::StrokeSettings& settings) = 0;
    virtual void addSample(const core::StrokeSample& sample) = 0;
    virtual void endStroke() = 0;
    virtual StrokeEffect takeEffect() = 0;

    /// Asks where a brush meets the surface. A newer query replaces one that is not answered yet.
    virtual void querySurface(const SurfaceQuery& query) = 0;
    virtual std::optional<SurfaceQueryResult> takeQueryResult() = 0;

    /// Asks what moves if the active part is moved.
    virtual void queryPart() = 0;
    virtual std::optional<MovablePart> takePart() = 0;

    virtual void request(const DocumentRequest& request) = 0;
    /// Returns whether all requests that change the model are done. The patches of these changes can then be taken.
    virtual bool isSettled() = 0;
    virtual void show(const AvatarState& avatar) = 0;
};
} // namespace vr
