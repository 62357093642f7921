// Measures the CPU cost of the headset's renderer to its thread, and draws pictures of what it shows. Run by hand, on a
// display:
//   headset_bench                    milliseconds of the thread's CPU per frame, outside draw calls
//   headset_bench --pictures FOLDER
#include "tests/bench/bench_models.h"

#include "tests/support/mesh_asserts.h"
#include "tests/vr/gl/offscreen_gl.h"
#include "tests/vr/scene/example_scene.h"
#include "vr/gl/texture.h"
#include "vr/scene/eye_target.h"
#include "vr/scene/scene.h"

#include "core/primitives/starter_models.h"
#include "core/sculpt/sculptor.h"

#include <QDir>

#include <algorithm>
#include <cstdio>

namespace
{
constexpr QSize eyePixels(1080, 1200);
/// Small size for measurements: the thread's own cost does not depend on it, but the cost of software OpenGL does.
constexpr QSize measuredPixels(216, 240);
/// tangents of an HTC Vive's fields of view
constexpr Tangents leftEye{1.39, 1.23, 1.47, 1.46}, rightEye{1.23, 1.39, 1.47, 1.46};
constexpr double halfEyeDistance = 0.0315;

struct Renderer
{
    OffscreenGl offscreen;
    vr::Scene scene;
    vr::EyeTarget target;
    TestImage image;
    vr::Texture panel;

    explicit Renderer(QSize pixels) : image(offscreen.gl(), pixels)
    {
        scene.create(offscreen.gl());
        target.create(offscreen.gl());
        panel.create(offscreen.gl());
        panel.upload(example::panelPicture());
    }

    void draw(const vr::SceneState& state, double sideways, const Tangents& tangents)
    {
        const vr::EyeImage wanted{image.texture(), image.format(), image.size().width(), image.size().height()};
        const vr::Pose eye = state.head * vr::Pose{Eigen::Quaterniond::Identity(), {sideways, 0, 0}};
        vr::EyeView view = eyeAt(eye, tangents, image);
        view.framebuffer = target.framebufferFor(wanted);
        scene.draw(view);
        target.resolve(wanted);
    }

    QImage picture(const vr::SceneState& state, double sideways, const Tangents& tangents)
    {
        for (int i = 0; i < 40; ++i)
            scene.prepare(state); // repeats until all labels are painted
        draw(state, sideways, tangents);
        return image.read();
    }
};

core::Box boxOf(const core::TriangleMesh& mesh)
{
    core::Box box;
    for (const core::Vec3f& point : mesh.points)
        box.extend(point.cast<double>());
    return box;
}

vr::RayBrush rayAt(const vr::SceneState& state, const core::Sculptor& sculptor)
{
    const vr::Pose aim = state.wands[1].grip * vr::Pose{Eigen::Quaterniond::Identity(), vr::wandTip()};
    const core::Vec3 at = state.model * (state.box.center() + core::Vec3(0.1, 0.25, 0).cwiseProduct(state.box.sizes()));
    vr::RayBrush brush{{aim.position, (at - aim.position).normalized()}, {}};
    const Eigen::Affine3d toModel = state.model.inverse();
    if (const auto hit = sculptor.hit({toModel * brush.ray.origin, toModel.linear() * brush.ray.direction}))
        brush.hit =
            vr::RayBrush::Hit{state.model * hit->position, (state.model.linear() * hit->normal).normalized(), 0.04};
    return brush;
}

void writePictures(Renderer& renderer, const QDir& folder)
{
    const core::TriangleMesh mesh = core::starterModel(core::Starter::Head);
    const core::Sculptor sculptor(mesh_asserts::sculptable(mesh));
    renderer.scene.apply(sculptor.wholePatch());
    const vr::SceneState ball = example::scene(boxOf(mesh));
    const auto save = [&](const vr::SceneState& state, const char* name) {
        renderer.picture(state, -halfEyeDistance, leftEye)
            .save(folder.filePath(QLatin1StringView(name) + QStringLiteral("-left.png")));
        renderer.picture(state, halfEyeDistance, rightEye)
            .save(folder.filePath(QLatin1StringView(name) + QStringLiteral("-right.png")));
    };
    save(ball, "ball");
    vr::SceneState ray = ball;
    ray.brush = rayAt(ball, sculptor);
    save(ray, "ray");
    vr::SceneState panel = ball;
    const core::Vec3 at(-0.42, 1.42, -0.62);
    vr::Pose pose = looking(at, 2 * at - ball.head.position);
    panel.panels = {{pose, {0.40, 0.30}, renderer.panel.id(), 1}};
    panel.lasers[1] = vr::Laser{ball.wands[1].grip * vr::wandTip(), pose * core::Vec3(0.06, 0.02, 0)};
    panel.brush = {};
    panel.symmetry = core::Symmetry::None;
    save(panel, "panel");
    vr::SceneState near = ball;
    near.head =
        looking(ball.wands[1].grip * core::Vec3(-0.10, 0.22, 0.06), ball.wands[1].grip * core::Vec3(0, 0, -0.03));
    renderer.picture(near, 0, {0.55, 0.55, 0.61, 0.61}).save(folder.filePath(QStringLiteral("wand-above.png")));
    near.head =
        looking(ball.wands[1].grip * core::Vec3(0.26, -0.06, -0.02), ball.wands[1].grip * core::Vec3(0, 0, -0.03));
    near.wands[1].labels = {};
    renderer.picture(near, 0, {0.55, 0.55, 0.61, 0.61}).save(folder.filePath(QStringLiteral("wand-beside.png")));
}
/// Durations of the frames, ms.
struct Samples
{
    std::vector<double> values;

    double at(double share)
    {
        std::ranges::sort(values);
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    }
};

/// Measures the thread's CPU time in a part of the frame, excluding the time in draw calls.
class Phase
{
public:
    Phase(const Renderer& renderer, Samples& into) : m_renderer(renderer), m_into(into) {}
    ~Phase() { m_into.values.push_back(now() - m_start); }
    Phase(const Phase&) = delete;
    Phase& operator=(const Phase&) = delete;

private:
    double now() const { return core::threadCpuMs() - m_renderer.scene.drawCallMs() - m_renderer.target.drawCallMs(); }

    const Renderer& m_renderer;
    Samples& m_into;
    double m_start = now();
};

/// Measures the frames from the arrival of a new model until it is shown.
void measureLoading(Renderer& renderer, const core::MeshPatch& whole, const vr::SceneState& state)
{
    Samples frames;
    core::MeshPatch patch = whole; // a copy, because the stream takes the patch over; the copying is not measured
    for (bool isNew = true; isNew || renderer.scene.isLoading(); isNew = false) {
        const Phase phase(renderer, frames);
        if (isNew)
            renderer.scene.apply(std::move(patch));
        renderer.scene.prepare(state);
    }
    {
        const Phase phase(renderer, frames); // releases the previous model
        renderer.scene.prepare(state);
    }
    std::printf("%9zu vertices, loading: %zu frames, median %.3f, longest %.3f\n", whole.vertices.size(),
                frames.values.size(), frames.at(0.5), frames.at(1));
}

/// Measures a stroke around a ball with one dab in each frame.
void measure(Renderer& renderer, core::Slot cuts)
{
    constexpr int frames = 100, warmUp = 20;
    core::Sculptor sculptor(bench::opened(bench::geodesicSphere(cuts)));
    vr::SceneState state = example::scene(core::Box(core::Vec3(-1, -1, -1), core::Vec3(1, 1, 1)));
    state.panels = {{looking({-0.4, 1.4, -0.6}, {-0.8, 1.2, -1.2}), {0.4, 0.3}, renderer.panel.id(), 1}};
    renderer.scene.prepare(state);
    measureLoading(renderer, sculptor.wholePatch(), state);
    sculptor.takePatch();
    core::StrokeSettings settings;
    settings.radius = 0.08;
    sculptor.beginStroke(settings);
    Samples apply, prepare, draw, whole;
    std::uint64_t bytes = 0;
    unsigned long calls = 0;
    for (int i = 0; i < frames + warmUp; ++i) {
        core::StrokeSample sample;
        sample.position = {std::cos(0.02 * i), std::sin(0.02 * i), 0};
        sculptor.addSample(sample);
        core::MeshPatch patch = sculptor.takePatch();
        if (i == warmUp) {
            for (Samples* samples : {&apply, &prepare, &draw, &whole})
                samples->values.clear();
            bytes = renderer.scene.meshBytes();
            calls = renderer.scene.drawCalls();
        }
        const Phase all(renderer, whole);
        {
            const Phase phase(renderer, apply);
            renderer.scene.apply(std::move(patch));
        }
        {
            const Phase phase(renderer, prepare);
            renderer.scene.prepare(state);
        }
        const Phase phase(renderer, draw);
        renderer.draw(state, -halfEyeDistance, leftEye);
        renderer.draw(state, halfEyeDistance, rightEye);
    }
    std::printf("%9llu vertices: apply %.3f (p99 %.3f)  prepare %.3f (%.3f)  both eyes %.3f (%.3f)  frame %.3f (%.3f)  "
                " %.0f kB a frame, %lu draw calls\n",
                static_cast<unsigned long long>(10 * cuts * cuts + 2), apply.at(0.5), apply.at(0.99), prepare.at(0.5),
                prepare.at(0.99), draw.at(0.5), draw.at(0.99), whole.at(0.5), whole.at(0.99),
                static_cast<double>(renderer.scene.meshBytes() - bytes) / frames / 1000,
                (renderer.scene.drawCalls() - calls) / frames);
    std::fflush(stdout);
}
} // namespace

int main(int argc, char* argv[])
{
    QGuiApplication application(argc, argv);
    const QStringList arguments = QGuiApplication::arguments();
    if (arguments.value(1) == QStringLiteral("--pictures")) {
        Renderer renderer(eyePixels);
        writePictures(renderer, QDir(arguments.value(2)));
        return 0;
    }
    Renderer renderer(measuredPixels);
    for (const double size : {1e4, 1e5, 1e6})
        measure(renderer, static_cast<core::Slot>(std::lround(std::sqrt(size / 10))));
    return 0;
}
