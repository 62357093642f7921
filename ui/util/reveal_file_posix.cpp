#include "ui/util/reveal_file.h"

#include <QCoreApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

namespace ui
{
namespace
{
struct RevealFile
{
    Q_DECLARE_TR_FUNCTIONS(ui::RevealFile)
};

void showFolder(const QString& path, const std::function<void(const QString&)>& refused)
{
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        refused(RevealFile::tr("No file manager was found; the file is in %1.").arg(QDir::toNativeSeparators(folder)));
}
} // namespace

void revealFile(const QString& path, QObject* context, const std::function<void(const QString&)>& refused)
{
    QDBusMessage call = QDBusMessage::createMethodCall(
        QStringLiteral("org.freedesktop.FileManager1"), QStringLiteral("/org/freedesktop/FileManager1"),
        QStringLiteral("org.freedesktop.FileManager1"), QStringLiteral("ShowItems"));
    call << QStringList{QUrl::fromLocalFile(path).toString()} << QString();
    auto* watcher = new QDBusPendingCallWatcher(QDBusConnection::sessionBus().asyncCall(call), context);
    QObject::connect(watcher, &QDBusPendingCallWatcher::finished, context, [=] {
        if (watcher->isError())
            showFolder(path, refused);
        watcher->deleteLater();
    });
}
} // namespace ui
