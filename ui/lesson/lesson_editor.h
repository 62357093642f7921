#pragma once

#include "ui/lesson/lesson_step_editor.h"

#include "core/primitives/starter_models.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QListWidget;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace ui
{
class SideColumn;
struct LessonCard;

/// A panel in which a teacher makes and edits a lesson: first the choice of a beginning, then texts and steps. Edits
/// are written into the draft at once; everything else is requested by signals. Thread: gui.
class LessonEditor : public QWidget
{
    Q_OBJECT

public:
    explicit LessonEditor(const Actions& actions, QWidget* parent = nullptr);

    void setDescribe(DescribeStroke describe) { m_step->setDescribe(std::move(describe)); }
    /// Sets the lessons that can be edited, besides those in files.
    void setLessons(const QList<LessonCard>& lessons);

    /// Shows the whole draft, with this step selected. Precondition: the draft lives until another draft or none is
    /// shown.
    void showDraft(core::LessonDraft* draft, std::size_t step = 0);
    void showStarts();
    bool isOpen() const { return m_draft != nullptr; }
    std::size_t step() const;

    /// Updates the editor after other code has changed strokes or a checkpoint.
    void showChanges();
    /// Appends a step and selects it.
    void addStep();
    void setRecording(bool isRecording);

Q_SIGNALS:
    /// A new lesson is to begin with this starter; nullopt: with the present model.
    void startChosen(const std::optional<core::Starter>& starter);
    void lessonChosen(const QString& name);
    void fileRequested();
    /// An edit is about to change the model that a step ends with.
    void aboutToChange();
    void recordRequested(bool on);
    void factsRequested();
    void saveRequested();
    void closeRequested();

private:
    void addStarts(const Actions& actions);
    void addEditor();
    void addHead(QVBoxLayout* rows);
    void addSteps(QVBoxLayout* rows);
    void addRecorder(QVBoxLayout* rows);
    std::string language() const;
    void fillLanguages();
    void showTexts();
    void fillSteps(int row);
    QString lineOf(std::size_t step) const;
    void removeStep();
    void moveStep(int by);

    core::LessonDraft* m_draft = nullptr;
    bool m_isRecording = false;
    QStackedWidget* m_stack = nullptr;
    QComboBox *m_start = nullptr, *m_library = nullptr, *m_language = nullptr;
    QLineEdit *m_title = nullptr, *m_summary = nullptr;
    QListWidget* m_steps = nullptr;
    QToolButton *m_up = nullptr, *m_down = nullptr, *m_remove = nullptr;
    LessonStepEditor* m_step = nullptr;
    QLabel* m_state = nullptr;
    QPushButton* m_record = nullptr;
};

/// Adds the panel to the column; the action lesson.record opens it.
void addLessonEditor(SideColumn* column, const Actions& actions);
} // namespace ui
