// Each class has a subfolder of one root, named after the first known path of the class's folder. Its file folders.json
// lists all known paths of the class's folder.

#include "app/classroom/class_paths.h"

#include "app/classroom/work_archive.h"
#include "app/recovery/recovery_store.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>

namespace app
{
namespace
{
constexpr int keyLength = 16; ///< number of hexadecimal digits of the hash that identifies a class

QDir classesRoot()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                QStringLiteral("/fettle/classes"));
}

QString keyOf(const QString& path)
{
    const QByteArray hash = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha256);
    return QString::fromLatin1(hash.toHex().left(keyLength));
}

std::filesystem::path journalsOf(const QString& key)
{
    return RecoveryStore::defaultRoot().parent_path() / "class-journals" / key.toStdString();
}

QString outboxOf(const QString& key)
{
    return classesRoot().filePath(key + QStringLiteral("/waiting"));
}

QString foldersFile(const QString& key)
{
    return classesRoot().filePath(key + QStringLiteral("/folders.json"));
}

/// Returns the known paths of the class's folder; empty: an older version identified the class by its file.
QStringList foldersOf(const QString& key)
{
    QStringList folders;
    QFile file(foldersFile(key));
    if (file.open(QIODevice::ReadOnly))
        for (const QJsonValue& folder : QJsonDocument::fromJson(file.readAll()).array())
            folders << folder.toString();
    return folders;
}

/// Adds paths to the known paths of a class. If the file cannot be written, the class is later found only by its other
/// paths.
void addFolders(const QString& key, const QStringList& folders)
{
    const QStringList known = foldersOf(key);
    QStringList all = folders + known;
    all.removeDuplicates();
    if (all == known)
        return;
    classesRoot().mkpath(key);
    QSaveFile file(foldersFile(key));
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(QJsonDocument(QJsonArray::fromStringList(all)).toJson());
    file.commit();
}

/// Returns the path as written in the class file and, if the folder exists, its path without links.
QStringList pathsOf(const QString& folder)
{
    QStringList paths{QDir::cleanPath(folder), QFileInfo(folder).canonicalFilePath()};
    paths.removeAll(QString());
    paths.removeDuplicates();
    return paths;
}

/// Returns the keys of the classes that have this folder. Classes with journals come first, because only the first
/// one's journals are read.
QStringList classesWith(const QStringList& folders, const QString& classFile)
{
    QStringList keys;
    const QString ofOlderVersion = keyOf(QFileInfo(classFile).canonicalFilePath());
    for (const QString& key : classesRoot().entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        const QStringList known = foldersOf(key);
        const bool isSame = std::ranges::any_of(known, [&](const QString& path) { return folders.contains(path); });
        if (isSame || (known.isEmpty() && key == ofOlderVersion))
            keys << key;
    }
    std::ranges::stable_partition(keys, [](const QString& key) {
        std::error_code none;
        return !std::filesystem::is_empty(journalsOf(key), none) && !none;
    });
    return keys;
}
} // namespace

ClassPaths ClassPaths::prepare(const QString& classFile, const QString& folder)
{
    const QStringList paths = pathsOf(folder), classes = classesWith(paths, classFile);
    const QString key = classes.value(0, keyOf(paths.constLast()));
    addFolders(key, paths);
    const ClassPaths found{journalsOf(key), outboxOf(key), classesRoot().filePath(key + QStringLiteral("/turn.json"))};
    for (const QString& other : classes)
        if (other != key && !WorkArchive::worksIn(outboxOf(other)).isEmpty() && QDir().mkpath(found.outbox))
            WorkArchive(found.outbox, outboxOf(other)).deliver();
    return found;
}

QList<WaitingWorks> ClassPaths::waiting()
{
    QList<WaitingWorks> all;
    for (const QString& key : classesRoot().entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
        if (const qsizetype count = WorkArchive::worksIn(outboxOf(key)).size(); count > 0)
            all << WaitingWorks{outboxOf(key), foldersOf(key).value(0), static_cast<int>(count)};
    return all;
}
} // namespace app
