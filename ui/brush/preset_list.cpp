#include "ui/brush/preset_list.h"

#include "ui/actions/actions.h"
#include "ui/brush/brush_shapes.h"
#include "ui/brush/preset_choice.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_button.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int pictureSize = 64;
constexpr int drawnPixels = 2 * pictureSize; ///< pixels, sharp on screens scaled to 200 %
constexpr int pathRole = Qt::UserRole;
} // namespace

PresetList::PresetList(BrushSettings* brush, BrushShapes* shapes, QWidget* parent)
    : QWidget(parent)
    , m_brush(brush)
    , m_shapes(shapes)
    , m_list(named(new QListWidget, "presets", {}, tr("Brush presets")))
{
    build();
    connect(&m_library, &PresetLibrary::loaded, this, &PresetList::fill);
    connect(&m_library, &PresetLibrary::pictureMade, this, &PresetList::setPicture);
    connect(&m_library, &PresetLibrary::refused, this, &PresetList::noticed);
    connect(m_list, &QListWidget::itemClicked, this, &PresetList::take);
    connect(m_list, &QListWidget::itemActivated, this, &PresetList::take);
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (const PresetLibrary::Entry* entry = entryOf(item); entry && entry->name != item->text())
            m_library.rename(PresetLibrary::Entry(*entry), item->text());
    });
    connect(m_list, &QListWidget::currentItemChanged, this, &PresetList::update);
    connect(brush, &BrushSettings::changed, this, &PresetList::update);
    connect(shapes, &BrushShapes::changed, this, &PresetList::update);
}

void PresetList::build()
{
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setWordWrap(true);
    m_list->setIconSize({pictureSize, pictureSize});
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // A scroll bar that appears and disappears would change the number of columns
    m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    m_new = button(QStringLiteral("presets.new"), QStringLiteral("plus"), tr("New Preset"),
                   tr("Saves the current brush as a preset, and asks for its name."), [this] { makeNew(); });
    m_rename = button(QStringLiteral("presets.rename"), QStringLiteral("rename"), tr("Rename"),
                      tr("Renames this preset (F2)."), [this] { m_list->editItem(m_list->currentItem()); });
    m_delete = button(QStringLiteral("presets.delete"), QStringLiteral("trash"), tr("Delete"),
                      tr("Moves this preset to the trash."), [this] {
                          if (const auto* entry = entryOf(m_list->currentItem()))
                              m_library.remove(*entry);
                      });
    m_import = button(QStringLiteral("presets.import"), QStringLiteral("open"), tr("Import"),
                      tr("Imports a preset from a file."),
                      [this] { askForPreset(window(), [this](const QString& path) { m_library.import(path); }); });
    m_export = button(QStringLiteral("presets.export"), QStringLiteral("export"), tr("Export"),
                      tr("Writes this preset to a file that others can import."), [this] { exportChosen(); });
    auto* row = new QHBoxLayout;
    row->setSpacing(gap / 2);
    for (QToolButton* each : {m_new, m_rename, m_delete})
        row->addWidget(each);
    row->addStretch(1);
    for (QToolButton* each : {m_import, m_export})
        row->addWidget(each);
    QVBoxLayout* column = panelLayout(this);
    column->addWidget(m_list, 1);
    column->addLayout(row);
    m_list->viewport()->installEventFilter(this);
    layCells();
}

QToolButton* PresetList::button(const QString& name, const QString& icon, const QString& text, const QString& tip,
                                const std::function<void()>& what)
{
    QToolButton* made = panelButton(name, icon, text, tip);
    connect(made, &QToolButton::clicked, this, what);
    return made;
}

/// Divides the list's width evenly among the columns; each cell has two lines for the name.
void PresetList::layCells()
{
    const QFontMetrics metrics = m_list->fontMetrics();
    const int least = std::max(pictureSize, metrics.averageCharWidth() * 12) + gap;
    const int available = m_list->viewport()->width() - 1, columns = std::max(1, available / least);
    m_list->setGridSize({std::max(least, available / columns), pictureSize + 2 * metrics.lineSpacing() + 2 * gap});
    m_list->setMinimumWidth(least + m_list->verticalScrollBar()->sizeHint().width() + 2 * m_list->frameWidth() + 2);
}

void PresetList::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!std::exchange(m_isLoaded, true))
        m_library.load();
}

void PresetList::showIn(QListView* view)
{
    if (!std::exchange(m_isLoaded, true))
        m_library.load();
    view->setModel(m_list->model());
    const auto hide = [this, view] {
        for (int i = 0; i < m_list->count(); ++i)
            view->setRowHidden(i, m_list->isRowHidden(i));
    };
    hide();
    connect(&m_library, &PresetLibrary::loaded, view, hide);
    const auto takeAt = [this](const QModelIndex& index) { take(m_list->item(index.row())); };
    connect(view, &QListView::clicked, this, takeAt);
    connect(view, &QListView::activated, this, takeAt);
}

bool PresetList::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange)
        layCells();
    return QWidget::eventFilter(watched, event);
}

void PresetList::fill()
{
    const auto* chosen = m_list->currentItem();
    const QString current = chosen ? chosen->data(pathRole).toString() : QString();
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const PresetLibrary::Entry& entry : m_library.entries()) {
            auto* item = new QListWidgetItem(entry.name, m_list);
            item->setData(pathRole, entry.file.path);
            item->setToolTip(entry.tip.isEmpty() ? entry.name : entry.tip);
            if (!entry.isOurs)
                item->setFlags(item->flags() | Qt::ItemIsEditable);
            QPixmap blank(drawnPixels, drawnPixels);
            blank.fill(Qt::transparent);
            item->setIcon(m_pictures.value(entry.file.path, blank));
            if (entry.file.path == (m_toEdit.isEmpty() ? current : m_toEdit))
                m_list->setCurrentItem(item);
        }
    }
    update();
    m_library.draw(drawnPixels);
    if (m_toEdit.isEmpty() || !m_list->currentItem())
        return;
    m_toEdit.clear();
    m_list->setFocus();
    m_list->scrollToItem(m_list->currentItem());
    m_list->editItem(m_list->currentItem());
}

void PresetList::setPicture(const QString& path, const QImage& picture)
{
    m_pictures.insert(path, QPixmap::fromImage(picture));
    const QSignalBlocker quiet(m_list); // itemChanged() must be emitted for edited names only
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->data(pathRole) == path)
            m_list->item(i)->setIcon(m_pictures.value(path));
}

const PresetLibrary::Entry* PresetList::entryOf(const QListWidgetItem* item) const
{
    const auto& entries = m_library.entries();
    const auto found = std::ranges::find_if(
        entries, [item](const PresetLibrary::Entry& entry) { return item && item->data(pathRole) == entry.file.path; });
    return found == entries.end() ? nullptr : &*found;
}

void PresetList::take(const QListWidgetItem* item)
{
    const PresetLibrary::Entry* entry = entryOf(item);
    if (!entry || !m_brush->isOffered(entry->file.preset->stroke.tool))
        return;
    if (const QString problem = takePreset(entry->file, m_brush, m_shapes); !problem.isEmpty())
        Q_EMIT noticed(problem);
    Q_EMIT taken();
}

/// Hides presets of tools that are not offered. Clears the selection if the brush no longer has the values of the
/// selected preset.
void PresetList::update()
{
    for (int i = 0; i < m_list->count(); ++i) {
        const PresetLibrary::Entry* entry = entryOf(m_list->item(i));
        m_list->item(i)->setHidden(!entry || !m_brush->isOffered(entry->file.preset->stroke.tool));
    }
    const PresetLibrary::Entry* chosen = entryOf(m_list->currentItem());
    if (chosen && !m_list->hasFocus() && !isInHand(*chosen->file.preset, *m_brush))
        m_list->clearSelection();
    const bool mayWrite = m_shapes->mayLoad();
    m_list->setEditTriggers(mayWrite ? QAbstractItemView::EditKeyPressed : QAbstractItemView::NoEditTriggers);
    for (QToolButton* each : {m_new, m_rename, m_delete, m_import, m_export})
        each->setVisible(mayWrite);
    m_export->setEnabled(chosen);
    m_rename->setEnabled(chosen && !chosen->isOurs);
    m_delete->setEnabled(chosen && !chosen->isOurs);
}

void PresetList::makeNew()
{
    m_toEdit = m_library.add(presetOf(*m_brush), tr("My brush"));
}

void PresetList::exportChosen()
{
    const PresetLibrary::Entry* chosen = entryOf(m_list->currentItem());
    if (!chosen)
        return;
    askForPresetTarget(window(), chosen->name, [this, entry = PresetLibrary::Entry(*chosen)](const QString& path) {
        m_library.exportTo(entry, path);
    });
}

PresetList* addPresetList(const PresetListContext& context, BrushSettings* brush, BrushShapes* shapes)
{
    auto* list = new PresetList(brush, shapes);
    QObject::connect(list, &PresetList::taken, list, context.taken);
    QObject::connect(list, &PresetList::noticed, list, context.notice);
    SidePanel* panel = context.column->add(QStringLiteral("presetPanel"), PresetList::tr("Presets"), list);
    QObject::connect(context.actions->get(QStringLiteral("brush.presets")), &QAction::triggered, panel,
                     &SidePanel::bringForward);
    return list;
}
} // namespace ui
