#include "ui/classroom/waiting_works_dialog.h"

#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui
{
namespace
{
constexpr int waitingTextWidth = 460;
} // namespace

WaitingWorksDialog::WaitingWorksDialog(int works, const QString& problem, const QString& folder, QWidget* parent)
    : QDialog(parent)
{
    QVBoxLayout* column = beginDialog(this, "waitingWorks", tr("Models on This Computer"));
    column->addWidget(dialogText(tr("%n models are not yet in the class folder.", nullptr, works), waitingTextWidth));
    column->addWidget(dialogText(problem, waitingTextWidth));
    column->addWidget(dialogText(tr("They are safe in %1 and go to the class folder when this class begins on this "
                                    "computer again. You can copy them now, to a USB drive for example.")
                                     .arg(QDir::toNativeSeparators(folder)),
                                 waitingTextWidth));
    m_word = dialogText({}, waitingTextWidth);
    m_word->setObjectName(QStringLiteral("waitingWord"));
    column->addWidget(m_word);
    auto* buttons = new QDialogButtonBox;
    m_copy = named(buttons->addButton(tr("&Copy to a Folder…"), QDialogButtonBox::ActionRole), "copyWaiting");
    QPushButton* end = named(buttons->addButton(tr("&End Class"), QDialogButtonBox::AcceptRole), "endClass");
    column->addWidget(buttons);
    m_copy->setDefault(true);
    connect(m_copy, &QPushButton::clicked, this, &WaitingWorksDialog::chooseFolder);
    connect(end, &QPushButton::clicked, this, &QDialog::accept);
}

void WaitingWorksDialog::chooseFolder()
{
    askForFolder(this, QDir::homePath(), [this](const QString& folder) {
        m_copy->setEnabled(false);
        Q_EMIT copyRequested(folder);
    });
}

void WaitingWorksDialog::showCopied(const QString& sentence)
{
    m_word->setText(sentence);
    m_copy->setEnabled(true);
}
} // namespace ui
