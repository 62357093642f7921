#pragma once

#include "core/lesson/lesson_draft.h"

#include <QString>
#include <QTabWidget>

#include <functional>
#include <map>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace ui
{
class Actions;

/// The description of a stroke or command of a lesson, for the user.
struct LessonStroke
{
    QString text;
    QString icon; ///< icon name as in the table of actions
};
using DescribeStroke = std::function<LessonStroke(const core::FileEntry& entry)>;

/// An editor of one step of a lesson, with pages for texts, strokes, tools and checkpoint. Edits are written into the
/// draft at once. Thread: gui.
class LessonStepEditor : public QTabWidget
{
    Q_OBJECT

public:
    explicit LessonStepEditor(const Actions& actions, QWidget* parent = nullptr);

    void setDescribe(DescribeStroke describe) { m_describe = std::move(describe); }
    /// Shows a step of the draft in a language; shows nothing if the draft has no such step. Precondition: the draft
    /// lives as long as it is shown.
    void showStep(core::LessonDraft* draft, std::size_t step, const std::string& language);
    /// Update the pages after other code has changed the strokes or the checkpoint.
    void showStrokes();
    void showCheckpoint();

Q_SIGNALS:
    void titleEdited();
    /// Emitted before and after a stroke is removed.
    void aboutToCut();
    void cut();
    /// The checkpoint's facts are to be set to those of the present model.
    void factsRequested();

private:
    struct Bounds
    {
        core::Fact fact;
        QDoubleSpinBox *min, *max;
    };

    void addText();
    void addStrokes();
    void addTools(const Actions& actions);
    void addCheckpoint();
    void addFact(QGridLayout* grid, core::Fact fact, const QString& words);
    void storeText();
    void storeTools();
    void storeFact(const Bounds& bounds, const QDoubleSpinBox* changed);
    void cutStroke();
    bool hasStep() const { return m_draft && m_step < m_draft->steps(); }

    core::LessonDraft* m_draft = nullptr;
    std::size_t m_step = 0;
    std::string m_language;
    DescribeStroke m_describe;
    bool m_isShowing = false; ///< the editor is setting its controls; changes are not the user's
    QLineEdit* m_title = nullptr;
    QPlainTextEdit* m_text = nullptr;
    QListWidget* m_strokes = nullptr;
    QPushButton* m_cut = nullptr;
    std::map<core::Tool, QCheckBox*> m_tools;
    std::vector<Bounds> m_facts;
    QCheckBox* m_printReady = nullptr;
    QDoubleSpinBox* m_tolerance = nullptr;
};
} // namespace ui
