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
/// For the viewport's own files: viewport.cpp shows, viewport_events.cpp takes what the hand does, viewport_keys.cpp
/// what keys do, viewport_navigation.cpp goes where somebody wants to look, viewport_avatar.cpp to where the headset
/// is, and viewport_pointing.cpp shows somebody where to look.
struct Viewport::State
{
    explicit State(BrushSettings* settings) : brush(settings) {}

    BrushSettings* brush;
    OrbitCamera camera;
    PointerInput input{brush, &camera};
    TouchInput touch{&input};
    KeyHand keys{&input};
    std::unique_ptr<Scene> scene;
    core::Box box;
    ViewLook look;
    References references;
    ScaleBar* scaleBar = nullptr;
    StringLine* string = nullptr;
    KeyCross* cross = nullptr; ///< where the hand of the keys is
    PointLight* light = nullptr;
    std::function<std::optional<core::MeshPatch>()> take;
    struct Mark
    {
        core::Vec3 point, normal;
        double radius;
    };
    std::optional<Mark> mark;
    std::shared_ptr<const core::Footprint> shades;
    OrbitCamera::Pose from, to; ///< of the flight
    QVariantAnimation flight;
    bool isCalm = false; ///< there are none
    std::optional<Wearer> wearer;
    std::optional<core::Sphere> teacher;
    std::optional<core::SurfaceHit> pointed; ///< as was told last
    QTimer pointRest;                        ///< runs out: the light goes
    QTimer following;                        ///< runs while the view follows the head
    QElapsedTimer sinceFollowed;
    bool patchWaiting = false;
    unsigned int readFramebuffer = 0;
    ViewportStats stats;

    bool applyPatch();
    void placeCursor();
    void reachWithKeys(const QSize& view);
    void spanString();
    void placeMark();
    void placeWearer();
    void placeLight();
    void show(const Scene::Image& image, QSize pixels, unsigned int widgetFramebuffer);
};
} // namespace ui
