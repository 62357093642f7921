#include "ui/window/tool_palette.h"

#include "ui/actions/actions.h"
#include "ui/settings/settings.h"
#include "ui/widgets/app_style.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QEvent>
#include <QMainWindow>
#include <QPainter>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int maxColumns = 4;
constexpr QSize iconSize{26, 26};

qsizetype shownIn(const QList<QToolButton*>& group)
{
    return std::ranges::count_if(group, [](const QToolButton* button) { return !button->isHidden(); });
}
} // namespace

ToolPalette::ToolPalette(const QList<QList<QAction*>>& groups, QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    for (const QList<QAction*>& actions : groups) {
        Group& buttons = m_groups.emplace_back();
        for (QAction* action : actions)
            buttons << makeButton(action);
    }
}

QToolButton* ToolPalette::makeButton(QAction* action)
{
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize(iconSize);
    button->setFocusPolicy(Qt::TabFocus);
    connect(action, &QAction::changed, button, [this, action, button] {
        if (button->isHidden() != action->isVisible())
            return;
        button->setVisible(action->isVisible());
        arrange();
    });
    return button;
}

void ToolPalette::setShowsNames(bool showsNames)
{
    m_showsNames = showsNames;
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    for (const Group& group : m_groups) {
        for (QToolButton* button : group) {
            button->setToolButtonStyle(showsNames ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
            button->setFont(showsNames ? small : font());
        }
    }
    arrange();
}

/// Returns the size of a button: all buttons are as large as the largest.
QSize ToolPalette::cell() const
{
    QSize largest;
    for (const Group& group : m_groups)
        for (const QToolButton* button : group)
            if (!button->isHidden())
                largest = largest.expandedTo(button->sizeHint());
    return largest;
}

int ToolPalette::heightOf(int columns) const
{
    int rows = 0, shown = 0;
    for (const Group& group : m_groups) {
        const int count = static_cast<int>(shownIn(group));
        rows += (count + columns - 1) / columns;
        shown += count > 0;
    }
    return rows * cell().height() + std::max(0, shown - 1) * gap;
}

QSize ToolPalette::sizeHint() const
{
    return {m_columns * cell().width(), heightOf(maxColumns)};
}

/// Arranges the buttons in the smallest number of columns that fits the height.
void ToolPalette::arrange()
{
    int columns = 1;
    while (columns < maxColumns && heightOf(columns) > height())
        ++columns;
    if (columns != m_columns) {
        m_columns = columns;
        updateGeometry();
    }
    const QSize size = cell();
    int y = 0;
    m_lines.clear();
    for (const Group& group : m_groups) {
        if (shownIn(group) == 0)
            continue;
        if (y > 0) {
            m_lines << y + gap / 2;
            y += gap;
        }
        int column = 0;
        for (QToolButton* button : group) {
            if (button->isHidden())
                continue;
            if (column == m_columns) {
                column = 0;
                y += size.height();
            }
            const QPoint left(column++ * size.width(), y);
            button->setGeometry(QStyle::visualRect(layoutDirection(), rect(), {left, size}));
        }
        y += size.height();
    }
    update();
}

void ToolPalette::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void ToolPalette::paintEvent(QPaintEvent*)
{
    const QColor line = hairline(palette());
    QPainter painter(this);
    for (const int y : m_lines)
        painter.fillRect(gap / 2, y, width() - gap, 1, line);
}

void ToolPalette::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        setShowsNames(m_showsNames);
}

void addToolPalette(QMainWindow* window, Settings* settings, const Actions& actions)
{
    auto* palette = new ToolPalette(actions.groups(Bar::Tools));
    auto* bar = named(new QToolBar(ToolPalette::tr("Tool Palette")), "toolPalette");
    bar->setMovable(false);
    bar->addWidget(palette);
    window->addToolBar(Qt::LeftToolBarArea, bar);

    QAction* names = actions.get(QStringLiteral("view.toolNames"));
    QObject::connect(names, &QAction::toggled, palette, [settings, palette](bool on) {
        palette->setShowsNames(on);
        settings->set(&Setting::showsToolNames, on);
    });
    const auto applySettings = [settings, names] { names->setChecked(settings->get(&Setting::showsToolNames)); };
    applySettings();
    settings->onReset(applySettings);
}
} // namespace ui
