#pragma once

#include "headset_files.h"
#include "headset_port.h"

#include <QObject>

#include <deque>
#include <memory>
#include <optional>

namespace ui
{
class ColorPanel;
class MainWindow;
} // namespace ui

namespace app
{
class Document;

/// The gui thread's side of visits to the headset: tells how document and brush are, obeys wishes in their order, and hears where the person
/// is. Gui thread.
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

Q_SIGNALS:
    /// One sentence about what a wish came to, for those at the window.
    void noticed(const QString& sentence);
    /// Where the person is; nothing: gone.
    void seen(const std::optional<vr::Presence>& presence);

private:
    /// A wish that has to wait for its turn among the document's changes.
    struct Turn
    {
        std::shared_ptr<HeadsetPort> port;
        vr::Wish wish;
    };

    void hear();
    void takeBrush();
    void lookForFiles();
    void takeBusy();
    void tellSoon();
    Q_INVOKABLE void tell();
    QString folder() const;

    void takeMail();
    void obeyNext();
    void finish(const std::shared_ptr<HeadsetPort>& port);
    void refuse(const QString& sentence);
    void refuseTool();
    void obey(const vr::ChooseBrush& wish);
    void obey(const vr::HeadsetChoice& choice);
    void obey(const vr::Undo&);
    void obey(const vr::Redo&);
    void obey(const vr::RestoreModel&);
    void obey(const vr::SaveModel&);
    void obey(const vr::OpenModel& wish);
    void obey(const core::ChangeMask& change);

    Document* m_document;
    SculptWorker* m_worker;
    ui::MainWindow* m_window;
    ui::ColorPanel* m_colors;
    std::shared_ptr<HeadsetPort> m_port; ///< of the visit; null: there is none
    vr::DocumentNews m_news;             ///< what of it is not to be found elsewhere
    bool m_isChoosing = false;           ///< the headset's brush
    bool m_tellsSoon = false;
    std::deque<Turn> m_turns;
    bool m_isObeying = false; ///< one of them
    HeadsetFiles m_files;     ///< last
};
} // namespace app
