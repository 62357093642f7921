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
/// Draws everything into one image: MeshRenderer draws clay and backdrop, an OverlayRenderer the overlays (overlays.h),
/// with one depth buffer. The overlays are drawn by Qt3D, which then has the OpenGL context of all; in a build without
/// Qt3D, and where it does not draw into Fettle's own framebuffer, by OpenGL (Mode::OpenGl).
///
/// Thread: gui. Precondition: QApplication exists, and prepareGraphics() was called before it was made. No other
/// context may be current during a call; afterwards the scene's context is current.
class Scene
{
public:
    /// Renderer of the overlays.
    enum class Mode { Qt3d, OpenGl };

    struct Image
    {
        unsigned int texture = 0; ///< readable in any context of the share group, after waiting for `ready`
        void* ready = nullptr;    ///< a GLsync, which the caller must delete
        bool isDraft = false;     ///< the next image of the same view will be sharper
        double drawMs = 0, sceneMs = 0;
    };

    /// `wanted`: OpenGl forces that mode, for tests; Qt3d uses it if the build and the driver allow.
    explicit Scene(Mode wanted = Mode::Qt3d);
    ~Scene();

    /// Returns false if the driver gave no usable context or framebuffer. Then no other function may be called.
    bool usable() const;
    Mode mode() const;

    /// Returns the clay's buffer and makes the scene's context current, as the buffer's functions need. Use it at once.
    MeshBuffer& meshBuffer();

    void placeGround(const core::Box& box);
    void placeCursor(const core::SurfaceHit& hit, double radius, const QColor& color);
    void hideCursor();
    /// Tints the clay that the next dab of a spherical brush at `center` would move, in all sectors and with mirror
    /// images. Replaces the tint before.
    void tintBall(const core::Vec3& center, const core::StrokeSettings& brush);
    /// Tints the vertices of a footprint; null: tints nothing.
    void tint(const std::shared_ptr<const core::Footprint>& footprint);
    /// Shows the vertices of a footprint moved by a transformation, as far as their weights say, instead of the clay as
    /// it is; null: ends that. Later calls with the same footprint cost no upload.
    void move(const std::shared_ptr<const core::Footprint>& vertices, const core::Transform& by = {});
    /// Colours the clay by these shades (see PrintScale); null: by its own colours.
    void shade(const std::shared_ptr<const core::Footprint>& shades);
    /// Shows a ring around a point of the surface with a tick along the normal, faintly visible through clay.
    void showMark(const core::Vec3& point, const core::Vec3& normal, double radius);
    void hideMark();
    /// Shows the plane of symmetry through the box, and the line where it cuts the clay; Symmetry::None hides both.
    void showPlane(core::Symmetry symmetry, const core::Box& box);
    /// Shows where a plane cuts the clay, instead of the plane of symmetry. tint() says which vertices are cut; those
    /// on the side of the normal (unit length) are tinted. `image`: the mirror image about this plane cuts as
    /// well. showPlane() ends that.
    void showCut(const core::Vec3& point, const core::Vec3& normal, core::Symmetry image);
    /// Shows the borders of this number of sectors on the ground under the box; 1: hides them.
    void showSectors(int sectors, core::Symmetry symmetry, const core::Box& box);
    /// Shows a reference image in the next frames, until the next call; a null picture shows none.
    void showReference(const PlacedReference& reference);
    /// Shows the avatar of the headset's user in the next frames; nullopt hides it.
    void showAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Shows the brush of a lesson's teacher in the next frames; nullopt hides it.
    void showTeacher(const std::optional<core::Sphere>& brush);
    /// Shows solids translucent in the next frames, mm; null shows none.
    void showTranslucent(const std::shared_ptr<const core::DrawArrays>& translucent);
    /// `darkTheme`: whether Background::Theme is dark.
    void setAppearance(const ViewAppearance& appearance, bool darkTheme);

    Image render(const OrbitCamera& camera, QSize pixels, double pixelRatio);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Returns why this machine cannot show the clay, as one translated sentence, or an empty text if it can. Cost: makes
/// an OpenGL context in the first call; later calls are cheap.
QString graphicsProblem();
} // namespace ui
