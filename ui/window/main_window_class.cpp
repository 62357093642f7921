// What becomes of the main window in a class.

#include "ui/window/main_window_state.h"

#include "ui/brush/brush_shapes.h"
#include "ui/brush/color_panel.h"
#include "ui/classroom/classroom_lock.h"

#include <QAction>

namespace ui
{
void MainWindow::setClassroom(const Classroom& classroom)
{
    m_state->classroom = classroom;
    m_state->files.refuseDrops();
    m_state->shapes->setMayLoad(false);
    m_state->brush.offerTools(classroom.tools);
    lockWindow(this, m_state->actions, classroom);
    m_state->turnDefaults = {switchesOf(m_state->actions), findChild<ColorPanel*>()->swatches(), saveState(),
                             m_state->viewport->camera().saved()};
}

/// The settings first: they bring panels and switches of their own, of which a class has less.
void MainWindow::beginTurn()
{
    const TurnDefaults& turnDefaults = m_state->turnDefaults;
    m_state->viewport->input()->finish();
    m_state->settings.reset();
    restoreState(turnDefaults.bars);
    m_state->brush.reset();
    m_state->brush.setRadiusShare(m_state->settings.get(&Setting::radiusShare));
    findChild<ColorPanel*>()->reset(turnDefaults.swatches);
    setSwitches(m_state->actions, turnDefaults.switches);
    m_state->viewport->navigation()->setView(turnDefaults.view);
    m_state->viewport->navigation()->frame();
}
} // namespace ui
