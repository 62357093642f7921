#pragma once

#include "app/worker/job_queue.h"

#include <QObject>

#include <atomic>

namespace app
{
/// Lets one source at a time sculpt, and posts its stroke to the mesh thread. Thread: any; returns at once.
class StrokeGate : public QObject
{
    Q_OBJECT

public:
    /// The queue is not owned.
    explicit StrokeGate(JobQueue* queue) : m_queue(queue) {}

    /// False, and refused() from here, if another source's stroke is open, or the gate is held. Each stroke that was
    /// begun is reported once by SculptWorker::strokeFinished(). A pull that may add a sphere (settings.add) does so
    /// by its first dab, where nothing is under the brush, and goes on as a pull. With settings.join only the first
    /// sample counts.
    bool beginStroke(Source source, const core::StrokeSettings& settings);
    void addSample(Source source, const core::StrokeSample& sample);
    void endStroke(Source source, core::StrokeEnd how = core::StrokeEnd::Kept);
    /// A stroke of one sample that adds a sphere at its position (settings.add) and does nothing else: where the brush
    /// would touch the surface it is refused as too close, or with settings.join becomes part of the model. As
    /// beginStroke().
    bool addSphere(Source source, const core::StrokeSettings& settings, const core::StrokeSample& sample);

    /// From now on strokes are refused: the mesh stays as it is except for jobs. False if a stroke is open.
    bool hold();
    void release();
    /// Ends the stroke that is open, and runs the task on the mesh thread before any other stroke.
    void pushAfterStroke(Task task);
    /// One more stroke, which the worker does itself.
    void countStroke() { ++m_begun; }

    bool isOpen() const;
    /// The number of strokes ever begun.
    quint64 begun() const { return m_begun; }

Q_SIGNALS:
    void refused(app::Source source);

private:
    bool begin(const BeginStroke& stroke);

    JobQueue* m_queue;
    std::atomic<quint64> m_begun = 0;
    mutable std::mutex m_mutex; ///< guards the next two
    std::optional<Source> m_openSource;
    bool m_isHeld = false;
};
} // namespace app
