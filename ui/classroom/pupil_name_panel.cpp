#include "ui/classroom/pupil_name_panel.h"

#include "ui/actions/actions.h"
#include "ui/classroom/classroom.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui
{
namespace
{
constexpr QSize starterSize{64, 64};
constexpr int starterWidth = 84, nameWidth = 320;
constexpr double titleScale = 1.6;
} // namespace

PupilNamePanel::PupilNamePanel(const QList<core::Starter>& starters, const Actions& actions, QWidget* over)
    : CoverPanel(over)
    , m_name(new QLineEdit)
    , m_starters(new QButtonGroup(this))
    , m_begin(new QPushButton(tr("&Begin")))
{
    setObjectName(QStringLiteral("namePanel"));
    setAccessibleName(tr("The next turn"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(card(starters, actions), 0, Qt::AlignCenter);
}

QWidget* PupilNamePanel::card(const QList<core::Starter>& starters, const Actions& actions)
{
    auto* title = new QLabel(tr("Whose turn is it?"));
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * titleScale);
    title->setFont(font);
    named(m_name, "pupilName", {}, tr("Name"));
    m_name->setPlaceholderText(tr("Name or nickname"));
    m_name->setMaxLength(maxNameLength);
    m_name->setMinimumWidth(nameWidth);
    named(m_begin, "beginTurn", tr("Begins the turn. (Return)"));
    m_begin->setDefault(true);
    connect(m_name, &QLineEdit::textChanged, m_begin,
            [this](const QString& text) { m_begin->setEnabled(!text.trimmed().isEmpty()); });
    connect(m_name, &QLineEdit::returnPressed, this, &PupilNamePanel::begin);
    connect(m_begin, &QPushButton::clicked, this, &PupilNamePanel::begin);

    auto* panel = new QFrame;
    panel->setFrameShape(QFrame::StyledPanel);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(3 * gap, 2 * gap, 3 * gap, 2 * gap);
    column->setSpacing(2 * gap);
    column->addWidget(title);
    column->addWidget(m_name);
    column->addLayout(tiles(starters, actions));
    column->addWidget(m_begin, 0, Qt::AlignRight);
    return panel;
}

/// Of one there is nothing to choose.
QLayout* PupilNamePanel::tiles(const QList<core::Starter>& starters, const Actions& actions)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    for (const core::Starter starter : starters) {
        const QAction* action = actions.get(QStringLiteral("new.") + QString::fromUtf8(core::name(starter)));
        auto* tile = named(new QToolButton, QStringLiteral("turn.") + action->objectName());
        tile->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        tile->setIcon(action->icon());
        tile->setIconSize(starterSize);
        tile->setText(action->iconText());
        tile->setToolTip(action->statusTip());
        tile->setCheckable(true);
        tile->setMinimumWidth(starterWidth);
        tile->setFocusPolicy(Qt::StrongFocus);
        tile->setVisible(starters.size() > 1);
        m_starters->addButton(tile, static_cast<int>(starter));
        row->addWidget(tile, 1);
    }
    return row;
}

void PupilNamePanel::open()
{
    m_name->clear();
    m_begin->setEnabled(false);
    m_starters->buttons().constFirst()->setChecked(true);
    cover();
    m_name->setFocus();
}

void PupilNamePanel::begin()
{
    const QString name = m_name->text().simplified();
    if (!name.isEmpty())
        Q_EMIT begun(name, static_cast<core::Starter>(m_starters->checkedId()));
}
} // namespace ui
