#pragma once

#include "app/headset/headset_files.h"
#include "app/headset/headset_port.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <deque>
#include <memory>
#include <optional>

namespace ui
{
class ColorPanel;
class LessonPanel;
class MainWindow;
} // namespace ui

namespace app
{
class Document;

/// The gui thread's side of visits to the headset: sends the state of document and brush, handles requests in their
/// order, and receives where the user is. Thread: gui.
class HeadsetController : public QObject
{
    Q_OBJECT

public:
    struct Program
    {
        Document* document;
        SculptWorker* worker;
        ui::MainWindow* window;
    };

    /// None is owned. Document and worker must outlive the controller; the window may be just going.
    explicit HeadsetController(const Program& program, QObject* parent = nullptr);
    /// As close().
    ~HeadsetController() override;

    /// A visit begins: its document, with the model as it is.
    std::shared_ptr<HeadsetPort> open();
    /// The headset's thread has ended, or is abandoned. Strokes and requests made before are still done.
    void close();

    /// To be read in the headset.
    void showNotice(const QString& sentence);
    /// Where somebody at the window points; nothing: nowhere.
    void point(const std::optional<core::SurfaceHit>& place);
    /// The window alone changes the model, until it gives back or the visit ends. A stroke of the headset that is open
    /// ends as it is.
    void setTakenOver(bool isTakenOver);

Q_SIGNALS:
    /// One sentence about the outcome of a request, for those at the window.
    void noticed(const QString& sentence);
    /// The user in the headset moved; none: gone.
    void avatarChanged(const std::optional<vr::AvatarState>& avatar);

private:
    /// A request that has to wait for its turn among the document's changes.
    struct Turn
    {
        std::shared_ptr<HeadsetPort> port;
        vr::DocumentRequest request;
        bool isForbidden = false; ///< the window has taken over
    };

    void connectAll();
    void onBrushChanged();
    void updateFolder();
    void onBusyChanged();
    void scheduleUpdate();
    void sendUpdate();
    QString folder() const;

    void connectPartner();
    void beginPartner();
    void checkRadius();
    void announceChoice();
    void announceHistory(const QString& sentence);
    void onLessonChanged();
    bool isForbidden(const vr::DocumentRequest& request) const;
    void rejectRequest();

    void takeMessages();
    void handleNext();
    void finish(const std::shared_ptr<HeadsetPort>& port);
    void refuse(const QString& sentence);
    void refuseTool();
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
    SculptWorker* m_worker;
    ui::MainWindow* m_window;
    ui::ColorPanel* m_colors;
    std::shared_ptr<HeadsetPort> m_port; ///< of the visit; null: there is none
    vr::DocumentUpdate m_update;         ///< the part that is not found elsewhere
    bool m_isChoosing = false;           ///< the headset's brush
    QPointer<ui::LessonPanel> m_lessons;
    bool m_isTakenOver = false;
    core::StrokeSettings m_knownBrush; ///< of which the person in the headset knows
    QString m_undoText, m_redoText;    ///< as it was told: what is undone just now is still among them
    quint64 m_radiusModel = 0;         ///< whose share the next is
    double m_radiusShare = 0;          ///< of the window's brush, as it was told
    bool m_isRadiusNew = false;
    bool m_isStepNew = false;  ///< of a lesson, which has tools of its own
    double m_avatarRadius = 0; ///< mm; 0: not known
    QTimer m_choiceTimer;      ///< runs while the window's choice may still go on
    bool m_isUpdateScheduled = false;
    std::deque<Turn> m_turns;
    bool m_isHandling = false; ///< one of them
    HeadsetFiles m_files;      ///< last
};
} // namespace app
