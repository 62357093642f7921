#pragma once

#include "ui/scene/orbit_camera.h"

#include <QSize>
#include <Qt3DCore/QEntity>

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace ui
{
/// A Qt3D aspect engine in Manual mode: frame() does all work synchronously, on the calling thread. Entities must be
/// children of root().
class Qt3dEngine
{
public:
    /// Number of frames after which a new entity is visible: shaders are loaded in one frame, commands built in the
    /// next.
    static constexpr int warmUpFrames = 4;

    /// The surface must outlive the engine. Entities should be added to root() before start().
    explicit Qt3dEngine(QOffscreenSurface& surface);
    ~Qt3dEngine();

    Qt3DCore::QEntity* root() const;
    /// Starts the engine. Qt3D creates its OpenGL context here, which is left current if it was found.
    void start();
    /// Returns Qt3D's OpenGL context, or null if it was not found.
    QOpenGLContext* context() const;
    /// Returns true if Qt3D draws into the bound framebuffer, here a small one, and leaves it bound. Precondition: the
    /// context is current and no entity is enabled.
    bool drawsIntoBoundFramebuffer(unsigned int framebuffer);

    void setView(const OrbitCamera& camera, QSize pixels);
    /// Renders a frame into the bound framebuffer. Precondition: the context is current.
    void frame();

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace ui
