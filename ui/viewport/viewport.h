#pragma once

#include "ui/scene/headset_avatar.h"
#include "ui/scene/orbit_camera.h"
#include "ui/scene/reference_image.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/preferences.h"
#include "ui/settings/view_appearance.h"

#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"
#include "core/mesh/surface_hit.h"
#include "core/render/shading.h"
#include "core/stroke/stroke.h"

#include <QOpenGLWidget>

#include <functional>
#include <memory>
#include <optional>

namespace ui
{
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

/// Shows the clay and turns mouse, pen and fingers into strokes. Knows no mesh: it draws the patches it takes and asks
/// where the surface is. Lives on the gui thread; every signal is emitted there.
///
/// A left press, or a finger, is a stroke if it is on the model, else it turns the view. Whether it is on the model is
/// the answer to a hover question; events that come before the answer wait for it, none is lost.
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

    /// Another model: moves the ground under its box and frames it.
    void showModel(const core::Box& box);
    /// The same model has another box now; the ground stays under it.
    void setBox(const core::Box& box);
    const core::Box& box() const;
    /// Shows the whole box from the present direction.
    void frame();
    void turnTo(OrbitCamera::Side side);
    void setView(const core::SavedView& view);
    /// About the Y axis by so many radians, anticlockwise seen from above, in so many seconds; under an open stroke,
    /// too. Not while the view follows a head, but for such a stroke.
    void turnModel(double angle, double seconds);
    void setProjection(OrbitCamera::Projection projection);

    void setInputPreferences(const InputPreferences& preferences);
    /// Without animations: the view jumps instead of flying, and the highlight does not pulse.
    void setReducesMotion(bool reducesMotion);
    bool reducesMotion() const;
    void setAppearance(const ViewAppearance& appearance);
    const ViewAppearance& appearance() const;
    /// The shading of the appearance's material.
    core::Shading shading() const;
    /// Each is seen while the view looks from its side.
    void setReferences(const References& references);

    /// At its lower left; hidden where the appearance has none.
    QWidget* scaleBar() const;

    const OrbitCamera& camera() const;
    const ViewportStats& stats() const;
    /// Colours the model by shades (see PrintScale) until the next model or null; they belong to the mesh as it is
    /// drawn.
    void setShades(const std::shared_ptr<const core::Footprint>& shades);
    /// Flies to a place of the surface that is `extent` mm large, and marks it.
    void flyTo(const core::Vec3& point, const core::Vec3& normal, double extent);
    void clearMark();

    /// Shows the avatar of the user of the headset over the model until the next call; none: following ends. As often
    /// as wanted: it costs nothing until the next frame.
    void showAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// The view goes, smoothed, where the avatar's head is and looks, and shows no avatar of it, until the user,
    /// frame(), turnTo() or flyTo() takes it elsewhere. Does not begin without an avatar.
    void setFollowing(bool on);
    bool isFollowing() const;

    /// How many logical pixels 1 mm covers where the cursor lies, else at the depth that the view turns about.
    double pixelsPerMm() const;
    bool strokeOpen() const;
    /// A press waits for its answer: a stroke may still come of it, before pressDecided().
    bool isPressPending() const;
    /// Armed: the next left press anywhere is sphereRequested(); Esc disarms.
    void setAdding(bool adding);
    /// Ends whatever drag is going on, as a release would.
    void finish();

    /// Turns on the keyboard cursor: arrow keys, Space and Return act as the pointer while the view has the focus,
    /// which it gets.
    void setKeyboardCursor(bool on);
    bool hasKeyboardCursor() const;
    /// The view turns by so many degrees, to the right and down, as the hand would turn it.
    void turnView(double right, double down);
    /// `factor` < 1 comes nearer: to the keyboard cursor, else to the middle of the view.
    void zoomView(double factor);

    /// The brush of a lesson's teacher, as a ghost besides; nothing: nobody teaches.
    void showTeacher(const std::optional<core::Sphere>& brush);

    /// While on, the pointer does not sculpt but highlights where it is on the model, and pointed() tells. Escape
    /// ends it, and so does what else a press may be for.
    void setPointing(bool on);
    bool isPointing() const;

    /// While on, the next press for the brush takes a colour from the model instead: picked() ends it. So does Escape.
    void setPicking(bool on);

public Q_SLOTS:
    /// There is something to take. Coalesced: at most one frame is scheduled.
    void patchReady();
    /// The answer to the hover question in flight. Each hoverRequested() is answered exactly once, in order, at any
    /// later time: with the surface's point, or with nothing if the ray misses or there is no model.
    /// `footprint`: of the brush that was asked about; it belongs to the mesh as it is drawn, or soon will be.
    void setHover(const std::optional<core::SurfaceHit>& hit,
                  const std::shared_ptr<const core::Footprint>& footprint = {});

Q_SIGNALS:
    /// At most one is in flight: the next is asked after setHover(), with the newest ray only. `brush`: whose footprint
    /// there is wanted, too; of a spherical brush none is, for that is seen without asking.
    void hoverRequested(const core::Ray& ray, const std::optional<core::StrokeSettings>& brush);

    /// A stroke: began, one sample or more (the first at the press), ended. Placement is Ray. The settings are those at
    /// the press. Always in this order, never nested.
    void strokeBegan(const core::StrokeSettings& settings);
    /// Each event of mouse or pen, none left out. `time`: the event's own, seconds; `position`, `direction`: the ray
    /// through the pixel, in mm; nothing is rounded to the lattice here.
    void strokeSampled(const core::StrokeSample& sample);
    void strokeEnded();
    void pressDecided();
    void addingChanged(bool adding);
    void keyboardCursorChanged(bool on);
    /// A ball of the brush's radius at the sample's position, or nothing.
    void sphereRequested(const core::StrokeSettings& settings, const core::StrokeSample& sample);

    void viewChanged();
    void appearanceChanged();
    void followingChanged(bool on);

    void pointingChanged(bool on);
    /// Nothing: the pointer has left the model, or has rested for a while.
    void pointed(const std::optional<core::SurfaceHit>& place);
    void teacherShown(const std::optional<core::Sphere>& brush);

    void pickingChanged(bool on);
    /// Nothing: the press was not on the model.
    void picked(const std::optional<core::Rgb>& color);

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
    void prepareFlight();
    void prepareFollowing();
    void prepareKeyboardCursor();
    void preparePointing();
    void restartPointingTimer();
    void emitPointed();
    void follow();
    void updateCursor();
    void showDriverProblem();

    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace ui
