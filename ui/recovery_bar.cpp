#include "recovery_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>

namespace ui
{
namespace
{
constexpr int gap = 8; ///< of the window's spacing grid
constexpr int mostNameWidth = 240;
} // namespace

RecoveryBar::RecoveryBar(const Unsaved& unsaved, QMainWindow* window)
    : QToolBar(tr("Unsaved Model"), window), m_name(fontMetrics().elidedText(unsaved.name, Qt::ElideMiddle, mostNameWidth))
{
    setObjectName(QStringLiteral("recoveryBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false); // it is not one of those that a person hides and shows
    setContextMenuPolicy(Qt::PreventContextMenu);
    const QString time = QLocale().toString(unsaved.changed, QLocale::ShortFormat);
    auto* words = new QLabel(tr("%1 was not saved when Fettle ended: %2, %3.").arg(m_name, tr("%Ln steps", nullptr, unsaved.steps), time));
    words->setObjectName(QStringLiteral("recoveryText"));
    words->setTextFormat(Qt::PlainText);
    words->setToolTip(unsaved.name);
    words->setContentsMargins(gap, 0, gap, 0);
    words->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(words);
    addButton("recover", tr("Rec&over"), tr("Opens it as it was, with its steps to undo and do again."), &RecoveryBar::recoverRequested);
    addButton("discardRecovery", tr("&Discard…"), tr("Removes what was kept of it, after a question."), &RecoveryBar::askToDiscard);
    addButton("recoverLater", tr("&Later"), tr("Hides this bar; the next start offers it again."), &RecoveryBar::leave);
    window->addToolBarBreak();
    window->addToolBar(this);
}

void RecoveryBar::addButton(const char* name, const QString& text, const QString& tip, void (RecoveryBar::*what)())
{
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1StringView(name));
    button->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, what);
    auto* cell = new QWidget;
    auto* row = new QHBoxLayout(cell);
    row->setContentsMargins(0, gap / 2, gap, gap / 2);
    row->addWidget(button);
    addWidget(cell);
}

void RecoveryBar::leave()
{
    hide();
    deleteLater();
}

void RecoveryBar::askToDiscard()
{
    auto* question = new QMessageBox(QMessageBox::Question, tr("Fettle"), tr("Should the unsaved changes to %1 be removed for good?").arg(m_name),
                                     QMessageBox::Cancel, this);
    question->setObjectName(QStringLiteral("discardRecoveryQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setTextFormat(Qt::PlainText);
    QPushButton* remove = question->addButton(tr("&Remove"), QMessageBox::DestructiveRole);
    connect(remove, &QPushButton::clicked, this, &RecoveryBar::discardRequested);
    question->setDefaultButton(QMessageBox::Cancel);
    question->open();
}
} // namespace ui
