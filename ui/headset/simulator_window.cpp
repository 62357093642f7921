#include "ui/headset/simulator_window.h"

#include "ui/headset/simulator_view.h"
#include "ui/widgets/spacing.h"

#include <QCloseEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int legendWidth = 330, edge = 8;

struct Control
{
    const char* hand; ///< a key, or what the mouse does
    const char* effect;
};

// clang-format off
constexpr Control controls[] = {
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Mouse"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "moves the wand")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Wheel"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "farther and nearer")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Shift and wheel"),
     QT_TRANSLATE_NOOP("ui::SimulatorWindow", "turns the wand about itself")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Left button, Space"),
     QT_TRANSLATE_NOOP("ui::SimulatorWindow", "trigger; with Shift half as strong")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Tab"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "the other wand")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Arrows"),
     QT_TRANSLATE_NOOP("ui::SimulatorWindow", "press the pad at that side")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Ctrl and mouse"),
     QT_TRANSLATE_NOOP("ui::SimulatorWindow", "the thumb slides on the pad")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "M"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "menu button")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "G"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "squeezes the wand")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "B"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "squeezes both wands")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Right button"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "looks about")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "W A S D"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "walk")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "E, Q"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "up and down")},
    {QT_TRANSLATE_NOOP("ui::SimulatorWindow", "Esc"), QT_TRANSLATE_NOOP("ui::SimulatorWindow", "leaves VR")},
};
// clang-format on

QLabel* wrapped(const QString& text)
{
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

QFont bold(QFont font)
{
    font.setBold(true);
    return font;
}
} // namespace

SimulatorWindow::SimulatorWindow(QWidget* main)
    : QWidget(main, Qt::Window)
    , m_view(new SimulatorView)
    , m_hand(wrapped({}))
{
    setObjectName(QStringLiteral("simulatorWindow"));
    setWindowTitle(tr("VR Simulator"));
    m_view->setAccessibleName(tr("What the headset shows"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_view, 1);
    row->addWidget(legend());
    connect(m_view, &SimulatorView::handChanged, this, &SimulatorWindow::showHand);
    connect(m_view, &SimulatorView::escaped, this, &QWidget::close);
    showHand();
}

QWidget* SimulatorWindow::legend()
{
    auto* legend = new QWidget;
    legend->setFixedWidth(legendWidth);
    auto* grid = new QGridLayout(legend);
    grid->setContentsMargins(2 * gap, 2 * gap, 2 * gap, 2 * gap);
    grid->setHorizontalSpacing(2 * gap);
    grid->setVerticalSpacing(gap);
    grid->setColumnStretch(1, 1);
    m_hand->setObjectName(QStringLiteral("simulatedHand"));
    grid->addWidget(m_hand, 0, 0, 1, 2);
    grid->setRowMinimumHeight(1, gap);
    int row = 2;
    for (const Control& control : controls) {
        QLabel* hand = wrapped(tr(control.hand));
        hand->setFont(bold(hand->font()));
        grid->addWidget(hand, row, 0);
        grid->addWidget(wrapped(tr(control.effect)), row++, 1);
    }
    grid->setRowStretch(row, 1);
    return legend;
}

void SimulatorWindow::begin()
{
    m_view->begin();
    if (isVisible())
        return;
    resize(sizeHint());
    placeBesideMain();
    show();
    activateWindow();
    m_view->setFocus();
}

/// To its right, as far as the screen goes.
void SimulatorWindow::placeBesideMain()
{
    const QRect main = parentWidget()->window()->frameGeometry();
    const QRect screen =
        parentWidget()->screen()->availableGeometry().adjusted(edge, edge, -edge, -edge); // a frame comes around it
    resize(size().boundedTo(screen.size()));
    move(std::clamp(main.right() + 1, screen.left(), std::max(screen.left(), screen.right() + 1 - width())),
         std::clamp(main.top(), screen.top(), std::max(screen.top(), screen.bottom() + 1 - height())));
}

void SimulatorWindow::showHand()
{
    m_hand->setText(m_view->controls().hand() == SimulatedHand::Left ? tr("The mouse moves the left wand.")
                                                                     : tr("The mouse moves the right wand."));
}

void SimulatorWindow::closeEvent(QCloseEvent* event)
{
    event->accept();
    Q_EMIT closed();
}
} // namespace ui
