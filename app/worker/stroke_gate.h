#pragma once

#include "app/worker/job_queue.h"

#include <QObject>

#include <atomic>

namespace app
{
/// Lets one source at a time sculpt, and posts its stroke to the mesh thread. Thread: any; all functions return at
/// once.
class StrokeGate : public QObject
{
    Q_OBJECT

public:
    /// The queue is not owned.
    explicit StrokeGate(JobQueue* queue) : m_queue(queue) {}

    /// Begins a stroke. Returns false and emits refused() on the calling thread if another source's stroke is open or
    /// the gate is held. Each stroke that begins is reported once by SculptWorker::strokeFinished().
    /// A pull with settings.add adds a sphere by its first dab if nothing is under the brush, and continues as a pull.
    /// With settings.join only the first sample counts.
    bool beginStroke(Source source, const core::StrokeSettings& settings);
    void addSample(Source source, const core::StrokeSample& sample);
    void endStroke(Source source, core::StrokeEnd how = core::StrokeEnd::Kept);
    /// Posts a stroke of one sample that only adds a sphere at its position (settings.add). If the brush would touch
    /// the surface, the sphere is refused as too close, or with settings.join becomes part of the model. Returns false
    /// and emits refused() under the same conditions as beginStroke().
    bool addSphere(Source source, const core::StrokeSettings& settings, const core::StrokeSample& sample);

    /// Refuses strokes until release(), so that only jobs change the mesh. Returns false if a stroke is open.
    bool hold();
    void release();
    /// Ends the open stroke, if there is one, and runs the task on the mesh thread before any other stroke.
    void pushAfterStroke(Task task);
    /// Counts a stroke that the worker begins itself.
    void countStroke() { ++m_begun; }

    bool isOpen() const;
    /// Returns the number of strokes begun so far.
    quint64 begun() const { return m_begun; }

Q_SIGNALS:
    void refused(app::Source source);

private:
    bool begin(const BeginStroke& stroke);

    JobQueue* m_queue;
    std::atomic<quint64> m_begun = 0;
    mutable std::mutex m_mutex; ///< guards m_openSource and m_isHeld
    std::optional<Source> m_openSource;
    bool m_isHeld = false;
};
} // namespace app
