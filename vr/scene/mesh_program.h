#pragma once

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_uniforms.h"

#include "core/render/shading.h"

namespace vr
{
/// Shades the mesh and the wands as the desktop shades its mesh.
class MeshProgram : public Program
{
public:
    bool create(QOpenGLExtraFunctions* gl) { return Program::create(gl, "clay.vert", "clay.frag"); }

    /// Puts it in use for an eye. Without cut, footprint and faults, each vertex in its own shade.
    void useFor(const EyeUniforms& eye) const;
    /// From the vertices' own space to the room.
    void place(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom) const
    {
        view.set(Eigen::Matrix4f(eye.view * toRoom));
    }
    void shade(const core::Shading& shading) const;

    Uniform flatShading{this, "flatShading"};
    Uniform cut{this, "cut"}, cutNormal{this, "cutNormal"};
    Uniform ball{this, "ball"}, ballImage{this, "ballImage"}, ballFalloff{this, "ballFalloff"},
        sectors{this, "sectors"};

private:
    Uniform view{this, "view"}, projection{this, "projection"};
    Uniform up{this, "up"}, lights{this, "lights"};
    Uniform tint{this, "tint"}, wrap{this, "wrap"}, gloss{this, "gloss"}, sharpness{this, "sharpness"},
        rim{this, "rim"};
    Uniform through{this, "through"}, sheen{this, "sheen"};
    Uniform encodeSrgb{this, "encodeSrgb"}, shaded{this, "shaded"};
};
} // namespace vr
