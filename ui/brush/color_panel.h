#pragma once

#include "core/geometry/geometry.h"

#include <QWidget>

#include <array>
#include <functional>

class QLayout;
class QLineEdit;
class QPixmap;
class QSlider;
class QSpinBox;
class QToolButton;

namespace ui
{
class Actions;
class BrushSettings;
class ColorSwatches;
class ColorWheel;
class Settings;
class SideColumn;
class Viewport;

/// The paint colour by wheel, by channel, by name or from a swatch, and another to swap it with. Thread: gui.
class ColorPanel : public QWidget
{
    Q_OBJECT

public:
    /// None is owned; all must outlive the panel.
    ColorPanel(BrushSettings* brush, Settings* settings, const Actions& actions, QWidget* parent = nullptr);

    /// Where the keys go first.
    ColorWheel* wheel() const { return m_wheel; }
    void swap();
    /// A model's own, until another is opened; the person's own stay stored as they are while none is changed.
    void setSwatches(const QList<core::Rgb>& swatches);
    const QList<core::Rgb>& swatches() const;
    /// These are the person's own, and white is the other colour.
    void reset(const QList<core::Rgb>& swatches);

Q_SIGNALS:
    void swatchesChanged();
    /// A number was typed, and Return.
    void entered();
    /// What was typed is no colour.
    void refused(const QString& sentence);

private:
    struct Channel
    {
        QSlider* slider = nullptr;
        QSpinBox* box = nullptr;
    };

    QLayout* buildButtons(const Actions& actions);
    QLayout* buildChannels();
    void buildSwatches();
    Channel channel(const QString& name, const char* id, std::uint8_t core::Rgb::*what);
    void showColor();
    QPixmap pairPicture() const;
    void set(const core::Rgb& color);
    void setFromText();

    BrushSettings* m_brush;
    Settings* m_settings;
    core::Rgb m_other{255, 255, 255};
    ColorWheel* m_wheel;
    QToolButton* m_pair; ///< both colours
    QLineEdit* m_name;
    std::array<Channel, 3> m_channels;
    ColorSwatches* m_swatches;
};

struct ColorPanelContext
{
    SideColumn* column;
    Viewport* viewport;
};

/// Adds the panel to the column; brush.color opens it, color.pick and color.swap
/// work. `notice` says a small word.
void addColorPanel(const ColorPanelContext& context, BrushSettings* brush, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice);
} // namespace ui
