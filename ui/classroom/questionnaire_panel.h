#pragma once

#include "ui/classroom/cover_panel.h"
#include "ui/classroom/questionnaire.h"

#include <QList>

class QLabel;
class QPushButton;

namespace ui
{
class AnswerScale;

/// The six questions after a turn, which can all be left out. Thread: gui.
class QuestionnairePanel : public CoverPanel
{
    Q_OBJECT

public:
    explicit QuestionnairePanel(QWidget* over);

    /// Without answers.
    void open(const QString& pupil);
    Questionnaire questionnaire() const;

Q_SIGNALS:
    /// All answers so far, whenever one is given or taken back.
    void answered(const ui::Questionnaire& soFar);
    /// Done or Skip was pressed; Skip takes all answers back before.
    void finished();

private:
    QWidget* card();
    QWidget* questions();
    QLayout* buttons();
    void skip();

    QLabel* m_title;
    QList<AnswerScale*> m_scales; ///< in the order of Question
    QPushButton *m_skip, *m_done;
};
} // namespace ui
