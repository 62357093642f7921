#pragma once

#include "ui/input/pointer_input.h"

#include <QTimer>

namespace ui
{
/// A mode in which the pointer shows others a place of the model instead of sculpting. Escape or any other pointer mode
/// ends it. Thread: gui.
class PointerSpotlight : public QObject
{
    Q_OBJECT

public:
    /// The input is not owned.
    explicit PointerSpotlight(PointerInput* input, QObject* parent = nullptr);

    void setOn(bool on);
    bool isOn() const { return m_input->mode() == PointerMode::Point; }
    /// Restarts the time after which a resting pointer shows no place. Must be called when the pointer moves.
    void restartTimer();
    /// Returns the place reported last.
    const std::optional<core::SurfaceHit>& place() const { return m_place; }

Q_SIGNALS:
    /// The place changed. nullopt: the pointer has left the model, or has rested for 4 seconds.
    void pointed(const std::optional<core::SurfaceHit>& place);

private:
    void report();

    PointerInput* m_input;
    QTimer m_timer; ///< runs out when the pointer has rested for 4 seconds
    std::optional<core::SurfaceHit> m_place;
};
} // namespace ui
