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

/// Has the whole model looked at whenever somebody wants to know, after it has rested for a moment: a copy is made by
/// the mesh thread, and a change of the model ends the looking. Gui thread. Must be gone after the worker has stopped:
/// a child of the document is.
class RestingModel : public QObject
{
    Q_OBJECT

public:
    RestingModel(Document* document, SculptWorker* worker);

    void setWanted(bool wanted);
    /// At once, if it is wanted, though it was stopped before.
    void askAgain();
    /// What is being done ends; nothing begins before the next change.
    void stop();

Q_SIGNALS:
    /// What was answered is of another model now.
    void outdated();

protected:
    /// On the mesh thread: hands the copy on to another one.
    virtual void look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) = 0;
    void setAnswered() { m_isAnswered = true; }
    /// First in the destructor of who looks.
    void end() { m_stop.request_stop(); }

private:
    void forget();
    void ask();

    Document* m_document;
    SculptWorker* m_worker;
    QTimer m_rest;
    bool m_isWanted = false;
    bool m_isAnswered = false;
    std::stop_source m_stop;
};
} // namespace app
