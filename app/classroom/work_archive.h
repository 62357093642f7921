#pragma once

#include "app/classroom/classroom_turn.h"

#include "core/geometry/triangle_mesh.h"
#include "core/io/document_metadata.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QHash>
#include <QString>

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
};

/// Where a turn's work went.
struct KeptWork
{
    QString folder;  ///< empty: nowhere
    QString problem; ///< then: one sentence
};

struct Delivery
{
    QHash<QString, QString> moved; ///< folders: where they were, and where they are
    int waiting = 0;               ///< that could not be moved
    QString problem;               ///< then: one sentence about the first
};

/// The works of a class: a folder for each turn, called after time and pupil, with model.glb, picture.png, record.json
/// and turn.json. A folder is there whole or not at all, after a power cut too. A work is kept on this computer first,
/// which is quick, and from there goes to the class's folder, which may be far away, full or gone. Any thread; never
/// throws.
class ClassArchive
{
    Q_DECLARE_TR_FUNCTIONS(app::ClassArchive)

public:
    /// Local paths. `waiting` is made if it is missing; `classFolder` is not: it may be a share that is not mounted
    /// just now.
    ClassArchive(QString classFolder, QString waiting)
        : m_classFolder(std::move(classFolder))
        , m_waiting(std::move(waiting))
    {}

    /// In the waiting folder, else, if that has no room, in the class's own.
    KeptWork keep(const TurnWork& work) const;
    /// All that waits goes to the class's folder; what cannot stays. A work that is there already is not doubled.
    Delivery deliver() const;
    /// Parts of works that a power cut left: in the waiting folder all, in the class's, where others may be writing,
    /// those of another day.
    void sweep() const;

    /// Of the turn with that id, whose work was kept in that folder: where it is now, since it may have been delivered.
    QString whereIs(const QString& folder, const QString& id) const;

    const QString& waiting() const { return m_waiting; }

    /// "2026-11-24-1015-Anna": letters, digits and signs of the nickname, nothing that means something to a file
    /// system.
    static QString folderName(const QDateTime& begun, const QString& pupil);

private:
    QString m_classFolder, m_waiting;
};
} // namespace app
