#pragma once

#include <Eigen/Core>

#include <variant>

namespace vr
{
// Translucent shapes in room space; colours are linear light.

/// A translucent sphere surface. Where the mesh hides it, it is drawn faintly.
struct Shell
{
    Eigen::Vector3f center = Eigen::Vector3f::Zero();
    float radius = 0;
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float strength = 1;
};

/// Never thinner than about two pixels.
struct Line
{
    Eigen::Vector3f from = Eigen::Vector3f::Zero(), to = Eigen::Vector3f::Zero();
    float width = 0; ///< metres
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    Eigen::Vector2f alphas = {1, 1}; ///< at both ends
};

struct Rectangle
{
    Eigen::Vector3f center = Eigen::Vector3f::Zero(), halfX = Eigen::Vector3f::Zero(), halfY = Eigen::Vector3f::Zero();
};

/// A ring, or, without a hole, a disc.
struct Ring
{
    Rectangle place;
    float hole = 0;  ///< its share of the radius
    float sweep = 1; ///< the share that there is, clockwise from +Y on
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float alpha = 1;
    float hiddenAlpha = 0; ///< where something hides it
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
    float distance = 0; ///< from the head; the farthest is drawn first
    std::variant<Shell, Line, Ring, Plane, Picture> shape;
};
} // namespace vr
