#include "app/headset/avatar.h"

#include "vr/scene/wand_model.h"

#include <iterator>

namespace app
{
namespace
{
void append(core::DrawArrays& whole, const core::DrawArrays& part)
{
    const auto first = static_cast<core::Slot>(whole.vertices.size());
    std::ranges::copy(part.vertices, std::back_inserter(whole.vertices));
    for (const core::Triangle& face : part.faces)
        whole.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
}

const std::shared_ptr<const core::DrawArrays>& wholeWand()
{
    static const std::shared_ptr<const core::DrawArrays> wand = [] {
        core::DrawArrays whole;
        for (std::size_t i = 0; i < vr::wandPartCount; ++i)
            append(whole, vr::wandPartModel(static_cast<vr::WandPart>(i)));
        return std::make_shared<const core::DrawArrays>(std::move(whole));
    }();
    return wand;
}
} // namespace

ui::HeadsetAvatar avatarOf(const vr::AvatarState& state)
{
    const Eigen::Affine3d toModel = state.model.inverse();
    const double metre = toModel.linear().col(0).norm();
    const auto inModel = [&](const vr::Pose& pose) {
        return Eigen::Translation3d(toModel * pose.position) *
               Eigen::Isometry3d(Eigen::Quaterniond(toModel.linear() / metre) * pose.rotation);
    };
    ui::HeadsetAvatar avatar;
    avatar.metre = metre;
    avatar.radius = state.radius * metre;
    if (state.head)
        avatar.head = inModel(*state.head);
    for (std::size_t i = 0; i < vr::sideCount; ++i)
        if (state.hands[i])
            avatar.hands[i] = ui::GhostMesh{wholeWand(), inModel(*state.hands[i])};
    if (state.brush)
        avatar.brush = core::Sphere{toModel * state.brush->center, state.brush->radius * metre};
    return avatar;
}
} // namespace app
