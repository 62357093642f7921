#include "ui/shapes/tube_card.h"

#include "ui/model/command_dialog.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/spacing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace ui
{
TubeCard::TubeCard(QWidget* view)
    : ViewCard(view, "tubeCard")
    , m_radius(named(new NumberField, "tubeRadius", tr("Radius of the tube at the chosen point."), tr("Radius")))
    , m_combination(named(new QComboBox, "tubeCombination", {}, ModelDialogs::tr("Combine")))
    , m_problem(named(new QLabel, "tubeProblem"))
{
    auto* ofAll = named(new QCheckBox(tr("of &all points")), "tubeAllRadii", tr("Gives every point this radius."));
    m_radius->setDecimals(3);
    m_radius->setRange(0.001, maxCoordinate);
    m_radius->setSuffix(ModelDialogs::tr(" mm"));
    m_radius->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    fillCombinations(m_combination);
    m_problem->setWordWrap(true);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap, gap, gap, gap);
    grid->setSpacing(gap / 2);
    grid->addWidget(new QLabel(tr("Radius")), 0, 0);
    grid->addWidget(m_radius, 0, 1);
    grid->addWidget(ofAll, 0, 2);
    grid->addWidget(new QLabel(ModelDialogs::tr("Combine")), 1, 0);
    grid->addWidget(m_combination, 1, 1, 1, 2);
    grid->addWidget(m_problem, 2, 0, 1, 3);
    auto* ends = new QHBoxLayout;
    ends->addStretch();
    grid->addLayout(ends, 3, 0, 1, 3);
    const auto addEnd = [&](const char* name, const QString& text, const QString& tip, auto signal) {
        auto* button = named(new QPushButton(text), name, tip);
        connect(button, &QPushButton::clicked, this, signal);
        ends->addWidget(button);
        return button;
    };
    m_apply = addEnd("tubeApply", tr("A&pply"), tr("Makes the tube (Return)."), &TubeCard::applied);
    addEnd("tubeCancel", tr("&Cancel"), tr("Makes no tube (Esc)."), &TubeCard::cancelled);
    const auto enter = [this, ofAll] { Q_EMIT radiusEntered(m_radius->value(), ofAll->isChecked()); };
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, enter);
    connect(this, &ViewCard::entered, this, &TubeCard::applied);
    connect(ofAll, &QCheckBox::toggled, this, enter);
}

void TubeCard::show(double radius, const QString& problem)
{
    if (m_radius->value() != radius) { // otherwise the text that is being typed would be formatted
        const QSignalBlocker quiet(m_radius);
        m_radius->setValue(radius);
    }
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_apply->setEnabled(problem.isEmpty());
    ViewCard::show();
    place();
}

core::Insert::Combination TubeCard::combination() const
{
    return combinationOf(m_combination);
}

void TubeCard::storeCombination() const
{
    ui::storeCombination(m_combination);
}
} // namespace ui
