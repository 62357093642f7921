#pragma once

#include <QColor>
#include <QMatrix4x4>
#include <QVector3D>

#include <Eigen/Core>

namespace ui
{
inline QMatrix4x4 toQt(const Eigen::Matrix4d& m)
{
    QMatrix4x4 q;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            q(row, column) = static_cast<float>(m(row, column));
    return q;
}

inline QVector3D toQt(const Eigen::Vector3d& v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline QVector3D toQt(const Eigen::Vector3f& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Returns sRGB components unchanged, scaled to 0 to 1.
inline QVector3D toQt(const QColor& color)
{
    return {color.redF(), color.greenF(), color.blueF()};
}
} // namespace ui
