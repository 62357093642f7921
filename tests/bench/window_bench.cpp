// Measures the window with models of 10,000 to 1,000,000 vertices: opening, frames during strokes, the 2D preview, and
// the longest time that the GUI thread did not process events. Run by hand, on a release build, with a display:
//   window_bench [VERTICES...]
// Units: CPU milliseconds of the GUI thread. In "clay" and "blit" software GL rasterises, which a graphics card would
// do instead.
#include "app/worker/drawing_worker.h"
#include "app/worker/job_queue.h"

#include "core/io/mesh_io.h"
#include "tests/bench/bench_models.h"
#include "tests/support/program.h"
#include "ui/viewport/viewport.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <execinfo.h>
#include <link.h>
#include <pthread.h>
#include <thread>
#include <unistd.h>

namespace
{
constexpr int moves = 150, moveMs = 10;
constexpr int waitMs = 300'000;

using app::Program;

struct Samples
{
    std::vector<double> values;

    double median() { return at(0.5); }
    double worst() { return at(1); }
    double at(double share)
    {
        if (values.empty())
            return 0;
        std::ranges::sort(values);
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    }
};

/// Measures how long the event loop was blocked, excluding the GL driver. A signal every 2 ms samples the call stack of
/// the GUI thread.
class Absence
{
public:
    Absence()
    {
        s_guiThread = pthread_self();
        void* warm[1];
        backtrace(warm, 1); // the first call loads a library, which a signal handler must not do
        s_code.clear();
        dl_iterate_phdr(note, nullptr);
        struct sigaction action = {};
        action.sa_handler = look;
        action.sa_flags = SA_RESTART;
        sigaction(SIGUSR2, &action, nullptr);
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { comeBack(); });
        m_timer.start(1);
        m_asker = std::jthread([](const std::stop_token& stop) {
            while (!stop.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                pthread_kill(s_guiThread, SIGUSR2);
            }
        });
    }
    double worst() const { return m_worst; }

private:
    static double nowMs() { return static_cast<double>(app::steadyNs()) * 1e-6; }

    struct Code
    {
        std::uintptr_t begin, end;
        bool isDriver;
    };

    /// Records the address range of a library's code. The compiler of software GL counts as part of the driver.
    static int note(dl_phdr_info* library, std::size_t, void*)
    {
        const bool isDriver =
            std::strstr(library->dlpi_name, "_dri.so") != nullptr || std::strstr(library->dlpi_name, "LLVM") != nullptr;
        for (int i = 0; i < library->dlpi_phnum; ++i)
            if (const auto& part = library->dlpi_phdr[i]; part.p_type == PT_LOAD && (part.p_flags & PF_X) != 0)
                s_code.push_back(
                    {library->dlpi_addr + part.p_vaddr, library->dlpi_addr + part.p_vaddr + part.p_memsz, isDriver});
        return 0;
    }

    /// Returns whether the frame is in the driver. Code that software GL compiles at run time is in no library.
    static bool isOfDriver(void* frame)
    {
        const auto at = reinterpret_cast<std::uintptr_t>(frame);
        const auto code = std::ranges::find_if(s_code, [at](const Code& c) { return at >= c.begin && at < c.end; });
        return code == s_code.end() || code->isDriver;
    }

    /// Adds the time since the last sample to the driver if the thread is in the driver now.
    static void look(int)
    {
        std::array<void*, 64> frames;
        const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
        const double now = nowMs();
        if (std::any_of(frames.begin(), frames.begin() + count, isOfDriver))
            s_driverMs = s_driverMs + now - s_lookedMs;
        s_lookedMs = now;
    }

    void comeBack()
    {
        const double now = nowMs();
        if (m_leftMs > 0)
            m_worst = std::max(m_worst, now - m_leftMs - s_driverMs);
        m_leftMs = now;
        s_lookedMs = now;
        s_driverMs = 0;
    }

    static inline pthread_t s_guiThread;
    static inline std::vector<Code> s_code;
    static inline std::atomic<double> s_driverMs = 0, s_lookedMs = 0;
    QTimer m_timer;
    double m_worst = 0, m_leftMs = 0;
    std::jthread m_asker;
};

double secondsSinceProcessStart()
{
    QFile stat(QStringLiteral("/proc/self/stat")), uptime(QStringLiteral("/proc/uptime"));
    if (!stat.open(QIODevice::ReadOnly) || !uptime.open(QIODevice::ReadOnly))
        return 0;
    const QByteArray text = stat.readAll();
    const double ticks = text.mid(text.lastIndexOf(')') + 2).split(' ')[19].toDouble();
    return uptime.readAll().split(' ')[0].toDouble() - ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

bool waitFor(const std::function<bool()>& isSo)
{
    return QTest::qWaitFor(isSo, waitMs);
}

void open(Program& program, const QString& path)
{
    int told = 0;
    const auto counting =
        QObject::connect(&program.document.job(), &app::BackgroundJob::progressed, &program.window, [&] { ++told; });
    Absence absence;
    QElapsedTimer clock;
    clock.start();
    const quint64 wholes = program.window.viewport()->stats().wholeUploads;
    program.document.opener().open(path);
    const bool opened = waitFor(
        [&] { return !program.document.job().isBusy() && program.window.viewport()->stats().wholeUploads > wholes; });
    QObject::disconnect(counting);
    std::printf("%9llu  open to frame %7.0f ms   progress told %3d times   gui away at most %4.0f ms%s\n",
                static_cast<unsigned long long>(program.document.modelInfo().vertices),
                static_cast<double>(clock.elapsed()), told, absence.worst(), opened ? "" : "   NOT OPENED");
}

/// Sculpts a spiral on the front of the model and prints the measured times.
void stroke(Program& program, const char* what)
{
    ui::Viewport* viewport = program.window.viewport();
    Samples patch, clay, scene, rest, frame, latency, drawing;
    const auto frames = QObject::connect(viewport, &QOpenGLWidget::frameSwapped, viewport, [&] {
        const ui::ViewportStats& stats = viewport->stats();
        patch.values.push_back(stats.patchMs);
        clay.values.push_back(stats.drawMs);
        scene.values.push_back(stats.sceneMs);
        rest.values.push_back(stats.frameMs - stats.patchMs - stats.drawMs - stats.sceneMs);
        frame.values.push_back(stats.frameMs);
        latency.values.push_back(stats.latencyMs);
    });
    auto* drawings = program.window.findChild<app::DrawingWorker*>();
    QObject::connect(drawings, &app::DrawingWorker::drawn, viewport, [&] {
        if (drawings->latencyMs() > 0)
            drawing.values.push_back(drawings->latencyMs());
    });
    Absence absence;
    const QPoint middle = viewport->rect().center();
    const auto at = [&](int i) {
        const double turn = 0.25 * i, radius = 0.9 * i;
        return middle + QPoint(static_cast<int>(radius * std::cos(turn)), static_cast<int>(radius * std::sin(turn)));
    };
    QTest::mousePress(viewport, Qt::LeftButton, {}, at(0));
    for (int i = 1; i < moves; ++i) {
        QMouseEvent move(QEvent::MouseMove, at(i), viewport->mapToGlobal(at(i)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(viewport, &move);
        QTest::qWait(moveMs);
    }
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, at(moves));
    waitFor([&] { return program.document.queue().isSettled(); });
    QTest::qWait(500);
    QObject::disconnect(frames);
    QObject::disconnect(drawings, nullptr, viewport, nullptr);
    std::printf("           %-18s %3zu frames: patch %5.2f  scene %5.2f  clay %6.2f  blit %6.2f  whole %6.2f (worst "
                "%6.1f)   input to frame %5.1f"
                "   gui away %4.0f",
                what, frame.values.size(), patch.median(), scene.median(), clay.median(), rest.median(), frame.median(),
                frame.worst(), latency.median(), absence.worst());
    if (!drawing.values.empty())
        std::printf("   %zu drawings, behind %.0f, worst %.0f", drawing.values.size(), drawing.median(),
                    drawing.worst());
    std::printf("\n");
    std::fflush(stdout);
}

void measure(Program& program, core::Slot cuts, const QString& folder)
{
    core::TriangleMesh model = bench::geodesicSphere(cuts);
    for (core::Vec3f& point : model.points)
        point *= 50;
    const QString path = folder + QStringLiteral("/%1.ply").arg(cuts);
    core::writeMesh(path.toStdString(), model);
    open(program, path);
    program.window.brush()->setValue(core::Parameter::Radius, 4);
    stroke(program, "stroke");
    QAction* wireframe = program.window.action(QStringLiteral("view.wireframe"));
    wireframe->trigger();
    stroke(program, "with wireframe");
    wireframe->trigger();
    auto* preview = program.window.findChild<QDockWidget*>(QStringLiteral("previewPanel"));
    preview->show();
    QTest::qWait(2000); // waits for the first, fine drawing
    stroke(program, "with 2D preview");
    preview->hide();
}
} // namespace

int main(int argc, char* argv[])
{
    const QTemporaryDir folder;
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        qputenv(name, folder.path().toLocal8Bit());
    ui::prepareGraphics();
    QApplication application(argc, argv);
    Program program;
    program.document.opener().setDiscardPrompt([](const auto&) { return true; });
    program.window.resize(1280, 720);
    program.window.show();
    program.document.opener().openBall();
    waitFor([&] { return program.window.viewport()->stats().patches > 0; });
    std::printf("start to the first frame with clay: %.2f s\n", secondsSinceProcessStart());
    QStringList sizes = QApplication::arguments().mid(1);
    if (sizes.isEmpty())
        sizes = {QStringLiteral("10000"), QStringLiteral("100000"), QStringLiteral("1000000")};
    for (const QString& size : sizes)
        measure(program, static_cast<core::Slot>(std::lround(std::sqrt(size.toDouble() / 10))), folder.path());
    return 0;
}
