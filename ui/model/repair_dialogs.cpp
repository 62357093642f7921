#include "ui/model/repair_dialogs.h"

#include "ui/widgets/dialog_helpers.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui
{
namespace
{
class RepairDialogs
{
    Q_DECLARE_TR_FUNCTIONS(ui::RepairDialogs)
};

constexpr int textWidth = 400;

QCheckBox* check(const char* name, const QString& label, bool isChecked)
{
    auto* box = new QCheckBox(label);
    box->setObjectName(QLatin1StringView(name));
    box->setChecked(isChecked);
    return box;
}
/// Lines, none of which ends before its unit.
QString joined(const QStringList& lines)
{
    return lines.join(QLatin1Char('\n')).replace(QStringLiteral(" mm"), QStringLiteral("\u00A0mm"));
}
} // namespace

void askToRepair(QWidget* parent, RepairUse use, const QString& problem,
                 const std::function<void(const core::RepairOptions& options)>& callback)
{
    auto* dialog = new QDialog(parent);
    QVBoxLayout* column = beginDialog(dialog, "mendDialog", RepairDialogs::tr("Mend the Model"));
    const core::RepairOptions defaults;
    auto* largeHoles =
        check("largeHoles", RepairDialogs::tr("Fill large holes, too: longer than a quarter of the model"),
              defaults.fillLargeHoles);
    auto* cavities = check("cavities", RepairDialogs::tr("Parts inside of others are cavities, not solid"),
                           defaults.innerAreCavities);
    column->addWidget(dialogText(problem, textWidth));
    column->addWidget(
        dialogText(RepairDialogs::tr("Fettle can mend it: holes are filled, faces turned outwards, and parts that "
                                     "intersect become one. You will see what changed. The file stays as it is."),
                   textWidth));
    column->addSpacing(dialogGap);
    column->addWidget(largeHoles);
    column->addWidget(cavities);
    column->addSpacing(dialogGap);
    addDialogButtons(dialog, use == RepairUse::Opening ? RepairDialogs::tr("Mend and Open")
                                                       : RepairDialogs::tr("Mend and Insert"))
        ->setFocus();

    QObject::connect(dialog, &QDialog::accepted, dialog, [callback, largeHoles, cavities] {
        callback({.fillLargeHoles = largeHoles->isChecked(),
                  .innerAreCavities = cavities->isChecked(),
                  .canWrap = true}); // askToAccept() follows
    });
    dialog->open();
}

void askToAccept(QWidget* parent, const RepairDoubt& doubt, const std::function<void()>& callback)
{
    auto* dialog = new QDialog(parent);
    QVBoxLayout* column = beginDialog(dialog, "repairDoubtDialog", RepairDialogs::tr("Mended, But Not the Same"));
    column->addWidget(dialogText(doubt.problem, textWidth));
    auto* pictures = new QGridLayout;
    int place = 0;
    for (const auto& [title, picture] : {std::pair(RepairDialogs::tr("In the file"), doubt.before),
                                         std::pair(RepairDialogs::tr("Mended"), doubt.after)}) {
        auto* label = new QLabel;
        label->setPixmap(QPixmap::fromImage(picture));
        label->setAccessibleName(title);
        pictures->addWidget(label, 0, place, Qt::AlignHCenter);
        pictures->addWidget(new QLabel(title), 1, place++, Qt::AlignHCenter);
    }
    column->addLayout(pictures);
    column->addWidget(dialogText(joined(doubt.losses), textWidth));
    column->addSpacing(dialogGap);
    addDialogButtons(dialog, doubt.use == RepairUse::Opening ? RepairDialogs::tr("Open This")
                                                             : RepairDialogs::tr("Insert This"));
    QObject::connect(dialog, &QDialog::accepted, dialog, callback);
    dialog->open();
}

void showRepaired(QWidget* parent, RepairUse use, const QString& name, const QStringList& steps)
{
    const QString what = use == RepairUse::Opening
                             ? RepairDialogs::tr("%1 was mended. It has no file of its own until you save it.")
                             : RepairDialogs::tr("%1 was mended and inserted. Undo takes both back.");
    auto* dialog =
        new QMessageBox(QMessageBox::Information, RepairDialogs::tr("Fettle"), what.arg(name), QMessageBox::Ok, parent);
    dialog->setObjectName(QStringLiteral("mendedDialog"));
    dialog->setTextFormat(Qt::PlainText);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInformativeText(joined(steps));
    dialog->open();
}
} // namespace ui
