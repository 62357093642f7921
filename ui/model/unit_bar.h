#pragma once

#include "ui/widgets/message_bar.h"

#include "core/print/print_check.h"

namespace ui
{
/// A bar that asks whether a model without a unit is really in millimetres, and offers other units. Thread: gui.
class UnitBar : public MessageBar
{
    Q_OBJECT

public:
    struct Doubt
    {
        QString name;
        double longest = 0;                              ///< longest side of the model, in units of the file
        core::UnitDoubt guess = core::UnitDoubt::Inches; ///< not None
    };
    UnitBar(const Doubt& doubt, QMainWindow* window);

Q_SIGNALS:
    /// The user has chosen a unit. `millimetres`: mm for each unit of the file.
    void unitChosen(double millimetres);
};
} // namespace ui
