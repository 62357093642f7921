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

/// A turn whose work is saved.
struct EndedTurn
{
    ClassTurn turn;
    QString folder; ///< folder of the turn's work
    TurnRecord record;
};

/// Brings the works of turns from the document to the class's folder. Thread: gui; files are written on a background
/// thread. Answers have a thread of their own, because delivery to a slow folder may take minutes.
class ClassWork : public QObject
{
    Q_OBJECT

public:
    /// Owns none of the arguments; all must outlive this.
    ClassWork(Document* document, ui::ClassBar* bar, WorkArchive archive);

    const WorkArchive& archive() const { return m_archive; }
    /// Removes incomplete works left by a power cut, and delivers the undelivered ones.
    void begin();
    /// A callback for the end of saving. `problem`: one sentence; empty if the work is safe.
    using Done = std::function<void(const EndedTurn& ended, const QString& problem)>;
    /// Saves the model as the turn's work and calls `done`, then delivers the work unless `done` has called
    /// setHeld(true). `before`: steps made before the document's history begins. Returns false and does not save if
    /// another job is running on the model.
    bool save(const QString& what, const ClassTurn& turn, const TurnRecord& before, Done done);
    /// Delivers undelivered works, and retries until all are delivered. Does nothing while works are held. Calls `then`
    /// after the first attempt.
    void deliver(const std::function<void()>& then = {});
    /// Copies the undelivered works to another folder.
    void copyWaiting(const QString& folder, const std::function<void(const Delivery& copied)>& done);
    /// Returns the number of works that could not be delivered; problem() says why for the first one.
    int undelivered() const { return m_undelivered; }
    const QString& problem() const { return m_problem; }
    /// Holds works on this computer. When they are no longer held, they are delivered with the answers given by then.
    void setHeld(bool isHeld);
    /// Saves the answers with the turn's work and replaces earlier answers. Precondition: works are held.
    void keepAnswers(const EndedTurn& ended, const ui::Questionnaire& answers);

    /// Returns the previous turn, while it can be resumed.
    const std::optional<EndedTurn>& ended() const { return m_ended; }
    void setEnded(const EndedTurn& ended) { m_ended = ended; }
    void forgetEnded() { m_ended.reset(); }

Q_SIGNALS:
    void noticed(const QString& sentence);
    /// Emitted after each delivery, with the pupils who have a work begun today.
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
    std::atomic<bool> m_isPaused = false; ///< m_isHeld or m_isSaving; read by the delivery before each work
    QTimer m_retryTimer;
    ui::BackgroundThread m_answering;  ///< before m_background, whose jobs wait for this thread
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
