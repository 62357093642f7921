#pragma once

#include "vr/gl/eye_image.h"
#include "vr/scene/scene_state.h"

#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"

#include <memory>

class QOpenGLExtraFunctions;

namespace vr
{
/// Draws what a headset shows: the mesh with the desktop's shader, and around it room, wands, brush, plane of symmetry
/// and panels. Its own little renderer: OpenGL 3.3 core or more, without Qt3D. Writes linear light; an sRGB image
/// encodes it.
///
/// On the thread of its context, which must be current at every call. Per frame: apply() if there is a patch, prepare()
/// once, draw() for each eye. Nothing is allocated from frame to frame, but for texts that are new.
class Scene
{
public:
    Scene();
    ~Scene();

    /// False if a shader does not compile; the log is in the debug output. Takes some tenths of a second.
    bool create(QOpenGLExtraFunctions* gl);
    /// Before the scene goes, and its context.
    void destroy();

    /// Patches of one mesh in order, a whole one first. Cost: as core::MeshBuffer::apply(). But a large model that
    /// comes once frames have been prepared is sent in slices, one in each prepare(), and the one before is shown until
    /// the new one is there whole.
    void apply(core::MeshPatch patch);
    /// What is shown is still the model before.
    bool isLoading() const;
    /// Marks the vertices that a ray brush would take, in place of those before; null: none. A whole patch takes the
    /// marks away, and while a model is loading there are none.
    void tint(const core::Footprint* footprint);

    /// What can be done once for both eyes.
    void prepare(const SceneState& state);
    /// Into the eye's framebuffer, all of it.
    void draw(const EyeView& eye);

    std::uint64_t meshBytes() const; ///< uploaded since create()
    std::uint64_t wholeUploads() const;
    /// CPU time within draw calls since create(), milliseconds: without a graphics card they shade the picture
    /// themselves.
    double drawCallMs() const;
    unsigned long drawCalls() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace vr
