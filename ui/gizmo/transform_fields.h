#pragma once

#include "ui/gizmo/transform_values.h"
#include "ui/widgets/view_card.h"

#include <array>

class QComboBox;
class QDoubleSpinBox;

namespace ui
{
/// The numbers of a transformation, in the lower right corner of the view. Return in a field enters them. Thread: gui.
class TransformFields : public ViewCard
{
    Q_OBJECT

public:
    explicit TransformFields(QWidget* view);

    TransformValues values() const;
    /// Shows numbers without emitting edited().
    void setValues(const TransformValues& values);
    /// Returns whether the part's own axes are chosen, not the document's.
    bool usesOwnAxes() const;

Q_SIGNALS:
    void edited();
    void axesChosen();
    void closed();

private:
    enum Row { Move, Rotate, Scale, RowCount };

    QDoubleSpinBox* addField(Row row, int axis);

    std::array<std::array<QDoubleSpinBox*, 3>, RowCount> m_fields{};
    QComboBox* m_axes;
};
} // namespace ui
