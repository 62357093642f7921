#include "ui/model/command_dialog.h"

#include "ui/settings/settings.h"
#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QRadioButton>

namespace ui
{
namespace
{
using Combination = core::Insert::Combination;

constexpr int explanationWidth = 320; ///< pixels

/// Combinations in the order of InsertUse.
constexpr Combination combinations[] = {Combination::Part, Combination::Join, Combination::Subtract,
                                        Combination::Intersect, Combination::Apart};
} // namespace

Number millimetreField(double value, double min, double max)
{
    return {value, min, max, 3, ModelDialogs::tr(" mm")};
}

CommandDialog::CommandDialog(QWidget* parent, const char* name, const QString& title, const QString& sentence)
    : QDialog(parent)
    , m_form(new QFormLayout)
{
    QVBoxLayout* column = beginDialog(this, name, title);
    column->setSpacing(dialogMargin);
    column->addWidget(dialogText(sentence, explanationWidth));
    column->addLayout(m_form);
    m_form->setSpacing(dialogGap);
}

QDoubleSpinBox* CommandDialog::addNumber(const char* name, const QString& label, const Number& number)
{
    auto* box = named(new NumberField, name);
    box->setDecimals(number.decimals);
    box->setRange(number.min, number.max);
    box->setValue(number.value);
    box->setSuffix(number.unit);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setMinimumWidth(explanationWidth / 2);
    m_form->addRow(label, box);
    return box;
}

QButtonGroup* CommandDialog::addChoice(const QString& label, const QStringList& choices)
{
    auto* group = new QButtonGroup(this);
    for (qsizetype i = 0; i < choices.size(); ++i) {
        auto* button = new QRadioButton(choices[i]);
        button->setObjectName(QStringLiteral("choice%1").arg(i));
        button->setChecked(i == 0);
        group->addButton(button, static_cast<int>(i));
        m_form->addRow(i == 0 ? label : QString(), button);
    }
    return group;
}

QComboBox* CommandDialog::addList(const char* name, const QString& label, const QStringList& choices)
{
    auto* box = named(new QComboBox, name);
    box->addItems(choices);
    m_form->addRow(label, box);
    return box;
}

QLabel* CommandDialog::addText(const QString& sentence)
{
    QLabel* label = dialogText(sentence, explanationWidth);
    layout()->addWidget(label);
    return label;
}

QPushButton* CommandDialog::openWith(const QString& verb)
{
    QPushButton* button = addDialogButtons(this, verb);
    open();
    return button;
}

core::Vec3 Coordinates::value() const
{
    return {x->value(), y->value(), z->value()};
}

void Coordinates::setValue(const core::Vec3& value) const
{
    x->setValue(value.x());
    y->setValue(value.y());
    z->setValue(value.z());
}

void Coordinates::setEnabled(bool enabled) const
{
    for (QDoubleSpinBox* box : {x, y, z})
        box->setEnabled(enabled);
}

Coordinates addCoordinates(CommandDialog* dialog)
{
    return {dialog->addNumber("x", ModelDialogs::tr("X, to the right"), millimetreField(0)),
            dialog->addNumber("y", ModelDialogs::tr("Y, upwards"), millimetreField(0)),
            dialog->addNumber("z", ModelDialogs::tr("Z, to the front"), millimetreField(0))};
}

void fillCombinations(QComboBox* list)
{
    list->addItems({ModelDialogs::tr("As a part of its own"), ModelDialogs::tr("Join"), ModelDialogs::tr("Subtract"),
                    ModelDialogs::tr("Intersect"), ModelDialogs::tr("In the same part, without touching")});
    static_assert(insertUses.size() == std::size(combinations));
    list->setCurrentIndex(static_cast<int>(Settings().get(&Setting::insertUse)));
}

void storeCombination(const QComboBox* list)
{
    Settings().set(&Setting::insertUse, static_cast<InsertUse>(list->currentIndex()));
}

QComboBox* addCombinations(CommandDialog* dialog)
{
    QComboBox* list = dialog->addList("combine", ModelDialogs::tr("Combine"), {});
    fillCombinations(list);
    QObject::connect(dialog, &QDialog::accepted, list, [list] { storeCombination(list); });
    return list;
}

core::Insert::Combination combinationOf(const QComboBox* list)
{
    return combinations[list->currentIndex()];
}

bool needsOverlap(const QComboBox* list)
{
    return combinationOf(list) != Combination::Part && combinationOf(list) != Combination::Apart;
}
} // namespace ui
