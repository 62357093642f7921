#pragma once

#include "ui/settings/brush_settings.h"

#include <QLabel>

#include <optional>

class QSinglePointEvent;

namespace ui
{
class Viewport;

/// Changes a value of the brush by moving the pointer over the view, no button held: a click or Return keeps it, Esc or
/// the right button goes back. The ring stays where it is and shows the radius; the word beside it shows the value.
/// Thread: gui.
class BrushDrag : public QLabel
{
    Q_OBJECT

public:
    /// The view is the label's parent; the brush is not owned.
    BrushDrag(BrushSettings* brush, Viewport* viewport);

    /// Of Radius or Strength. While one goes on it is kept; nothing happens while a stroke is open.
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
    std::optional<core::Parameter> m_parameter; ///< while it goes on
    std::optional<double> m_from;               ///< x of the first move
    QPoint m_center;                            ///< of the ring, in the view
    double m_before = 0;
    bool m_releaseFollows = false; ///< of the press that ended it
};
} // namespace ui
