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
    /// The transform from the vertices' own space, scaled evenly, to the room.
    void place(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom) const
    {
        view.set(Eigen::Matrix4f(eye.view * toRoom));
    }
    /// Tints what is in a ball and in its mirror image: centre and radius, in the vertices' own space. Radius 0: none.
    void tintBalls(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom, const Eigen::Vector4f& ball,
                   const Eigen::Vector4f& image) const;
    /// Draws a line where the plane through the origin of the vertices' own space cuts. Zero: none.
    void cutAlong(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom, const Eigen::Vector3f& normal) const;
    void shade(const core::Shading& shading) const;
    /// The number of sectors about the y axis in which the ball and its image are.
    void setSectors(float count) const;

    Uniform flatShading{this, "flatShading"};
    Uniform ballFalloff{this, "ballFalloff"}, ballCore{this, "ballCore"};
    Uniform tinted{this, "tinted"}, cavity{this, "cavity"};

private:
    Uniform view{this, "view"}, projection{this, "projection"};
    Uniform up{this, "up"}, lights{this, "lights"};
    Uniform tint{this, "tint"}, wrap{this, "wrap"}, gloss{this, "gloss"}, sharpness{this, "sharpness"},
        rim{this, "rim"};
    Uniform through{this, "through"}, sheen{this, "sheen"};
    Uniform encodeSrgb{this, "encodeSrgb"}, shaded{this, "shaded"};
    Uniform cut{this, "cut"}, cutPlane{this, "cutPlane"};
    Uniform ball{this, "ball"}, ballImage{this, "ballImage"};
    Uniform ballInEye{this, "ballInEye"}, imageInEye{this, "imageInEye"};
    Uniform sectors{this, "sectors"}, sector{this, "sector"};
};
} // namespace vr
