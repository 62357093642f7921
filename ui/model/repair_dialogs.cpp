#include "ui/model/repair_dialogs.h"

#include "ui/widgets/dialog_helpers.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
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

constexpr int textWidth = 400;

QCheckBox* check(const char* name, const QString& label, bool isChecked)
{
    auto* box = new QCheckBox(label);
    box->setObjectName(QLatin1StringView(name));
    box->setChecked(isChecked);
    return box;
}
} // namespace

void askToMend(QWidget* parent, MendFor use, const QString& problem,
               const std::function<void(const core::RepairOptions& options)>& answer)
{
    auto* dialog = new QDialog(parent);
    QVBoxLayout* column = beginDialog(dialog, "mendDialog", MendingDialogs::tr("Mend the Model"));
    const core::RepairOptions defaults;
    auto* largeHoles =
        check("largeHoles", MendingDialogs::tr("Fill large holes, too: longer than a quarter of the model"),
              defaults.fillLargeHoles);
    auto* cavities = check("cavities", MendingDialogs::tr("Parts inside of others are cavities, not solid"),
                           defaults.innerAreCavities);
    column->addWidget(dialogText(problem, textWidth));
    column->addWidget(
        dialogText(MendingDialogs::tr("Fettle can mend it: holes are filled, faces turned outwards, and parts that "
                                      "intersect become one. You will see what changed. The file stays as it is."),
                   textWidth));
    column->addSpacing(dialogGap);
    column->addWidget(largeHoles);
    column->addWidget(cavities);
    column->addSpacing(dialogGap);
    addAnswers(dialog,
               use == MendFor::Opening ? MendingDialogs::tr("Mend and Open") : MendingDialogs::tr("Mend and Insert"))
        ->setFocus();

    QObject::connect(dialog, &QDialog::accepted, dialog, [answer, largeHoles, cavities] {
        answer({.fillLargeHoles = largeHoles->isChecked(), .innerAreCavities = cavities->isChecked()});
    });
    dialog->open();
}

void showMended(QWidget* parent, MendFor use, const QString& name, const QStringList& steps)
{
    const QString what = use == MendFor::Opening
                             ? MendingDialogs::tr("%1 was mended. It has no file of its own until you save it.")
                             : MendingDialogs::tr("%1 was mended and inserted. Undo takes both back.");
    auto* dialog = new QMessageBox(QMessageBox::Information, MendingDialogs::tr("Fettle"), what.arg(name),
                                   QMessageBox::Ok, parent);
    dialog->setObjectName(QStringLiteral("mendedDialog"));
    dialog->setTextFormat(Qt::PlainText);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const QString lines = steps.join(QLatin1Char('\n'));
    dialog->setInformativeText(
        QString(lines).replace(QStringLiteral(" mm"), QStringLiteral("\u00A0mm"))); // no line ends before its unit
    dialog->open();
}
} // namespace ui
