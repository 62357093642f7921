#include "ui/widgets/side_column.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace ui
{
namespace
{
constexpr std::array<std::pair<SidePanel::State, const char*>, 3> stateNames{
    {{SidePanel::State::Open, "open"}, {SidePanel::State::Folded, "folded"}, {SidePanel::State::Hidden, "hidden"}}};

/// Returns true for a control whose value the mouse wheel changes.
bool isTurnedByWheel(const QObject* object)
{
    return qobject_cast<const QComboBox*>(object) || qobject_cast<const QAbstractSpinBox*>(object) ||
           (qobject_cast<const QAbstractSlider*>(object) && !qobject_cast<const QScrollBar*>(object));
}
} // namespace

/// The scroll area of the column. Its width is that of the widest panel plus the scroll bar.
class SideColumn::Area : public QScrollArea
{
public:
    Area(QWidget* panels, const QList<SidePanel*>* all) : m_all(all)
    {
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidgetResizable(true);
        setWidget(panels);
    }

    QSize minimumSizeHint() const override { return {width(), 4 * fontMetrics().lineSpacing()}; }
    QSize sizeHint() const override { return {width(), widget()->sizeHint().height()}; }

private:
    int width() const
    {
        int widest = 0;
        for (const SidePanel* panel : *m_all)
            widest = std::max(widest, (panel->grows() ? panel->minimumSizeHint() : panel->sizeHint()).width());
        return widest + verticalScrollBar()->sizeHint().width();
    }

    const QList<SidePanel*>* m_all;
};

SideColumn::SideColumn(QWidget* parent)
    : QDockWidget(parent)
    , m_area(new Area(new QWidget, &m_panels))
    , m_rows(new QVBoxLayout(m_area->widget()))
{
    setObjectName(QStringLiteral("sideColumn"));
    setWindowTitle(tr("Panels"));
    setFeatures(NoDockWidgetFeatures);
    setTitleBarWidget(new QWidget);
    toggleViewAction()->setVisible(false);
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(1);
    m_rows->addStretch(1);
    setWidget(m_area);
    m_area->widget()->installEventFilter(this);
}

SidePanel* SideColumn::add(const QString& name, const QString& title, QWidget* content, SidePanel::State first)
{
    auto* panel = new SidePanel(name, title, content);
    m_rows->insertWidget(m_rows->count() - 1, panel);
    m_panels.append(panel);
    panel->setState(first);
    panel->installEventFilter(this);
    for (QWidget* control : content->findChildren<QWidget*>())
        if (isTurnedByWheel(control))
            control->installEventFilter(this);
    connect(panel, &SidePanel::broughtForward, this, [this, panel] { scrollTo(panel); });
    connect(panel, &SidePanel::soloRequested, this, [this, panel] {
        for (SidePanel* other : std::as_const(m_panels))
            if (other != panel && other->state() == SidePanel::State::Open)
                other->setState(SidePanel::State::Folded);
    });
    return panel;
}

QStringList SideColumn::panelStates() const
{
    QStringList states;
    for (const SidePanel* panel : m_panels)
        for (const auto& [state, name] : stateNames)
            if (panel->state() == state)
                states << panel->objectName() + u' ' + QLatin1StringView(name);
    return states;
}

void SideColumn::setPanelStates(const QStringList& states)
{
    for (SidePanel* panel : std::as_const(m_panels))
        for (const auto& [state, name] : stateNames)
            if (states.contains(panel->objectName() + u' ' + QLatin1StringView(name)))
                panel->setState(state);
}

/// Scrolls to a panel, after the layout has been updated in the event loop.
void SideColumn::scrollTo(SidePanel* panel)
{
    QTimer::singleShot(0, panel, [this, panel] {
        m_area->ensureWidgetVisible(panel, 0, 0);
        m_area->ensureVisible(0, panel->y(), 0, 0);
    });
}

void SideColumn::showWhatIsOpen()
{
    setVisible(std::ranges::any_of(m_panels, [](const SidePanel* panel) { return !panel->isHidden(); }));
}

bool SideColumn::eventFilter(QObject* watched, QEvent* event)
{
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::Wheel && isTurnedByWheel(watched) && !widget->hasFocus()) {
        event->ignore();
        return true;
    }
    if ((event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) &&
        qobject_cast<SidePanel*>(watched))
        showWhatIsOpen();
    const bool isLaidOut = event->type() == QEvent::LayoutRequest && watched == m_area->widget();
    if (isLaidOut && m_area->minimumSizeHint().width() > m_area->size().width())
        m_area->updateGeometry(); // a panel has become wider than the column
    return QDockWidget::eventFilter(watched, event);
}
} // namespace ui
