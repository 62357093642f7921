#include "ui/viewport/turntable_panel.h"

#include "ui/viewport/turntable.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/spacing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QSignalBlocker>

namespace ui
{
namespace
{
struct TurntablePanel
{
    Q_DECLARE_TR_FUNCTIONS(ui::TurntablePanel)
};

QCheckBox* makeSwitch(Turntable* turntable)
{
    auto* box =
        named(new QCheckBox(TurntablePanel::tr("The model turns")), "turns",
              TurntablePanel::tr("Turns the model under your hand. Hold still to cut a groove all around (T)."));
    QObject::connect(box, &QCheckBox::clicked, turntable, &Turntable::setOn);
    return box;
}

QComboBox* makeDirection(Turntable* turntable)
{
    auto* box = named(new QComboBox, "turnDirection", TurntablePanel::tr("Direction of the turn, seen from above."),
                      TurntablePanel::tr("Direction"));
    box->addItem(TurntablePanel::tr("Anticlockwise"));
    box->addItem(TurntablePanel::tr("Clockwise"));
    QObject::connect(box, &QComboBox::activated, turntable,
                     [turntable](int index) { turntable->setClockwise(index == 1); });
    return box;
}

QDoubleSpinBox* makeSpeed(Turntable* turntable)
{
    auto* box =
        named(new NumberField, "turnSpeed", TurntablePanel::tr("Speed in degrees per second; 360 are one turn."),
              TurntablePanel::tr("Speed"));
    box->setDecimals(0);
    box->setRange(minTurn, maxTurn);
    box->setSingleStep(10);
    box->setSuffix(TurntablePanel::tr(" °/s"));
    box->setKeyboardTracking(false);
    QObject::connect(box, &QDoubleSpinBox::valueChanged, turntable, &Turntable::setSpeed);
    return box;
}
} // namespace

void addTurntablePanel(SideColumn* column, Turntable* turntable)
{
    auto* content = new QWidget;
    content->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    auto* form = new QFormLayout(content);
    form->setContentsMargins(gap, gap, gap, gap);
    form->setSpacing(gap);

    QCheckBox* on = makeSwitch(turntable);
    QComboBox* direction = makeDirection(turntable);
    QDoubleSpinBox* speed = makeSpeed(turntable);
    form->addRow(on);
    form->addRow(TurntablePanel::tr("Direction"), direction);
    form->addRow(TurntablePanel::tr("Speed"), speed);
    const auto show = [=] {
        on->setChecked(turntable->isOn());
        direction->setCurrentIndex(turntable->isClockwise() ? 1 : 0);
        const QSignalBlocker quiet(speed);
        speed->setValue(turntable->speed());
    };
    QObject::connect(turntable, &Turntable::changed, content, show);
    show();
    column->add(QStringLiteral("turntablePanel"), TurntablePanel::tr("Turntable"), content);
}
} // namespace ui
