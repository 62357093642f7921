#include "ui/parts/parts_panel.h"

#include "ui/actions/actions.h"
#include "ui/util/color_convert.h"
#include "ui/util/part_name.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QColorDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>

namespace ui
{
namespace
{
enum Column { Name, Shown, Locked };
constexpr int tagSize = 12; ///< side of the square that shows a part's colour, pixels

core::PartId idOf(const QTreeWidgetItem* row)
{
    return static_cast<core::PartId>(row->type());
}

/// Returns the only selected row; null while Ctrl or Shift extends the selection.
const QTreeWidgetItem* chosenAlone(const QTreeWidget& list)
{
    const QList<QTreeWidgetItem*> selected = list.selectedItems();
    const bool extends = QGuiApplication::keyboardModifiers() & (Qt::ControlModifier | Qt::ShiftModifier);
    return selected.size() == 1 && !extends ? selected.front() : nullptr;
}

QIcon tagIcon(const std::optional<core::Rgb>& tag)
{
    QPixmap square(tagSize, tagSize);
    square.fill(tag ? toQt(*tag) : QColor(Qt::transparent));
    return square;
}

void fillRow(QTreeWidgetItem* row, const core::Part& part, bool isActive)
{
    row->setFlags(row->flags() | Qt::ItemIsEditable);
    row->setText(Name, partName(part));
    row->setIcon(Name, tagIcon(part.tag));
    row->setIcon(Shown, themedIcon(part.isVisible ? QStringLiteral("part-shown") : QStringLiteral("part-hidden")));
    row->setToolTip(Shown, part.isVisible ? PartsPanel::tr("Shown. Click to hide.")
                                          : PartsPanel::tr("Hidden. Click to show."));
    row->setIcon(Locked, themedIcon(part.isLocked ? QStringLiteral("part-locked") : QStringLiteral("part-unlocked")));
    row->setToolTip(Locked, part.isLocked ? PartsPanel::tr("Locked. Click to unlock.")
                                          : PartsPanel::tr("Unlocked. Click to lock."));
    QFont font; // of the list, but for its weight
    font.setBold(isActive);
    row->setFont(Name, font);
    QString state = isActive ? PartsPanel::tr("%1, active").arg(partName(part)) : partName(part);
    if (part.isLocked)
        state = PartsPanel::tr("%1, locked").arg(state);
    row->setData(Name, Qt::AccessibleTextRole, part.isVisible ? state : PartsPanel::tr("%1, hidden").arg(state));
}
} // namespace

PartsPanel::PartsPanel(const Actions& actions, QWidget* parent)
    : QWidget(parent)
    , m_list(named(new QTreeWidget, "partList",
                   tr("The parts of the model. Click one to sculpt it, and its name becomes bold; with Ctrl choose "
                      "others to combine it with. Double-click a name to change it."),
                   tr("Parts")))
{
    m_list->setColumnCount(3);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setMinimumHeight(96);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    for (const Column column : {Shown, Locked})
        m_list->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_list->installEventFilter(this);
    connect(m_list, &QTreeWidget::itemChanged, this, &PartsPanel::onRenamed);
    const auto activateChosen = [this] {
        const QTreeWidgetItem* row = m_isFilling ? nullptr : chosenAlone(*m_list);
        if (row && idOf(row) != m_active)
            Q_EMIT activated(idOf(row));
    };
    connect(m_list, &QTreeWidget::itemClicked, this, activateChosen);
    connect(m_list, &QTreeWidget::itemClicked, this, &PartsPanel::onClicked);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, activateChosen);

    QVBoxLayout* rows = panelLayout(this);
    rows->addWidget(m_list, 1);
    for (const QList<const char*>& ids :
         {QList<const char*>{"parts.duplicate", "parts.separate", "parts.delete", "parts.isolate", "parts.up",
                             "parts.down"},
          QList<const char*>{"parts.union", "parts.subtract", "parts.intersect", "parts.tag"}}) {
        auto* buttons = new QHBoxLayout;
        for (const char* id : ids) {
            auto* button = new QToolButton;
            button->setAutoRaise(true);
            button->setDefaultAction(actions.get(QLatin1StringView(id)));
            button->setObjectName(QLatin1StringView(id));
            buttons->addWidget(button);
        }
        buttons->addStretch();
        rows->addLayout(buttons);
    }
    connectActions(actions);
    setParts({}, 0);
}

void PartsPanel::connectActions(const Actions& actions)
{
    const auto on = [&](const char* id, const auto& what) {
        connect(actions.get(QLatin1StringView(id)), &QAction::triggered, this, what);
    };
    on("parts.duplicate", [this] {
        if (const core::Part* part = present())
            Q_EMIT requested(m_active, core::DuplicatePart{
                                           tr("%1 copy", "name of a copied part").arg(partName(*part)).toStdString()});
    });
    on("parts.separate", [this] { Q_EMIT requested(m_active, core::SeparatePart{}); });
    on("parts.delete", [this] { Q_EMIT requested(m_active, core::DeletePart{}); });
    on("parts.rename", [this] {
        if (QTreeWidgetItem* row = rowOf(m_active))
            m_list->editItem(row, Name);
    });
    on("parts.hide", [this] {
        if (const core::Part* part = present())
            toggleShown(*part);
    });
    on("parts.lock", [this] {
        if (core::Part part = present() ? *present() : core::Part(); present()) {
            part.isLocked = !part.isLocked;
            edit(part);
        }
    });
    on("parts.tag", [this] { chooseTag(); });
    on("parts.up", [this] { move(-1); });
    on("parts.down", [this] { move(1); });
    on("parts.union", [this] { combine(core::SetOperation::Union); });
    on("parts.subtract", [this] { combine(core::SetOperation::Difference); });
    on("parts.intersect", [this] { combine(core::SetOperation::Intersection); });
}

void PartsPanel::setParts(const core::PartList& parts, core::PartId active)
{
    const QScopedValueRollback filling(m_isFilling, true);
    const bool hasSameRows = std::ranges::equal(parts.all(), m_parts.all(), {}, &core::Part::id, &core::Part::id) &&
                             m_list->topLevelItemCount() > 0;
    const std::vector<core::PartId> selected = others();
    const bool isSameActive = active == m_active;
    m_parts = parts;
    m_active = active;
    if (!hasSameRows) { // otherwise rows stay, because a click may be in progress
        m_list->clear();
        for (const core::Part& part : parts.all())
            new QTreeWidgetItem(m_list, {QString(), QString(), QString()}, part.id);
    }
    for (const core::Part& part : parts.all())
        fillRow(rowOf(part.id), part, part.id == active);
    if (hasSameRows && isSameActive)
        return;
    if (QTreeWidgetItem* row = rowOf(active); row && m_list->selectedItems() != QList{row})
        m_list->setCurrentItem(row, Name, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    if (hasSameRows)
        return;
    for (const core::PartId id : selected) {
        if (QTreeWidgetItem* row = rowOf(id))
            row->setSelected(true);
    }
}

QTreeWidgetItem* PartsPanel::rowOf(core::PartId part) const
{
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        if (idOf(m_list->topLevelItem(i)) == part)
            return m_list->topLevelItem(i);
    }
    return nullptr;
}

const core::Part* PartsPanel::present() const
{
    return m_parts.find(m_active);
}

/// Returns the selected parts other than the active one, in the order of the list.
std::vector<core::PartId> PartsPanel::others() const
{
    std::vector<core::PartId> ids;
    for (const core::Part& part : m_parts.all()) {
        const QTreeWidgetItem* row = rowOf(part.id);
        if (row && row->isSelected() && part.id != m_active)
            ids.push_back(part.id);
    }
    return ids;
}

void PartsPanel::onClicked(QTreeWidgetItem* row, int column)
{
    const core::Part* part = m_parts.find(idOf(row));
    if (!part || column == Name)
        return;
    if (column == Shown)
        return toggleShown(*part);
    core::Part changed = *part;
    changed.isLocked = !part->isLocked;
    edit(changed);
}

void PartsPanel::onRenamed(QTreeWidgetItem* row)
{
    const core::Part* part = m_isFilling ? nullptr : m_parts.find(idOf(row));
    if (!part)
        return;
    core::Part renamed = *part;
    renamed.name = row->text(Name).trimmed().toStdString();
    const QScopedValueRollback filling(m_isFilling, true);
    row->setText(Name, partName(*part)); // until the name is changed
    if (QString::fromStdString(renamed.name) != partName(*part))
        edit(renamed);
}

void PartsPanel::toggleShown(const core::Part& part)
{
    core::ShowParts show;
    for (const core::Part& other : m_parts.all()) {
        if (other.isVisible != (other.id == part.id))
            show.visible.push_back(other.id);
    }
    Q_EMIT requested(part.id, show);
}

/// Requests the properties of the part. `position`: its new index in the list; nothing: the present one.
void PartsPanel::edit(core::Part part, std::optional<std::size_t> position)
{
    Q_EMIT requested(part.id, core::EditPart{std::move(part.name), part.isLocked, part.tag, position});
}

void PartsPanel::move(int by)
{
    const QTreeWidgetItem* row = rowOf(m_active);
    const int to = row ? m_list->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(row)) + by : -1;
    if (present() && to >= 0 && to < m_list->topLevelItemCount())
        edit(*present(), static_cast<std::size_t>(to));
}

void PartsPanel::chooseTag()
{
    if (!present())
        return;
    auto* dialog = new QColorDialog(present()->tag ? toQt(*present()->tag) : QColor(Qt::white), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour of %1 in the List").arg(partName(*present())));
    connect(dialog, &QColorDialog::colorSelected, this, [this, id = m_active](const QColor& color) {
        if (const core::Part* part = m_parts.find(id)) {
            core::Part tagged = *part;
            tagged.tag = toRgb(color);
            edit(tagged);
        }
    });
    dialog->open();
}

void PartsPanel::combine(core::SetOperation operation)
{
    Q_EMIT combinationRequested(m_active, core::CombineParts{operation, others()});
}

bool PartsPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = watched == m_list && event->type() == QEvent::KeyPress;
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        Q_EMIT requested(m_active, core::DeletePart{});
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

PartsPanel* addPartsPanel(SideColumn* column, const Actions& actions)
{
    auto* panel = new PartsPanel(actions);
    column->add(QStringLiteral("partsPanel"), PartsPanel::tr("Parts"), panel);
    return panel;
}
} // namespace ui
