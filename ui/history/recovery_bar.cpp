#include "ui/history/recovery_bar.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace ui
{
RecoveryBar::RecoveryBar(const UnsavedModel& unsaved, QMainWindow* window)
    : MessageBar("recoveryBar", tr("Unsaved Model"), window)
    , m_name(shortened(unsaved.name))
{
    const QString time = QLocale().toString(unsaved.changed, QLocale::ShortFormat);
    setMessage("recoveryText",
               tr("Unsaved changes to %1 can be recovered: %2, %3.")
                   .arg(m_name, tr("%Ln steps", nullptr, unsaved.steps), time),
               unsaved.name);
    const auto add = [this](const char* name, const QString& text, const QString& tip, void (RecoveryBar::*what)()) {
        QPushButton* button = addButton(name, text, tip);
        connect(button, &QPushButton::clicked, this, what);
        return button;
    };
    QPushButton* recover = add("recover", tr("Rec&over"), tr("Opens the model as it was, with its history."),
                               &RecoveryBar::recoverRequested);
    recover->setDefault(true);
    add("discardRecovery", tr("&Discard…"), tr("Deletes these changes, after a question."), &RecoveryBar::askToDiscard);
    add("recoverLater", tr("&Later"), tr("Hides this bar; the next start offers it again."), &RecoveryBar::dismiss);
}

void RecoveryBar::askToDiscard()
{
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Fettle"),
                        tr("Permanently delete the unsaved changes to %1?").arg(m_name), QMessageBox::Cancel, this);
    question->setObjectName(QStringLiteral("discardRecoveryQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setTextFormat(Qt::PlainText);
    QPushButton* remove = question->addButton(tr("&Remove"), QMessageBox::DestructiveRole);
    connect(remove, &QPushButton::clicked, this, &RecoveryBar::discardRequested);
    question->setDefaultButton(QMessageBox::Cancel);
    question->open();
}
} // namespace ui
