#pragma once

#include "tests/app/headset/headset_hand.h"

#include "app/headset/headset_settings_store.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>

namespace app
{
/// A ball of 100 mm from a file, at the desktop, and a headset that lies beside it.
struct HeadsetFixture
{
    /// `pixels`: of an eye.
    explicit HeadsetFixture(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : hand(program, pixels)
    {
        QSettings().clear();
        HeadsetSettingsStore().save(settings);
        core::writeMesh(path("clay.glb").toStdU16String(), core::icosphere(4, 50));
        program.window.viewport()->setMaximumSize(viewSize); // each frame of the headset moves a ghost there
        openFile(program, path("clay.glb"), {640, 480});
        startHash = hash();
    }
    QString path(const char* name) const { return m_folder.filePath(QLatin1StringView(name)); }
    QStringList files() const { return QDir(m_folder.path()).entryList(QDir::Files, QDir::Name); }
    std::uint64_t hash()
    {
        return hand.ask([](core::Sculptor& sculptor) { return sculptor.mesh().meshHash(); });
    }
    core::Box box()
    {
        return hand.ask([](core::Sculptor& sculptor) {
            core::Box box;
            for (const core::Vec3f& point : core::extractMesh(sculptor.mesh()).points)
                box.extend(point.cast<double>());
            return box;
        });
    }
    core::StrokeSettings brush() const { return program.window.brush()->stroke(); }
    void trigger(const char* action) { program.window.action(QLatin1StringView(action))->trigger(); }
    /// Changes on the undo stack that are done.
    int changes() { return program.document.history().stack().index(); }
    /// As it was opened.
    bool isUntouched() { return hash() == startHash && !program.document.savedState().isModified(); }

    Program program;
    HeadsetHand hand;
    std::uint64_t startHash = 0;

private:
    static constexpr QSize viewSize{240, 180};

    QTemporaryDir m_folder;
};

/// The same, and a person in the headset before the ball.
struct Visit : HeadsetFixture
{
    explicit Visit(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : HeadsetFixture(settings, pixels)
    {
        hand.enter();
    }

    Eigen::Affine3d model() const { return hand.seen().model; }
    double scale() const { return model().linear().col(0).norm(); }
    /// Out of the surface at the top.
    void pull(double trigger = 1) { hand.stroke({0, 49, 0}, {0, 54, 0}, 8, trigger); }
};

/// The same, and nobody at the window: it is not painted, which is half of what a frame costs.
struct Alone : Visit
{
    explicit Alone(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : Visit(settings, pixels)
    {
        program.window.viewport()->setUpdatesEnabled(false);
    }
};

/// What the left eye sees.
struct Look
{
    QImage picture;
    vr::Pose head;

    /// Where a place of the room is on the picture.
    QPoint at(const core::Vec3& place) const
    {
        const core::Vec3 own = head.inverse() * place - core::Vec3(-0.032, 0, 0);
        const double left = std::tan(-0.94), right = std::tan(0.81), top = std::tan(0.96), bottom = std::tan(-0.98);
        const double x = (own.x() / -own.z() - left) / (right - left), y = (top - own.y() / -own.z()) / (top - bottom);
        return {static_cast<int>(x * picture.width()), static_cast<int>(y * picture.height())};
    }
    /// Between two corners, those of a panel's part.
    QImage between(const core::Vec3& a, const core::Vec3& b) const
    {
        return picture.copy(QRect(at(a), at(b)).normalized());
    }
};

/// Metres from the eye along its axis, of a pixel of an eye's picture of depth ("left_depth"), between planes at these
/// distances.
inline double distanceAt(const QImage& depth, const QPoint& at, double nearest = 0.03, double farthest = 60)
{
    const QColor color = depth.pixelColor(at);
    const double share = (color.red() * 65536 + color.green() * 256 + color.blue()) / double((1 << 24) - 1);
    return nearest * farthest / (farthest - share * (farthest - nearest));
}

/// The pulses of a run that feel like that.
inline int pulsesOf(HeadsetHand& hand, vr::Side side, const vr::HapticInput& feeling)
{
    std::array<vr::HapticInput, vr::sideCount> hands;
    hands[0] = feeling;
    const double frequency = vr::Haptics().step(1, hands).at(0).frequency;
    int count = 0;
    for (const QJsonValue& pulse : hand.headset().report()["haptics"].toArray())
        count +=
            pulse["frequency"].toDouble() == frequency &&
            pulse["hand"].toString() == (side == vr::Side::Left ? QStringLiteral("left") : QStringLiteral("right"));
    return count;
}
} // namespace app
