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
/// What a turn leaves.
struct TurnWork
{
    QString id;      ///< no other turn has it
    QString pupil;   ///< as it was typed; may be empty
    QDateTime begun; ///< invalid: nobody knows
    QDateTime ended;
    int steps = 0; ///< that are done
    std::shared_ptr<const core::TriangleMesh> mesh;
    quint64 meshHash = 0;
    core::DocumentMetadata metadata;
    TurnRecord record; ///< step by step, without what was undone
    std::optional<LessonResult> lesson = {};
    std::optional<qint64> usedMs = {}; ///< without pauses; nothing: nobody knows
};

/// The place where a turn's work was archived.
struct ArchivedWork
{
    QString folder;  ///< empty: nowhere
    QString problem; ///< then: one sentence
};

struct Delivery
{
    QHash<QString, QString> moved; ///< folders: where they were, and where they or their copies are
    int undelivered = 0;           ///< that could not be moved or copied
    QString problem;               ///< then: one sentence about the first
    bool isPaused = false;         ///< before it was through
};

/// The works of a class: a folder for each turn, called after time and pupil, with model.glb, picture.png, record.json
/// and turn.json; if the pupil answered questions, answers.json comes afterwards. A folder is there whole or not at
/// all, after a power cut too. A work is kept on this computer first, which is quick, and from there goes to the
/// class's folder, which may be far away, full or gone. Any thread; never throws.
class WorkArchive
{
    Q_DECLARE_TR_FUNCTIONS(app::WorkArchive)

public:
    /// Local paths. `outbox` is made if it is missing; `classFolder` is not: it may be a share that is not mounted
    /// just now.
    WorkArchive(QString classFolder, QString outbox)
        : m_classFolder(std::move(classFolder))
        , m_outbox(std::move(outbox))
    {}

    /// Adds the work to the outbox or, if that has no room, to the class's folder.
    ArchivedWork add(const TurnWork& work) const;
    /// Moves all works from the outbox to the class's folder; those that cannot be moved stay. A work that is there
    /// already is not added twice. `isPaused`: asked before each work; true: the rest stays.
    Delivery deliver(const std::function<bool()>& isPaused = {}) const;
    /// Copies all works of the outbox to another folder. A work that is there already is not added twice.
    Delivery copy(const QString& folder) const;
    /// Adds the answers to a work that was kept in that folder, in the place of those that are there. Returns an empty
    /// text, or a sentence that says what is wrong. Precondition: this work is not being delivered.
    QString addAnswers(const QString& folder, const TurnAnswers& answers) const;
    /// Removes parts of works that a power cut left: all of them in the outbox; in the class's folder, where others may
    /// be writing, those older than a day.
    void removeUnfinished() const;

    /// Of the turn with that id, whose work was kept in that folder: where it is now, since it may have been delivered.
    QString locate(const QString& folder, const QString& id) const;

    /// Returns the pupils who have a work that was begun on that day, here or in the class's folder.
    QStringList pupilsOf(const QDate& day) const;

    const QString& outbox() const { return m_outbox; }

    /// Returns the folders in a class's folder that hold a whole work, by name.
    static QStringList worksIn(const QString& classFolder);
    /// Returns whether a folder holds a whole work.
    static bool isWork(const QString& folder);
    /// Returns what a work's folder says about its turn.
    static TurnFacts turnOf(const QString& work);
    /// Returns the path of the model's file in a work's folder.
    static QString modelOf(const QString& work);

    /// "2026-11-24-1015-Anna": letters, digits and signs of the nickname, nothing that means something to a file
    /// system.
    static QString folderName(const QDateTime& begun, const QString& pupil);

private:
    QString m_classFolder, m_outbox;
};
} // namespace app
