#pragma once

#include "app/classroom/class_work.h"

#include <QObject>

namespace ui
{
class QuestionnairePanel;
}

namespace app
{
/// Asks the six questions after a turn whose work is kept, and keeps each answer with the work as soon as it is given:
/// a program that ends in the form loses nothing. Meanwhile the work stays on this computer. Thread: gui.
class TurnQuestions : public QObject
{
    Q_OBJECT

public:
    /// `work`: not owned; must outlive this. `over`: the widget that the form covers, which owns it.
    TurnQuestions(ClassWork* work, QWidget* over);

    void ask(const EndedTurn& ended);
    /// Closes the form, if it is open, with the answers that are there; emits nothing.
    void finish();

Q_SIGNALS:
    /// Emitted when the pupil has closed the form.
    void done();

private:
    ClassWork* m_work;
    ui::QuestionnairePanel* m_panel;
    EndedTurn m_ended; ///< the turn that is asked about
};
} // namespace app
