#include "ui/lesson/lesson_step_editor.h"

#include "ui/actions/actions.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace ui
{
namespace
{
constexpr double maxShown = 1e9;             ///< largest value of a fact that can be typed
constexpr double maxTolerance = 1000;        ///< mm
constexpr int spinWidth = 84, iconSide = 16; ///< pixels

QLabel* sentence(const QString& text)
{
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    return label;
}

QDoubleSpinBox* spin(double min, double max, int decimals)
{
    auto* spin = new NumberField;
    spin->setDecimals(decimals);
    spin->setRange(min, max);
    spin->setSpecialValueText(QStringLiteral("–"));
    spin->setFixedWidth(spinWidth);
    spin->setValue(min);
    return spin;
}
} // namespace

LessonStepEditor::LessonStepEditor(const Actions& actions, QWidget* parent) : QTabWidget(parent)
{
    setDocumentMode(true);
    setUsesScrollButtons(false);
    addText();
    addStrokes();
    addTools(actions);
    addCheckpoint();
}

void LessonStepEditor::addText()
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    m_title = named(new QLineEdit, "lessonStepTitle", tr("What the step is called."), tr("Title of the step"));
    m_text = named(new QPlainTextEdit, "lessonStepText", tr("Text that the pupil reads beside the model."),
                   tr("Text of the step"));
    m_text->setTabChangesFocus(true);
    rows->addWidget(m_title);
    rows->addWidget(m_text, 1);
    connect(m_title, &QLineEdit::textEdited, this, [this](const QString& words) {
        m_draft->setStepTitle(m_step, m_language, words.toStdString());
        Q_EMIT titleEdited();
    });
    connect(m_text, &QPlainTextEdit::textChanged, this, &LessonStepEditor::storeText);
    addTab(page, tr("Text"));
}

void LessonStepEditor::addStrokes()
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    m_strokes = named(new QListWidget, "lessonStrokes", {}, tr("Strokes of the step"));
    m_strokes->setIconSize(QSize(iconSide, iconSide));
    m_cut =
        named(new QPushButton(tr("Cut Stroke")), "lessonCut",
              tr("Removes this stroke from the lesson. Later ones are played without it when the lesson is saved."));
    rows->addWidget(m_strokes, 1);
    rows->addWidget(m_cut);
    connect(m_cut, &QPushButton::clicked, this, &LessonStepEditor::cutStroke);
    connect(m_strokes, &QListWidget::currentRowChanged, this, [this](int row) { m_cut->setEnabled(row >= 0); });
    addTab(page, tr("Strokes"));
}

void LessonStepEditor::addTools(const Actions& actions)
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    rows->addWidget(sentence(tr("Tools that the pupil has; if none is chosen, all of them.")));
    auto* grid = new QGridLayout;
    constexpr int columns = 2;
    for (const std::string_view name : core::toolNames()) {
        const core::Tool tool = *core::named<core::Tool>(name);
        const QString id = QStringLiteral("tool.") + QString::fromUtf8(name);
        auto* box = named(new QCheckBox(Actions::plain(actions.get(id)->text())), QStringLiteral("lesson.") + id);
        const int place = static_cast<int>(m_tools.size());
        m_tools.emplace(tool, box);
        grid->addWidget(box, place / columns, place % columns);
        connect(box, &QCheckBox::clicked, this, &LessonStepEditor::storeTools);
    }
    rows->addLayout(grid);
    rows->addStretch();
    addTab(page, tr("Tools"));
}

void LessonStepEditor::addFact(QGridLayout* grid, core::Fact fact, const QString& words)
{
    const int decimals = core::info(fact).isWhole ? 0 : 1, row = grid->rowCount();
    const double max = std::min(core::info(fact).max, maxShown), step = decimals > 0 ? 0.1 : 1;
    const Bounds bounds{fact, spin(0, max, decimals), spin(-step, max, decimals)};
    grid->addWidget(new QLabel(words), row, 0);
    grid->addWidget(bounds.min, row, 1);
    grid->addWidget(bounds.max, row, 2);
    const std::string name(core::info(fact).key);
    bounds.min->setObjectName(QStringLiteral("lessonLeast.") + QString::fromStdString(name));
    bounds.max->setObjectName(QStringLiteral("lessonMost.") + QString::fromStdString(name));
    bounds.min->setAccessibleName(tr("%1, at least").arg(words));
    bounds.max->setAccessibleName(tr("%1, at most").arg(words));
    for (const QDoubleSpinBox* box : {bounds.min, bounds.max})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, bounds, box] { storeFact(bounds, box); });
    m_facts.push_back(bounds);
}

void LessonStepEditor::addCheckpoint()
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    rows->addWidget(sentence(tr("The step is done when the pupil's model is so:")));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(gap);
    grid->setColumnStretch(0, 1);
    grid->addWidget(new QLabel(tr("at least")), 0, 1);
    grid->addWidget(new QLabel(tr("at most")), 0, 2);
    using core::Fact;
    addFact(grid, Fact::Genus, tr("Holes"));
    addFact(grid, Fact::Components, tr("Parts"));
    addFact(grid, Fact::Height, tr("Height, mm"));
    addFact(grid, Fact::Width, tr("Width, mm"));
    addFact(grid, Fact::Depth, tr("Depth, mm"));
    addFact(grid, Fact::Widest, tr("Length from above, mm"));
    addFact(grid, Fact::Feet, tr("Legs on the ground"));
    addFact(grid, Fact::BaseArea, tr("Flat base, mm²"));
    addFact(grid, Fact::Grooves, tr("Narrow places all around"));
    addFact(grid, Fact::Volume, tr("Volume, mm³"));
    addFact(grid, Fact::Faces, tr("Triangles"));
    m_tolerance = spin(0, maxTolerance, 1);
    named(m_tolerance, "lessonTolerance", tr("How close the pupil's shape must be to the teacher's."));
    auto* shape = new QLabel(tr("Near the teacher's, mm"));
    shape->setBuddy(m_tolerance);
    const int row = grid->rowCount();
    grid->addWidget(shape, row, 0, 1, 2);
    grid->addWidget(m_tolerance, row, 2);
    rows->addLayout(grid);
    m_printReady = named(new QCheckBox(tr("Ready to print")), "lessonPrintReady");
    auto* factsButton =
        named(new QPushButton(tr("Take from the Model")), "lessonFacts",
              tr("Asks for the holes and parts that the model in the window has, for its height at least, and "
                 "that it can be printed."));
    rows->addWidget(m_printReady);
    rows->addWidget(factsButton);
    rows->addStretch();
    connect(m_printReady, &QCheckBox::clicked, this, [this](bool on) {
        m_draft->setFact(m_step, on ? core::FactBounds{Fact::PrintReady, 1, 1} : core::FactBounds{Fact::PrintReady});
    });
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, [this](double millimetres) {
        if (!m_isShowing && hasStep())
            m_draft->setTolerance(m_step, millimetres);
    });
    connect(factsButton, &QPushButton::clicked, this, &LessonStepEditor::factsRequested);
    addTab(page, tr("Goal"));
}

void LessonStepEditor::storeText()
{
    if (!m_isShowing && hasStep())
        m_draft->setStepText(m_step, m_language, m_text->toPlainText().toStdString());
}

void LessonStepEditor::storeTools()
{
    std::vector<core::Tool> tools;
    for (const auto& [tool, box] : m_tools)
        if (box->isChecked())
            tools.push_back(tool);
    m_draft->setTools(m_step, std::move(tools));
}

/// Stores the bounds of a fact. If they cross, the bound that was not edited is set to the edited one.
void LessonStepEditor::storeFact(const Bounds& bounds, const QDoubleSpinBox* changed)
{
    if (m_isShowing || !hasStep())
        return;
    const bool hasMax = bounds.max->value() >= 0;
    if (hasMax && bounds.min->value() > bounds.max->value()) {
        QDoubleSpinBox* other = changed == bounds.min ? bounds.max : bounds.min;
        const QSignalBlocker quiet(other);
        other->setValue(changed->value());
    }
    m_draft->setFact(m_step,
                     {bounds.fact, bounds.min->value(), hasMax ? bounds.max->value() : core::FactBounds::unbounded});
}

void LessonStepEditor::cutStroke()
{
    const int row = m_strokes->currentRow();
    if (!hasStep() || row < 0)
        return;
    Q_EMIT aboutToCut();
    m_draft->cutStroke(m_step, static_cast<std::size_t>(row));
    showStrokes();
    m_strokes->setCurrentRow(std::min(row, m_strokes->count() - 1));
    Q_EMIT cut();
}

void LessonStepEditor::showStep(core::LessonDraft* draft, std::size_t step, const std::string& language)
{
    m_draft = draft;
    m_step = step;
    m_language = language;
    setEnabled(hasStep());
    m_isShowing = true;
    const core::LessonText none;
    const auto show = [&](const core::LessonText& text, auto field) {
        const auto found = text.words.find(m_language);
        field(found == text.words.end() ? QString() : QString::fromStdString(found->second),
              QString::fromStdString(text.in(m_language)));
    };
    show(hasStep() ? draft->step(step).title : none, [this](const QString& words, const QString& instead) {
        m_title->setText(words);
        m_title->setCursorPosition(0);
        m_title->setPlaceholderText(instead.isEmpty() ? tr("Title of the step") : instead);
    });
    show(hasStep() ? draft->step(step).text : none, [this](const QString& words, const QString& instead) {
        m_text->setPlainText(words);
        m_text->setPlaceholderText(instead.isEmpty() ? tr("What the pupil reads") : instead);
    });
    for (const auto& [tool, box] : m_tools)
        box->setChecked(hasStep() && std::ranges::find(draft->step(step).tools, tool) != draft->step(step).tools.end());
    m_isShowing = false;
    showStrokes();
    showCheckpoint();
}

void LessonStepEditor::showStrokes()
{
    const int row = m_strokes->currentRow();
    m_strokes->clear();
    if (hasStep() && m_describe)
        for (const core::FileEntry& entry : m_draft->step(m_step).strokes) {
            const LessonStroke stroke = m_describe(entry);
            m_strokes->addItem(new QListWidgetItem(
                themedIcon(stroke.icon),
                tr("%1. %2", "number of a stroke; what it is").arg(m_strokes->count() + 1).arg(stroke.text)));
        }
    m_strokes->setCurrentRow(std::min(row, m_strokes->count() - 1));
    m_cut->setEnabled(m_strokes->currentRow() >= 0);
}

void LessonStepEditor::showCheckpoint()
{
    m_isShowing = true;
    for (const Bounds& bounds : m_facts) {
        const std::optional<core::FactBounds> asked = hasStep() ? m_draft->fact(m_step, bounds.fact) : std::nullopt;
        const bool hasMax = asked && asked->max < core::FactBounds::unbounded;
        bounds.min->setValue(asked ? asked->min : 0);
        bounds.max->setValue(hasMax ? asked->max : bounds.max->minimum());
    }
    m_printReady->setChecked(hasStep() && m_draft->fact(m_step, core::Fact::PrintReady).has_value());
    m_tolerance->setValue(
        hasStep() && m_draft->step(m_step).checkpoint.target ? m_draft->step(m_step).checkpoint.target->tolerance : 0);
    m_isShowing = false;
}
} // namespace ui
