#include "ui/files/file_browser.h"

#include "ui/actions/actions.h"
#include "ui/files/file_grid.h"
#include "ui/files/file_item_delegate.h"
#include "ui/files/file_list_model.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/settings/settings.h"
#include "ui/util/reveal_file.h"
#include "ui/widgets/panel_button.h"
#include "ui/widgets/spacing.h"

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
constexpr int listDelayMs = 200, thumbnailDelayMs = 30; ///< what comes at once is done once

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
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap, gap, gap, gap);
    column->setSpacing(gap);
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
    m_grid = new FileGrid;
    m_grid->setObjectName(QStringLiteral("files.grid"));
    m_grid->setAccessibleName(tr("Models in this folder"));
    m_grid->setModel(m_sorter);
    m_grid->setCells(new FileItemDelegate(m_files, m_sorter, m_grid));
    m_grid->setPicture(m_options.picture);
    m_empty = new QLabel;
    m_empty->setObjectName(QStringLiteral("files.empty"));
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
    m_place = new QLineEdit;
    m_place->setObjectName(QStringLiteral("files.folder"));
    m_place->setAccessibleName(tr("Folder"));
    m_place->setToolTip(tr("The folder that is shown; type another and press Return."));
    connect(m_place, &QLineEdit::returnPressed, this,
            [this] { goTo(QDir::fromNativeSeparators(m_place->text().trimmed())); });
    return row({m_place, panelButton(m_actions.get(QStringLiteral("files.choose"))),
                panelButton(m_actions.get(QStringLiteral("files.up")))});
}

QLayout* FileBrowser::buildChoices()
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
        m_thumbnailTimer.start();
    });
    m_order = new QComboBox;
    m_order->setObjectName(QStringLiteral("files.order"));
    m_order->setAccessibleName(tr("Sorted by"));
    m_order->setToolTip(tr("What the files are sorted by; folders come first."));
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
    m_state = new QLabel;
    m_state->setObjectName(QStringLiteral("files.state"));
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_stop = panelButton(QStringLiteral("files.stop"), QStringLiteral("stop"), tr("Stop"),
                         tr("Makes no more pictures in this folder."));
    QSizePolicy keepsItsPlace = m_stop->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_stop->setSizePolicy(keepsItsPlace);
    connect(m_stop, &QToolButton::clicked, this, [this] {
        m_isStopped = true;
        requestThumbnails();
    });
    m_size = new QSlider(Qt::Horizontal);
    m_size->setObjectName(QStringLiteral("files.size"));
    m_size->setAccessibleName(tr("Size of the pictures"));
    m_size->setToolTip(tr("How large the pictures are."));
    m_size->setRange(minPicture, maxPicture);
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
    m_rename = on("files.rename", [this] { rename(); });
    m_duplicate =
        on("files.duplicate", [this] { change([paths = chosenFiles()] { return FileJobs::duplicate(paths); }); });
    m_trash = on("files.trash", [this] {
        change([paths = chosenFiles()] { return FileJobs::trash(paths); },
               [this](const FileOutcome&) { Q_EMIT trashed(); });
    });
    m_reveal = on("files.reveal", [this] { reveal(); });
    m_up = on("files.up", [this] { goUp(); });
    m_chooseFolder = on("files.choose", [this] { askForFolder(); });
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
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("files.menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    m_actions.fill(menu, MenuId::Files);
    menu->popup(m_grid->viewport()->mapToGlobal(at));
}

/// In its place; the command may have come from elsewhere.
void FileBrowser::rename()
{
    m_grid->setFocus();
    m_grid->scrollTo(m_grid->currentIndex());
    m_grid->edit(m_grid->currentIndex());
}

void FileBrowser::renameTo(const QString& path, const QString& name)
{
    const auto report = [this, path](const FileOutcome& outcome) {
        if (!outcome.paths.isEmpty() && outcome.paths.constFirst() != path)
            Q_EMIT renamed(path, outcome.paths.constFirst());
    };
    change([=] { return FileJobs::rename(path, name); }, report);
}

void FileBrowser::reveal()
{
    const QString path = m_files->entry(m_sorter->mapToSource(m_grid->currentIndex())).path;
    revealFile(path, this, [this](const QString& word) { Q_EMIT noticed(word); });
}
} // namespace ui
