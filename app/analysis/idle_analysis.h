#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <stop_token>

namespace app
{
class Document;
class SculptWorker;

/// A copy of parts of the model, with the slot of each point in the live mesh.
struct ModelCopy
{
    core::TriangleMesh mesh;
    std::vector<core::Slot> slots;
    core::Lattice lattice; ///< of the live mesh
};

/// The parts of the model that an analysis concerns.
enum class AnalysedParts {
    All,    ///< hidden ones, too
    Active, ///< the active part
    Visible ///< the parts that an export for print has; if all are hidden, all parts
};

/// Base of analyses that run when the model has not changed for 0.7 s, while the analysis is active. The mesh thread
/// makes a copy; changing the model cancels the analysis. Precondition: the worker has stopped before this is
/// destroyed; a child of the document satisfies this. Thread: gui.
class IdleAnalysis : public QObject
{
    Q_OBJECT

public:
    IdleAnalysis(Document* document, SculptWorker* worker, AnalysedParts parts);

    void setActive(bool active);
    /// Starts at once if the analysis is active, even after stop().
    void runNow();
    /// Cancels the analysis. The next one starts after the next change of the model.
    void stop();

Q_SIGNALS:
    /// Emitted when the last result no longer describes the present model.
    void outdated();

protected:
    /// Starts the analysis of the copy on another thread. Thread: mesh.
    virtual void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) = 0;
    void setFinished();
    Document& document() { return *m_document; }
    /// Cancels the analysis. Must be called first in the destructor of a derived class.
    void cancel() { m_stop.request_stop(); }

private:
    bool isOfPresent() const;
    void invalidate();
    void run();

    Document* m_document;
    SculptWorker* m_worker;
    AnalysedParts m_parts;
    core::PartId m_active = 0; ///< the active part when the analysis was last invalidated
    QTimer m_idleTimer;
    bool m_isActive = false;
    bool m_isFinished = false;
    int m_step = 0; ///< undo index of the document's history when the analysis finished
    std::stop_source m_stop;
};
} // namespace app
