#pragma once

#include "tests/vr/simulator/scripted_runtime.h"

#include "vr/frame/headset_thread.h"
#include "vr/util/draw_call_timer.h"

#include <QImage>
#include <QOpenGLContext>
#include <QPointer>
#include <QTemporaryDir>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>

/// The inputs of a frame as the client received them.
struct SeenFrame
{
    vr::Wands wands;
    std::optional<vr::Pose> head;
    std::int64_t displayNs = 0;
    bool hasFocus = false;
    bool roomMoved = false;
    bool offersPassthrough = false;
    std::array<std::optional<vr::HandJoints>, vr::sideCount> joints;
};

/// A client that fills each eye with a colour and records its calls.
class RecordingClient : public vr::FrameClient
{
public:
    bool create(QOpenGLContext& context) override;
    vr::FrameOutput frame(const vr::FrameInput& input) override;
    void draw(std::size_t eye, const vr::EyeImage& image, const vr::EyeView& view) override;
    void idle() override { ++idleCalls; }
    double drawCallMs() const override { return m_clock.milliseconds(); }
    void destroy() override;

    /// Sets the output that the next frame returns.
    void answer(const vr::FrameOutput& output);
    SeenFrame last() const;
    std::vector<vr::EyeImage> images() const; ///< images of the last frame, by eye; empty if it was not drawn
    std::vector<vr::EyeView> views() const;   ///< views of the last frame, by eye; empty if it was not drawn

    /// linear colour that the eye is filled with
    static QColor linear(std::size_t eye);
    /// depth that the eye is filled with, if depth is requested
    static double depth(std::size_t eye) { return eye == 0 ? 0.25 : 0.75; }

    std::atomic<bool> canDraw = true;
    std::atomic<int> creates = 0, destroys = 0, frames = 0, draws = 0, idleCalls = 0, moves = 0, glErrors = 0;
    QPointer<QOpenGLContext> context;
    std::thread::id thread;

private:
    mutable std::mutex m_mutex;
    vr::FrameOutput m_answer;
    SeenFrame m_last;
    std::vector<vr::EyeImage> m_images;
    std::vector<vr::EyeView> m_views;
    unsigned int m_framebuffer = 0;
    vr::DrawCallTimer m_clock;
};

/// The scripted runtime behind Khronos' validation layer, with a folder for their output. Scripts are written with '
/// instead of ".
class ScriptedHeadset
{
public:
    ScriptedHeadset();

    /// Turns the layer off while the returned object exists.
    [[nodiscard]] std::shared_ptr<void> withoutLayer() const;

    /// Loads a script and restarts the runtime with it.
    void load(const char* script);
    void step(const char* step);
    bool frames(int count);
    QJsonObject report() const { return m_runtime.report(); }
    int calls(const char* name) const;
    /// Returns the errors that the runtime and the layer found in the client.
    QString complaints() const;
    /// Returns the image of a frame that was kept; null if there is none.
    QImage picture(int session, int frame, const char* eye) const;

private:
    QTemporaryDir m_folder;
    ScriptedRuntime m_runtime;
};

/// A HeadsetThread with a client, and the reports that it has sent.
class Visitor
{
public:
    explicit Visitor(ScriptedHeadset& headset,
                     std::chrono::milliseconds exitTimeout = vr::RuntimeThread::responseTimeout);
    ~Visitor(); ///< makes the runtime deliver frames freely and answer calls, so that a failed test ends

    bool enter();
    bool enterAndRun();
    /// Leaves and waits for the end of the visit.
    bool leave();
    bool waitForEnd();
    bool waitFor(vr::HeadsetStage stage);

    std::shared_ptr<RecordingClient> client = std::make_shared<RecordingClient>();
    QList<vr::HeadsetReport> reports;
    vr::HeadsetThread thread;

private:
    ScriptedHeadset& m_headset;
};
