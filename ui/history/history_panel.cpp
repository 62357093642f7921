#include "ui/history/history_panel.h"

#include "ui/history/timeline.h"
#include "ui/settings/settings.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QAbstractTableModel>
#include <QFont>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QTreeView>

#include <utility>

namespace ui
{
namespace
{
constexpr qint64 megabyte = 1 << 20;
} // namespace

/// The rows of the list: one for each state, with the name and the size of its step.
class HistoryPanel::Model : public QAbstractTableModel
{
public:
    void set(History history)
    {
        beginResetModel();
        m_history = std::move(history);
        endResetModel();
    }

    const History& history() const { return m_history; }
    int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_history.steps.size()) + 1;
    }
    int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : 2; }

    Qt::ItemFlags flags(const QModelIndex& index) const override
    {
        return isKept(index.row()) ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags;
    }

    QVariant data(const QModelIndex& index, int role) const override
    {
        const bool isName = index.column() == 0;
        switch (role) {
        case Qt::DisplayRole:
            return isName ? name(index.row()) : marks(index.row());
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return HistoryPanel::tr("%1: %2", "step: what it took").arg(name(index.row()), marks(index.row()));
        case Qt::DecorationRole:
            return isName ? themedIcon(index.row() == 0 ? QStringLiteral("open") : step(index.row()).icon) : QVariant();
        case Qt::FontRole:
            return font(index.row());
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignVCenter | (isName ? Qt::AlignLeft : Qt::AlignRight));
        default:
            return {};
        }
    }

private:
    const HistoryStep& step(int row) const { return m_history.steps[row - 1]; }
    bool isKept(int row) const { return row >= m_history.first && row <= m_history.last; }
    QString name(int row) const { return row == 0 ? HistoryPanel::tr("Start") : step(row).name; }

    QString marks(int row) const
    {
        if (!isKept(row))
            return HistoryPanel::tr("expired");
        if (row > m_history.present)
            return HistoryPanel::tr("undone");
        if (row == 0 || step(row).dabs == 0)
            return {};
        const QString dabs = HistoryPanel::tr("%Ln dabs", nullptr, static_cast<int>(step(row).dabs));
        if (step(row).fusions == 0)
            return dabs;
        return HistoryPanel::tr("%1, %2", "dabs, fusions")
            .arg(dabs, HistoryPanel::tr("%Ln fusions", nullptr, static_cast<int>(step(row).fusions)));
    }

    QFont font(int row) const
    {
        QFont font;
        font.setItalic(row > m_history.present);
        font.setBold(row == m_history.present);
        return font;
    }

    History m_history;
};

HistoryPanel::HistoryPanel(Settings* settings, QWidget* parent)
    : QWidget(parent)
    , m_model(std::make_unique<Model>())
    , m_list(new QTreeView)
    , m_timeline(new Timeline)
    , m_memory(new QLabel)
    , m_cap(new QSpinBox)
{
    named(m_list, "historyList", tr("Every step since the model was opened. Click one, or press Return, to go there."),
          tr("History"));
    m_list->setModel(m_model.get());
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setMinimumHeight(96);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    const auto jump = [this](const QModelIndex& index) {
        if (index.flags() & Qt::ItemIsEnabled)
            Q_EMIT jumpRequested(index.row());
    };
    connect(m_list, &QTreeView::clicked, this, jump);
    connect(m_list, &QTreeView::activated, this, jump);
    connect(m_timeline, &Timeline::stateRequested, this, &HistoryPanel::stateRequested);

    m_memory->setObjectName(QStringLiteral("historyMemory"));
    named(m_cap, "historyCap",
          tr("The memory that the history may use. Older steps are moved to disk; if the disk is full, they expire."),
          tr("Memory for the history"));
    m_cap->setRange(minHistoryMegabytes, maxHistoryMegabytes);
    m_cap->setSuffix(tr(" MB"));
    m_cap->setKeyboardTracking(false);
    m_cap->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    const auto applySettings = [this, settings] { m_cap->setValue(settings->get(&Setting::historyMegabytes)); };
    applySettings();
    settings->onReset(applySettings);
    connect(m_cap, &QSpinBox::valueChanged, this, [this, settings](int megabytes) {
        settings->set(&Setting::historyMegabytes, megabytes);
        Q_EMIT capChanged(cap());
    });

    auto* foot = new QHBoxLayout;
    foot->setSpacing(gap);
    foot->addWidget(m_memory);
    foot->addWidget(m_cap);
    foot->addStretch();
    QVBoxLayout* column = panelLayout(this);
    column->addWidget(m_list, 1);
    column->addWidget(m_timeline);
    column->addLayout(foot);
    setHistory({});
}

HistoryPanel::~HistoryPanel()
{
    m_list->setModel(nullptr);
}

void HistoryPanel::setHistory(History history)
{
    m_timeline->setHistory(history);
    m_model->set(std::move(history));
    const QModelIndex present = m_model->index(m_model->history().present, 0);
    m_list->setCurrentIndex(present);
    m_list->scrollTo(present);
    m_memory->setText(
        tr("%1 MB of").arg(QLocale().toString(static_cast<double>(m_model->history().bytes) / megabyte, 'f', 1)));
}

qint64 HistoryPanel::cap() const
{
    return m_cap->value() * megabyte;
}

void HistoryPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    Q_EMIT shown();
}

HistoryPanel* addHistoryPanel(SideColumn* column, Settings* settings)
{
    auto* panel = new HistoryPanel(settings);
    column->add(QStringLiteral("historyPanel"), HistoryPanel::tr("History"), panel);
    return panel;
}
} // namespace ui
