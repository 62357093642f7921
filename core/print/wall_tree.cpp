#include "core/print/wall_tree.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// Float32 steps by which a coordinate may be wrong after the sums of a test.
constexpr double floatSteps = 4;
/// Limit for inverse directions. A ray nearly parallel to a plane is treated as parallel; the product with any
/// coordinate still fits in a float32.
constexpr double maxInverse = 1e30;
/// Error of the cosine between a direction and a normal in float32.
constexpr double normalError = 1e-5;
} // namespace

WallTree::WallTree(const BoxTree& tree, std::vector<FaceBox> normals)
{
    std::vector<FaceBox> boxes(tree.size());
    for (Slot position = 0; position < tree.size(); ++position)
        boxes[position] = tree.box(position);
    for (const FaceBox& box : boxes)
        m_farthest =
            std::max({m_farthest, static_cast<double>(-box.min.minCoeff()), static_cast<double>(box.max.maxCoeff())});
    do {
        std::vector<Node>& nodes = m_levels.emplace_back();
        std::vector<FaceBox> above((boxes.size() + width - 1) / width), normalsAbove(above.size());
        nodes.resize(std::max<std::size_t>(1, above.size()));
        for (std::size_t i = 0; i < width * nodes.size(); ++i) {
            const FaceBox box = i < boxes.size() ? boxes[i] : FaceBox();
            const FaceBox ofNormals = i < boxes.size() ? normals[i] : FaceBox();
            Node& node = nodes[i / width];
            const auto child = static_cast<Eigen::Index>(i % width);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto axis = static_cast<Eigen::Index>(k);
                node.min[k][child] = box.min[axis];
                node.max[k][child] = box.max[axis];
                node.minNormal[k][child] = ofNormals.min[axis];
                node.maxNormal[k][child] = ofNormals.max[axis];
            }
            if (i < boxes.size()) {
                above[i / width].extend(box);
                normalsAbove[i / width].extend(ofNormals);
            }
        }
        boxes = std::move(above);
        normals = std::move(normalsAbove);
    } while (boxes.size() > 1);
}

double WallTree::errorOf(const Vec3& p) const
{
    constexpr auto step = static_cast<double>(std::numeric_limits<float>::epsilon());
    return floatSteps * step * std::max(m_farthest, p.cwiseAbs().maxCoeff());
}

WallTree::Ray::Ray(const WallTree& tree, const Vec3& origin, const Vec3& direction)
{
    const double error = tree.errorOf(origin);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        m_afterOrigin[i] = static_cast<float>(origin[axis] + error);
        m_beforeOrigin[i] = static_cast<float>(origin[axis] - error);
        const double inverse = direction[axis] == 0 ? maxInverse : 1 / direction[axis];
        m_inverse[i] = static_cast<float>(std::clamp(inverse, -maxInverse, maxInverse));
    }
}

WallTree::Opposite::Opposite(const Vec3& direction, double maxCosine)
    : m_maxCosine(static_cast<float>(maxCosine + normalError))
{
    for (std::size_t i = 0; i < 3; ++i)
        m_direction[i] = static_cast<float>(direction[static_cast<Eigen::Index>(i)]);
}

WallTree::Point::Point(const WallTree& tree, const Vec3& p)
{
    const double error = tree.errorOf(p);
    for (std::size_t i = 0; i < 3; ++i) {
        m_after[i] = static_cast<float>(p[static_cast<Eigen::Index>(i)] + error);
        m_before[i] = static_cast<float>(p[static_cast<Eigen::Index>(i)] - error);
    }
}
} // namespace core
