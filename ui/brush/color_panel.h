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

/// A panel for the paint colour: colour wheel, channels, name, swatches, and a second colour to swap with. Thread: gui.
class ColorPanel : public QWidget
{
    Q_OBJECT

public:
    /// Nothing is owned. Precondition: all arguments outlive the panel.
    ColorPanel(BrushSettings* brush, Settings* settings, const Actions& actions, QWidget* parent = nullptr);

    /// Returns the widget that gets the keyboard focus first.
    ColorWheel* wheel() const { return m_wheel; }
    void swap();
    /// Shows the swatches of a model until another model is opened. The user's stored swatches stay unchanged until the
    /// user edits a swatch.
    void setSwatches(const QList<core::Rgb>& swatches);
    const QList<core::Rgb>& swatches() const;
    /// Stores these swatches as the user's own and sets the second colour to white.
    void reset(const QList<core::Rgb>& swatches);

Q_SIGNALS:
    void swatchesChanged();
    /// A number was typed and confirmed with Return.
    void entered();
    /// The typed text is not a colour. `sentence`: the message for the user.
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
    QToolButton* m_pair; ///< shows the paint colour and the second colour; a click swaps them
    QLineEdit* m_name;
    std::array<Channel, 3> m_channels;
    ColorSwatches* m_swatches;
};

struct ColorPanelContext
{
    SideColumn* column;
    Viewport* viewport;
};

/// Adds the panel to the column and connects the actions brush.color, color.pick and color.swap. `notice` shows a short
/// message.
void addColorPanel(const ColorPanelContext& context, BrushSettings* brush, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice);
} // namespace ui
