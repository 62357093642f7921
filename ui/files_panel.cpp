#include "files_panel.h"

#include "file_grid.h"
#include "file_item_delegate.h"
#include "file_list_model.h"
#include "reveal_file.h"
#include "settings.h"
#include "panel_button.h"
#include "thumbnail_maker.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QToolButton>

namespace ui
{
namespace
{
constexpr int gap = 8; ///< of the window's spacing grid
constexpr int listDelayMs = 200, wantDelayMs = 30; ///< what comes at once is done once

QHBoxLayout* row(std::initializer_list<QWidget*> widgets)
{
    auto* layout = new QHBoxLayout;
    layout->setSpacing(gap / 2);
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
    return layout;
}
} // namespace

FilesPanel::FilesPanel(Settings* settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_choice(settings->files())
    , m_files(new FileListModel(this))
    , m_sorter(new FileSorter(m_files))
{
    m_disk.setMaxThreadCount(1);
    buildGrid();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap, gap, gap, gap);
    column->setSpacing(gap);
    column->addLayout(buildFolderLine());
    column->addLayout(buildChoices());
    column->addWidget(m_grid, 1);
    column->addLayout(buildFoot());
    buildActions();

    for (const auto& [timer, delay] : {std::pair(&m_listSoon, listDelayMs), std::pair(&m_wantSoon, wantDelayMs)}) {
        timer->setSingleShot(true);
        timer->setInterval(delay);
    }
    connect(&m_listSoon, &QTimer::timeout, this, &FilesPanel::list);
    connect(&m_wantSoon, &QTimer::timeout, this, &FilesPanel::wantThumbnails);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_listSoon, qOverload<>(&QTimer::start));
    connect(m_files, &FileListModel::pictureMissed, &m_wantSoon, qOverload<>(&QTimer::start));
    connect(m_files, &FileListModel::renameRequested, this,
            [this](const QString& path, const QString& name) { change([=] { return FileJobs::rename(path, name); }); });
    settings->onReset([this] { setControls(m_settings->files()); });
    setControls(m_choice);
    enable();
}

FilesPanel::~FilesPanel()
{
    m_listing.request_stop();
    m_disk.waitForDone();
}

void FilesPanel::buildGrid()
{
    m_grid = new FileGrid;
    m_grid->setObjectName(QStringLiteral("files.grid"));
    m_grid->setAccessibleName(tr("Models in this folder"));
    m_grid->setModel(m_sorter);
    m_grid->setCells(new FileItemDelegate(m_files, m_sorter, m_grid));
    m_grid->setPicture(m_choice.picture);
    m_empty = new QLabel;
    m_empty->setObjectName(QStringLiteral("files.empty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setTextFormat(Qt::PlainText);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* over = new QVBoxLayout(m_grid->viewport());
    over->addWidget(m_empty);
    connect(m_grid, &QListView::doubleClicked, this, &FilesPanel::activate);
    connect(m_grid, &FileGrid::moved, &m_wantSoon, qOverload<>(&QTimer::start));
    connect(m_grid->selectionModel(), &QItemSelectionModel::selectionChanged, this, &FilesPanel::enable);
    connect(m_grid->selectionModel(), &QItemSelectionModel::currentChanged, this, &FilesPanel::enable);
}

QLayout* FilesPanel::buildFolderLine()
{
    m_place = new QLineEdit;
    m_place->setObjectName(QStringLiteral("files.folder"));
    m_place->setAccessibleName(tr("Folder"));
    m_place->setToolTip(tr("The folder that is shown; type another and press Return."));
    connect(m_place, &QLineEdit::returnPressed, this, [this] { goTo(QDir::fromNativeSeparators(m_place->text().trimmed())); });
    auto* choosing = panelButton(QStringLiteral("files.choose"), QStringLiteral("open"), tr("Choose Folder"), tr("Asks for the folder that is shown."));
    connect(choosing, &QToolButton::clicked, this, &FilesPanel::askForFolder);
    auto* up = panelButton(QStringLiteral("files.up"), QStringLiteral("folder-up"), tr("Up (%1)").arg(QKeySequence(Qt::ALT | Qt::Key_Up).toString(QKeySequence::NativeText)), tr("Shows the folder in which this one lies."));
    connect(up, &QToolButton::clicked, this, &FilesPanel::goUp);
    return row({m_place, choosing, up});
}

QLayout* FilesPanel::buildChoices()
{
    m_filter = new QLineEdit;
    m_filter->setObjectName(QStringLiteral("files.filter"));
    m_filter->setAccessibleName(tr("Filter"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setToolTip(tr("Shows only what has these letters in its name."));
    m_filter->setClearButtonEnabled(true);
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& part) {
        m_sorter->filter(part);
        showState();
        m_wantSoon.start();
    });
    m_order = new QComboBox;
    m_order->setObjectName(QStringLiteral("files.order"));
    m_order->setAccessibleName(tr("Sorted by"));
    m_order->setToolTip(tr("What the files are sorted by; folders come first."));
    m_order->addItems({tr("Name"), tr("Size"), tr("Date"), tr("Vertices")});
    m_direction = panelButton(QStringLiteral("files.direction"), QStringLiteral("sort-up"), tr("Descending"), tr("Turns the order round."));
    m_direction->setCheckable(true);
    connect(m_order, &QComboBox::activated, this, &FilesPanel::choose);
    connect(m_direction, &QToolButton::clicked, this, &FilesPanel::choose);
    QHBoxLayout* choices = row({m_filter, m_order, m_direction});
    choices->setStretch(0, 1);
    return choices;
}

QLayout* FilesPanel::buildFoot()
{
    m_state = new QLabel;
    m_state->setObjectName(QStringLiteral("files.state"));
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_stop = panelButton(QStringLiteral("files.stop"), QStringLiteral("stop"), tr("Stop"), tr("Makes no more pictures in this folder."));
    QSizePolicy keepsItsPlace = m_stop->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_stop->setSizePolicy(keepsItsPlace);
    connect(m_stop, &QToolButton::clicked, this, [this] {
        m_isStopped = true;
        wantThumbnails();
    });
    m_size = new QSlider(Qt::Horizontal);
    m_size->setObjectName(QStringLiteral("files.size"));
    m_size->setAccessibleName(tr("Size of the pictures"));
    m_size->setToolTip(tr("How large the pictures are."));
    m_size->setRange(minPicture, maxPicture);
    m_size->setSingleStep(gap);
    m_size->setPageStep(4 * gap);
    m_size->setMaximumWidth(80);
    connect(m_size, &QSlider::valueChanged, this, &FilesPanel::choose);
    QHBoxLayout* foot = row({m_state, m_stop, m_size});
    foot->setStretch(0, 1);
    return foot;
}

void FilesPanel::buildActions()
{
    m_open = add(QStringLiteral("files.open"), tr("&Open"), tr("Opens the model, or enters the folder."),
                 {QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)}, [this] { activate(m_grid->currentIndex()); });
    m_rename = add(QStringLiteral("files.rename"), tr("&Rename"), tr("Gives the file another name; its ending stays."), {QKeySequence(Qt::Key_F2)},
                   [this] { m_grid->edit(m_grid->currentIndex()); });
    m_duplicate = add(QStringLiteral("files.duplicate"), tr("&Duplicate"), tr("Puts a copy of the file beside it."),
                      {QKeySequence(Qt::CTRL | Qt::Key_D)}, [this] { change([paths = chosenFiles()] { return FileJobs::duplicate(paths); }); });
    m_trash = add(QStringLiteral("files.trash"), tr("Move to &Trash"), tr("Puts the file into the trash, from which it can be taken back."),
                  {QKeySequence(Qt::Key_Delete)}, [this] { change([paths = chosenFiles()] { return FileJobs::trash(paths); }); });
    m_reveal = add(QStringLiteral("files.reveal"), tr("&Show in Folder"), tr("Shows the file in the desktop's program for files."), {}, [this] {
        revealFile(m_files->entry(m_sorter->mapToSource(m_grid->currentIndex())).path, this, [this](const QString& word) { Q_EMIT noticed(word); });
    });
    auto* up = add(QStringLiteral("files.goUp"), tr("&Up"), tr("Shows the folder in which this one lies."),
                   {QKeySequence(Qt::ALT | Qt::Key_Up), QKeySequence(Qt::Key_Backspace)}, [this] { goUp(); });
    connect(m_grid, &QListView::customContextMenuRequested, this, [this, up](QPoint at) {
        auto* menu = new QMenu(this);
        menu->setObjectName(QStringLiteral("files.menu"));
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->setToolTipsVisible(true);
        menu->addActions({m_open, m_rename, m_duplicate, m_trash, m_reveal});
        menu->addSeparator();
        menu->addAction(up);
        menu->popup(m_grid->viewport()->mapToGlobal(at));
    });
}

QAction* FilesPanel::add(const QString& id, const QString& text, const QString& tip, const QList<QKeySequence>& keys, const std::function<void()>& what)
{
    auto* action = new QAction(text, this);
    action->setObjectName(id);
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, what);
    m_grid->addAction(action);
    return action;
}
} // namespace ui
