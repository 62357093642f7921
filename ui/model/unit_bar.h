#pragma once

#include "ui/widgets/message_bar.h"

#include "core/analysis/print_check.h"

namespace ui
{
/// Doubts that a model without a unit was made in millimetres, and offers others. Thread: gui.
class UnitBar : public MessageBar
{
    Q_OBJECT

public:
    struct Doubt
    {
        QString name;
        double longest = 0;                              ///< side of the model, as its file has it
        core::UnitDoubt guess = core::UnitDoubt::Inches; ///< not None
    };
    UnitBar(const Doubt& doubt, QMainWindow* window);

Q_SIGNALS:
    /// So many millimetres are one of the model's units.
    void unitChosen(double millimetres);
};
} // namespace ui
