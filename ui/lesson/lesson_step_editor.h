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

/// A stroke or command of a lesson, in words for people.
struct LessonStroke
{
    QString text;
    QString icon; ///< as the table of actions has it
};
using DescribeStroke = std::function<LessonStroke(const core::FileEntry& entry)>;

/// One step of a lesson: its words, strokes, tools and checkpoint, each on a page. Changes the draft as it is changed.
/// Thread: gui.
class LessonStepEditor : public QTabWidget
{
    Q_OBJECT

public:
    explicit LessonStepEditor(const Actions& actions, QWidget* parent = nullptr);

    void setDescribe(DescribeStroke describe) { m_describe = std::move(describe); }
    /// All of the draft's step, in that language; of a draft without it nothing. The draft must outlive what is shown.
    void showStep(core::LessonDraft* draft, std::size_t step, const std::string& language);
    /// What has changed by others.
    void showStrokes();
    void showCheckpoint();

Q_SIGNALS:
    void titleEdited();
    /// A stroke is about to be cut, and was.
    void aboutToCut();
    void cut();
    /// The checkpoint's facts are to be those of the model as it is.
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
    bool m_isShowing = false; ///< what changes now was not changed by hand
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
