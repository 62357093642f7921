#include "ui/files/file_browser.h"

#include "ui/actions/actions.h"
#include "ui/files/file_grid.h"
#include "ui/files/file_item_delegate.h"
#include "ui/files/file_list_model.h"
#include "ui/files/model_files.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/settings/settings.h"
#include "ui/util/format_filters.h"
#include "ui/util/reveal_file.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_button.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QSlider>
#include <QToolButton>

#include <utility>

namespace ui
{
namespace
{
constexpr int listDelayMs = 200, thumbnailDelayMs = 30; ///< delays that merge several changes into one update

QHBoxLayout* row(std::initializer_list<QWidget*> widgets)
{
    auto* layout = new QHBoxLayout;
    layout->setSpacing(gap / 2);
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
    return layout;
}
} // namespace

FileBrowser::FileBrowser(Settings* settings, const Actions& actions, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_actions(actions)
    , m_options(settings->files())
    , m_files(new FileListModel(this))
    , m_sorter(new FileSorter(m_files))
{
    buildGrid();
    QVBoxLayout* column = panelLayout(this);
    column->addLayout(buildFolderLine());
    column->addLayout(buildChoices());
    column->addWidget(m_grid, 1);
    column->addLayout(buildFoot());
    buildActions();

    for (const auto& [timer, delay] :
         {std::pair(&m_listTimer, listDelayMs), std::pair(&m_thumbnailTimer, thumbnailDelayMs)}) {
        timer->setSingleShot(true);
        timer->setInterval(delay);
    }
    connect(&m_listTimer, &QTimer::timeout, this, &FileBrowser::list);
    connect(&m_thumbnailTimer, &QTimer::timeout, this, &FileBrowser::requestThumbnails);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_listTimer, qOverload<>(&QTimer::start));
    connect(m_files, &FileListModel::pictureMissed, &m_thumbnailTimer, qOverload<>(&QTimer::start));
    connect(m_files, &FileListModel::renameRequested, this, &FileBrowser::renameTo);
    settings->onReset([this] { setControls(m_settings->files()); });
    setControls(m_options);
    enable();
}

FileBrowser::~FileBrowser()
{
    m_listing.request_stop();
}

void FileBrowser::buildGrid()
{
    m_grid = named(new FileGrid, "files.grid", {}, tr("Models in this folder"));
    m_grid->setModel(m_sorter);
    m_grid->setCells(new FileItemDelegate(m_files, m_sorter, m_grid));
    m_grid->setPicture(m_options.pictureSize);
    m_empty = named(new QLabel, "files.empty");
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setTextFormat(Qt::PlainText);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* over = new QVBoxLayout(m_grid->viewport());
    over->addWidget(m_empty);
    connect(m_grid, &QListView::doubleClicked, this, &FileBrowser::activate);
    connect(m_grid, &FileGrid::moved, &m_thumbnailTimer, qOverload<>(&QTimer::start));
    connect(m_grid->selectionModel(), &QItemSelectionModel::selectionChanged, this, &FileBrowser::enable);
    connect(m_grid->selectionModel(), &QItemSelectionModel::currentChanged, this, &FileBrowser::enable);
}

QLayout* FileBrowser::buildFolderLine()
{
    m_place = named(new QLineEdit, "files.folder", tr("The folder that is shown; type another and press Return."),
                    tr("Folder"));
    connect(m_place, &QLineEdit::returnPressed, this, [this] {
        goTo(QDir::fromNativeSeparators(m_place->text().trimmed()));
        focusGrid();
    });
    return row({m_place, panelButton(m_actions.get(QStringLiteral("files.choose"))),
                panelButton(m_actions.get(QStringLiteral("files.up")))});
}

QLayout* FileBrowser::buildChoices()
{
    m_filter =
        named(new QLineEdit, "files.filter", tr("Shows only files whose names contain these letters."), tr("Filter"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& part) {
        m_sorter->filter(part);
        showState();
        m_thumbnailTimer.start();
    });
    m_order = named(new QComboBox, "files.order", tr("How the files are sorted; folders come first."), tr("Sorted by"));
    m_order->addItems({tr("Name"), tr("Size"), tr("Date"), tr("Vertices")});
    m_direction = panelButton(QStringLiteral("files.direction"), QStringLiteral("sort-up"), tr("Descending"),
                              tr("Turns the order round."));
    m_direction->setCheckable(true);
    connect(m_order, &QComboBox::activated, this, &FileBrowser::choose);
    connect(m_direction, &QToolButton::clicked, this, &FileBrowser::choose);
    QHBoxLayout* choices = row({m_filter, m_order, m_direction});
    choices->setStretch(0, 1);
    return choices;
}

QLayout* FileBrowser::buildFoot()
{
    m_state = named(new QLabel, "files.state");
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_stop = panelButton(QStringLiteral("files.stop"), QStringLiteral("stop"), tr("Stop"),
                         tr("Stops making pictures of this folder."));
    QSizePolicy keepsItsPlace = m_stop->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_stop->setSizePolicy(keepsItsPlace);
    connect(m_stop, &QToolButton::clicked, this, [this] {
        m_isStopped = true;
        requestThumbnails();
    });
    m_size = named(new QSlider(Qt::Horizontal), "files.size", tr("Size of the pictures."), tr("Size of the pictures"));
    m_size->setRange(minPictureSize, maxPictureSize);
    m_size->setSingleStep(gap);
    m_size->setPageStep(4 * gap);
    m_size->setMaximumWidth(80);
    connect(m_size, &QSlider::valueChanged, this, &FileBrowser::choose);
    QHBoxLayout* foot = row({m_state, m_stop, m_size});
    foot->setStretch(0, 1);
    return foot;
}

void FileBrowser::buildActions()
{
    m_open = on("files.open", [this] { activate(m_grid->currentIndex()); });
    m_rename = on("files.rename", [this] { // focuses the grid, because the command may come from elsewhere
        m_grid->setFocus();
        m_grid->scrollTo(m_grid->currentIndex());
        m_grid->edit(m_grid->currentIndex());
    });
    m_duplicate =
        on("files.duplicate", [this] { change([paths = chosenFiles()] { return FileJobs::duplicate(paths); }); });
    m_trash = on("files.trash", [this] {
        change([paths = chosenFiles()] { return FileJobs::trash(paths); },
               [this](const FileOutcome&) { Q_EMIT trashed(); });
    });
    m_reveal = on("files.reveal", [this] {
        const QString path = m_files->entry(m_sorter->mapToSource(m_grid->currentIndex())).path;
        revealFile(path, this, [this](const QString& word) { Q_EMIT noticed(word); });
    });
    m_up = on("files.up", [this] { // to the nearest existing parent, because the folder's own parent may be deleted too
        const QString from = m_options.folder;
        QString folder = QFileInfo(from).path();
        while (!QDir(folder).exists() && !QDir(folder).isRoot())
            folder = QFileInfo(folder).path();
        if (folder == from)
            return;
        goTo(folder);
        m_toSelect = {from};
    });
    m_chooseFolder = on("files.choose", [this] {
        askForFolder(window(), m_options.folder, [this](const QString& folder) { goTo(folder); });
    });
    connect(m_grid, &QListView::customContextMenuRequested, this, &FileBrowser::showMenu);
}

QAction* FileBrowser::on(const char* id, const std::function<void()>& what)
{
    QAction* action = m_actions.get(QLatin1StringView(id));
    connect(action, &QAction::triggered, this, what);
    m_grid->addAction(action);
    return action;
}

void FileBrowser::showMenu(QPoint at)
{
    auto* menu = named(new QMenu(this), "files.menu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    m_actions.fill(menu, MenuId::Files);
    menu->popup(m_grid->viewport()->mapToGlobal(at));
}

void FileBrowser::renameTo(const QString& path, const QString& name)
{
    const auto report = [this, path](const FileOutcome& outcome) {
        if (!outcome.paths.isEmpty() && outcome.paths.constFirst() != path)
            Q_EMIT renamed(path, outcome.paths.constFirst());
    };
    change([=] { return FileJobs::rename(path, name); }, report);
}

// --- the folder: listing, showing and changing its content

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

/// Sets the controls to the options. The folder is not changed.
void FileBrowser::setControls(const FileBrowserSettings& options)
{
    const QSignalBlocker quiet(m_size);
    m_order->setCurrentIndex(static_cast<int>(options.order));
    m_direction->setChecked(options.descending);
    m_size->setValue(options.pictureSize);
    choose();
}

/// Updates the options from the controls.
void FileBrowser::choose()
{
    m_options.order = static_cast<FileOrder>(m_order->currentIndex());
    m_options.descending = m_direction->isChecked();
    m_direction->setIcon(themedIcon(m_options.descending ? QStringLiteral("sort-down") : QStringLiteral("sort-up")));
    m_sorter->order(m_options.order, m_options.descending);
    if (m_options.pictureSize != m_size->value())
        m_grid->setPicture(m_size->value());
    m_options.pictureSize = m_size->value();
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

/// Requests thumbnails: first of the visible files that lack one, then of all other files that have not been read.
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
        m_listTimer.start(); // the file may have been deleted
    showState();
}

/// Shows the number of models and of pictures made so far, or why the grid is empty.
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
                         : m_files->rowCount() == 0 ? tr("No models in this folder (%1).").arg(modelFormats())
                                                    : tr("No file name contains %1.").arg(m_filter->text().trimmed()));
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

void FileBrowser::followModel()
{
    const QString folder = m_settings->lastFolder();
    if (std::exchange(m_modelFolder, folder) != folder && !isVisible())
        goTo(folder);
}

void FileBrowser::focusGrid()
{
    m_grid->setFocus();
}

/// Lists the folder again when the window is activated, because the watcher reports changed names but not changed
/// dates.
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
    auto* dock = named(new QDockWidget(FileBrowser::tr("Files")), "filesPanel");
    dock->setWidget(panel);
    context.window->addDockWidget(Qt::LeftDockWidgetArea, dock);
    context.toggles->addAction(dock->toggleViewAction());
    QObject::connect(panel, &FileBrowser::openRequested, context.opener, &ModelFiles::openRequested);
    QObject::connect(panel, &FileBrowser::renamed, context.opener, &ModelFiles::setRenamed);
    QObject::connect(panel, &FileBrowser::trashed, context.opener, &ModelFiles::checkFile);
    QObject::connect(panel, &FileBrowser::noticed, dock, notice);
    const QAction* browse = actions.get(QStringLiteral("file.browse"));
    dock->hide();
    QObject::connect(browse, &QAction::triggered, panel, [dock, panel] {
        panel->followModel();
        dock->show();
        panel->focusGrid();
    });
}
} // namespace ui
