#pragma once

#include "ui/classroom/class_bar.h"
#include "ui/scene/headset_avatar.h"

namespace ui
{
class Actions;
class BrushCaption;
class BrushSettings;
class Viewport;

/// A tool bar for the person at the desktop while another person is in VR: a large caption of the brush for the
/// audience, and buttons to point and to take over. Visible only while the headset is worn. Thread: gui.
class PartnerBar : public QToolBar
{
    Q_OBJECT

public:
    struct Parts
    {
        const Actions* actions;
        BrushSettings* brush;
        Viewport* viewport;
    };

    /// Adds the bar to the window. Precondition: the parts, which are not owned, outlive the bar.
    PartnerBar(const Parts& parts, QMainWindow* window);

    /// Returns a length without its unit: three significant digits, no trailing zeros.
    static QString figures(double mm);

    void setWorn(bool isWorn);
    /// Sets the person in VR, whose brush radius the caption shows; nullopt: unknown.
    void setAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Sets the remaining time of a class's turn; nullopt: the turn has no end.
    void setTime(const std::optional<TurnTime>& time);

    /// Ignores `visible`: the bar is visible while the headset is worn. QMainWindow::restoreState() would otherwise
    /// hide or show it.
    void setVisible(bool visible) override;

private:
    void updateCaption();

    Parts m_parts;
    BrushCaption* m_caption;
    QAction* m_captionCell;
    bool m_isWorn = false;
    std::optional<double> m_radius; ///< brush radius of the person in VR, mm
    std::optional<TurnTime> m_time;
};
} // namespace ui
