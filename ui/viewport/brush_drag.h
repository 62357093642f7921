#pragma once

#include "ui/settings/brush_settings.h"

#include <QLabel>

#include <optional>

class QSinglePointEvent;

namespace ui
{
class Viewport;

/// Changes a value of the brush by moving the pointer over the view without a button. A click or Return accepts the
/// value; Esc or the right button restores the old one. Meanwhile the brush's ring stays in place and shows the radius;
/// this label beside it shows the value. Thread: gui.
class BrushDrag : public QLabel
{
    Q_OBJECT

public:
    /// The viewport is the label's parent; the brush is not owned.
    BrushDrag(BrushSettings* brush, Viewport* viewport);

    /// Starts changing `parameter`, which must be Radius or Strength. If a change is already in progress, accepts it
    /// instead. No effect while the view is hidden, a stroke is open or a press is pending.
    void begin(core::Parameter parameter);
    bool isActive() const { return m_parameter.has_value(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool handleKey(int key);
    bool handlePointer(const QSinglePointEvent& event);
    void moveTo(double x);
    void accept();
    void cancel();
    void showValue();
    void place();

    BrushSettings* m_brush;
    Viewport* m_viewport;
    std::optional<core::Parameter> m_parameter; ///< parameter being changed; nullopt: no change in progress
    std::optional<double> m_from;               ///< x of the first pointer move, pixels
    QPoint m_center;                            ///< centre of the ring in the view, pixels
    double m_before = 0;
    /// the release of the mouse press that ended the change is still to come, and must be swallowed
    bool m_releaseFollows = false;
};
} // namespace ui
