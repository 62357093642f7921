#pragma once

#include "vr/panels/panel_action.h"

#include <Eigen/Core>

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QRectF>

#include <optional>
#include <vector>

namespace vr
{
// Lengths on panels are in dmm: millimetres as seen from a distance of one metre. An item of 60 dmm is 3.44 degrees
// high at the distance from which its panel is meant to be read. x is to the right, y down, from the panel's upper left
// corner.

enum class TextRole { Title, Body, Faint, Number };

struct TextLook
{
    QString text;
    TextRole role = TextRole::Body;
    Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter;
    int lines = 1;
};

/// A button with the icon :/icons/<name>.svg, a text, or both.
struct ButtonLook
{
    QString text{};
    QString icon{};
    bool isChosen = false;
    bool isUpright = false; ///< the text is below the icon
    bool isFlat = false;    ///< no background unless the button is chosen or pointed at
};

/// A switch that is on or off, and its text.
struct SwitchLook
{
    QString text{};
    bool isOn = false;
};

struct SliderLook
{
    double min = 0, max = 1, step = 0.01;
    double origin = 0;      ///< value at which the filled bar begins
    QColor first{}, last{}; ///< colours of the least and the greatest value; invalid: a plain bar
    bool isChosen = false;
};

struct SwatchLook
{
    core::Rgb color;
    bool isChosen = false;
};

/// A model's picture with its name.
struct TileLook
{
    QString name;
    QImage picture; ///< null: the icon is shown
    QString icon;
    bool isChosen = false;
};

/// The background of several items.
struct WellLook
{};

using ItemLook = std::variant<TextLook, ButtonLook, SwitchLook, SliderLook, SwatchLook, TileLook, WellLook>;

/// A part of a panel. Its look is drawn within its area. Items that act do not overlap each other.
struct PanelItem
{
    QRectF area;
    ItemLook look;
    std::optional<PanelAction> action{}; ///< action of a press; for a slider, a Slide with its present value
    bool isEnabled = true;
    bool mustHold = false; ///< the item acts when it has been pressed for holdSeconds

    bool isSlider() const { return std::holds_alternative<SliderLook>(look); }
    bool isInteractive() const { return action && isEnabled; }
};

/// The items of a panel and their places, used for both painting and pointing.
struct PanelLayout
{
    PanelKind kind = PanelKind::Notice;
    QSizeF size;                  ///< dmm
    double distance = 0.6;        ///< distance from which the panel is meant to be read, metres
    std::vector<PanelItem> items; ///< later items are drawn above earlier ones

    /// Returns the width and height in the room, metres.
    Eigen::Vector2d metres() const;
    /// Returns a point in the panel's coordinates, dmm. `point`: metres from the panel's middle, x to the right, y up.
    QPointF toPanel(const Eigen::Vector2d& point) const;
    bool contains(const Eigen::Vector2d& point) const;

    /// Returns the interactive item at a point; null if there is none.
    const PanelItem* itemAt(const Eigen::Vector2d& point) const;
    const PanelItem* itemFor(const PanelAction& action) const;
    /// Returns the action of a press at a point; none if no interactive item is there.
    std::optional<PanelAction> hit(const Eigen::Vector2d& point) const;
};

/// Returns the line on which the middle of a slider's knob moves, from the least value to the greatest.
QLineF sliderTrack(const QRectF& area);
double sliderShare(const SliderLook& look, double value);
/// Returns the action of a press at a point. A slider's value follows the point's x and stays in its range.
/// Precondition: the item is interactive.
PanelAction actionAt(const PanelItem& item, const QPointF& point);
} // namespace vr
