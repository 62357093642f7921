#pragma once

#include "core/lesson/lesson_player.h"
#include "ui/viewport/viewport.h"

#include <QElapsedTimer>
#include <QPointer>

#include <optional>

namespace app
{
/// Turns the view to where a step works, and keeps the teacher's brush in sight. Thread: gui.
class LessonCamera
{
public:
    /// Takes no ownership.
    explicit LessonCamera(ui::Viewport* viewport) : m_viewport(viewport) {}

    /// Flies to the step's view, where it has one, so that the model and all that the teacher does are in the picture.
    void show(const core::LessonStep& step);
    /// Follows the teacher's brush, which has moved. `shown`: where it meets the model.
    void follow(const core::GhostBrush& ghost, const core::Sphere& shown);
    /// Forgets the last brush: the teacher begins, or is done.
    void rest() { m_turned.reset(); }

private:
    bool isInSight(const core::Sphere& shown) const;

    QPointer<ui::Viewport> m_viewport;
    std::optional<double> m_turned; ///< radians: the model on the turntable, when the brush moved last
    QElapsedTimer m_sinceFlight;
};
} // namespace app
