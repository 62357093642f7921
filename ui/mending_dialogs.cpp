#include "mending_dialogs.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui
{
namespace
{
class MendingDialogs
{
    Q_DECLARE_TR_FUNCTIONS(ui::MendingDialogs)
};

constexpr int margin = 16, gap = 8; ///< of the window's spacing grid
constexpr int textWidth = 400;

QLabel* text(const QString& sentence)
{
    auto* label = new QLabel(sentence);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setFixedWidth(textWidth);
    return label;
}

QCheckBox* check(const char* name, const QString& label, bool isChecked)
{
    auto* box = new QCheckBox(label);
    box->setObjectName(QLatin1StringView(name));
    box->setChecked(isChecked);
    return box;
}
} // namespace

void askToMend(QWidget* parent, const QString& problem, const std::function<void(const core::LegaliseOptions& options)>& answer)
{
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(QStringLiteral("mendDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(MendingDialogs::tr("Mend the Model"));
    const core::LegaliseOptions defaults;
    auto* largeHoles = check("largeHoles", MendingDialogs::tr("Fill large holes, too: longer than a quarter of the model"), defaults.fillLargeHoles);
    auto* cavities = check("cavities", MendingDialogs::tr("Parts inside of others are cavities, not solid"), defaults.innerAreCavities);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* agree = buttons->addButton(MendingDialogs::tr("Mend and Open"), QDialogButtonBox::AcceptRole);

    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(gap);
    column->setSizeConstraint(QLayout::SetFixedSize);
    column->addWidget(text(problem));
    column->addWidget(text(MendingDialogs::tr("Fettle can mend it: holes are filled, faces turned outwards, and parts that "
                                              "intersect become one. You will see what changed. The file stays as it is.")));
    column->addSpacing(gap);
    column->addWidget(largeHoles);
    column->addWidget(cavities);
    column->addSpacing(gap);
    column->addWidget(buttons);
    agree->setDefault(true);
    agree->setFocus();

    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(dialog, &QDialog::accepted, dialog, [answer, largeHoles, cavities] {
        answer({.fillLargeHoles = largeHoles->isChecked(), .innerAreCavities = cavities->isChecked()});
    });
    dialog->open();
}

void showMended(QWidget* parent, const QString& name, const QStringList& steps)
{
    auto* dialog = new QMessageBox(QMessageBox::Information, MendingDialogs::tr("Fettle"),
                                   MendingDialogs::tr("%1 was mended. It has no file of its own until you save it.").arg(name),
                                   QMessageBox::Ok, parent);
    dialog->setObjectName(QStringLiteral("mendedDialog"));
    dialog->setTextFormat(Qt::PlainText);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInformativeText(steps.join(QLatin1Char('\n')));
    dialog->open();
}
} // namespace ui
