#pragma once

#include "ui/scene/headset_avatar.h"
#include "ui/scene/orbit_camera.h"
#include "ui/scene/reference_image.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/view_appearance.h"
#include "ui/viewport/pointer_spotlight.h"
#include "ui/viewport/view_navigation.h"

#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"
#include "core/parts/part_transform.h"

#include <QOpenGLWidget>

#include <functional>
#include <memory>
#include <optional>

namespace ui
{
class KeyboardCursor;

/// Sets the surface format, shared contexts and Qt3D's renderer. Must be called once, before QApplication is created;
/// otherwise the viewport shows a message instead of the model.
void prepareGraphics();

/// Statistics of the viewport. Times in milliseconds.
struct ViewportStats
{
    quint64 frames = 0;
    quint64 patches = 0;
    quint64 uploadedBytes = 0; ///< bytes uploaded to the clay's buffers in total
    quint64 wholeUploads = 0;  ///< number of patches that replaced the whole buffers
    double patchMs = 0;        ///< CPU time to take and upload the last patch
    /// CPU time of the clay's draw calls in the last frame; includes rasterising in software OpenGL
    double drawMs = 0;
    double sceneMs = 0; ///< CPU time of overlays and ghosts in the last frame
    double frameMs = 0; ///< CPU time of the whole last frame
    /// time from an input event to the upload of its patch, for the last patch caused by input
    double latencyMs = 0;
    double worstLatencyMs = 0;
};

/// Shows the clay, and passes mouse, pen, touch and keys to the input. Has no mesh: it draws the patches that it takes.
/// Thread: gui.
class Viewport : public QOpenGLWidget
{
    Q_OBJECT

public:
    /// Neither pointer is owned; `brush` must outlive the viewport. Turns off the compression of mouse moves for the
    /// whole program.
    explicit Viewport(BrushSettings* brush, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Sets the function that returns the next patch, or none. It is called on the gui thread, once per frame, after
    /// patchReady().
    void setPatchSource(std::function<std::optional<core::MeshPatch>()> patchSource);

    /// Returns the input, which handles strokes, drags of the view, and the place under the pointer.
    PointerInput* input() const;
    ViewNavigation* navigation() const;
    PointerSpotlight* spotlight() const;
    const KeyboardCursor* keyboardCursor() const;
    /// Turns the keyboard cursor on or off. If on, the view gets the focus, and arrow keys, Space and Return sculpt
    /// while it has it.
    void setKeyboardCursor(bool on);

    /// Shows a new model: moves the ground under its box and frames it.
    void showModel(const core::Box& box);
    /// Updates the box of the present model; the ground stays under it.
    void setBox(const core::Box& box);

    /// Turns animation on or off: without it the view jumps instead of flying, and the spotlight does not pulse.
    void setReducesMotion(bool reducesMotion);
    bool reducesMotion() const;
    void setAppearance(const ViewAppearance& appearance);
    const ViewAppearance& appearance() const;
    /// Sets the reference images. Each is visible while the view looks from its side.
    void setReferences(const References& references);
    /// Colours the model by shades (see PrintScale) until null is set or another model is shown. Precondition: the
    /// shades were computed for the mesh that is drawn.
    void setShades(const std::shared_ptr<const core::Footprint>& shades);

    /// Shows vertices moved by a transformation, as far as their weights say; null: shows the model as it is. If it
    /// `isDone`, this ends with the next patch, which has it.
    void showMoved(const std::shared_ptr<const core::Footprint>& vertices, const core::Transform& by = {},
                   bool isDone = false);

    /// A plane that will cut the model.
    struct Cut
    {
        core::Vec3 point, normal; ///< mm; unit length, towards what is to go
        /// About which the plane's mirror image cuts the model, too; None: it does not.
        core::Symmetry image = core::Symmetry::None;
        std::shared_ptr<const core::Footprint> vertices; ///< what is cut: one part
    };
    /// Shows where a plane cuts the model, instead of the plane of symmetry; nullopt: ends that.
    void showCut(const std::optional<Cut>& cut);

    /// Returns the scale bar at the lower left; hidden if the appearance has none.
    QWidget* scaleBar() const;
    const OrbitCamera& camera() const;
    const ViewportStats& stats() const;

    /// Shows the user of the headset as a ghost over the clay until the next call. Cost: none until the next frame.
    void showAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Shows the brush of a lesson's teacher as a ghost until the next call.
    void showTeacher(const std::optional<core::Sphere>& brush);
    /// Shows solids translucent until the next call, mm; null: none.
    void showTranslucent(const std::shared_ptr<const core::DrawArrays>& translucent);

public Q_SLOTS:
    /// Schedules a frame that takes the waiting patch. Several calls before it cause only one frame.
    void patchReady();

Q_SIGNALS:
    /// A frame is about to be drawn: overlays follow the camera.
    void drawing();
    void appearanceChanged();
    void teacherShown(const std::optional<core::Sphere>& brush);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectInput();
    void updateCursor();
    void showDriverProblem();

    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace ui
