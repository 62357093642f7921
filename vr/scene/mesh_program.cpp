#include "vr/scene/mesh_program.h"

#include "core/stroke/symmetry_plane.h"

#include <cmath>
#include <numbers>

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
    cutSide.set(0.0F);
    cutMarked.set(0.0F);
    ball.set(Eigen::Vector4f(0, 0, 0, 0));
    ballImage.set(Eigen::Vector4f(0, 0, 0, 0));
    ballInEye.set(Eigen::Vector4f(0, 0, 0, 0));
    imageInEye.set(Eigen::Vector4f(0, 0, 0, 0));
    setSectors(1);
    tinted.set(0.0F);
    cavity.set(0.0F);
    moved.set(0.0F);
}

void MeshProgram::move(const core::TransformUniforms& move) const
{
    moved.set(1.0F);
    moveCentre.set(move.centre);
    moveBy.set(move.by);
    turnAxis.set(move.axis);
    turnAngle.set(move.angle);
    stretch.set(move.stretch);
}

void MeshProgram::tintBalls(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom, const Eigen::Vector4f& brush,
                            const Eigen::Vector4f& image) const
{
    const Eigen::Matrix4f toEye = eye.view * toRoom;
    const float scale = toEye.col(0).head<3>().norm();
    const auto inEye = [&](const Eigen::Vector4f& of) {
        const Eigen::Vector4f center = toEye * Eigen::Vector4f(of.x(), of.y(), of.z(), 1);
        return Eigen::Vector4f(center.x(), center.y(), center.z(), scale * of.w());
    };
    ball.set(brush);
    ballImage.set(image);
    ballInEye.set(inEye(brush));
    imageInEye.set(inEye(image));
}

void MeshProgram::cutAlong(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom, const CutPlane& plane) const
{
    const Eigen::Matrix4f toEye = eye.view * toRoom;
    const auto planeInEye = [&](const Eigen::Vector3f& normalInMesh, const Eigen::Vector3f& pointInMesh) {
        const Eigen::Vector3f normal = toEye.topLeftCorner<3, 3>() * normalInMesh;
        const Eigen::Vector3f point = (toEye * pointInMesh.homogeneous()).head<3>();
        return Eigen::Vector4f(normal.x(), normal.y(), normal.z(), -normal.dot(point));
    };
    const Eigen::Vector3f mirror = core::planeNormal(plane.image).cast<float>();
    const auto image = [&](const Eigen::Vector3f& v) { return Eigen::Vector3f(v - 2 * mirror.dot(v) * mirror); };
    cut.set(plane.normal.isZero() ? 0.0F : 1.0F);
    cutSide.set(plane.tints ? 1.0F : 0.0F);
    cutPlane.set(planeInEye(plane.normal, plane.point));
    cutImage.set(planeInEye(image(plane.normal), image(plane.point)));
}

void MeshProgram::setSectors(float count) const
{
    const float angle = 2 * std::numbers::pi_v<float> / count;
    sectors.set(count);
    sector.set(Eigen::Vector2f(std::cos(angle), std::sin(angle)));
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
