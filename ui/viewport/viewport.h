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

#include <QOpenGLWidget>

#include <functional>
#include <memory>
#include <optional>

namespace ui
{
class KeyboardCursor;

/// To be called once, before QApplication is made: surface format, shared contexts, Qt3D's renderer.
/// Without it the viewport shows a sentence in place of the clay.
void prepareGraphics();

/// What the viewport measured. Times in milliseconds.
struct ViewportStats
{
    quint64 frames = 0;
    quint64 patches = 0;
    quint64 uploadedBytes = 0; ///< to the clay's buffers, ever
    quint64 wholeUploads = 0;  ///< patches that replaced the buffers
    double patchMs = 0;        ///< taking and uploading the last patch, CPU
    double drawMs = 0;         ///< the clay's draw calls of the last frame, CPU; software GL rasterises in here
    double sceneMs = 0;        ///< Qt3D's part of the last frame, CPU
    double frameMs = 0;        ///< the whole last frame, CPU
    double latencyMs = 0;      ///< from the input to its patch on the way to the screen, last patch that answers one
    double worstLatencyMs = 0;
};

/// Shows the clay and passes mouse, pen, fingers and keys to the input. Knows no mesh: it draws the patches it takes.
/// Thread: gui.
class Viewport : public QOpenGLWidget
{
    Q_OBJECT

public:
    /// Neither pointer is owned; `brush` must outlive the viewport. Switches off the compression of mouse moves in the
    /// whole program.
    explicit Viewport(BrushSettings* brush, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Where patches come from: called on the gui thread, once a frame, after patchReady(). An empty answer is fine.
    void setPatchSource(std::function<std::optional<core::MeshPatch>()> patchSource);

    /// Strokes, drags of the view, and what the pointer is on.
    PointerInput* input() const;
    ViewNavigation* navigation() const;
    PointerSpotlight* spotlight() const;
    const KeyboardCursor* keyboardCursor() const;
    /// On, arrow keys, Space and Return sculpt while the view has the focus, which it gets.
    void setKeyboardCursor(bool on);

    /// Another model: moves the ground under its box and frames it.
    void showModel(const core::Box& box);
    /// The same model has another box now; the ground stays under it.
    void setBox(const core::Box& box);

    /// Calm: the view jumps instead of flying, and the spotlight does not pulse.
    void setReducesMotion(bool reducesMotion);
    bool reducesMotion() const;
    void setAppearance(const ViewAppearance& appearance);
    const ViewAppearance& appearance() const;
    /// Each is seen while the view looks from its side.
    void setReferences(const References& references);
    /// Colours the model by shades (see PrintScale) until the next model or null; they belong to the mesh as it is
    /// drawn.
    void setShades(const std::shared_ptr<const core::Footprint>& shades);

    /// At its lower left; hidden where the appearance has none.
    QWidget* scaleBar() const;
    const OrbitCamera& camera() const;
    const ViewportStats& stats() const;

    /// Shows somebody in the headset as a ghost over the clay, until the next call. Cost: nothing until the next frame.
    void showAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Shows the brush of a lesson's teacher as a ghost, too.
    void showTeacher(const std::optional<core::Sphere>& brush);

public Q_SLOTS:
    /// There is something to take. Coalesced: at most one frame is scheduled.
    void patchReady();

Q_SIGNALS:
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
