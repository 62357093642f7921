#pragma once

#include "vr/gl/eye_image.h"
#include "vr/scene/scene_state.h"

#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"

#include <memory>

class QOpenGLExtraFunctions;

namespace vr
{
/// Draws everything that the headset shows: the mesh with the desktop's shader, and around it the room, wands, brush,
/// plane of symmetry and panels. It is a small renderer of its own: OpenGL 3.3 core or later, without Qt3D. It writes
/// linear light, which an sRGB image encodes.
///
/// Use in each frame: apply() if there is a patch, prepare() once, draw() for each eye. Nothing is allocated from frame
/// to frame, except for new texts.
///
/// Thread: that of its context, which must be current at every call.
class Scene
{
public:
    Scene();
    ~Scene();

    /// Returns false if a shader does not compile; the log is in the debug output. Cost: some tenths of a second.
    bool create(QOpenGLExtraFunctions* gl);
    /// Frees the OpenGL objects. To be called before the scene or its context is destroyed.
    void destroy();

    /// Applies a patch. Patches of one mesh come in order, a whole one first. A large model that comes after the first
    /// prepare() is uploaded in slices, one in each prepare(); the last model is shown until the new one is complete.
    /// Cost: as core::MeshBuffer::apply(), unless the model is uploaded in slices.
    void apply(core::MeshPatch patch);
    /// Returns whether the last model is still shown because a new one is being uploaded.
    bool isLoading() const;
    /// Marks the vertices of a ray brush's footprint, or those that SceneState::move moves, in place of earlier marks;
    /// null: no marks. A whole patch removes the marks, and a model that is being uploaded has none.
    void tint(const core::Footprint* footprint);

    /// Prepares a frame: does the work that both eyes share.
    void prepare(const SceneState& state);
    /// Draws the whole picture of an eye into its framebuffer.
    void draw(const EyeView& eye);

    std::uint64_t meshBytes() const; ///< bytes of meshes uploaded since create()
    std::uint64_t wholeUploads() const;
    /// Returns the CPU time of draw calls since create(), milliseconds. Without a graphics card the driver rasterises
    /// within them.
    double drawCallMs() const;
    unsigned long drawCalls() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace vr
