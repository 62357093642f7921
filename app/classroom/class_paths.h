#pragma once

#include <QList>
#include <QString>

#include <filesystem>

namespace app
{
/// The works that wait on this computer for one class's folder.
struct WaitingWorks
{
    QString outbox;
    QString folder; ///< of the class; empty: nobody knows
    int count = 0;
};

/// Places where this computer keeps a class's files until they are in the class's folder. A class is known by that
/// folder: all files of classes that name it, in whatever way, have the same places. Thread: gui.
struct ClassPaths
{
    std::filesystem::path journals;
    QString outbox;
    QString turnNote;

    /// Returns those of a class that begins, and brings to its outbox what waits for its folder in others: older
    /// versions had one for each class file, and a folder that is not there is only known by one of its names.
    static ClassPaths prepare(const QString& classFile, const QString& folder);
    /// Returns what waits on this computer, of all classes.
    static QList<WaitingWorks> waiting();
};
} // namespace app
