#include "ui/shapes/solid_card.h"

#include "ui/model/command_dialog.h"
#include "ui/model/primitive_messages.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/spacing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
using core::Primitive;
using Measure = core::Primitive::Measure;

constexpr std::size_t kinds = static_cast<std::size_t>(Primitive::Kind::Torus) + 1; ///< those that have measures
constexpr double minMeasure = 0.001;                                                ///< mm
constexpr double tubeShare = 0.3; ///< radius of a torus's tube, as a share of its radius

constexpr double capsuleShare = 4; ///< height of a capsule, as a share of its radius

/// Cosine of the angle within which a normal counts as an axis of the document: 2 degrees.
constexpr double alongAxis = 0.99939;

/// Returns half the extent of a solid along its axis, mm.
double halfHeight(const Primitive& solid)
{
    switch (solid.kind) {
    case Primitive::Kind::Ball:
        return solid.length(Measure::Radius);
    case Primitive::Kind::Torus:
        return solid.length(Measure::TubeRadius);
    default:
        return solid.length(Measure::Height) / 2;
    }
}
} // namespace

SolidCard::SolidCard(QWidget* view)
    : ViewCard(view, "solidCard")
    , m_kind(named(new QComboBox, "solidKind", {}, tr("Shape")))
    , m_combination(named(new QComboBox, "solidCombination", {}, ModelDialogs::tr("Combine")))
    , m_isTurned(named(new QCheckBox(tr("&Turn to the surface")), "solidTurned",
                       tr("The solid stands at a right angle to the surface. Off: along the nearest axis.")))
    , m_problem(named(new QLabel, "solidProblem"))
    , m_apply(named(new QPushButton(tr("A&pply")), "solidApply", tr("Makes the solid (Return).")))
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap, gap, gap, gap);
    grid->setSpacing(gap / 2);
    grid->addWidget(new QLabel(tr("Shape")), 0, 0);
    grid->addWidget(m_kind, 0, 1);
    for (std::size_t i = 0; i < kinds; ++i)
        m_kind->addItem(PrimitiveMessages::kind(static_cast<Primitive::Kind>(i)));
    for (std::size_t i = 0; i < Primitive::measures; ++i) {
        const auto measure = static_cast<Measure>(i);
        const QString text = PrimitiveMessages::measure(measure);
        const double least = measure == Measure::TopRadius ? 0 : minMeasure;
        m_measures[i] = makeNumber(QLatin1StringView(core::name(measure).data()), text, least);
        connect(m_measures[i], &QDoubleSpinBox::valueChanged, this, &SolidCard::noteMeasure);
        m_labels[i] = new QLabel(text);
        grid->addWidget(m_labels[i], int(i) + 1, 0);
        grid->addWidget(m_measures[i], int(i) + 1, 1);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const QChar letter(u'X' + axis);
        const int row = int(Primitive::measures) + 1 + axis;
        QDoubleSpinBox* field =
            makeNumber(QStringLiteral("centre") + letter, tr("Middle, %1").arg(letter), -maxCoordinate);
        connect(field, &QDoubleSpinBox::valueChanged, this, [this] {
            m_base.reset();
            Q_EMIT edited();
        });
        m_centre[std::size_t(axis)] = field;
        grid->addWidget(new QLabel(field->accessibleName()), row, 0);
        grid->addWidget(field, row, 1);
    }
    const int last = grid->rowCount() + 1;
    grid->addWidget(m_isTurned, last - 1, 0, 1, 2);
    grid->addWidget(new QLabel(ModelDialogs::tr("Combine")), last, 0);
    grid->addWidget(m_combination, last, 1);
    grid->addWidget(m_problem, last + 1, 0, 1, 2);
    fillCombinations(m_combination);
    m_problem->setWordWrap(true);
    grid->addLayout(makeButtons(), last + 2, 0, 1, 2);
    m_isTurned->setChecked(true);
    connect(m_isTurned, &QCheckBox::toggled, this, &SolidCard::noteMeasure);
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        showKind();
        noteMeasure();
    });
    showKind();
}

/// Returns the buttons that end the card.
QLayout* SolidCard::makeButtons()
{
    auto* cancel = named(new QPushButton(tr("&Cancel")), "solidCancel", tr("Makes no solid (Esc)."));
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_apply);
    buttons->addWidget(cancel);
    connect(m_apply, &QPushButton::clicked, this, &SolidCard::applied);
    connect(this, &ViewCard::entered, this, &SolidCard::applied);
    connect(cancel, &QPushButton::clicked, this, &SolidCard::cancelled);
    return buttons;
}

QDoubleSpinBox* SolidCard::makeNumber(const QString& name, const QString& label, double least)
{
    auto* field = named(new NumberField, name, {}, label);
    field->setDecimals(3);
    field->setRange(least, maxCoordinate);
    field->setSuffix(ModelDialogs::tr(" mm"));
    field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    return field;
}

void SolidCard::noteMeasure()
{
    keepBase();
    Q_EMIT edited();
}

/// Shows the rows of the measures that the kind has. Makes a capsule high enough.
void SolidCard::showKind()
{
    QDoubleSpinBox* height = m_measures[static_cast<std::size_t>(Measure::Height)];
    const double radius = m_measures[static_cast<std::size_t>(Measure::Radius)]->value();
    if (static_cast<Primitive::Kind>(m_kind->currentIndex()) == Primitive::Kind::Capsule &&
        height->value() <= 2 * radius) {
        const QSignalBlocker quiet(height);
        height->setValue(capsuleShare * radius);
    }

    const auto measures = core::measuresOf(static_cast<Primitive::Kind>(m_kind->currentIndex()));
    for (std::size_t i = 0; i < Primitive::measures; ++i) {
        const bool isUsed = std::ranges::count(measures, static_cast<Measure>(i)) > 0;
        m_labels[i]->setVisible(isUsed);
        m_measures[i]->setVisible(isUsed);
    }
    m_isTurned->setEnabled(static_cast<Primitive::Kind>(m_kind->currentIndex()) != Primitive::Kind::Ball);
}

core::Primitive SolidCard::primitive() const
{
    Primitive solid;
    solid.kind = static_cast<Primitive::Kind>(m_kind->currentIndex());
    for (std::size_t i = 0; i < Primitive::measures; ++i)
        solid.lengths[i] = m_measures[i]->value();
    if (solid.kind != Primitive::Kind::Ball)
        solid.axis = axis();
    return solid;
}

core::Insert SolidCard::insertion() const
{
    core::Insert insert;
    insert.primitive = primitive();
    insert.place = core::Insert::Place::Centre;
    insert.centre = {m_centre[0]->value(), m_centre[1]->value(), m_centre[2]->value()};
    insert.combination = combinationOf(m_combination);
    if (insert.combination == core::Insert::Combination::Part)
        insert.name = m_kind->currentText().toStdString();
    return insert;
}

void SolidCard::setSize(double size)
{
    const bool isCapsule = static_cast<Primitive::Kind>(m_kind->currentIndex()) == Primitive::Kind::Capsule;
    const std::pair<Measure, double> lengths[] = {
        {Measure::Width, 2 * size}, {Measure::Height, (isCapsule ? capsuleShare : 2) * size},
        {Measure::Depth, 2 * size}, {Measure::Radius, size},
        {Measure::TopRadius, 0},    {Measure::TubeRadius, tubeShare * size}};
    for (const auto& [measure, length] : lengths) {
        QDoubleSpinBox* field = m_measures[static_cast<std::size_t>(measure)];
        const QSignalBlocker quiet(field);
        field->setValue(length);
    }
}

void SolidCard::putOn(const core::Vec3& point, const core::Vec3& normal)
{
    m_base = point;
    m_normal = normal;
    keepBase();
}

/// Returns the direction of the solid's axis.
core::Vec3 SolidCard::axis() const
{
    const core::Vec3 nearest = core::nearestAxis(m_normal);
    return m_isTurned->isChecked() && nearest.dot(m_normal) < alongAxis ? m_normal : nearest;
}

void SolidCard::keepBase()
{
    if (!m_base)
        return;
    const core::Vec3 centre = *m_base + halfHeight(primitive()) * axis();
    for (int i = 0; i < 3; ++i) {
        const QSignalBlocker quiet(m_centre[std::size_t(i)]);
        m_centre[std::size_t(i)]->setValue(centre[i]);
    }
}

void SolidCard::show(const QString& problem)
{
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_apply->setEnabled(problem.isEmpty());
    ViewCard::show();
    place();
}

void SolidCard::storeCombination() const
{
    ui::storeCombination(m_combination);
}
} // namespace ui
