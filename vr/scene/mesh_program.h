#pragma once

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_uniforms.h"

#include "core/render/shading.h"
#include "core/render/transform_uniforms.h"
#include "core/stroke/tool.h"

namespace vr
{
/// A plane that cuts the mesh. Space: the vertices' own.
struct CutPlane
{
    Eigen::Vector3f point = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< zero: no plane
    bool tints = false;                               ///< what is on the side of the normal is tinted
    /// About which the plane's mirror image has a part in the cut; None: it has not.
    core::Symmetry image = core::Symmetry::None;
};

/// Shades the mesh and the wands as the desktop's viewer does.
class MeshProgram : public Program
{
public:
    bool create(QOpenGLExtraFunctions* gl) { return Program::create(gl, "clay.vert", "clay.frag"); }

    /// Makes the program current for an eye, with smooth shading and without cut line, tint, cavity shading and
    /// transform.
    void useFor(const EyeUniforms& eye) const;
    /// Sets the transform from the vertices' own space to room space. Unless it scales uniformly, the light is only
    /// about right.
    void place(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom) const
    {
        view.set(Eigen::Matrix4f(eye.view * toRoom));
    }
    /// Tints the vertices in a ball and in its mirror image. Units: centre and radius in the vertices' own space;
    /// radius 0: no tint.
    void tintBalls(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom, const Eigen::Vector4f& ball,
                   const Eigen::Vector4f& image) const;
    /// Draws a line where a plane cuts the mesh.
    void cutAlong(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom, const CutPlane& plane) const;
    void shade(const core::Shading& shading) const;
    /// Shows a transform of the mesh before it is made. A vertex follows it as far as its weight says.
    void move(const core::TransformUniforms& move) const;
    /// Sets the number of sectors about the y axis in which the ball and its mirror image are repeated.
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
    Uniform cut{this, "cut"}, cutPlane{this, "cutPlane"}, cutImage{this, "cutImage"}, cutSide{this, "cutSide"},
        cutMarked{this, "cutMarked"};
    Uniform ball{this, "ball"}, ballImage{this, "ballImage"};
    Uniform ballInEye{this, "ballInEye"}, imageInEye{this, "imageInEye"};
    Uniform moved{this, "moved"}, moveCentre{this, "moveCentre"}, moveBy{this, "moveBy"}, turnAxis{this, "turnAxis"},
        turnAngle{this, "turnAngle"}, stretch{this, "stretch"};
    Uniform sectors{this, "sectors"}, sector{this, "sector"};
};
} // namespace vr
