#include "ui/headset/simulator_window.h"

#include "ui/headset/simulator_view.h"
#include "ui/widgets/spacing.h"

#include <QApplication>
#include <QCloseEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr int legendWidth = 330, edge = 8;

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
    const std::pair<QString, QString> controls[] = {
        {tr("Mouse"), tr("moves the controller on the surface")},
        {tr("Wheel"), tr("farther and nearer")},
        {tr("Shift and wheel"), tr("turns the controller about its own axis")},
        {tr("Left button, Space"), tr("trigger; with Shift half as strong")},
        {tr("Tab"), tr("the other controller")},
        {tr("Arrows"), tr("press the pad at that side")},
        {tr("Ctrl and mouse"), tr("the thumb slides on the pad")},
        {tr("M"), tr("menu button")},
        {tr("G"), tr("squeezes the controller")},
        {tr("B"), tr("squeezes both controllers")},
        {tr("Right button"), tr("looks around")},
        {tr("W A S D"), tr("walk")},
        {tr("E, Q"), tr("up and down")},
        {tr("Esc"), tr("leaves VR")}};
    int row = 2;
    for (const auto& [control, effect] : controls) {
        QLabel* hand = wrapped(control);
        hand->setFont(bold(hand->font()));
        grid->addWidget(hand, row, 0);
        grid->addWidget(wrapped(effect), row++, 1);
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
    showQuestion();
}

/// Places the window to the right of the main window, moved back onto the screen if necessary.
void SimulatorWindow::placeBesideMain()
{
    const QRect main = parentWidget()->window()->frameGeometry();
    const QRect screen =
        // Leaves room for the window frame
        parentWidget()->screen()->availableGeometry().adjusted(edge, edge, -edge, -edge);
    resize(size().boundedTo(screen.size()));
    move(std::clamp(main.right() + 1, screen.left(), std::max(screen.left(), screen.right() + 1 - width())),
         std::clamp(main.top(), screen.top(), std::max(screen.top(), screen.bottom() + 1 - height())));
}

void SimulatorWindow::showHand()
{
    m_hand->setText(m_view->controls().hand() == SimulatedHand::Left ? tr("The mouse moves the left controller.")
                                                                     : tr("The mouse moves the right controller."));
}

/// Keeps modal dialogs of the program visible: raises the dialog when it blocks this window, and raises this window
/// when the dialog closes.
bool SimulatorWindow::event(QEvent* event)
{
    if (event->type() == QEvent::WindowBlocked)
        QMetaObject::invokeMethod(this, &SimulatorWindow::showQuestion, Qt::QueuedConnection);
    if (event->type() == QEvent::WindowUnblocked && isVisible()) {
        raise();
        activateWindow();
    }
    return QWidget::event(event);
}

void SimulatorWindow::showQuestion()
{
    if (QWidget* question = QApplication::activeModalWidget()) {
        question->raise();
        question->activateWindow();
    }
}

void SimulatorWindow::closeEvent(QCloseEvent* event)
{
    event->accept();
    Q_EMIT closed();
}
} // namespace ui
