#pragma once

#include "app/classroom/class_works.h"
#include "app/classroom/classroom_turn.h"
#include "app/classroom/turn_answers.h"

#include "core/geometry/triangle_mesh.h"
#include "core/io/document_metadata.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QHash>
#include <QString>

#include <functional>
#include <memory>

namespace app
{
/// The data of a turn that are archived.
struct TurnWork
{
    QString id;      ///< unique id of the turn
    QString pupil;   ///< as typed by the pupil; may be empty
    QDateTime begun; ///< invalid: unknown
    QDateTime ended;
    int steps = 0; ///< number of steps in effect
    std::shared_ptr<const core::TriangleMesh> mesh = {};
    quint64 meshHash = 0;
    core::DocumentMetadata metadata = {};
    TurnRecord record = {}; ///< the steps in effect, without undone ones
    std::optional<LessonResult> lesson = {};
    std::optional<qint64> usedMs = {}; ///< time used without pauses; nothing: unknown
};

/// Result of archiving a turn's work.
struct ArchivedWork
{
    QString folder;  ///< the work's folder; empty: it was not archived
    QString problem; ///< one sentence; empty if the work was archived
};

struct Delivery
{
    QHash<QString, QString> moved; ///< original folders, and the folders where the works or their copies are now
    int undelivered = 0;           ///< number of works that could not be moved or copied
    QString problem;               ///< one sentence about the first undelivered work; empty if there is none
    bool isPaused = false;         ///< whether the delivery was interrupted
};

/// The archive of a class's work. Each turn has a folder named after time and pupil, with model.glb, picture.png,
/// record.json and turn.json, later also answers.json if the pupil answered questions. A folder is complete or absent,
/// even after a power cut. A work is first stored on this computer, which is fast, and then moved to the class's
/// folder, which may be remote, full or unreachable. Thread: any. Never throws.
class WorkArchive
{
    Q_DECLARE_TR_FUNCTIONS(app::WorkArchive)

public:
    /// Both are paths of this computer. `outbox` is created if it does not exist. `classFolder` is not, because it may
    /// be a network share that is not mounted.
    WorkArchive(QString classFolder, QString outbox)
        : m_classFolder(std::move(classFolder))
        , m_outbox(std::move(outbox))
    {}

    /// Adds the work to the outbox. If that fails, adds it to the class's folder.
    ArchivedWork add(const TurnWork& work) const;
    /// Moves all works from the outbox to the class's folder. Works that cannot be moved stay in the outbox. A work
    /// already in the class's folder is not added twice. `isPaused` is called before each work; if it returns true, the
    /// remaining works stay.
    Delivery deliver(const std::function<bool()>& isPaused = {}) const;
    /// Copies all works of the outbox to another folder. A work already in that folder is not added twice.
    Delivery copy(const QString& folder) const;
    /// Saves the answers with the work in `folder`, replacing earlier answers. Returns an empty string, or one sentence
    /// about the error. Precondition: the work is not being delivered.
    QString addAnswers(const QString& folder, const TurnAnswers& answers) const;
    /// Removes incomplete works left by a power cut: all of them in the outbox, but only those older than a day in the
    /// class's folder, where other computers may be writing.
    void removeUnfinished() const;

    /// Returns the present folder of the work with this turn id that was saved in `folder`: it may have been delivered.
    QString locate(const QString& folder, const QString& id) const;

    /// Returns the pupils with a work begun on this day, in the outbox or the class's folder.
    QStringList pupilsOf(const QDate& day) const;

    const QString& outbox() const { return m_outbox; }

    /// Returns the subfolders of a class's folder that contain a complete work, sorted by name.
    static QStringList worksIn(const QString& classFolder);
    /// Returns whether a folder contains a complete work.
    static bool isWork(const QString& folder);
    /// Returns the facts in the turn.json of a work's folder. Missing and unreadable values are empty.
    static TurnFacts turnOf(const QString& work);
    /// Returns the path of the model file in a work's folder.
    static QString modelOf(const QString& work);

    /// Returns a folder name such as "2026-11-24-1015-Anna", without characters of the nickname that are special in a
    /// file system.
    static QString folderName(const QDateTime& begun, const QString& pupil);

private:
    QString m_classFolder, m_outbox;
};
} // namespace app
