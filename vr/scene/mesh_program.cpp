#include "vr/scene/mesh_program.h"

namespace vr
{
void MeshProgram::useFor(const EyeUniforms& eye) const
{
    use();
    projection.set(eye.projection);
    up.set(eye.up);
    lights.set(eye.lights);
    flatShading.set(0);
    encodeSrgb.set(0.0F);
    shaded.set(0.0F);
    cut.set(0.0F);
    ball.set(Eigen::Vector4f(0, 0, 0, 0));
    ballImage.set(Eigen::Vector4f(0, 0, 0, 0));
    sectors.set(1.0F);
}

void MeshProgram::shade(const core::Shading& shading) const
{
    tint.set(shading.tint);
    wrap.set(shading.wrap);
    gloss.set(shading.gloss);
    sharpness.set(shading.sharpness);
    rim.set(shading.rim);
    through.set(shading.through);
    sheen.set(shading.sheen);
}
} // namespace vr
