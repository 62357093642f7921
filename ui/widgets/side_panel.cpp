#include "ui/widgets/side_panel.h"

#include "ui/widgets/panel_button.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int minLines = 12; ///< smallest height, in lines, of content that scrolls by itself

bool grows(const QWidget* content)
{
    const QSizePolicy::Policy policy = content->sizePolicy().verticalPolicy();
    return policy != QSizePolicy::Maximum && policy != QSizePolicy::Fixed;
}

/// Keeps its content at a usable height, below which no layout shrinks it.
class PanelBody : public QWidget
{
public:
    explicit PanelBody(QWidget* content) : m_content(content)
    {
        auto* rows = new QVBoxLayout(this);
        rows->setContentsMargins(0, 0, 0, 0);
        rows->addWidget(content);
    }

    QSize minimumSizeHint() const override
    {
        const QSize least = QWidget::minimumSizeHint(), whole = QWidget::sizeHint();
        const int height =
            grows(m_content) ? std::min(whole.height(), minLines * fontMetrics().lineSpacing()) : whole.height();
        return {least.width(), std::max(least.height(), height)};
    }

private:
    const QWidget* m_content;
};
} // namespace

SidePanel::SidePanel(const QString& name, const QString& title, QWidget* content)
    : m_header(new QToolButton)
    , m_headerRow(makeHeader(title))
    , m_body(new PanelBody(content))
    , m_grows(ui::grows(content))
    , m_toggle(new QAction(title, this))
{
    setObjectName(name);
    setWindowTitle(title);
    m_toggle->setCheckable(true);
    m_toggle->setChecked(true);
    connect(m_toggle, &QAction::triggered, this, [this](bool isShown) {
        if (isShown)
            bringForward();
        else
            setState(State::Hidden);
    });

    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_headerRow);
    rows->addWidget(m_body, 1);
    showFold();
}

QWidget* SidePanel::makeHeader(const QString& title)
{
    QFont bold = font();
    bold.setBold(true);
    m_header->setText(title);
    m_header->setFont(bold);
    m_header->setAutoRaise(true);
    m_header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_header->setFocusPolicy(Qt::TabFocus);
    m_header->setToolTip(tr("Folds or unfolds this panel. With Ctrl it stays open alone."));
    connect(m_header, &QToolButton::clicked, this, &SidePanel::clickHeader);
    auto* closing = panelButton({}, QStringLiteral("panel-close"), tr("Close"),
                                tr("Hides this panel. View › Panels brings it back."));
    closing->setFocusPolicy(Qt::TabFocus);
    closing->setIconSize({14, 14});
    connect(closing, &QToolButton::clicked, this, [this] { setState(State::Hidden); });

    auto* row = new QWidget;
    auto* cells = new QHBoxLayout(row);
    cells->setContentsMargins(0, 0, 0, 0);
    cells->setSpacing(0);
    cells->addWidget(m_header);
    cells->addWidget(closing);
    return row;
}

SidePanel::State SidePanel::state() const
{
    return isHidden() ? State::Hidden : m_body->isHidden() ? State::Folded : State::Open;
}

void SidePanel::setState(State state)
{
    if (state != State::Hidden) {
        m_body->setVisible(state == State::Open);
        showFold();
    }
    setVisible(state != State::Hidden);
}

void SidePanel::openBy(const QAction* action)
{
    setState(State::Hidden);
    connect(action, &QAction::triggered, this, &SidePanel::bringForward);
}

void SidePanel::bringForward()
{
    setState(State::Open);
    Q_EMIT broughtForward();
}

void SidePanel::clickHeader()
{
    const bool isAlone = QApplication::keyboardModifiers() & Qt::ControlModifier;
    if (isAlone)
        Q_EMIT soloRequested();
    if (isAlone || state() == State::Folded)
        bringForward();
    else
        setState(State::Folded);
}

void SidePanel::showFold()
{
    constexpr int most = 100; // stretch factor for the remaining height; the stretch below the panels has 1
    const bool isOpen = !m_body->isHidden();
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setVerticalStretch(isOpen && m_grows ? most : 0);
    setSizePolicy(policy);
    m_header->setArrowType(isOpen                                 ? Qt::DownArrow
                           : layoutDirection() == Qt::RightToLeft ? Qt::LeftArrow
                                                                  : Qt::RightArrow);
    m_header->setAccessibleDescription(isOpen ? tr("open") : tr("folded"));
}

bool SidePanel::event(QEvent* event)
{
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent)
        m_toggle->setChecked(!isHidden());
    return QWidget::event(event);
}

/// Shades the header's background.
void SidePanel::paintEvent(QPaintEvent*)
{
    QColor shade = palette().color(QPalette::WindowText);
    shade.setAlphaF(0.07F);
    QPainter(this).fillRect(m_headerRow->geometry(), shade);
}
} // namespace ui
