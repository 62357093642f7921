#pragma once

#include "app/classroom/work_archive.h"

#include "ui/util/background_thread.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <functional>
#include <optional>

namespace ui
{
class ClassBar;
}

namespace app
{
class Document;

/// A turn whose work is kept.
struct EndedTurn
{
    ClassTurn turn;
    QString folder; ///< of its work
    TurnRecord record;
};

/// The work of turns on its way from the document to the class's folder. Thread: gui; files are written on others, and
/// answers on one of their own, because a delivery to a slow folder may take minutes.
class ClassWork : public QObject
{
    Q_OBJECT

public:
    /// None is owned; all must outlive this.
    ClassWork(Document* document, ui::ClassBar* bar, WorkArchive archive);

    const WorkArchive& archive() const { return m_archive; }
    /// Removes what a power cut left, and delivers what waits.
    void begin();
    /// `problem` is empty if the work is safe.
    using Done = std::function<void(const EndedTurn& ended, const QString& problem)>;
    /// Keeps the model as the turn's work, and then delivers it, unless `done` has it held. `before`: what was done
    /// before the document's history begins. False: other work on the model goes on, and nothing is done.
    bool save(const QString& what, const ClassTurn& turn, const TurnRecord& before, Done done);
    /// Delivers what waits, now and again until nothing waits. Delivers nothing while works are held. `then` is called
    /// when it was tried.
    void deliver(const std::function<void()>& then = {});
    /// Copies what waits to another folder.
    void copyWaiting(const QString& folder, const std::function<void(const Delivery& copied)>& done);
    /// Works that could not be delivered, and why: the first one's sentence.
    int undelivered() const { return m_undelivered; }
    const QString& problem() const { return m_problem; }
    /// Works stay on this computer until they are not held any more; then they are delivered, with the answers that
    /// were given by then.
    void setHeld(bool isHeld);
    /// Keeps the answers with the turn's work, in the place of those that were there. Precondition: works are held.
    void keepAnswers(const EndedTurn& ended, const ui::Questionnaire& answers);

    /// The turn before, while it can be resumed.
    const std::optional<EndedTurn>& ended() const { return m_ended; }
    void setEnded(const EndedTurn& ended) { m_ended = ended; }
    void forgetEnded() { m_ended.reset(); }

Q_SIGNALS:
    void noticed(const QString& sentence);
    /// Emitted after each delivery, with those who have a work of today.
    void pupilsFound(const QStringList& pupils);

private:
    void setPaused(bool isSaving, bool isHeld);
    void onDelivered(const Delivery& delivery);

    Document* m_document;
    ui::ClassBar* m_bar;
    WorkArchive m_archive;
    std::optional<EndedTurn> m_ended;
    int m_undelivered = 0;
    QString m_problem;
    bool m_isHeld = false, m_isSaving = false;
    std::atomic<bool> m_isPaused = false; ///< either; read by the delivery before each work
    QTimer m_retryTimer;
    ui::BackgroundThread m_answering;  ///< before the next, which waits for it
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
