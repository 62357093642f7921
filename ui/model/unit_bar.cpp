#include "ui/model/unit_bar.h"

#include <QLocale>
#include <QPushButton>

namespace ui
{
namespace
{
struct UnitChoice
{
    const char* name;
    double millimetres;
    core::UnitDoubt guess; ///< doubt for which this unit is proposed; None: never proposed
    const char* question;
    const char* text;
    const char* tip;
};
constexpr UnitChoice units[] = {{"asMetres", 1000, core::UnitDoubt::Metres,
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "%1 is %2 units long. Is it in metres (%3 mm)?"),
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "As Me&tres"),
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "Makes the model 1000 times as large, as one step.")},
                                {"asInches", 25.4, core::UnitDoubt::Inches,
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "%1 is %2 units long. Is it in inches (%3 mm)?"),
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "As I&nches"),
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "Makes the model 25.4 times as large, as one step.")},
                                {"asCentimetres", 10, core::UnitDoubt::None, "",
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "As &Centimetres"),
                                 QT_TRANSLATE_NOOP("ui::UnitBar", "Makes the model 10 times as large, as one step.")}};
} // namespace

UnitBar::UnitBar(const Doubt& doubt, QMainWindow* window) : MessageBar("unitBar", tr("Unit of the Model"), window)
{
    const auto length = [&](double unit) {
        const double mm = unit * doubt.longest;
        return mm < 1000 ? QLocale().toString(mm, 'g', 3) : QLocale().toString(mm, 'f', 0);
    };
    for (const UnitChoice& unit : units)
        if (unit.guess == doubt.guess)
            setMessage("unitText", tr(unit.question).arg(shortened(doubt.name), length(1), length(unit.millimetres)),
                       doubt.name);
    for (const UnitChoice& unit : units) {
        QPushButton* button = addButton(unit.name, tr(unit.text), tr(unit.tip));
        button->setDefault(unit.guess == doubt.guess);
        connect(button, &QPushButton::clicked, this, [this, &unit] { Q_EMIT unitChosen(unit.millimetres); });
    }
    QPushButton* leaveButton =
        addButton("asMillimetres", tr("Le&ave as mm"), tr("Leaves the model as it is, and hides this bar."));
    connect(leaveButton, &QPushButton::clicked, this, &UnitBar::dismiss);
}
} // namespace ui
