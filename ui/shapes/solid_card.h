#pragma once

#include "core/operations/model_command.h"
#include "ui/widgets/view_card.h"

#include <array>
#include <optional>
#include <utility>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace ui
{
/// The measures and the place of a solid that is being placed in the view, and how it is combined with the model.
/// Return applies. Thread: gui.
class SolidCard : public ViewCard
{
    Q_OBJECT

public:
    explicit SolidCard(QWidget* view);

    /// Returns the insertion that the numbers stand for.
    core::Insert insertion() const;
    /// Sets the measures of the chosen kind to those of a solid that is `size` wide on either side of its axis, mm.
    void setSize(double size);
    /// Puts the solid on a surface: the middle of its base at `point` (mm), its axis along the document's axis that is
    /// nearest to the normal. The base stays there when a measure changes, until a coordinate is typed.
    void putOn(const core::Vec3& point, const core::Vec3& normal);
    /// Moves the middle so that the base is where putOn() has put it.
    void keepBase();
    /// Shows the card, and why the solid cannot be made; an empty text: it can.
    void show(const QString& problem);
    /// Remembers the combination for the next time.
    void storeCombination() const;

Q_SIGNALS:
    /// The user has changed a number or a choice.
    void edited();
    void applied();
    void cancelled();

private:
    QDoubleSpinBox* makeNumber(const QString& name, const QString& label, double least);
    void showKind();
    void noteMeasure();
    core::Primitive primitive() const;

    QComboBox *m_kind, *m_combination;
    std::array<QDoubleSpinBox*, core::Primitive::measures> m_measures;
    std::array<QLabel*, core::Primitive::measures> m_labels;
    std::array<QDoubleSpinBox*, 3> m_centre;
    QLabel* m_problem;
    QPushButton* m_apply;
    int m_axis = 1; ///< of the document, along which the solid's axis is
    /// where the base is: a point and the normal there; nothing once a coordinate was typed
    std::optional<std::pair<core::Vec3, core::Vec3>> m_base;
};
} // namespace ui
