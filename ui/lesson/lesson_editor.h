#pragma once

#include "ui/lesson/lesson_step_editor.h"

#include "core/operations/starter_models.h"

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

/// Where a teacher makes and changes a lesson: first with what to begin, then its words and steps. Changes the draft as
/// it is changed, and says what else is wanted. Thread: gui.
class LessonEditor : public QWidget
{
    Q_OBJECT

public:
    explicit LessonEditor(const Actions& actions, QWidget* parent = nullptr);

    void setDescribe(DescribeStroke describe) { m_step->setDescribe(std::move(describe)); }
    /// That can be changed, besides those in files.
    void setLessons(const QList<LessonCard>& lessons);

    /// All of it, at that step. The draft must live until another is shown, or none.
    void showDraft(core::LessonDraft* draft, std::size_t step = 0);
    void showStarts();
    bool isOpen() const { return m_draft != nullptr; }
    std::size_t step() const;

    /// Strokes or a checkpoint were changed by others.
    void showChanges();
    /// As the last one, which is shown then.
    void addStep();
    void setRecording(bool isRecording);

Q_SIGNALS:
    /// A lesson that begins so; nothing: with the model as it is.
    void startChosen(const std::optional<core::Starter>& starter);
    void lessonChosen(const QString& name);
    void fileRequested();
    /// What the steps leave is about to be another model than it was.
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

/// Adds the panel to the column; lesson.record opens it.
void addLessonEditor(SideColumn* column, const Actions& actions);
} // namespace ui
