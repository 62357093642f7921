#pragma once

#include "tests/vr/simulator/scripted_runtime.h"

#include "vr/frame/headset_thread.h"

#include <QImage>
#include <QOpenGLContext>
#include <QPointer>
#include <QTemporaryDir>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>

/// What a frame was to a client.
struct SeenFrame
{
    vr::Wands wands;
    std::optional<vr::Pose> head;
    std::int64_t displayNs = 0;
    bool hasFocus = false;
    bool roomMoved = false;
};

/// Fills each eye with a colour and notes all that it is told.
class RecordingClient : public vr::FrameClient
{
public:
    bool create(QOpenGLContext& context) override;
    vr::FrameOutput frame(const vr::FrameInput& input) override;
    void draw(std::size_t eye, const vr::EyeImage& image, const vr::EyeView& view) override;
    void idle() override { ++idleCalls; }
    double drawCallMs() const override { return m_clock.milliseconds(); }
    void destroy() override;

    /// Given back with the next frame.
    void answer(const vr::FrameOutput& output);
    SeenFrame last() const;
    std::vector<vr::EyeImage> images() const; ///< by eye, of the last frame; none if it was not drawn
    std::vector<vr::EyeView> views() const;   ///< the same

    static QColor linear(std::size_t eye);                                  ///< what it is filled with
    static double depth(std::size_t eye) { return eye == 0 ? 0.25 : 0.75; } ///< the same, where it is wanted

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

/// The scripted runtime behind Khronos' validation layer, with a folder for what they write. Words are written with '
/// in place of ".
class ScriptedHeadset
{
public:
    ScriptedHeadset();

    /// Without the layer, as long as that lives.
    [[nodiscard]] std::shared_ptr<void> withoutLayer() const;

    /// Begins anew.
    void load(const char* script);
    void step(const char* step);
    bool frames(int count);
    QJsonObject report() const { return m_runtime.report(); }
    int calls(const char* name) const;
    /// What the runtime and the layer found wrong with us.
    QString complaints() const;
    /// The picture of a frame that was kept; null if there is none.
    QImage picture(int session, int frame, const char* eye) const;

private:
    QTemporaryDir m_folder;
    ScriptedRuntime m_runtime;
};

/// A thread with a client, and what it has reported.
class Visitor
{
public:
    explicit Visitor(ScriptedHeadset& headset,
                     std::chrono::milliseconds exitTimeout = vr::RuntimeThread::responseTimeout);
    ~Visitor(); ///< the runtime then gives frames freely and answers, so that a test that has failed comes to an end

    bool enter();
    bool enterAndRun();
    /// Waits for the end.
    bool leave();
    bool waitForEnd();
    bool waitFor(vr::HeadsetStage stage);

    std::shared_ptr<RecordingClient> client = std::make_shared<RecordingClient>();
    QList<vr::HeadsetReport> reports;
    vr::HeadsetThread thread;

private:
    ScriptedHeadset& m_headset;
};
