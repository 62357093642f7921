#include "ui/widgets/dialog_helpers.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui
{
QVBoxLayout* beginDialog(QDialog* dialog, const char* name, const QString& title)
{
    dialog->setObjectName(QLatin1StringView(name));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(dialogMargin, dialogMargin, dialogMargin, dialogMargin);
    column->setSpacing(dialogGap);
    column->setSizeConstraint(QLayout::SetFixedSize);
    return column;
}

QLabel* dialogText(const QString& sentences, int width)
{
    auto* label = new QLabel(sentences);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setFixedWidth(width);
    return label;
}

QPushButton* addDialogButtons(QDialog* dialog, const QString& verb)
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* accept = buttons->addButton(verb, QDialogButtonBox::AcceptRole);
    dialog->layout()->addWidget(buttons);
    accept->setDefault(true);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    return accept;
}
} // namespace ui
