#pragma once

#include "core/lesson/lesson_player.h"
#include "ui/viewport/viewport.h"

#include <QElapsedTimer>
#include <QPointer>

#include <optional>

namespace app
{
/// Turns the view to the working area of a step, and keeps the demonstration's brush visible. Thread: gui.
class LessonCamera
{
public:
    /// Does not own the viewport.
    explicit LessonCamera(ui::Viewport* viewport) : m_viewport(viewport) {}

    /// Moves the camera to the step's view, if it has one, so that the model and the whole demonstration are visible.
    void show(const core::LessonStep& step);
    /// Follows the moving brush of the demonstration. `shown`: sphere of the brush as displayed, model space, mm.
    void follow(const core::GhostBrush& ghost, const core::Sphere& shown);
    /// Forgets the last brush. Called when the demonstration begins or ends.
    void rest() { m_turned.reset(); }

private:
    bool isInSight(const core::Sphere& shown) const;

    QPointer<ui::Viewport> m_viewport;
    /// turntable angle of the demonstration at the last call of follow(), radians; none: not called since rest()
    std::optional<double> m_turned;
    QElapsedTimer m_sinceFlight;
};
} // namespace app
