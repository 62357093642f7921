#pragma once

#include "ui/scene/headset_avatar.h"
#include "ui/scene/mesh_renderer.h"
#include "ui/scene/orbit_camera.h"
#include "ui/scene/reference_image.h"

#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"
#include "core/mesh/surface_hit.h"
#include "core/stroke/stroke.h"

#include <QOpenGLContext>

#include <memory>

namespace ui
{
/// Everything that is drawn, in one image: clay and backdrop by MeshRenderer, the overlays (OverlayEntities) by Qt3D,
/// which renders on demand and on this thread into our own framebuffer, so that both share one depth buffer.
///
/// That rests on Qt3D drawing into whatever framebuffer is bound when its context is current already; it is tested at
/// the start. Where it does not hold, the clay gets a context of its own and Qt3D's picture, of brush ring and mark
/// only, is laid over it.
///
/// Thread: gui. Precondition: QApplication exists, and prepareGraphics() was called before it. No other context may be
/// current during a call; afterwards the scene's is.
class Scene
{
public:
    enum class Mode { InQt3dContext, Layered };

    struct Image
    {
        unsigned int texture = 0; ///< readable in any context of the share group, once `ready` was waited for
        void* ready = nullptr;    ///< GLsync; the caller deletes it
        bool isDraft = false;     ///< the next one of the same will be sharper
        double drawMs = 0, sceneMs = 0;
    };

    /// Layered is for tests; else the mode is found out.
    explicit Scene(Mode wanted = Mode::InQt3dContext);
    ~Scene();

    /// False if the driver gave no usable context or framebuffer; nothing else may be called then.
    bool usable() const;
    Mode mode() const;

    /// Makes the scene's context current; use it at once.
    MeshBuffer& meshBuffer();

    void placeGround(const core::Box& box);
    void placeCursor(const core::SurfaceHit& hit, double radius, const QColor& color);
    void hideCursor();
    /// Tints what the next dab of a spherical brush at `center` would take, in all sectors and with mirror images, in
    /// place of what was tinted before.
    void tintBall(const core::Vec3& center, const core::StrokeSettings& brush);
    /// Those of a footprint; null: none.
    void tint(const std::shared_ptr<const core::Footprint>& footprint);
    /// Colours the clay by them, see PrintScale; null: by its own colours.
    void shade(const std::shared_ptr<const core::Footprint>& shades);
    /// A ring around a point of the surface, and a tick along the normal; seen through clay, too.
    void showMark(const core::Vec3& point, const core::Vec3& normal, double radius);
    void hideMark();
    /// The plane through the box, and the line where it cuts the clay; without symmetry neither.
    void showPlane(core::Symmetry symmetry, const core::Box& box);
    /// Where so many sectors meet, on the ground under the box; of one nothing.
    void showSectors(int sectors, core::Symmetry symmetry, const core::Box& box);
    /// In the next images, until another is named; its picture may be null.
    void showReference(const PlacedReference& reference);
    /// Draws the avatar of the user of the headset in the next images; none: nobody is in the headset.
    void showAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// The same of a lesson's teacher, of whom there is a brush.
    void showTeacher(const std::optional<core::Sphere>& brush);
    /// `darkTheme`: what the background is where it follows the window.
    void setAppearance(const ViewAppearance& appearance, bool darkTheme);

    Image render(const OrbitCamera& camera, QSize pixels, double pixelRatio);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Empty, or why this machine cannot show the clay, in one translated sentence. Makes a context to find out; cheap
/// after the first call.
QString graphicsProblem();
} // namespace ui
