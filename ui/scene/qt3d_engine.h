#pragma once

#include "ui/scene/orbit_camera.h"

#include <QSize>
#include <Qt3DCore/QEntity>

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace ui
{
/// One aspect engine in Manual mode: frame() does everything at once, on this thread. Entities are children of root().
class Qt3dEngine
{
public:
    /// OwnTexture: Qt3D renders into textures of its own, in its own context.
    enum class Target { BoundFramebuffer, OwnTexture };

    /// What is new shows up after so many frames at the latest: shaders are loaded in one, commands built in the next.
    static constexpr int warmUpFrames = 4;

    /// The surface must outlive the engine. Fill root() before start().
    Qt3dEngine(QOffscreenSurface* surface, Target target);
    ~Qt3dEngine();

    Qt3DCore::QEntity* root() const;
    /// Qt3D makes its context here, and it is left current if it was found.
    void start();
    /// Null if it was not found.
    QOpenGLContext* context() const;
    /// Whether Qt3D draws into the framebuffer that is bound, a small one, and leaves it bound. Context current, no
    /// entity enabled.
    bool drawsIntoBoundFramebuffer(unsigned int framebuffer);

    void setView(const OrbitCamera& camera, QSize pixels);
    /// Target BoundFramebuffer: into it, context current. Else into texture(); no context is current afterwards.
    void frame();
    /// Target OwnTexture; 0 as long as Qt3D has not told.
    unsigned int texture() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace ui
