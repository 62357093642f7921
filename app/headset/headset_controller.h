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

/// The gui thread's side of visits to the headset: tells how document and brush are, obeys wishes in their order, and
/// hears where the person is. Gui thread.
class HeadsetDesk : public QObject
{
    Q_OBJECT

public:
    struct Program
    {
        Document* document;
        SculptWorker* worker;
        ui::MainWindow* window;
    };

    /// None is owned. Document and worker must outlive the desk; the window may be just going.
    explicit HeadsetDesk(const Program& program, QObject* parent = nullptr);
    /// As close().
    ~HeadsetDesk() override;

    /// A visit begins: its document, with the model as it is.
    std::shared_ptr<HeadsetPort> open();
    /// The headset's thread has ended, or is not heard any more. What was drawn and wished for is done all the same.
    void close();

    /// To be read in the headset.
    void tellNotice(const QString& sentence);
    /// Where somebody at the window points; nothing: nowhere.
    void point(const std::optional<core::SurfaceHit>& place);
    /// The window alone changes the model, until it gives back or the visit ends. A stroke of the headset that is open
    /// ends as it is.
    void setTakenOver(bool isTakenOver);

Q_SIGNALS:
    /// One sentence about what a wish came to, for those at the window.
    void noticed(const QString& sentence);
    /// Where the person is; nothing: gone.
    void seen(const std::optional<vr::AvatarState>& presence);

private:
    /// A wish that has to wait for its turn among the document's changes.
    struct Turn
    {
        std::shared_ptr<HeadsetPort> port;
        vr::DocumentRequest wish;
        bool isForbidden = false; ///< the window has taken over
    };

    void hear();
    void takeBrush();
    void lookForFiles();
    void takeBusy();
    void tellSoon();
    Q_INVOKABLE void tell();
    QString folder() const;

    void hearPartner();
    void beginPartner();
    void takeRadius();
    void tellChoice();
    void tellHistory(const QString& sentence);
    void takeLesson();
    bool isForbidden(const vr::DocumentRequest& wish) const;
    void forbid();

    void takeMail();
    void obeyNext();
    void finish(const std::shared_ptr<HeadsetPort>& port);
    void refuse(const QString& sentence);
    void refuseTool();
    void obey(const vr::ChooseBrush& wish);
    void obey(const vr::HeadsetSettings& choice);
    void obey(vr::LessonRequest wish);
    void obey(const vr::Undo&);
    void obey(const vr::Redo&);
    void obey(const vr::RestoreModel&);
    void obey(const vr::SaveModel&);
    void obey(const vr::OpenModel& wish);
    void obey(const core::MaskOperation& change);

    Document* m_document;
    SculptWorker* m_worker;
    ui::MainWindow* m_window;
    ui::ColorPanel* m_colors;
    std::shared_ptr<HeadsetPort> m_port; ///< of the visit; null: there is none
    vr::DocumentUpdate m_news;           ///< what of it is not to be found elsewhere
    bool m_isChoosing = false;           ///< the headset's brush
    QPointer<ui::LessonPanel> m_lessons;
    bool m_isTakenOver = false;
    core::StrokeSettings m_toldBrush; ///< of which the person in the headset knows
    QString m_undoText, m_redoText;   ///< as it was told: what is undone just now is still among them
    quint64 m_radiusModel = 0;        ///< whose share the next is
    double m_radiusShare = 0;         ///< of the window's brush, as it was told
    bool m_isRadiusNew = false;
    bool m_isStepNew = false;  ///< of a lesson, which has tools of its own
    double m_wearerRadius = 0; ///< mm; 0: not known
    QTimer m_choice;           ///< runs while the window's choice may still go on
    bool m_tellsSoon = false;
    std::deque<Turn> m_turns;
    bool m_isObeying = false; ///< one of them
    HeadsetFiles m_files;     ///< last
};
} // namespace app
