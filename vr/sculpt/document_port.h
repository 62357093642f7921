#pragma once

#include "vr/input/headset_settings.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_placement.h"
#include "vr/util/pose.h"

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
/// A place of the surface, in the document's space, mm.
struct PointedPlace
{
    core::Vec3 position = core::Vec3::Zero();
    core::Vec3 normal = core::Vec3::UnitY(); ///< of length 1

    bool operator==(const PointedPlace&) const = default;
};

/// What the headset knows of the document and of the window beside it. The newest replaces those before it.
struct DocumentUpdate
{
    quint64 model = 0; ///< counts the models that were opened: another one is placed before the head
    core::Box box;     ///< mm
    core::Shading shading;
    bool isFlat = false;    ///< each triangle in one shade
    bool hasTint = true;    ///< what the brush would move is coloured
    bool hasCavity = false; ///< valleys are darkened, ridges lightened
    /// Tool, shape, topology, symmetry, colour, falloff, strength, detail and fusion as the window has them.
    /// `brushChange` counts the window's own changes: what the headset requested is reported back without one.
    core::StrokeSettings brush;
    quint64 brushChange = 0;
    core::AirbrushRates airbrush = core::defaultAirbrushRates();
    bool smooths = true;        ///< Smooth is offered: by a trigger, too, whatever the tool is
    double smoothStrength = 1;  ///< of that trigger
    bool reducesMotion = false; ///< nothing moves that nobody moves
    /// The brush's radius is the headset's own, in metres of the room. Another number: the person at the window chose
    /// brush.radius for it, mm.
    quint64 radiusChange = 0;
    std::optional<core::Symmetry> plane; ///< of symmetry when it is switched on; nothing: none was chosen yet
    bool canUndo = false, canRedo = false;
    bool isModified = false; ///< opening another file would lose something
    bool isBusy = false;     ///< opening, saving or changing the whole model: nothing of that kind can begin
    QList<core::Rgb> swatches;
    QString folder; ///< the name of the folder of the files, for people
    QList<FileTile> files;
    QString saved;                       ///< the name that the last save of this visit gave, for people
    QString notice;                      ///< a sentence that is to be read in the headset, too
    quint64 noticeCount = 0;             ///< another number: it is shown again
    std::optional<PointedPlace> pointed; ///< where the person at the window points
    std::optional<LessonPanel> lesson;   ///< that is open in the window; its page is the headset's own
    std::optional<core::Sphere> teacher; ///< the brush of the lesson's teacher, mm
};

/// Where a brush of these settings meets the surface: a ray brush along the ray, a spherical one at its origin.
struct SurfaceQuery
{
    core::Ray ray;
    core::StrokeSettings brush;
    bool wantsFootprint = true; ///< of a ray brush; it is the costly part
};

/// Answer to querySurface(): where the brush meets the surface. `hit`: of a ray brush where the ray meets it; of a
/// spherical one the surface's nearest point, if that is within the radius.
struct SurfaceQueryResult
{
    std::optional<core::SurfaceHit> hit;
    std::shared_ptr<const core::Footprint> footprint; ///< of a ray brush that hits
};

/// What the strokes of this visit have done since it was last taken.
struct StrokeEffect
{
    int fusions = 0;  ///< surfaces joined, or parted
    int refusals = 0; ///< dabs that could not do what was asked, and strokes that somebody else's stroke forbade
};

/// Where the person is, for those at the window. Room space.
struct AvatarState
{
    std::optional<Pose> head;
    std::array<std::optional<Pose>, sideCount> hands;    ///< grips, by Side
    std::optional<core::Sphere> brush;                   ///< the spherical one
    double radius = 0;                                   ///< of the brush, whatever its shape; metres
    Eigen::Affine3d model = Eigen::Affine3d::Identity(); ///< document to room
    std::vector<PanelTarget> panels;
};

/// The brush that the window shall have, too: what DocumentUpdate::brush says, but for falloff, strength, detail and
/// fusion.
struct ChooseBrush
{
    core::StrokeSettings brush;
};

/// Another model; `discardsChanges`: the person held the button that says so.
struct OpenModel
{
    QString path;
    bool discardsChanges = false;
};

/// What the gui thread is asked to do; it is done there in this order, and in the order of the strokes before and after
/// it.
using DocumentRequest = std::variant<ChooseBrush, Undo, Redo, SaveModel, RestoreModel, OpenModel, core::MaskOperation,
                                     HeadsetSettings, LessonRequest>;

/// The document as the headset's thread sees it. All is called on that thread, none waits for another thread, and none
/// allocates more than what it hands over. Values of millimetres are in the document's space.
class DocumentPort
{
public:
    virtual ~DocumentPort() = default;

    /// The newest that was not taken yet. The first of a visit is whole.
    virtual std::optional<core::MeshPatch> takePatch() = 0;
    virtual std::optional<DocumentUpdate> takeUpdate() = 0;

    /// False: somebody else draws, or the model is being changed as a whole; then the stroke does not begin, and the
    /// other two do nothing.
    virtual bool beginStroke(const core::StrokeSettings& settings) = 0;
    virtual void addSample(const core::StrokeSample& sample) = 0;
    virtual void endStroke() = 0;
    virtual StrokeEffect takeEffect() = 0;

    /// The newest counts.
    virtual void querySurface(const SurfaceQuery& query) = 0;
    virtual std::optional<SurfaceQueryResult> takeQueryResult() = 0;

    virtual void request(const DocumentRequest& request) = 0;
    virtual void show(const AvatarState& avatar) = 0;
};
} // namespace vr
