#include "tests/vr/scene/example_scene.h"

#include <QPainter>
#include <QPainterPath>

#include <numbers>

namespace example
{
namespace
{
using vr::Pose;
using vr::WandPart;
using vr::WandSpot;

constexpr double degree = std::numbers::pi / 180;
const core::Vec3 brushPlace(0.095, 1.345, -0.635); ///< at the model's surface, metres

/// Returns a rotation about the room's Y by `yaw` and about its own X by `pitch`, degrees.
Eigen::Quaterniond turned(double yaw, double pitch)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(yaw * degree, core::Vec3::UnitY()) *
                              Eigen::AngleAxisd(pitch * degree, core::Vec3::UnitX()));
}

vr::WandLabel& label(vr::ShownWand& wand, WandSpot spot)
{
    return wand.labels[static_cast<std::size_t>(spot)];
}

vr::ShownWand leftWand()
{
    vr::ShownWand wand;
    wand.isShown = true;
    wand.grip = {turned(-18, 24), {-0.24, 1.20, -0.40}};
    label(wand, WandSpot::PadUp).text = QStringLiteral("Uniform / adaptive");
    label(wand, WandSpot::PadLeft).text = QStringLiteral("Turn left");
    label(wand, WandSpot::PadRight).text = QStringLiteral("Turn right");
    label(wand, WandSpot::PadMiddle).text = QStringLiteral("Slide: scale");
    label(wand, WandSpot::Menu).text = QStringLiteral("Tools");
    label(wand, WandSpot::Trigger).text = QStringLiteral("Move the model");
    label(wand, WandSpot::Side).text = QStringLiteral("Hold: save");
    wand.holdProgress = 0.65;
    wand.isLit[static_cast<std::size_t>(WandPart::Side)] = true;
    return wand;
}

vr::ShownWand rightWand()
{
    vr::ShownWand wand;
    wand.isShown = true;
    wand.grip.rotation = turned(28, 22);
    wand.grip.position = brushPlace - wand.grip.rotation * (vr::wandTip() - core::Vec3(0, 0, 0.03));
    label(wand, WandSpot::PadUp).text = QStringLiteral("Ball / ray");
    label(wand, WandSpot::PadLeft).text = QStringLiteral("Undo");
    label(wand, WandSpot::PadDown).text = QStringLiteral("Symmetry");
    label(wand, WandSpot::Trigger).text = QStringLiteral("Sculpt");
    label(wand, WandSpot::PadRight).text = QStringLiteral("Redo");
    label(wand, WandSpot::PadMiddle).text = QStringLiteral("Slide: radius");
    label(wand, WandSpot::Menu).text = QStringLiteral("Colour");
    label(wand, WandSpot::Side).text = QStringLiteral("Hold: start anew");
    wand.trigger = 0.7;
    wand.isLit[static_cast<std::size_t>(WandPart::Trigger)] = true;
    wand.isLit[static_cast<std::size_t>(WandPart::PadLeft)] = true;
    wand.touch = Eigen::Vector2d(-0.6, 0.1);
    wand.tip = core::Rgb{235, 240, 248};
    return wand;
}
} // namespace

vr::SceneState scene(const core::Box& box)
{
    vr::SceneState state;
    state.head = {turned(0, -16), {0, 1.62, 0}};
    const double scale = 0.34 / box.sizes().maxCoeff();
    state.model = Eigen::Translation3d(0, 1.30, -0.72) * turned(24, 0) * Eigen::UniformScaling(scale) *
                  Eigen::Translation3d(-box.center());
    state.box = box;
    state.shading.tint = {0.93F, 0.527F, 0.361F};
    state.symmetry = core::Symmetry::X;
    state.wands = {leftWand(), rightWand()};
    state.brush = vr::BallBrush{brushPlace, 0.035, 4};
    return state;
}

QImage panelPicture()
{
    QImage image(1024, 768, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(255, 255, 255, 40), 3));
    painter.setBrush(QColor(32, 35, 40, 242));
    painter.drawRoundedRect(QRectF(image.rect()).adjusted(3, 3, -3, -3), 44, 44);
    QFont font;
    font.setPixelSize(78);
    painter.setFont(font);
    painter.setPen(QColor(238, 241, 246));
    painter.drawText(QRect(64, 40, 900, 110), Qt::AlignVCenter, QStringLiteral("Tools"));
    font.setPixelSize(50);
    painter.setFont(font);
    const QString tools[] = {QStringLiteral("Pull"),   QStringLiteral("Push"),  QStringLiteral("Flatten"),
                             QStringLiteral("Smooth"), QStringLiteral("Paint"), QStringLiteral("Files")};
    for (int i = 0; i < 6; ++i) {
        const QRect cell(64 + 304 * (i % 3), 180 + 276 * (i / 3), 288, 260);
        painter.setPen(Qt::NoPen);
        painter.setBrush(i == 0 ? QColor(62, 118, 190) : QColor(52, 56, 63));
        painter.drawRoundedRect(cell, 24, 24);
        painter.setPen(QColor(238, 241, 246));
        painter.drawText(cell, Qt::AlignCenter, tools[i]);
    }
    return image;
}
} // namespace example
