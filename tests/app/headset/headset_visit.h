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
/// The window with a ball 100 mm in diameter, opened from a file. The headset is ready, but not in use.
struct HeadsetFixture
{
    /// `pixels`: size of an eye's picture.
    explicit HeadsetFixture(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : hand(program, pixels)
    {
        QSettings().clear();
        HeadsetSettingsStore().save(settings);
        core::writeMesh(path("clay.glb").toStdU16String(), core::icosphere(4, 50));
        // small, because each frame of the headset repaints its avatar in the window
        program.window.viewport()->setMaximumSize(viewSize);
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
    /// Returns the number of changes on the undo stack that are not undone.
    int changes() { return program.document.history().stack().index(); }
    /// Returns whether the model is as it was opened.
    bool isUntouched() { return hash() == startHash && !program.document.savedState().isModified(); }

    Program program;
    HeadsetHand hand;
    std::uint64_t startHash = 0;

private:
    static constexpr QSize viewSize{240, 180};

    QTemporaryDir m_folder;
};

/// A HeadsetFixture whose user is in VR, in front of the ball.
struct Visit : HeadsetFixture
{
    explicit Visit(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : HeadsetFixture(settings, pixels)
    {
        hand.enter();
    }

    Eigen::Affine3d model() const { return hand.seen().model; }
    double scale() const { return model().linear().col(0).norm(); }
    /// Pulls the surface out at the top.
    void pull(double trigger = 1) { hand.stroke({0, 49, 0}, {0, 54, 0}, 8, trigger); }
};

/// A Visit without painting of the window, which saves half of the time of a frame.
struct Alone : Visit
{
    explicit Alone(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : Visit(settings, pixels)
    {
        program.window.viewport()->setUpdatesEnabled(false);
    }
};

/// The left eye's picture and the head's pose.
struct Look
{
    QImage picture;
    vr::Pose head;

    /// Returns the pixel of a point in the room.
    QPoint at(const core::Vec3& place) const
    {
        const core::Vec3 own = head.inverse() * place - core::Vec3(-0.032, 0, 0);
        const double left = std::tan(-0.94), right = std::tan(0.81), top = std::tan(0.96), bottom = std::tan(-0.98);
        const double x = (own.x() / -own.z() - left) / (right - left), y = (top - own.y() / -own.z()) / (top - bottom);
        return {static_cast<int>(x * picture.width()), static_cast<int>(y * picture.height())};
    }
    /// Returns the part of the picture between two points in the room.
    QImage between(const core::Vec3& a, const core::Vec3& b) const
    {
        return picture.copy(QRect(at(a), at(b)).normalized());
    }
};

/// Returns the distance in metres along the viewing axis for a pixel of a depth picture ("left_depth") with these
/// clipping planes.
inline double distanceAt(const QImage& depth, const QPoint& at, double nearest = 0.03, double farthest = 60)
{
    const QColor color = depth.pixelColor(at);
    const double share = (color.red() * 65536 + color.green() * 256 + color.blue()) / double((1 << 24) - 1);
    return nearest * farthest / (farthest - share * (farthest - nearest));
}

/// Returns how many haptic pulses of the controller had the frequency that `feeling` produces.
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
