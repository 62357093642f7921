#pragma once

#include "ui/input/pointer_input.h"
#include "ui/input/touch_input.h"
#include "ui/scene/scene.h"
#include "ui/viewport/keyboard_cursor.h"
#include "ui/viewport/keyboard_cursor_overlay.h"
#include "ui/viewport/pointer_highlight.h"
#include "ui/viewport/scale_bar.h"
#include "ui/viewport/stabilizer_line.h"
#include "ui/viewport/viewport.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QVariantAnimation>

namespace ui
{
/// For the viewport's own files: viewport.cpp shows, viewport_events.cpp handles pointer events, viewport_keys.cpp
/// keys, viewport_navigation.cpp goes where somebody wants to look, viewport_avatar.cpp follows the headset, and
/// viewport_pointing.cpp shows somebody where to look.
struct Viewport::State
{
    explicit State(BrushSettings* settings) : brush(settings) {}

    BrushSettings* brush;
    OrbitCamera camera;
    PointerInput input{brush, &camera};
    TouchInput touch{&input};
    KeyboardCursor keyboardCursor{&input};
    std::unique_ptr<Scene> scene;
    core::Box box;
    ViewAppearance appearance;
    References references;
    ScaleBar* scaleBar = nullptr;
    StabilizerLine* stabilizerLine = nullptr;
    KeyboardCursorOverlay* keyboardOverlay = nullptr; ///< shows the keyboard cursor
    PointerHighlight* highlight = nullptr;
    std::function<std::optional<core::MeshPatch>()> patchSource;
    struct Mark
    {
        core::Vec3 point, normal;
        double radius;
    };
    std::optional<Mark> mark;
    std::shared_ptr<const core::Footprint> shades;
    OrbitCamera::Pose from, to; ///< of the flight
    QVariantAnimation flight;
    bool reducesMotion = false; ///< no flights
    std::optional<HeadsetAvatar> avatar;
    std::optional<core::Sphere> teacher;
    std::optional<core::SurfaceHit> pointed; ///< as was told last
    QTimer pointingTimer;                    ///< hides the highlight when it runs out
    QTimer following;                        ///< runs while the view follows the head
    QElapsedTimer sinceFollowed;
    bool patchPending = false;
    unsigned int readFramebuffer = 0;
    ViewportStats stats;

    bool applyPatch();
    void placeCursor();
    void updateKeyboardCursorBounds(const QSize& view);
    void updateStabilizerLine();
    void placeMark();
    void placeAvatar();
    void placeHighlight();
    void show(const Scene::Image& image, QSize pixels, unsigned int widgetFramebuffer);
};
} // namespace ui
