#include "model_files.h"

#include "file_dialogs.h"
#include "model_dialogs.h"
#include "settings.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

#include <utility>

namespace ui
{
namespace
{
/// The first local file that is being dragged, or nothing.
QString droppedFile(const QMimeData* data)
{
    for (const QUrl& url : data->urls())
        if (url.isLocalFile())
            return url.toLocalFile();
    return {};
}
} // namespace

ModelFiles::ModelFiles(Settings* settings, QWidget* window) : m_settings(settings), m_window(window)
{
    window->setAcceptDrops(true);
    window->installEventFilter(this);
}

void ModelFiles::open()
{
    askForModel(m_window, ModelUse::Open, m_settings->lastFolder(), [this](const QString& path) {
        remember(path);
        Q_EMIT openRequested(path);
    });
}

void ModelFiles::insert()
{
    askForModel(m_window, ModelUse::Insert, m_settings->lastFolder(), [this](const QString& path) {
        remember(path);
        askForPlace(m_window, QFileInfo(path).fileName(), [this, path](const core::ModelCommand& command) {
            Q_EMIT insertRequested(path, std::get<core::Insert>(command));
        });
    });
}

void ModelFiles::exportAs(const QString& name)
{
    m_afterExport = nullptr; // an earlier question was not answered to the end
    askForExport(m_window, m_settings->lastFolder(), name, [this](const QString& path) {
        remember(path);
        Q_EMIT exportRequested(path);
    });
}

bool ModelFiles::askToDiscard(const QString& name, const std::function<void()>& goOn)
{
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("%1 has changes that were not exported.").arg(name),
                    QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box.setObjectName(QStringLiteral("discardQuestion"));
    const QPushButton* exporting = box.addButton(tr("&Export…"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    const bool isDiscarded = box.exec() == QMessageBox::Discard;
    if (box.clickedButton() == exporting) {
        exportAs(name);
        m_afterExport = goOn;
    }
    return isDiscarded;
}

void ModelFiles::finishExport()
{
    if (const auto goOn = std::exchange(m_afterExport, nullptr))
        goOn();
}

/// What is dropped is asked for after the event, so that whoever dragged need not wait for our questions.
bool ModelFiles::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto* drop = static_cast<QDropEvent*>(event);
    if (!mayDrop(drop->mimeData()))
        return true;
    drop->acceptProposedAction();
    if (event->type() == QEvent::Drop)
        QMetaObject::invokeMethod(
            this, [this, path = droppedFile(drop->mimeData())] { Q_EMIT openRequested(path); }, Qt::QueuedConnection);
    return true;
}

bool ModelFiles::mayDrop(const QMimeData* data) const
{
    return !m_isBusy && !droppedFile(data).isEmpty();
}

void ModelFiles::remember(const QString& path)
{
    m_settings->setLastFolder(QFileInfo(path).absolutePath());
}
} // namespace ui
