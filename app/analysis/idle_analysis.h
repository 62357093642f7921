#pragma once

#include "core/geometry/triangle_mesh.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <stop_token>

namespace app
{
class Document;
class SculptWorker;

/// The surface as it was, and the slots that its points have.
struct ModelCopy
{
    core::TriangleMesh mesh;
    std::vector<core::Slot> slots;
};

/// Analyses the whole model while it is active, once the model has not changed for a moment. The mesh thread makes a
/// copy; a change of the model cancels the analysis. Must be destroyed after the worker has stopped, as a child of the
/// document is. Thread: gui.
class IdleAnalysis : public QObject
{
    Q_OBJECT

public:
    IdleAnalysis(Document* document, SculptWorker* worker);

    void setActive(bool active);
    /// Starts at once if it is active, even after stop().
    void runNow();
    /// Cancels the analysis; none starts before the next change.
    void stop();

Q_SIGNALS:
    /// The last result is of another model now.
    void outdated();

protected:
    /// Starts the analysis of the copy on another thread. Thread: mesh.
    virtual void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) = 0;
    void setFinished();
    /// To be called first in the destructor of a derived class.
    void cancel() { m_stop.request_stop(); }

private:
    bool isOfPresent() const;
    void invalidate();
    void run();

    Document* m_document;
    SculptWorker* m_worker;
    QTimer m_idleTimer;
    bool m_isActive = false;
    bool m_isFinished = false;
    int m_step = 0; ///< of the document's history, when it finished
    std::stop_source m_stop;
};
} // namespace app
