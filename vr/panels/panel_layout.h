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
// Lengths on panels are in dmm, millimetres as seen from one metre: what is 60 dmm high is 3.44 degrees high from
// wherever the panel is meant to be read. x to the right, y down, from the panel's upper left corner.

enum class TextRole { Title, Body, Faint, Number };

struct TextLook
{
    QString text;
    TextRole role = TextRole::Body;
    Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter;
    int lines = 1;
};

/// The icon :/icons/<name>.svg, a text, or both.
struct ButtonLook
{
    QString text{};
    QString icon{};
    bool isChosen = false;
    bool isUpright = false; ///< the text below the icon
    bool isFlat = false;    ///< no ground of its own unless it is chosen or pointed at
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
    double origin = 0;      ///< the bar grows from there
    QColor first{}, last{}; ///< what the ends stand for; invalid: a plain bar
    bool isChosen = false;
};

struct SwatchLook
{
    core::Rgb color;
    bool isChosen = false;
};

/// A model as a picture with its name.
struct TileLook
{
    QString name;
    QImage picture; ///< null: the icon
    QString icon;
    bool isChosen = false;
};

/// The background of several items.
struct WellLook
{};

using ItemLook = std::variant<TextLook, ButtonLook, SwitchLook, SliderLook, SwatchLook, TileLook, WellLook>;

/// Its look stays within its area. An item that acts overlaps no other such item.
struct PanelItem
{
    QRectF area;
    ItemLook look;
    std::optional<PanelAction> action{}; ///< of a slider: sets its present value
    bool isEnabled = true;
    bool mustHold = false; ///< acts when it has been pressed for holdSeconds

    bool isSlider() const { return std::holds_alternative<SliderLook>(look); }
    bool isInteractive() const { return action && isEnabled; }
};

/// What is where on a panel, for painting and pointing both.
struct PanelLayout
{
    PanelKind kind = PanelKind::Notice;
    QSizeF size;                  ///< dmm
    double distance = 0.6;        ///< metres from which it is to be read
    std::vector<PanelItem> items; ///< what comes later lies above

    /// Width and height in the room.
    Eigen::Vector2d metres() const;
    /// `point`: metres from the panel's middle, x to the right, y up.
    QPointF toPanel(const Eigen::Vector2d& point) const;
    bool contains(const Eigen::Vector2d& point) const;

    /// Null if no interactive item is there.
    const PanelItem* itemAt(const Eigen::Vector2d& point) const;
    const PanelItem* itemFor(const PanelAction& action) const;
    /// What a press there wants.
    std::optional<PanelAction> hit(const Eigen::Vector2d& point) const;
};

/// Where the middle of a slider's knob can be, from its least value to its most.
QLineF sliderTrack(const QRectF& area);
double sliderShare(const SliderLook& look, double value);
/// Precondition: the item is interactive. A slider's value follows the point's x and stays in its range.
PanelAction actionAt(const PanelItem& item, const QPointF& point);
} // namespace vr
