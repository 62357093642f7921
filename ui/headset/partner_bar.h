#pragma once

#include "ui/classroom/class_bar.h"
#include "ui/scene/headset_avatar.h"

namespace ui
{
class Actions;
class BrushCaption;
class BrushSettings;
class Viewport;

/// For the one at the desktop while somebody is in VR: a large caption of the brush for those who watch, and buttons to
/// point and to take over. It is there only while VR is worn. Thread: gui.
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

    /// None is owned, and all outlive the bar. Shows itself in the window.
    PartnerBar(const Parts& parts, QMainWindow* window);

    /// A length without its unit, as one reads it aloud: three figures at most, and no noughts after them.
    static QString figures(double mm);

    void setWorn(bool isWorn);
    /// Whose brush radius the caption shows; none: not known yet.
    void setAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Of a class's turn; nothing: it has no end.
    void setTime(const std::optional<TurnTime>& time);

    /// What the window's own state, which is kept, says of it does not count.
    void setVisible(bool visible) override;

private:
    void updateCaption();

    Parts m_parts;
    BrushCaption* m_caption;
    QAction* m_captionCell;
    bool m_isWorn = false;
    std::optional<double> m_radius; ///< the avatar's, mm
    std::optional<TurnTime> m_time;
};
} // namespace ui
