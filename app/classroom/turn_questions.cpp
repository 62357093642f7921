#include "app/classroom/turn_questions.h"

#include "ui/classroom/questionnaire_panel.h"

namespace app
{
TurnQuestions::TurnQuestions(ClassWork* work, QWidget* over) : m_work(work), m_panel(new ui::QuestionnairePanel(over))
{
    connect(m_panel, &ui::QuestionnairePanel::answered, this,
            [this](const ui::Questionnaire& soFar) { m_work->keepAnswers(m_ended, soFar); });
    connect(m_panel, &ui::QuestionnairePanel::finished, this, [this] {
        finish();
        Q_EMIT done();
    });
}

void TurnQuestions::ask(const EndedTurn& ended)
{
    m_ended = ended;
    m_work->setHeld(true);
    m_panel->open(ended.turn.pupil);
}

void TurnQuestions::finish()
{
    if (m_panel->isHidden())
        return;
    m_work->keepAnswers(m_ended, m_panel->questionnaire()); // saved again, because an earlier attempt may have failed
    m_panel->close();
    m_work->setHeld(false);
}
} // namespace app
