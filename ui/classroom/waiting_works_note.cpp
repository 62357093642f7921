#include "ui/classroom/waiting_works_note.h"

#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"

#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui
{
WaitingWorksNote::WaitingWorksNote(int width)
    : m_waiting(dialogText({}, width))
    , m_outcome(dialogText({}, width))
    , m_move(named(new QPushButton(tr("Mo&ve to a Folder…")), "moveWaiting",
                   tr("Moves each waiting model, in its own folder, to the folder that you choose.")))
{
    m_waiting->setObjectName(QStringLiteral("waitingModels"));
    m_outcome->setObjectName(QStringLiteral("movedModels"));
    m_move->setAutoDefault(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(dialogGap);
    column->addWidget(m_waiting);
    column->addWidget(m_move, 0, Qt::AlignLeft);
    column->addWidget(m_outcome);
    connect(m_move, &QPushButton::clicked, this, &WaitingWorksNote::chooseFolder);
    hide();
}

void WaitingWorksNote::setWaiting(const QString& sentences, const QString& outcome)
{
    m_waiting->setText(sentences);
    m_waiting->setVisible(!sentences.isEmpty());
    m_move->setVisible(!sentences.isEmpty());
    m_move->setEnabled(true);
    m_outcome->setText(outcome);
    m_outcome->setVisible(!outcome.isEmpty());
    setVisible(!sentences.isEmpty() || !outcome.isEmpty());
}

void WaitingWorksNote::chooseFolder()
{
    askForFolder(this, QDir::homePath(), [this](const QString& folder) {
        m_move->setEnabled(false);
        Q_EMIT moveRequested(folder);
    });
}
} // namespace ui
