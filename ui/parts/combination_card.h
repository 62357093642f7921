#pragma once

#include "core/operations/model_command.h"
#include "ui/widgets/view_card.h"

#include <array>

class QAbstractButton;

namespace ui
{
/// The choice that goes with the preview of a combination of parts: another operation, to apply it (Return), or to
/// cancel it. Thread: gui.
class CombinationCard : public ViewCard
{
    Q_OBJECT

public:
    explicit CombinationCard(QWidget* view);

    /// Shows the card, and gives it the focus. `operation`: the one whose result is shown.
    void open(core::SetOperation operation);
    /// Hides the card, and gives the focus back to the view.
    void close();

Q_SIGNALS:
    /// The user wants to see the result of another operation. The card is disabled until open() or close().
    void operationChosen(core::SetOperation operation);
    void applied();
    void cancelled();

private:
    std::array<QAbstractButton*, 3> m_operations; ///< by core::SetOperation
};
} // namespace ui
