#include "vr/scene/wand_renderer.h"

#include "vr/scene/light.h"

#include "core/geometry/rotation.h"

#include <algorithm>

namespace vr
{
namespace
{
constexpr float glow = 1.2F; ///< factor of a coloured bead's brightness, above 1 so that it shines

const core::Shading bodyLook{
    .tint = {0.052F, 0.055F, 0.062F}, .wrap = 0.25F, .gloss = 0.20F, .sharpness = 26, .rim = 0.30F};
const core::Shading padLook{
    .tint = {0.105F, 0.110F, 0.120F}, .wrap = 0.30F, .gloss = 0.10F, .sharpness = 16, .rim = 0.20F};
const core::Shading buttonLook{
    .tint = {0.200F, 0.208F, 0.222F}, .wrap = 0.30F, .gloss = 0.16F, .sharpness = 30, .rim = 0.24F};
const core::Shading litLook{
    .tint = {0.13F, 0.38F, 0.86F}, .wrap = 0.90F, .gloss = 0.05F, .sharpness = 20, .rim = 0.10F};

core::Shading beadLook(const std::optional<core::Rgb>& color)
{
    if (!color)
        return buttonLook;
    core::Shading look = litLook;
    look.tint = glow * linearFromSrgb(*color);
    return look;
}

core::Shading lookOf(WandPart part, const ShownWand& wand)
{
    if (wand.isLit[static_cast<std::size_t>(part)])
        return litLook;
    switch (part) {
    case WandPart::Body:
        return bodyLook;
    case WandPart::PadUp:
    case WandPart::PadDown:
    case WandPart::PadLeft:
    case WandPart::PadRight:
    case WandPart::PadMiddle:
    case WandPart::Stick:
        return padLook;
    case WandPart::Tip:
        return beadLook(wand.tip);
    default:
        return buttonLook;
    }
}
bool has(const ShownWand& wand, WandPart part)
{
    if (wand.pinch)
        return part == WandPart::Tip;
    switch (part) {
    case WandPart::PadUp:
    case WandPart::PadDown:
    case WandPart::PadLeft:
    case WandPart::PadRight:
    case WandPart::PadMiddle:
        return wand.thumb == ShownWand::Thumb::Pad;
    case WandPart::Stick:
        return wand.thumb == ShownWand::Thumb::Stick;
    case WandPart::Side:
        return wand.thumb != ShownWand::Thumb::None;
    default:
        return true;
    }
}

Eigen::Affine3d turnOf(WandPart part, const ShownWand& wand)
{
    return part == WandPart::Trigger ? triggerTurn(wand.trigger)
           : part == WandPart::Stick ? stickTurn(wand.stick)
                                     : Eigen::Affine3d::Identity();
}
} // namespace

void WandRenderer::create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock)
{
    m_clock = clock;
    for (std::size_t part = 0; part < wandPartCount; ++part) {
        m_parts[part].create(gl);
        m_parts[part].apply(core::wholePatchOf(wandPartModel(static_cast<WandPart>(part))));
    }
}

void WandRenderer::destroy()
{
    for (MeshBuffer& part : m_parts)
        part.destroy();
}

/// Draws the bead as a ball of radius 1 about the origin of `place`.
void WandRenderer::drawBall(const EyeUniforms& eye, const MeshProgram& program, const Eigen::Affine3d& place)
{
    const Eigen::Affine3d whole =
        place * Eigen::UniformScaling<double>(1 / wandTipRadius) * Eigen::Translation3d(-wandTip());
    program.place(eye, whole.matrix().cast<float>());
    m_clock->run([&] { m_parts[static_cast<std::size_t>(WandPart::Tip)].draw(); });
}

/// Draws a ball at each joint, and an ellipsoid for each bone.
void WandRenderer::drawHand(const EyeUniforms& eye, const MeshProgram& program, const HandJoints& joints)
{
    program.shade(buttonLook);
    for (std::size_t i = 0; i < jointCount; ++i) {
        const HandJoint &joint = joints[i], &before = joints[jointBefore(i)];
        drawBall(eye, program, Eigen::Translation3d(joint.position) * Eigen::Scaling(joint.radius));
        const core::Vec3 bone = joint.position - before.position;
        if (bone.isZero())
            continue;
        const double thickness = std::min(joint.radius, before.radius);
        drawBall(eye, program,
                 Eigen::Translation3d((joint.position + before.position) / 2) *
                     core::rotationBetween(core::Vec3::UnitZ(), bone) *
                     Eigen::Scaling(thickness, thickness, bone.norm() / 2 + thickness));
    }
}

void WandRenderer::draw(const EyeUniforms& eye, const MeshProgram& program, const ShownWand& wand)
{
    if (!wand.isShown)
        return;
    if (wand.joints)
        drawHand(eye, program, *wand.joints);
    const Eigen::Affine3d grip = wand.pinch ? Eigen::Affine3d(Eigen::Translation3d(*wand.pinch - wandTip()))
                                            : Eigen::Affine3d(wand.grip.matrix());
    for (std::size_t i = 0; i < wandPartCount; ++i) {
        const auto part = static_cast<WandPart>(i);
        if (!has(wand, part))
            continue;
        const Eigen::Affine3d place = grip * turnOf(part, wand);
        program.place(eye, place.matrix().cast<float>());
        program.shade(lookOf(part, wand));
        m_clock->run([&] { m_parts[i].draw(); });
    }
}
} // namespace vr
