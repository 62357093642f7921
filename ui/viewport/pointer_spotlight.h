#pragma once

#include "ui/input/pointer_input.h"

#include <QTimer>

namespace ui
{
/// Lets the pointer show a place of the model to others instead of sculpting. Escape ends it, and so does any other
/// mode of the pointer. Thread: gui.
class PointerSpotlight : public QObject
{
    Q_OBJECT

public:
    /// The input is not owned.
    explicit PointerSpotlight(PointerInput* input, QObject* parent = nullptr);

    void setOn(bool on);
    bool isOn() const { return m_input->mode() == PointerMode::Point; }
    /// Restarts the time after which a resting pointer points at nothing. Call when the pointer moves.
    void restartTimer();
    /// The place as it was reported last.
    const std::optional<core::SurfaceHit>& place() const { return m_place; }

Q_SIGNALS:
    /// Nothing: the pointer has left the model, or has rested for a while.
    void pointed(const std::optional<core::SurfaceHit>& place);

private:
    void report();

    PointerInput* m_input;
    QTimer m_timer; ///< runs out while the pointer rests
    std::optional<core::SurfaceHit> m_place;
};
} // namespace ui
