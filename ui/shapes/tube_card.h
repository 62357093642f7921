#pragma once

#include "core/operations/model_command.h"
#include "ui/widgets/view_card.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace ui
{
/// The numbers of a tube that is being drawn, and how it is combined with the model. Return applies. Thread: gui.
class TubeCard : public ViewCard
{
    Q_OBJECT

public:
    explicit TubeCard(QWidget* view);

    /// Shows the radius of the chosen point, mm. `problem`: why the tube cannot be made; empty: it can.
    void show(double radius, const QString& problem);
    core::Insert::Combination combination() const;
    /// Remembers the combination for the next time.
    void storeCombination() const;

Q_SIGNALS:
    /// The user has typed a radius, mm. `ofAll`: of every point.
    void radiusEntered(double radius, bool ofAll);
    void applied();
    void cancelled();

private:
    QDoubleSpinBox* m_radius;
    QComboBox* m_combination;
    QLabel* m_problem;
    QWidget* m_apply = nullptr;
};
} // namespace ui
