#pragma once

#include <Eigen/Core>

#include <variant>

namespace vr
{
// Translucent shapes are in room space. Their colours are linear light.

/// A translucent sphere surface. Where the mesh hides it, it is drawn faintly.
struct Shell
{
    Eigen::Vector3f center = Eigen::Vector3f::Zero();
    float radius = 0;
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float strength = 1;
};

/// A line, which is drawn at least about two pixels wide.
struct Line
{
    Eigen::Vector3f from = Eigen::Vector3f::Zero(), to = Eigen::Vector3f::Zero();
    float width = 0; ///< metres
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    Eigen::Vector2f alphas = {1, 1}; ///< opacities at `from` and at `to`
};

struct Rectangle
{
    Eigen::Vector3f center = Eigen::Vector3f::Zero(), halfX = Eigen::Vector3f::Zero(), halfY = Eigen::Vector3f::Zero();
};

/// A ring, or a disc if its hole is 0.
struct Ring
{
    Rectangle place;
    float hole = 0;  ///< radius of the hole as a fraction of the ring's radius
    float sweep = 1; ///< fraction of the circle that is drawn, clockwise from +Y
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float alpha = 1;
    float hiddenAlpha = 0; ///< opacity of the parts that something hides
};

struct Plane
{
    Rectangle place;
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
};

struct Picture
{
    Rectangle place;
    unsigned int texture = 0;
    float opacity = 1;
};

struct TranslucentShape
{
    float distance = 0; ///< distance from the head, metres; the farthest shape is drawn first
    std::variant<Shell, Line, Ring, Plane, Picture> shape;
};
} // namespace vr
