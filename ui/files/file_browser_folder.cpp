// The folder that the panel shows: looking into it, what is there, what is done with it.

#include "ui/actions/actions.h"
#include "ui/files/file_browser.h"
#include "ui/files/file_grid.h"
#include "ui/files/file_list_model.h"
#include "ui/files/model_files.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/settings/settings.h"
#include "ui/util/format_filters.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QSlider>
#include <QToolButton>

namespace ui
{
void FileBrowser::askForFolder()
{
    ui::askForFolder(window(), m_options.folder, [this](const QString& folder) { goTo(folder); });
}

/// To the next one that is there: this one's own may be gone with it.
void FileBrowser::goUp()
{
    const QString from = m_options.folder;
    QString folder = QFileInfo(from).path();
    while (!QDir(folder).exists() && !QDir(folder).isRoot())
        folder = QFileInfo(folder).path();
    if (folder == from)
        return;
    goTo(folder);
    m_toSelect = {from};
}

void FileBrowser::goTo(const QString& folder)
{
    m_listing.request_stop();
    m_files->clear();
    m_options.folder = QDir::cleanPath(QDir(folder).absolutePath());
    m_problem.clear();
    m_toSelect.clear();
    m_isListed = m_isStopped = false;
    m_filter->clear();
    m_settings->set(m_options);
    requestThumbnails();
    list();
}

/// Not the folder.
void FileBrowser::setControls(const FileBrowserSettings& options)
{
    const QSignalBlocker quiet(m_size);
    m_order->setCurrentIndex(static_cast<int>(options.order));
    m_direction->setChecked(options.descending);
    m_size->setValue(options.picture);
    choose();
}

/// What the controls say.
void FileBrowser::choose()
{
    m_options.order = static_cast<FileOrder>(m_order->currentIndex());
    m_options.descending = m_direction->isChecked();
    m_direction->setIcon(themedIcon(m_options.descending ? QStringLiteral("sort-down") : QStringLiteral("sort-up")));
    m_sorter->order(m_options.order, m_options.descending);
    if (m_options.picture != m_size->value())
        m_grid->setPicture(m_size->value());
    m_options.picture = m_size->value();
    m_settings->set(m_options);
    m_thumbnailTimer.start();
}

void FileBrowser::list()
{
    m_place->setText(QDir::toNativeSeparators(m_options.folder));
    m_place->setCursorPosition(static_cast<int>(m_place->text().size()));
    if (!isVisible())
        return;
    m_listing.request_stop();
    m_listing = {};
    const std::stop_token stop = m_listing.get_token();
    m_disk.run([folder = m_options.folder, stop] { return FileJobs::list(folder, stop); },
               [this, stop](const FolderContent& content) {
                   if (!stop.stop_requested())
                       setFolderContent(content);
               });
}

void FileBrowser::setFolderContent(const FolderContent& content)
{
    if (content.folder != m_options.folder)
        return;
    m_isListed = true;
    m_problem = content.problem;
    m_files->setEntries(content.entries);
    if (!m_watcher.directories().contains(m_options.folder)) {
        if (const QStringList old = m_watcher.directories(); !old.isEmpty())
            m_watcher.removePaths(old);
        if (m_problem.isEmpty())
            m_watcher.addPath(m_options.folder);
    }
    select(m_toSelect);
    requestThumbnails();
}

void FileBrowser::select(const QStringList& paths)
{
    QItemSelection selection;
    QModelIndex first;
    for (const QString& path : paths)
        if (const QModelIndex index = m_sorter->mapFromSource(m_files->indexOf(path)); index.isValid()) {
            selection.select(index, index);
            first = first.isValid() ? first : index;
        }
    if (!first.isValid())
        return;
    m_toSelect.clear();
    m_grid->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    m_grid->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    m_grid->scrollTo(first);
}

void FileBrowser::change(const FileJob& job, const std::function<void(const FileOutcome&)>& done)
{
    m_disk.run(job, [this, done](const FileOutcome& outcome) {
        if (!outcome.sentence.isEmpty())
            Q_EMIT noticed(outcome.sentence);
        if (!outcome.paths.isEmpty())
            m_toSelect = outcome.paths;
        list();
        if (done)
            done(outcome);
    });
}

/// What is in sight first, then what nothing is known of.
void FileBrowser::requestThumbnails()
{
    m_thumbnailTimer.stop();
    QList<FileEntry> wanted;
    if (isVisible() && !m_isStopped) {
        for (const QModelIndex& index : m_grid->visibleRows())
            if (const QModelIndex file = m_sorter->mapToSource(index); m_files->lacksPicture(file))
                wanted << m_files->entry(file);
        const QSet<FileEntry> inSight(wanted.begin(), wanted.end());
        for (int row = 0; row < m_sorter->rowCount(); ++row)
            if (const QModelIndex file = m_sorter->mapToSource(m_sorter->index(row, 0));
                m_files->isUnknown(file) && !inSight.contains(m_files->entry(file)))
                wanted << m_files->entry(file);
    }
    if (!m_maker && !wanted.isEmpty()) {
        m_maker = std::make_unique<ThumbnailMaker>();
        connect(m_maker.get(), &ThumbnailMaker::made, this, &FileBrowser::setThumbnail);
    }
    if (m_maker)
        m_maker->request(wanted);
    showState();
}

void FileBrowser::setThumbnail(const FileEntry& file, const Thumbnail& thumbnail)
{
    m_files->setThumbnail(file, thumbnail);
    if (!thumbnail.problem.isEmpty())
        m_listTimer.start(); // it may be gone
    showState();
}

/// How many there are and how far the pictures are; in an empty grid the reason.
void FileBrowser::showState()
{
    int models = 0, unknown = 0;
    for (int row = 0; row < m_files->rowCount(); ++row) {
        const QModelIndex index = m_files->index(row);
        models += m_files->entry(index).isFolder ? 0 : 1;
        unknown += m_files->isUnknown(index) ? 1 : 0;
    }
    const bool isWorking = unknown > 0 && !m_isStopped;
    m_stop->setVisible(isWorking);
    m_state->setText(isWorking ? tr("%L1 of %L2 read").arg(models - unknown).arg(models)
                               : tr("%Ln models", nullptr, models));
    const bool isEmpty = m_sorter->rowCount() == 0;
    m_empty->setVisible(isEmpty);
    if (isEmpty)
        m_empty->setText(!m_problem.isEmpty()       ? m_problem
                         : !m_isListed              ? QString()
                         : m_files->rowCount() == 0 ? tr("No models lie here (%1).").arg(modelFormats())
                                                    : tr("No name here has %1 in it.").arg(m_filter->text().trimmed()));
}

QStringList FileBrowser::chosenFiles() const
{
    QStringList paths;
    for (const QModelIndex& index : m_grid->selectionModel()->selectedIndexes())
        if (const FileEntry& file = m_files->entry(m_sorter->mapToSource(index)); !file.isFolder)
            paths << file.path;
    return paths;
}

void FileBrowser::enable()
{
    const QModelIndex current = isVisible() ? m_grid->currentIndex() : QModelIndex();
    const bool isFile = current.isValid() && !m_files->entry(m_sorter->mapToSource(current)).isFolder;
    const bool areFiles = isVisible() && !chosenFiles().isEmpty();
    m_open->setEnabled(current.isValid());
    m_rename->setEnabled(isFile);
    m_duplicate->setEnabled(areFiles);
    m_trash->setEnabled(areFiles);
    m_reveal->setEnabled(current.isValid());
    m_up->setEnabled(isVisible());
    m_chooseFolder->setEnabled(isVisible());
}

void FileBrowser::activate(const QModelIndex& index)
{
    if (!index.isValid())
        return;
    const FileEntry file = m_files->entry(m_sorter->mapToSource(index));
    if (file.isFolder)
        goTo(file.path);
    else
        Q_EMIT openRequested(file.path);
}

void FileBrowser::focusGrid()
{
    m_grid->setFocus();
}

/// Files that others wrote meanwhile are of another date: the watcher tells of names only.
bool FileBrowser::event(QEvent* event)
{
    if (event->type() == QEvent::WindowActivate)
        m_listTimer.start();
    return QWidget::event(event);
}

void FileBrowser::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_isStopped = false;
    list();
    enable();
}

void FileBrowser::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_listing.request_stop();
    requestThumbnails();
    enable();
}

void addFileBrowser(const FileBrowserContext& context, Settings* settings, const Actions& actions,
                    const std::function<void(const QString&)>& notice)
{
    auto* panel = new FileBrowser(settings, actions);
    auto* dock = new QDockWidget(FileBrowser::tr("Files"));
    dock->setObjectName(QStringLiteral("filesPanel"));
    dock->setWidget(panel);
    context.window->addDockWidget(Qt::LeftDockWidgetArea, dock);
    dock->hide();
    context.toggles->addAction(dock->toggleViewAction());
    QObject::connect(panel, &FileBrowser::openRequested, context.opener, &ModelFiles::openRequested);
    QObject::connect(panel, &FileBrowser::renamed, context.opener, &ModelFiles::setRenamed);
    QObject::connect(panel, &FileBrowser::trashed, context.opener, &ModelFiles::checkFile);
    QObject::connect(panel, &FileBrowser::noticed, dock, notice);
    QObject::connect(actions.get(QStringLiteral("file.browse")), &QAction::triggered, dock, [dock, panel] {
        dock->show();
        dock->raise();
        panel->focusGrid();
    });
}
} // namespace ui
