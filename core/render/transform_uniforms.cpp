#include "core/render/transform_uniforms.h"

namespace core
{
TransformUniforms uniformsOf(const Transform& transform)
{
    const Eigen::AngleAxisd turn(transform.rotation);
    const Eigen::Matrix3d axes = transform.scaleAxes.toRotationMatrix();
    const Eigen::Matrix3d stretch = axes * (transform.scale - Vec3::Ones()).asDiagonal() * axes.transpose();
    return {transform.centre.cast<float>(), transform.by.cast<float>(), turn.axis().cast<float>(),
            static_cast<float>(turn.angle()), stretch.cast<float>()};
}
} // namespace core
