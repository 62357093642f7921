#pragma once

#include <QList>
#include <QString>

#include <filesystem>

namespace app
{
/// The works on this computer that are not yet delivered to one class's folder.
struct WaitingWorks
{
    QString outbox;
    QString folder; ///< the class's folder; empty: unknown
    int count = 0;
};

/// Local folders for a class's files until they are in the class's folder. That folder identifies the class: all class
/// files that name it, by whatever path, share the same local folders. Thread: gui.
struct ClassPaths
{
    std::filesystem::path journals;
    QString outbox;
    QString turnNote;

    /// Returns the folders of a class that begins. Undelivered works for the same class folder in other outboxes are
    /// moved to its outbox: older versions had an outbox for each class file, and a folder that does not exist is known
    /// only by one of its paths.
    static ClassPaths prepare(const QString& classFile, const QString& folder);
    /// Returns the undelivered works on this computer, for all classes.
    static QList<WaitingWorks> waiting();
};
} // namespace app
