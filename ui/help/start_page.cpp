#include "ui/help/start_page.h"

#include "ui/actions/actions.h"
#include "ui/files/recent_files.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/settings/settings.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QSize pictureSize{150, 100}, starterSize{64, 64};
constexpr int starterWidth = 84, recentWidth = 260;
/// Heights of the list in pixels. It shrinks to the smallest height before the page gets a scroll bar.
constexpr int minRecentHeight = 72, recentHeight = 160;

QLabel* heading(const QString& text)
{
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

QToolButton* tile(QSize icon)
{
    auto* button = new QToolButton;
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(icon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}
} // namespace

StartPage::StartPage(const Actions& actions, Settings* settings, QWidget* over)
    : QFrame(over->window())
    , m_actions(actions)
    , m_settings(settings)
    , m_over(over)
    , m_area(new QScrollArea)
    , m_recent(new RecentFiles(settings))
    , m_lessonsHead(heading(tr("Three short lessons")))
    , m_lessons(new QHBoxLayout)
{
    setObjectName(QStringLiteral("startPage"));
    setAccessibleName(tr("Start page"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(m_area);
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(3 * gap, 2 * gap, 3 * gap, 2 * gap);
    grid->setHorizontalSpacing(3 * gap);
    grid->setVerticalSpacing(gap);
    grid->addLayout(head(), 0, 0, 1, 2);
    grid->addWidget(heading(tr("Begin with")), 1, 0, 1, 2);
    grid->addLayout(starters(), 2, 0, 1, 2);
    grid->setRowMinimumHeight(3, gap);
    grid->addWidget(heading(tr("Recent files")), 4, 0);
    grid->addWidget(m_lessonsHead, 4, 1);
    grid->addLayout(recent(), 5, 0);
    grid->addLayout(m_lessons, 5, 1);
    grid->addLayout(foot(), 6, 0, 1, 2);
    m_lessons->setSpacing(gap);
    m_lessonsHead->hide();
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setWidgetResizable(true);
    m_area->setWidget(content);
    over->installEventFilter(this);
    over->window()->installEventFilter(this);
    hide();
}

QLayout* StartPage::head()
{
    auto* icon = new QLabel;
    icon->setPixmap(QIcon(QStringLiteral(":/icons/fettle.svg")).pixmap(40, 40));
    auto* title = new QLabel(tr("What will you make?"));
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 1.6);
    title->setFont(font);
    auto* closing = named(new QToolButton, "startClose");
    closing->setIcon(themedIcon(QStringLiteral("panel-close")));
    closing->setAutoRaise(true);
    closing->setFocusPolicy(Qt::StrongFocus);
    closing->setAccessibleName(tr("Close"));
    closing->setToolTip(tr("Starts with the ball of clay. (Esc)"));
    connect(closing, &QToolButton::clicked, this, &StartPage::close);
    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    row->addWidget(icon);
    row->addWidget(title, 1);
    row->addWidget(closing, 0, Qt::AlignTop);
    return row;
}

QLayout* StartPage::starters()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    for (const ActionInfo& info : actionTable()) {
        if (info.menu != MenuId::New)
            continue;
        QAction* action = m_actions.get(QLatin1StringView(info.id));
        QToolButton* button = tile(starterSize);
        button->setDefaultAction(action);
        button->setObjectName(QStringLiteral("start.") + action->objectName());
        button->setMinimumWidth(starterWidth);
        connect(action, &QAction::triggered, this, &StartPage::close);
        row->addWidget(button, 1);
    }
    return row;
}

QLayout* StartPage::recent()
{
    named(m_recent, "startRecent", tr("Opens a model that was open before."), tr("Recent files"));
    m_recent->setFixedWidth(recentWidth);
    m_recent->setMinimumHeight(minRecentHeight);
    m_recent->setMaximumHeight(recentHeight);
    connect(m_recent, &RecentFiles::chosen, this, [this](const QString& path) {
        close();
        Q_EMIT fileChosen(path);
    });
    auto* opening = named(new QPushButton(m_actions.get(QStringLiteral("file.open"))->text()), "startOpen",
                          m_actions.get(QStringLiteral("file.open"))->toolTip());
    connect(opening, &QPushButton::clicked, this, [this] {
        close();
        m_actions.get(QStringLiteral("file.open"))->trigger();
    });
    auto* column = new QVBoxLayout;
    column->setSpacing(gap);
    column->addWidget(m_recent);
    column->addWidget(opening, 0, Qt::AlignLeft);
    return column;
}

void StartPage::setLessons(const QList<LessonCard>& lessons)
{
    for (const LessonCard& card : lessons) {
        QToolButton* button = tile(pictureSize);
        button->setObjectName(QStringLiteral("start.lesson.") + card.name);
        button->setIcon(QPixmap::fromImage(card.picture));
        button->setText(card.title);
        button->setToolTip(card.summary);
        connect(button, &QToolButton::clicked, this, [this, name = card.name] {
            close();
            Q_EMIT lessonChosen(name);
        });
        m_lessons->addWidget(button, 1, Qt::AlignTop);
    }
    m_lessonsHead->setVisible(!lessons.isEmpty());
}

QLayout* StartPage::foot()
{
    auto* atStart = named(new QCheckBox(tr("&Show this page at start")), "startAlways",
                          tr("Otherwise Fettle starts with a ball of clay; Help › Start Page brings this page back."));
    const auto applySettings = [this, atStart] { atStart->setChecked(m_settings->get(&Setting::showsStartPage)); };
    applySettings();
    m_settings->onReset(applySettings);
    connect(atStart, &QCheckBox::clicked, this,
            [this](bool shows) { m_settings->set(&Setting::showsStartPage, shows); });
    auto* guide = named(new QPushButton(m_actions.get(QStringLiteral("help.guide"))->text()), "startGuide",
                        m_actions.get(QStringLiteral("help.guide"))->toolTip());
    connect(guide, &QPushButton::clicked, this, &StartPage::guideRequested);
    auto* row = new QHBoxLayout;
    row->addWidget(atStart, 1);
    row->addWidget(guide);
    return row;
}

void StartPage::open()
{
    m_recent->fill();
    place();
    show();
    raise();
    findChild<QToolButton*>(QStringLiteral("start.new.ball"))->setFocus();
}

void StartPage::close()
{
    if (isHidden())
        return;
    hide();
    m_over->setFocus();
}

/// Centres the page in the view. If the view is too narrow, the page extends over its neighbours.
void StartPage::place()
{
    const QRect view(m_over->mapTo(window(), QPoint()), m_over->size());
    const QWidget* content = m_area->widget();
    QSize whole = content->sizeHint() + QSize(2 * frameWidth(), 2 * frameWidth());
    if (content->minimumSizeHint().height() + 2 * frameWidth() > view.height())
        whole.rwidth() += m_area->verticalScrollBar()->sizeHint().width();
    resize(whole.boundedTo({window()->width() - 2 * gap, view.height()}));
    QPoint corner = view.center() - rect().center();
    corner.setX(std::clamp(corner.x(), gap, std::max(gap, window()->width() - gap - width())));
    move(corner);
}

/// Closes the page on Esc. Handles ShortcutOverride too, because Esc is a shortcut of the action Stop.
bool StartPage::event(QEvent* event)
{
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return QFrame::event(event);
    event->accept();
    if (event->type() == QEvent::KeyPress)
        close();
    return true;
}

bool StartPage::eventFilter(QObject* watched, QEvent* event)
{
    const bool isEscape = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (event->type() == QEvent::Resize && isVisible())
        place();
    else if (watched != m_over)
        return QFrame::eventFilter(watched, event);
    else if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::TabletPress ||
             event->type() == QEvent::TouchBegin || isEscape)
        close();
    return QFrame::eventFilter(watched, event);
}
} // namespace ui
