#pragma once

#include "app/classroom/class_work.h"

#include <QObject>

namespace ui
{
class QuestionnairePanel;
}

namespace app
{
/// Asks the questionnaire after a turn, and saves each answer with the turn's work at once, so that a crash loses none.
/// The work is held on this computer meanwhile. Thread: gui.
class TurnQuestions : public QObject
{
    Q_OBJECT

public:
    /// `work` is not owned and must outlive this. `over`: the widget that the form covers and that owns the form.
    TurnQuestions(ClassWork* work, QWidget* over);

    void ask(const EndedTurn& ended);
    /// Closes the form if it is open, and saves its answers. Does not emit done().
    void finish();

Q_SIGNALS:
    /// Emitted when the pupil has closed the form.
    void done();

private:
    ClassWork* m_work;
    ui::QuestionnairePanel* m_panel;
    EndedTurn m_ended; ///< the turn that the questions are about
};
} // namespace app
