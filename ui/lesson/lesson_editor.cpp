#include "ui/lesson/lesson_editor.h"

#include "ui/actions/actions.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/themed_icon.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>

namespace ui
{
namespace
{
constexpr int stepsShown = 4;   ///< largest number of rows of the list
constexpr int stepHeight = 168; ///< smallest height of the pages of a step, pixels

QLabel* head(const QString& text)
{
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    return label;
}

QString nameOfLanguage(const QString& code)
{
    if (code == QStringLiteral("en"))
        return QStringLiteral("English");
    if (code == QStringLiteral("zh") || code == QStringLiteral("zh_CN"))
        return QStringLiteral("简体中文");
    const QString name = QLocale(code).nativeLanguageName();
    return name.isEmpty() ? code : name;
}

/// Returns the program's languages, then other languages of the lesson. If the lesson uses a plain code ("zh") for a
/// program's language ("zh_CN"), the plain code is returned.
QStringList languagesOf(const core::Lesson& lesson)
{
    QStringList own;
    const auto add = [&](const core::LessonText& text) {
        for (const auto& [code, words] : text.words)
            if (!own.contains(QString::fromStdString(code)))
                own << QString::fromStdString(code);
    };
    add(lesson.title);
    add(lesson.summary);
    for (const core::LessonStep& step : lesson.steps) {
        add(step.title);
        add(step.text);
    }
    QStringList all;
    for (const QString& code : {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("zh_CN")}) {
        const QString plain = code.section(u'_', 0, 0);
        all << (own.contains(plain) && !own.contains(code) ? plain : code);
    }
    for (const QString& code : own)
        if (!all.contains(code))
            all << code;
    return all;
}

QToolButton* button(const char* name, const char* icon, const QString& tip)
{
    auto* button = named(new QToolButton, name);
    button->setIcon(themedIcon(QLatin1StringView(icon)));
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    return button;
}
} // namespace

LessonEditor::LessonEditor(const Actions& actions, QWidget* parent)
    : QWidget(parent)
    , m_stack(new QStackedWidget)
    , m_step(new LessonStepEditor(actions))
{
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_stack);
    addStarts(actions);
    addEditor();
}

void LessonEditor::addStarts(const Actions& actions)
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    rows->addWidget(
        head(tr("A lesson records what you sculpt, step by step, here or in the headset. It begins with:")));
    m_start = named(new QComboBox, "lessonStart", {}, tr("Begins with"));
    m_start->addItem(tr("The model as it is now"), -1);
    for (const core::Starter starter : core::starters)
        m_start->addItem(
            Actions::plain(actions.get(QStringLiteral("new.") + QString::fromUtf8(core::name(starter)))->text()),
            static_cast<int>(starter));
    auto* record = named(new QPushButton(tr("Record")), "lessonBegin",
                         tr("Begins a lesson of one step. Earlier strokes can no longer be undone."));
    rows->addWidget(m_start);
    rows->addWidget(record);
    rows->addSpacing(2 * gap);
    rows->addWidget(head(tr("Or change an existing lesson:")));
    m_library = named(new QComboBox, "lessonLibrary", {}, tr("Built-in lessons"));
    auto* change =
        named(new QPushButton(tr("Edit")), "lessonEdit", tr("Opens it here; you save it under a name of your own."));
    auto* file = named(new QPushButton(tr("Open a Lesson…")), "lessonEditFile",
                       tr("Opens a lesson from a zip or a folder, to change it."));
    rows->addWidget(m_library);
    rows->addWidget(change);
    rows->addWidget(file);
    rows->addStretch();
    connect(record, &QPushButton::clicked, this, [this] {
        const int starter = m_start->currentData().toInt();
        Q_EMIT startChosen(starter < 0 ? std::nullopt : std::optional(static_cast<core::Starter>(starter)));
    });
    connect(change, &QPushButton::clicked, this, [this] { Q_EMIT lessonChosen(m_library->currentData().toString()); });
    connect(file, &QPushButton::clicked, this, &LessonEditor::fileRequested);
    m_stack->addWidget(page);
}

void LessonEditor::addEditor()
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    addHead(rows);
    addRecorder(rows); // above the pages, so that it is visible at any height
    addSteps(rows);
    m_step->setMinimumHeight(stepHeight);
    rows->addWidget(m_step, 1);
    m_stack->addWidget(page);
    connect(m_step, &LessonStepEditor::titleEdited, this, [this] { m_steps->currentItem()->setText(lineOf(step())); });
    connect(m_step, &LessonStepEditor::aboutToCut, this, &LessonEditor::aboutToChange);
    connect(m_step, &LessonStepEditor::cut, this, [this] { m_steps->currentItem()->setText(lineOf(step())); });
    connect(m_step, &LessonStepEditor::factsRequested, this, &LessonEditor::factsRequested);
}

void LessonEditor::addHead(QVBoxLayout* rows)
{
    m_language =
        named(new QComboBox, "lessonLanguage",
              tr("The language that you write in. Where a text is missing, pupils read it in another language."),
              tr("Language of the texts"));
    m_title = named(new QLineEdit, "lessonName", tr("Title of the lesson."), tr("Title of the lesson"));
    m_summary =
        named(new QLineEdit, "lessonSummary", tr("Subject of the lesson, in one sentence."), tr("In one sentence"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_title, 1);
    row->addWidget(m_language);
    rows->addLayout(row);
    rows->addWidget(m_summary);
    connect(m_language, &QComboBox::activated, this, &LessonEditor::showTexts);
    connect(m_title, &QLineEdit::textEdited, this,
            [this](const QString& words) { m_draft->setTitle(language(), words.toStdString()); });
    connect(m_summary, &QLineEdit::textEdited, this,
            [this](const QString& words) { m_draft->setSummary(language(), words.toStdString()); });
}

void LessonEditor::addSteps(QVBoxLayout* rows)
{
    m_steps = named(new QListWidget, "lessonSteps", {}, tr("Steps"));
    m_steps->setTextElideMode(Qt::ElideRight);
    m_steps->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_steps->setFixedHeight(stepsShown * (m_steps->fontMetrics().height() + gap));
    auto* add = named(new QPushButton(tr("New Step")), "lessonNewStep",
                      tr("Starts a new step at the end; strokes belong to it from here on."));
    m_up = button("lessonUp", "sort-up", tr("Moves the step up"));
    m_down = button("lessonDown", "sort-down", tr("Moves the step down"));
    m_remove = button("lessonRemove", "trash", tr("Removes the step with its strokes"));
    auto* row = new QHBoxLayout;
    row->addWidget(add, 1);
    for (QToolButton* each : {m_up, m_down, m_remove})
        row->addWidget(each);
    rows->addWidget(m_steps);
    rows->addLayout(row);
    connect(m_steps, &QListWidget::currentRowChanged, this, [this] { showTexts(); });
    connect(add, &QPushButton::clicked, this, &LessonEditor::addStep);
    connect(m_remove, &QToolButton::clicked, this, &LessonEditor::removeStep);
    connect(m_up, &QToolButton::clicked, this, [this] { moveStep(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { moveStep(1); });
}

void LessonEditor::addRecorder(QVBoxLayout* rows)
{
    m_state = head({});
    m_state->setObjectName(QStringLiteral("lessonState"));
    m_record = named(new QPushButton, "lessonRecord",
                     tr("Plays the lesson to its end and records from there. Press again to stop."));
    auto* save = named(new QPushButton(tr("Save…")), "lessonSave",
                       tr("Plays the lesson to its end, checks each step, and saves it as a file or a folder."));
    auto* close =
        named(new QPushButton(tr("Close")), "lessonClose", tr("Closes this lesson. The model stays as it is."));
    rows->addWidget(m_state);
    auto* row = new QHBoxLayout;
    row->addWidget(m_record, 1);
    row->addWidget(save);
    row->addWidget(close);
    rows->addLayout(row);
    connect(m_record, &QPushButton::clicked, this, [this] { Q_EMIT recordRequested(!m_isRecording); });
    connect(save, &QPushButton::clicked, this, &LessonEditor::saveRequested);
    connect(close, &QPushButton::clicked, this, &LessonEditor::closeRequested);
}

void LessonEditor::setLessons(const QList<LessonCard>& lessons)
{
    m_library->clear();
    for (const LessonCard& card : lessons)
        m_library->addItem(card.title, card.name);
}

std::string LessonEditor::language() const
{
    return m_language->currentData().toString().toStdString();
}

std::size_t LessonEditor::step() const
{
    return static_cast<std::size_t>(std::max(m_steps->currentRow(), 0));
}

/// Fills the list of languages and selects the window's language if it is in the list.
void LessonEditor::fillLanguages()
{
    m_language->clear();
    for (const QString& code : languagesOf(m_draft->lesson()))
        m_language->addItem(nameOfLanguage(code), code);
    const QString ours = QLocale().name();
    for (const QString& code : {ours.section(u'_', 0, 0), ours})
        if (const int found = m_language->findData(code); found >= 0)
            m_language->setCurrentIndex(found);
}

void LessonEditor::showDraft(core::LessonDraft* draft, std::size_t step)
{
    m_draft = draft;
    fillLanguages();
    fillSteps(static_cast<int>(step));
    m_stack->setCurrentIndex(1);
    setRecording(false);
}

void LessonEditor::showStarts()
{
    m_step->showStep(nullptr, 0, {});
    m_draft = nullptr;
    m_stack->setCurrentIndex(0);
}

void LessonEditor::showTexts()
{
    if (!m_draft)
        return;
    const auto show = [this](QLineEdit* field, const core::LessonText& text, const QString& none) {
        const auto found = text.words.find(language());
        const QString instead = QString::fromStdString(text.in(language()));
        field->setText(found == text.words.end() ? QString() : QString::fromStdString(found->second));
        field->setCursorPosition(0); // shows the beginning of a long text
        field->setPlaceholderText(instead.isEmpty() ? none : instead);
    };
    show(m_title, m_draft->lesson().title, m_title->accessibleName());
    show(m_summary, m_draft->lesson().summary, m_summary->accessibleName());
    m_step->showStep(m_draft, step(), language());
    for (int row = 0; row < m_steps->count(); ++row)
        m_steps->item(row)->setText(lineOf(static_cast<std::size_t>(row)));
    m_up->setEnabled(m_steps->currentRow() > 0);
    m_down->setEnabled(m_steps->currentRow() + 1 < m_steps->count());
    m_remove->setEnabled(m_steps->count() > 1);
}

void LessonEditor::fillSteps(int row)
{
    {
        const QSignalBlocker quiet(m_steps);
        m_steps->clear();
        for (std::size_t i = 0; i < m_draft->steps(); ++i)
            m_steps->addItem(lineOf(i));
        m_steps->setCurrentRow(std::min(row, m_steps->count() - 1));
    }
    showTexts();
}

QString LessonEditor::lineOf(std::size_t step) const
{
    const core::LessonStep& its = m_draft->step(step);
    const QString title = QString::fromStdString(its.title.in(language()));
    //: number of a step, its title, how many strokes it has
    return tr("%1. %2 (%3)").arg(step + 1).arg(title).arg(its.strokes.size());
}

void LessonEditor::addStep()
{
    m_draft->addStep();
    const std::size_t last = m_draft->steps() - 1;
    m_draft->setStepTitle(last, language(), tr("Step %1").arg(last + 1).toStdString());
    fillSteps(static_cast<int>(last));
    setRecording(m_isRecording);
}

void LessonEditor::removeStep()
{
    Q_EMIT aboutToChange();
    const auto row = static_cast<int>(step());
    m_draft->removeStep(step());
    fillSteps(row);
}

void LessonEditor::moveStep(int by)
{
    Q_EMIT aboutToChange();
    const int to = static_cast<int>(step()) + by;
    m_draft->moveStep(step(), static_cast<std::size_t>(to));
    fillSteps(to);
}

void LessonEditor::showChanges()
{
    if (!m_draft)
        return;
    m_step->showStrokes();
    m_step->showCheckpoint();
    for (int row = 0; row < m_steps->count(); ++row)
        m_steps->item(row)->setText(lineOf(static_cast<std::size_t>(row)));
}

/// Shows the state of the recording, by a symbol and words as well, not by colour alone. Selects the step that is
/// recorded.
void LessonEditor::setRecording(bool isRecording)
{
    if (isRecording && !m_isRecording)
        m_steps->setCurrentRow(m_steps->count() - 1);
    m_isRecording = isRecording;
    m_record->setText(isRecording ? tr("Stop Recording") : tr("Record On"));
    m_state->setText(isRecording ? tr("● Recording into step %1").arg(m_draft->steps()) : tr("○ Not recording"));
}

void addLessonEditor(SideColumn* column, const Actions& actions)
{
    column->add(QStringLiteral("lessonEditor"), LessonEditor::tr("Lesson Editor"), new LessonEditor(actions))
        ->openBy(actions.get(QStringLiteral("lesson.record")));
}
} // namespace ui
