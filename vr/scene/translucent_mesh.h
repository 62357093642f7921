#pragma once

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_uniforms.h"
#include "vr/scene/mesh_buffer.h"
#include "vr/scene/mesh_stream.h"
#include "vr/util/draw_call_timer.h"

#include "core/mesh/draw_arrays.h"

#include <memory>

namespace vr
{
/// Draws a translucent mesh of the document: the parts that a preview has taken away. It looks as in the window.
/// Precondition: the context of create() is current at every call.
class TranslucentMesh
{
public:
    /// Returns false if a shader does not compile.
    bool create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Sets what is drawn, in document space, mm; null: nothing. A large mesh is uploaded in slices, one in each call,
    /// and drawn when it is complete. To be called once a frame. Cost: a copy of a mesh that is set.
    void prepare(const std::shared_ptr<const core::DrawArrays>& arrays);
    /// Draws both sides. `toRoom`: document space to room space. Precondition: blending is on, writing of depth off.
    void draw(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom);

private:
    struct GhostProgram : Program
    {
        Uniform place{this, "place"}, projection{this, "projection"}, color{this, "color"}, alphas{this, "alphas"};
    };

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawCallTimer* m_clock = nullptr;
    GhostProgram m_program;
    MeshStream<MeshBuffer> m_mesh;
    std::shared_ptr<const core::DrawArrays> m_arrays; ///< what m_mesh shows or is loading
};
} // namespace vr
