#pragma once

#include "app/headset/headset_port.h"

#include <QObject>

#include <deque>
#include <memory>

namespace ui
{
class MainWindow;
}

namespace app
{
class Document;
class PartnerView;

/// Does what the user in the headset asks of the document and of the window, in the order in which it was asked.
/// Thread: gui.
class HeadsetRequests : public QObject
{
    Q_OBJECT

public:
    /// None is owned; all must outlive this.
    HeadsetRequests(Document* document, ui::MainWindow* window, PartnerView* partner);

    /// Requests that hold strokes of that port are done one at a time, among the document's changes; others at once.
    void enqueue(const std::shared_ptr<HeadsetPort>& port, std::deque<vr::DocumentRequest> requests);
    /// The brush is changed by the headset just now.
    bool isChoosing() const { return m_isChoosing; }

Q_SIGNALS:
    /// One sentence says why it was not done.
    void refused(const QString& sentence);
    /// The headset has to take the window's brush again.
    void brushRefused();

private:
    /// A request that has to wait for its turn among the document's changes.
    struct Turn
    {
        std::shared_ptr<HeadsetPort> port;
        vr::DocumentRequest request;
        bool isForbidden = false; ///< the window has taken over
    };

    bool isForbidden(const vr::DocumentRequest& request) const;
    void handleNext();
    void finish(const std::shared_ptr<HeadsetPort>& port);
    /// Emits refused() with that sentence if other work on the model goes on.
    bool isBusy(const QString& sentence);
    void handle(const vr::ChooseBrush& request);
    void handle(const vr::HeadsetSettings& settings);
    void handle(vr::LessonRequest request);
    void handle(const vr::Undo&);
    void handle(const vr::Redo&);
    void handle(const vr::RestoreModel&);
    void handle(const vr::SaveModel&);
    void handle(const vr::OpenModel& request);
    void handle(const core::MaskOperation& change);

    Document* m_document;
    ui::MainWindow* m_window;
    PartnerView* m_partner;
    std::deque<Turn> m_turns;
    bool m_isHandling = false; ///< one of them
    bool m_isChoosing = false;
};
} // namespace app
