#include "ui/files/model_files.h"

#include "ui/actions/actions.h"
#include "ui/files/export_dialog.h"
#include "ui/files/file_jobs.h"
#include "ui/model/model_dialogs.h"
#include "ui/scene/reference_image.h"
#include "ui/settings/model_info.h"
#include "ui/settings/settings.h"
#include "ui/util/format_filters.h"
#include "ui/widgets/file_dialogs.h"

#include <QAction>
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr std::pair<const char*, core::Starter> starterIds[] = {
    {"new.ball", core::Starter::Ball},    {"new.cube", core::Starter::Cube}, {"new.torus", core::Starter::Torus},
    {"new.slab", core::Starter::Slab},    {"new.vase", core::Starter::Vase}, {"new.head", core::Starter::Head},
    {"new.tablet", core::Starter::Tablet}};

/// Returns the path of the first dragged local file; empty if there is none.
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

void ModelFiles::refuseDrops()
{
    m_refusesDrops = true;
    m_window->setAcceptDrops(false);
}

void ModelFiles::addMenus(QMenu* fileMenu, const Actions& actions)
{
    auto* starters = new QMenu(actions.menuTitle(MenuId::New), fileMenu);
    actions.fill(starters, MenuId::New);
    fileMenu->insertMenu(actions.get(QStringLiteral("file.open")), starters);
    for (const auto& [id, starter] : starterIds)
        connect(actions.get(QLatin1StringView(id)), &QAction::triggered, this,
                [this, starter] { Q_EMIT starterRequested(starter); });

    m_recent = new QMenu(tr("Open &Recent"), fileMenu);
    m_recent->setObjectName(QStringLiteral("recentMenu"));
    m_recent->setToolTipsVisible(true);
    m_revert = actions.get(QStringLiteral("file.revert"));
    fileMenu->insertMenu(m_revert, m_recent);
    const auto on = [&](const char* id, const auto& what) {
        connect(actions.get(QLatin1StringView(id)), &QAction::triggered, this, what);
    };
    on("file.open", [this] { open(); });
    on("file.revert", [this] { Q_EMIT openRequested(m_path); });
    on("file.save", [this] { save(); });
    on("file.saveAs", [this] { saveAs(m_settings->lastFolder(), m_name); });
    on("file.saveCopy", [this] { saveCopy(); });
    on("file.exportAs", [this] { exportAs(m_settings->lastFolder(), m_name); });
    on("file.report", [this] { report(); });
    on("model.insert", [this] { insert(); });
    showRecent();
}

void ModelFiles::showRecent()
{
    m_recent->clear();
    const QStringList paths = m_settings->recentFiles();
    for (const QString& path : paths) {
        const QFileInfo file(path);
        QAction* entry = m_recent->addAction(QString(file.fileName()).replace(QLatin1Char('&'), QStringLiteral("&&")));
        entry->setToolTip(QDir::toNativeSeparators(path));
        connect(entry, &QAction::triggered, this, [this, path] { Q_EMIT openRequested(path); });
    }
    if (!paths.isEmpty()) {
        m_recent->addSeparator();
        const auto clear = [this] {
            m_settings->set(&Setting::recentFiles, {});
            showRecent(); // deletes this action, hence the queued connection
        };
        connect(m_recent->addAction(tr("&Clear This List")), &QAction::triggered, this, clear, Qt::QueuedConnection);
    }
    m_recent->setEnabled(!m_recent->isEmpty());
    m_revert->setEnabled(!m_path.isEmpty());
}

void ModelFiles::setOpened(const ModelInfo& model)
{
    m_name = model.name;
    m_path = model.path;
    m_file = FileJobs::entryOf(m_path);
    m_isFileDeleted = m_formatNoticeShown = false;
    m_afterSave = nullptr;
    if (const QString& file = m_path.isEmpty() ? model.source : m_path; !file.isEmpty()) {
        remember(file);
        m_settings->addRecentFile(QFileInfo(file).absoluteFilePath());
    }
    showRecent();
}

void ModelFiles::open()
{
    askForModel(m_window, ModelUse::Open, m_settings->lastFolder(),
                [this](const QString& path) { Q_EMIT openRequested(path); });
}

void ModelFiles::insert()
{
    askForModel(m_window, ModelUse::Insert, m_settings->lastFolder(), [this](const QString& path) {
        remember(path);
        askForPlace(m_window, path, [this](const InsertRequest& insertion) { Q_EMIT insertRequested(insertion); });
    });
}

void ModelFiles::save()
{
    m_afterSave = nullptr; // drops the continuation of an earlier question that was not answered
    if (m_path.isEmpty() || !isWritten(m_path))
        return saveAs(m_settings->lastFolder(), m_name);
    checkFile();
    if (m_isFileDeleted || FileJobs::entryOf(m_path) == m_file)
        Q_EMIT saveRequested(m_path);
    else
        askToOverwrite();
}

/// Asks before overwriting a file that another program has changed since it was read or written here.
void ModelFiles::askToOverwrite()
{
    const QString name = QFileInfo(m_path).fileName();
    auto* box = new QMessageBox(QMessageBox::Question, tr("The file was changed"),
                                tr("Another program has changed %1 since it was read or written here.").arg(name),
                                QMessageBox::Cancel, m_window);
    box->setObjectName(QStringLiteral("overwriteQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    const QPushButton* overwrite = box->addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
    QPushButton* other = box->addButton(tr("Save &As…"), QMessageBox::AcceptRole);
    box->setDefaultButton(other);
    connect(box, &QMessageBox::buttonClicked, this, [this, overwrite, other](const QAbstractButton* button) {
        const auto proceed = std::exchange(m_afterSave, nullptr);
        if (button == overwrite)
            Q_EMIT saveRequested(m_path);
        else if (button == other)
            saveAs(m_settings->lastFolder(), m_name);
        else
            return;
        m_afterSave = proceed;
    });
    box->open();
}

void ModelFiles::checkFile()
{
    const bool isGone = !m_path.isEmpty() && !QFileInfo::exists(m_path);
    if (std::exchange(m_isFileDeleted, isGone) || !isGone)
        return;
    Q_EMIT fileDeleted();
    Q_EMIT noticed(tr("%1 was deleted or moved. Save to write it again.").arg(QDir::toNativeSeparators(m_path)));
}

void ModelFiles::setRenamed(const QString& from, const QString& to)
{
    QStringList recent = m_settings->recentFiles();
    for (QString& path : recent)
        path = path == from ? to : path;
    recent.removeDuplicates();
    m_settings->set(&Setting::recentFiles, recent);
    if (QFileInfo(m_path).absoluteFilePath() == from) {
        m_path = m_file.path = to;
        m_name = QFileInfo(to).fileName();
        Q_EMIT renamed(to);
    }
    showRecent();
}

void ModelFiles::setExported(const QString& path)
{
    remember(path);
    if (QFileInfo(path) == QFileInfo(m_path))
        m_file = FileJobs::entryOf(m_path);
}

void ModelFiles::saveAs(const QString& folder, const QString& name)
{
    m_afterSave = nullptr;
    askForSaving(m_window, folder, name, [this](const QString& path) { Q_EMIT saveRequested(path); });
}

void ModelFiles::saveElsewhere(const QString& path)
{
    const QFileInfo file(path);
    saveAs(file.path(), file.fileName());
}

void ModelFiles::saveCopy()
{
    if (m_path.isEmpty() || !isWritten(m_path))
        return saveAs(m_settings->lastFolder(), m_name);
    Q_EMIT exportRequested(FileJobs::numberedCopyOf(m_path));
}

void ModelFiles::exportAs(const QString& folder, const QString& name)
{
    askForExport(m_window, folder, name, writtenEndings(),
                 [this](const QString& path) { Q_EMIT exportRequested(path); });
}

void ModelFiles::exportElsewhere(const QString& path)
{
    const QFileInfo file(path);
    exportAs(file.path(), file.fileName());
}

/// Asks for the folder of models and for the report's file; the file dialog begins in the same folder.
void ModelFiles::report()
{
    askForFolder(m_window, m_settings->lastFolder(), [this](const QString& folder) {
        m_settings->set(&Setting::lastFolder, folder);
        askForReport(m_window, folder, reportEndings(),
                     [this, folder](const QString& path) { Q_EMIT reportRequested(folder, path); });
    });
}

void ModelFiles::exportFor(const ModelInfo& model)
{
    const auto askOverlap = [this](const auto& answer) { Q_EMIT overlapAsked(answer); };
    askForExportChoice(m_window, {model, m_settings, askOverlap}, [this](const ExportSettings& options) {
        const QString ending =
            QLatin1StringView(std::ranges::find(exportUses, options.use, &Named<ExportUse>::value)->key);
        askForExport(m_window, m_settings->lastFolder(), m_name, {ending},
                     [this, options](const QString& path) { Q_EMIT exportRequested(path, options); });
    });
}

bool ModelFiles::askToDiscard(const std::function<void()>& proceed)
{
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("Save changes to %1?").arg(m_name),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box.setObjectName(QStringLiteral("discardQuestion"));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) {
        save();
        m_afterSave = proceed;
    }
    if (answer == QMessageBox::Cancel)
        Q_EMIT discardDeclined();
    return answer == QMessageBox::Discard;
}

void ModelFiles::setSaved(const ModelInfo& model)
{
    const auto proceed = std::exchange(m_afterSave, nullptr);
    const bool wasDeleted = m_isFileDeleted && m_path == model.path;
    const bool wasFormatNoticeShown = m_formatNoticeShown;
    setOpened(model);
    m_formatNoticeShown = true;
    if (wasDeleted)
        Q_EMIT noticed(tr("%1 had been deleted or moved and was written again.").arg(QDir::toNativeSeparators(m_path)));
    else if (!wasFormatNoticeShown && !isDocumentFormat(m_path))
        Q_EMIT noticed(tr("Saved %1. Only GLB files keep view, brush, symmetry and reference images: use Save As.")
                           .arg(QFileInfo(m_path).fileName()));
    if (proceed)
        proceed();
}

/// Handles a drop after the event has been delivered, so that the program the file is dragged from does not wait for
/// our questions.
bool ModelFiles::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::WindowActivate)
        checkFile();
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto* drop = static_cast<QDropEvent*>(event);
    if (m_refusesDrops) {
        drop->ignore();
        return true;
    }
    const QString path = droppedFile(drop->mimeData());
    if (path.isEmpty())
        return true;
    drop->acceptProposedAction();
    if (event->type() == QEvent::Drop)
        QMetaObject::invokeMethod(
            this, [this, path] { openDropped(path); }, Qt::QueuedConnection);
    return true;
}

void ModelFiles::openDropped(const QString& path)
{
    if (isNamedLikePicture(path))
        Q_EMIT pictureDropped(path);
    else
        Q_EMIT openRequested(path);
}

void ModelFiles::remember(const QString& path)
{
    m_settings->set(&Setting::lastFolder, QFileInfo(path).absolutePath());
}
} // namespace ui
