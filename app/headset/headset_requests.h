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

/// Carries out the requests of the headset user for document and window, in the order in which they were made. Thread:
/// gui.
class HeadsetRequests : public QObject
{
    Q_OBJECT

public:
    /// Owns none of the arguments; all must outlive this.
    HeadsetRequests(Document* document, ui::MainWindow* window, PartnerView* partner);

    /// Handles requests. Those that hold strokes of the port are handled one at a time, in the document's queue; all
    /// others are handled at once.
    void enqueue(const std::shared_ptr<HeadsetPort>& port, std::deque<vr::DocumentRequest> requests);
    /// Returns whether a brush chosen in the headset is being set in the window at the moment.
    bool isChoosing() const { return m_isChoosing; }

Q_SIGNALS:
    /// Emitted with one sentence why a request was not carried out.
    void refused(const QString& sentence);
    /// Emitted when a tool chosen in the headset is refused: the headset must return to the window's brush.
    void brushRefused();

private:
    /// A request that waits in the document's queue.
    struct Turn
    {
        std::shared_ptr<HeadsetPort> port;
        vr::DocumentRequest request;
        bool isForbidden = false; ///< the request is refused: isForbidden() was true when it was enqueued
    };

    bool isForbidden(const vr::DocumentRequest& request) const;
    bool isPreviewing() const;
    void answerInPreview(const vr::DocumentRequest& request);
    void handleNext();
    void finish(const Turn& turn);
    /// Returns whether another job is running on the model; emits refused(sentence) if so.
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
    void handle(const vr::ActivatePart& request);
    void handle(const vr::PickPart& request);
    void handle(const vr::IsolatePart&);
    void handle(const vr::ChangePart& request);
    void handle(const vr::PreviewParts& request);
    void handle(const vr::PreviewInstead& request);
    void handle(const vr::EndPreview& request);
    bool isBusyForParts();

    Document* m_document;
    ui::MainWindow* m_window;
    PartnerView* m_partner;
    std::deque<Turn> m_turns;
    bool m_isHandling = false; ///< whether one of the requests is being handled
    int m_previews = 0;        ///< number of vr::PreviewParts that are not finished
    bool m_isChoosing = false;
};
} // namespace app
