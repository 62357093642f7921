#include "ui/gizmo/transform_fields.h"

#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/spacing.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace ui
{
namespace
{
constexpr double largestMove = 1e6, largestTurn = 360; // mm, degrees
} // namespace

TransformFields::TransformFields(QWidget* view) : ViewCard(view, "transformFields"), m_axes(new QComboBox)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap, gap, gap, gap);
    grid->setSpacing(gap / 2);
    const QString rows[] = {tr("Move, mm"), tr("Rotate, °"), tr("Scale")};
    for (int axis = 0; axis < 3; ++axis)
        grid->addWidget(new QLabel(QString(QChar(u'X' + axis))), 0, axis + 1, Qt::AlignHCenter);
    for (const Row row : {Move, Rotate, Scale}) {
        grid->addWidget(new QLabel(rows[row]), row + 1, 0);
        for (int axis = 0; axis < 3; ++axis) {
            m_fields[row][static_cast<std::size_t>(axis)] = addField(row, axis);
            grid->addWidget(m_fields[row][static_cast<std::size_t>(axis)], row + 1, axis + 1);
        }
    }
    named(m_axes, "transformAxes",
          tr("Axes of the handles and of these numbers: the document's, or those that turn with "
             "the part."),
          tr("Axes"));
    m_axes->addItems({tr("Document's axes"), tr("Part's own axes")});
    connect(m_axes, &QComboBox::activated, this, &TransformFields::axesChosen);
    auto* ends = new QHBoxLayout; // of its own, so that it does not widen the columns of numbers
    grid->addLayout(ends, RowCount + 1, 0, 1, 4);
    ends->addWidget(m_axes);
    ends->addStretch();
    auto* apply = named(new QPushButton(tr("&Apply")), "transformApply", tr("Applies these numbers (Return)."));
    auto* close = named(new QPushButton(tr("D&one")), "transformDone", tr("Hides the handles (Esc)."));
    connect(apply, &QPushButton::clicked, this, &TransformFields::entered);
    connect(close, &QPushButton::clicked, this, &TransformFields::closed);
    ends->addWidget(apply);
    ends->addWidget(close);
    setValues({});
}

QDoubleSpinBox* TransformFields::addField(Row row, int axis)
{
    static constexpr const char* names[] = {"move", "rotate", "scale"};
    const QString labels[] = {tr("Move along %1"), tr("Rotate about %1"), tr("Scale along %1")};
    auto* field = named(new NumberField, QLatin1StringView(names[row]) + QLatin1Char(char('X' + axis)), {},
                        labels[row].arg(QChar(u'X' + axis)));
    const double least[] = {-largestMove, -largestTurn, 0.01}, most[] = {largestMove, largestTurn, 100};
    const double steps[] = {1, 15, 0.1};
    field->setDecimals(row == Rotate ? 2 : 3);
    field->setRange(least[row], most[row]);
    field->setSingleStep(steps[row]);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setFixedWidth(gap + fontMetrics().horizontalAdvance(QStringLiteral("-0000.000")));
    connect(field, &QDoubleSpinBox::valueChanged, this, &TransformFields::edited);
    return field;
}

TransformValues TransformFields::values() const
{
    const auto row = [this](Row index) {
        const auto& fields = m_fields[index];
        return core::Vec3(fields[0]->value(), fields[1]->value(), fields[2]->value());
    };
    return {row(Move), row(Rotate), row(Scale)};
}

void TransformFields::setValues(const TransformValues& values)
{
    const core::Vec3 rows[] = {values.move, values.degrees, values.scale};
    for (const Row row : {Move, Rotate, Scale}) {
        for (int axis = 0; axis < 3; ++axis) {
            QDoubleSpinBox* field = m_fields[row][static_cast<std::size_t>(axis)];
            const QSignalBlocker quiet(field);
            field->setValue(rows[row][axis]);
        }
    }
}

bool TransformFields::usesOwnAxes() const
{
    return m_axes->currentIndex() == 1;
}
} // namespace ui
