#include "ui/parts/combination_card.h"

#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui
{
CombinationCard::CombinationCard(QWidget* view) : ViewCard(view, "combinationCard")
{
    setFocusPolicy(Qt::StrongFocus);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(gap, gap, gap, gap);
    auto *operations = new QHBoxLayout, *ends = new QHBoxLayout;
    rows->addLayout(operations);
    rows->addLayout(ends);
    const auto addOperation = [&](core::SetOperation operation, const char* name, const QString& text,
                                  const char* icon) {
        auto* button = named(new QToolButton, name, {}, text);
        button->setText(text);
        button->setIcon(themedIcon(QLatin1StringView(icon)));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setCheckable(true);
        button->setAutoExclusive(true);
        connect(button, &QToolButton::clicked, this, [this, operation] { Q_EMIT operationChosen(operation); });
        operations->addWidget(button);
        m_operations[static_cast<std::size_t>(operation)] = button;
    };
    addOperation(core::SetOperation::Union, "combinationJoin", tr("Join"), "part-union");
    addOperation(core::SetOperation::Difference, "combinationSubtract", tr("Subtract"), "part-subtract");
    addOperation(core::SetOperation::Intersection, "combinationIntersect", tr("Intersect"), "part-intersect");
    ends->addStretch();
    const auto addEnd = [&](const char* name, const QString& text, const QString& tip, auto signal) {
        auto* button = named(new QPushButton(text), name, tip);
        connect(button, &QPushButton::clicked, this, signal);
        ends->addWidget(button);
    };
    addEnd("combinationApply", tr("&Apply"), tr("Keeps what is shown, as one step (Return)."),
           &CombinationCard::applied);
    connect(this, &ViewCard::entered, this, &CombinationCard::applied);
    addEnd("combinationCancel", tr("&Cancel"), tr("Leaves the parts as they were (Esc)."), &CombinationCard::cancelled);
}

void CombinationCard::open(core::SetOperation operation)
{
    m_operations[static_cast<std::size_t>(operation)]->setChecked(true);
    setEnabled(true);
    show();
}

void CombinationCard::close()
{
    const QWidget* focus = QApplication::focusWidget();
    const bool hadFocus = isVisible() && focus && (focus == this || isAncestorOf(focus));
    hide();
    if (hadFocus)
        parentWidget()->setFocus();
}
} // namespace ui
