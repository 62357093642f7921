// Source: Khronos, glTF 2.0 specification, section 3.7.3 (skins).
#include "core/io/mesh/gltf_skin.h"

#include <Eigen/LU>

#include <array>
#include <charconv>
#include <string>

namespace core::io
{
namespace
{
constexpr std::size_t each = 4;

bool isIndex(float joint, std::span<const Eigen::Matrix4d> joints)
{
    return joint >= 0 && joint < static_cast<float>(joints.size());
}

std::string textOf(float joint)
{
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), joint).ptr};
}
} // namespace

GltfSkinning::GltfSkinning(const FileBytes& file, const GltfDocument& gltf, const GltfPrimitive& primitive,
                           std::span<const Eigen::Matrix4d> joints, std::size_t vertices)
    : m_joints(joints)
{
    for (std::size_t set = 0; !joints.empty(); ++set) {
        const std::string number = std::to_string(set), jointsName = "JOINTS_" + number,
                          weightsName = "WEIGHTS_" + number;
        if (!primitive.has(jointsName) || !primitive.has(weightsName))
            return;
        if (set == maxJointSets)
            throw tooMany("sets of joints", maxJointSets, errorWithToken({}, file, {}));
        Binding binding{primitive.numbersOf(jointsName, each, each).values,
                        primitive.numbersOf(weightsName, each, each).values};
        if (binding.joints.size() != each * vertices || binding.weights.size() != each * vertices)
            gltf.refuse(FileFault::WrongAccessor, jointsName);
        for (std::size_t i = 0; i < binding.joints.size(); ++i)
            if (binding.weights[i] > 0 && !isIndex(binding.joints[i], joints))
                gltf.refuse(FileFault::Missing, "joints/" + textOf(binding.joints[i]));
        m_bindings.push_back(std::move(binding));
    }
}

Eigen::Matrix4d GltfSkinning::transformOf(std::size_t vertex) const
{
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    double weights = 0;
    for (const Binding& binding : m_bindings)
        for (std::size_t i = each * vertex; i < each * (vertex + 1); ++i)
            if (const auto weight = static_cast<double>(binding.weights[i]); weight > 0) {
                sum += weight * m_joints[static_cast<std::size_t>(binding.joints[i])];
                weights += weight;
            }
    if (weights > 0)
        return sum / weights;
    const float first = m_bindings.front().joints[each * vertex];
    return m_joints[isIndex(first, m_joints) ? static_cast<std::size_t>(first) : 0];
}

bool GltfSkinning::isMirrored(std::size_t a, std::size_t b, std::size_t c) const
{
    const Eigen::Matrix4d sum = transformOf(a) + transformOf(b) + transformOf(c);
    return sum.topLeftCorner<3, 3>().determinant() < 0;
}
} // namespace core::io
