// Measures the CPU cost of a headset visit to its thread while the user sculpts, by phases of a frame. Uses the whole
// program with the scripted runtime. Run by hand, on a release build, with a display:
//   visit_bench [VERTICES...]
// Units: CPU milliseconds. Draw calls are reported separately, because software OpenGL shades the picture within them.
#include "app/headset/headset_controller.h"
#include "core/io/mesh_io.h"
#include "tests/bench/bench_models.h"
#include "tests/support/program.h"
#include "tests/vr/simulator/scripted_headset.h"
#include "ui/viewport/viewport.h"
#include "vr/input/wand_mapping.h"
#include "vr/sculpt/sculpt_client.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <numbers>

namespace
{
constexpr int waitMs = 300'000;
constexpr int restFrames = 60, frames = 360; ///< total number of frames; the first restFrames have no stroke

double at(std::vector<double> values, double share)
{
    std::ranges::sort(values);
    return values.empty() ? 0 : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Returns a script that moves the controller with a pulled trigger over the front of a ball 0.5 m in diameter.
QByteArray script()
{
    QByteArray steps;
    for (int frame = restFrames; frame < frames; frame += 2) {
        const double angle = 0.02 * (frame - restFrames);
        const core::Vec3 tip =
            core::Vec3(0, 1.4, -0.6) + 0.25 * core::Vec3(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.8);
        steps +=
            QStringLiteral("%1{\"frame\": %2, \"over\": 2, \"right\": {\"position\": [%3, %4, %5], \"trigger\": 1}}")
                .arg(steps.isEmpty() ? QString() : QStringLiteral(", "))
                .arg(frame)
                .arg(tip.x())
                .arg(tip.y())
                .arg(tip.z() + vr::tipReach)
                .toUtf8();
    }
    return "{\"start\": {\"pace\": \"fast\", \"size\": [216, 240], \"head\": {\"position\": [0, 1.6, 0]}, \"aim\": "
           "{\"position\": [0, 0, 0], "
           "\"rotation\": [0, 0, 0, 1]}}, \"steps\": [" +
           steps + "]}";
}

void print(const char* name, const std::vector<vr::FrameTiming>& costs,
           const std::function<double(const vr::FrameTiming&)>& of)
{
    std::vector<double> values;
    for (const vr::FrameTiming& cost : costs)
        values.push_back(of(cost));
    std::printf("  %-9s %6.3f (%6.3f)", name, at(values, 0.5), at(values, 0.99));
}

template <class Condition> void waitFor(const Condition& condition)
{
    if (QTest::qWaitFor(condition, waitMs))
        return;
    std::fprintf(stderr, "visit_bench: what is to be measured did not come within %d s.\n", waitMs / 1000);
    std::exit(1);
}

void measure(core::Slot cuts)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("ball.ply"));
    core::TriangleMesh ball = bench::geodesicSphere(cuts);
    for (core::Vec3f& point : ball.points)
        point *= 50;
    core::writeMesh(path.toStdU16String(), ball);
    app::Program program;
    program.window.show();
    program.document.opener().open(path);
    waitFor([&] { return !program.document.job().isBusy() && program.document.modelInfo().path == path; });
    ScriptedHeadset headset;
    headset.load(script().constData());
    const auto ended = [&headset] { return headset.report()["frames_ended"].toInt(); };
    const int before = ended();
    app::HeadsetController controller({&program.document, &program.worker, &program.window});
    vr::HeadsetThread thread;
    thread.enter(std::make_shared<vr::SculptClient>(controller.open(), vr::HeadsetSettings()));
    waitFor([&] { return ended() - before >= frames; });
    const std::vector<vr::FrameTiming> all = thread.timings().recent();
    const auto first = std::min<std::ptrdiff_t>(restFrames, std::ssize(all)),
               last = std::min<std::ptrdiff_t>(frames, std::ssize(all));
    const std::vector<vr::FrameTiming> costs(all.begin() + first, all.begin() + last);
    std::printf("%8llu vertices", static_cast<unsigned long long>(program.document.modelInfo().vertices));
    constexpr const char* names[] = {"events", "wait", "input", "client", "images", "draw", "submit"};
    for (std::size_t i = 0; i < vr::framePhaseCount; ++i)
        print(names[i], costs, [i](const vr::FrameTiming& cost) {
            const auto phase = static_cast<vr::FramePhase>(i);
            return cost.of(phase) - (phase == vr::FramePhase::Draw ? cost.drawCallMs : 0);
        });
    print("all", costs, [](const vr::FrameTiming& cost) { return cost.ownMs(); });
    print("draw calls", costs, [](const vr::FrameTiming& cost) { return cost.drawCallMs; });
    std::printf("  %llu strokes\n", static_cast<unsigned long long>(program.worker.strokes().begun()));
    std::fflush(stdout);
    thread.leave();
    waitFor([&] { return !thread.isActive(); });
    controller.close();
}
} // namespace

int main(int argc, char* argv[])
{
    ui::prepareGraphics();
    QApplication application(argc, argv);
    std::vector<double> sizes;
    for (const QString& word : QCoreApplication::arguments().mid(1))
        sizes.push_back(word.toDouble());
    if (sizes.empty())
        sizes = {1e4, 1e5, 1e6};
    std::puts("CPU ms of the headset's thread a frame: median (99th percentile); draw calls apart");
    for (const double size : sizes)
        measure(static_cast<core::Slot>(std::lround(std::sqrt(size / 10))));
    return 0;
}
