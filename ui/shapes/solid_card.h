#pragma once

#include "core/operations/model_command.h"
#include "ui/widgets/view_card.h"

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLayout;
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
    /// Puts the solid on a surface: the middle of its base at `point` (mm), its axis along the unit normal or, if the
    /// user does not want it turned, along the document's axis nearest to that. The base stays there when a measure
    /// changes, until a coordinate is typed.
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
    QLayout* makeButtons();
    void showKind();
    void noteMeasure();
    core::Primitive primitive() const;
    core::Vec3 axis() const;

    QComboBox *m_kind, *m_combination;
    std::array<QDoubleSpinBox*, core::Primitive::measures> m_measures;
    std::array<QLabel*, core::Primitive::measures> m_labels;
    std::array<QDoubleSpinBox*, 3> m_centre;
    QCheckBox* m_isTurned;
    QLabel* m_problem;
    QPushButton* m_apply;
    core::Vec3 m_normal = core::Vec3::UnitY(); ///< of the surface that the solid was put on
    std::optional<core::Vec3> m_base;          ///< middle of the base; nothing once a coordinate was typed
};
} // namespace ui
