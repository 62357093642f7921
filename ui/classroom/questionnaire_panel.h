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

    /// Opens the form, without answers, for this pupil.
    void open(const QString& pupil);
    Questionnaire questionnaire() const;

Q_SIGNALS:
    /// Emitted with all answers so far when one is given or taken back.
    void answered(const ui::Questionnaire& soFar);
    /// Emitted when Done or Skip is pressed. Skip takes all answers back first.
    void finished();

private:
    QWidget* content();
    QLayout* buttons();
    void skip();

    QLabel* m_title;
    QList<AnswerScale*> m_scales; ///< in the order of Question
    QPushButton *m_skip, *m_done;
};
} // namespace ui
