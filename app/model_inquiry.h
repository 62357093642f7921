#pragma once

#include "core/mesh_check.h"
#include "ui/side_thread.h"

#include <QObject>
#include <QTimer>

#include <stop_token>

namespace app
{
class Document;
class SculptWorker;

/// Measures and judges the whole model whenever somebody wants to know, after it has rested for a moment: a copy, made by the mesh thread, is
/// judged on a thread aside, and a change of the model ends that. Gui thread. Must be gone after the worker has stopped: a child of the document is.
class ModelInquiry : public QObject
{
    Q_OBJECT

public:
    ModelInquiry(Document* document, SculptWorker* worker);
    ~ModelInquiry() override;

    void setWanted(bool wanted);

Q_SIGNALS:
    /// What was answered is of another model now.
    void outdated();
    void answered(const core::MeshReport& report);

private:
    void forget();
    void ask();
    void take(const core::MeshReport& report, const std::stop_token& stop);

    Document* m_document;
    SculptWorker* m_worker;
    QTimer m_rest;
    bool m_isWanted = false;
    bool m_isAnswered = false;
    std::stop_source m_stop;
    ui::SideThread m_aside; ///< last
};
} // namespace app
