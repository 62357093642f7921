#pragma once

#include "ui/classroom/cover_panel.h"
#include "ui/classroom/questionnaire.h"

#include <QList>

class QLabel;
class QPushButton;

namespace ui
{
class AnswerScale;

/// A form with the six questions after a turn; all are optional. Thread: gui.
class QuestionnairePanel : public CoverPanel
{
    Q_OBJECT

public:
    explicit QuestionnairePanel(QWidget* over);

    /// Opens the form for this pupil with all answers empty.
    void open(const QString& pupil);
    Questionnaire questionnaire() const;

Q_SIGNALS:
    /// An answer was given or cleared. `soFar`: all answers.
    void answered(const ui::Questionnaire& soFar);
    /// Done or Skip was pressed. Skip clears all answers first.
    void finished();

private:
    QWidget* content();
    QLayout* buttons();
    void skip();

    QLabel* m_title;
    QList<AnswerScale*> m_scales; ///< one for each question, in the order of Question
    QPushButton *m_skip, *m_done;
};
} // namespace ui
