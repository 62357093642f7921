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
/// Joins lines, with no-break spaces before the unit mm.
QString joined(const QStringList& lines)
{
    return lines.join(QLatin1Char('\n')).replace(QStringLiteral(" mm"), QStringLiteral("\u00A0mm"));
}
} // namespace

void askToRepair(QWidget* parent, RepairUse use, const QString& problem,
                 const std::function<void(const core::RepairOptions& options)>& callback)
{
    auto* dialog = new QDialog(parent);
    QVBoxLayout* column = beginDialog(dialog, "mendDialog", RepairDialogs::tr("Repair the Model"));
    const core::RepairOptions defaults;
    auto* largeHoles =
        check("largeHoles", RepairDialogs::tr("Also fill large holes (over a quarter of the model's size)"),
              defaults.fillLargeHoles);
    auto* cavities =
        check("cavities", RepairDialogs::tr("Treat enclosed parts as cavities"), defaults.innerAreCavities);
    column->addWidget(dialogText(problem, textWidth));
    column->addWidget(
        dialogText(RepairDialogs::tr("Fettle can repair it: it fills holes, turns faces outwards and joins parts that "
                                     "intersect. You will see what changed. The file stays as it is."),
                   textWidth));
    column->addSpacing(dialogGap);
    column->addWidget(largeHoles);
    column->addWidget(cavities);
    column->addSpacing(dialogGap);
    addDialogButtons(dialog, use == RepairUse::Opening ? RepairDialogs::tr("Repair and Open")
                                                       : RepairDialogs::tr("Repair and Insert"))
        ->setFocus();

    QObject::connect(dialog, &QDialog::accepted, dialog, [callback, largeHoles, cavities] {
        callback({.fillLargeHoles = largeHoles->isChecked(),
                  .innerAreCavities = cavities->isChecked(),
                  .canWrap = true}); // askToAccept() then asks about losses
    });
    dialog->open();
}

void askToAccept(QWidget* parent, const RepairDoubt& doubt, const std::function<void()>& callback)
{
    auto* dialog = new QDialog(parent);
    QVBoxLayout* column = beginDialog(dialog, "repairDoubtDialog", RepairDialogs::tr("Repaired, but Changed"));
    column->addWidget(dialogText(doubt.problem, textWidth));
    auto* pictures = new QGridLayout;
    int place = 0;
    for (const auto& [title, picture] : {std::pair(RepairDialogs::tr("In the file"), doubt.before),
                                         std::pair(RepairDialogs::tr("Repaired"), doubt.after)}) {
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
    const QString what =
        use == RepairUse::Opening
            ? RepairDialogs::tr("%1 was repaired. Save to keep the repaired model; the original file stays as it is.")
            : RepairDialogs::tr("%1 was repaired and inserted. Undo reverts both.");
    auto* dialog =
        new QMessageBox(QMessageBox::Information, RepairDialogs::tr("Fettle"), what.arg(name), QMessageBox::Ok, parent);
    dialog->setObjectName(QStringLiteral("mendedDialog"));
    dialog->setTextFormat(Qt::PlainText);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInformativeText(joined(steps));
    dialog->open();
}
} // namespace ui
