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
// Lengths on panels are in dmm, millimetres as seen from one metre: what is 60 dmm high is 3.44 degrees high from wherever the panel is
// meant to be read. x to the right, y down, from the panel's upper left corner.

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
    double least = 0, most = 1, step = 0.01;
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

/// The ground of several parts.
struct WellLook
{};

using PartLook = std::variant<TextLook, ButtonLook, SwitchLook, SliderLook, SwatchLook, TileLook, WellLook>;

/// Its look stays within its area. A part that acts overlaps no other such part.
struct PanelPart
{
    QRectF area;
    PartLook look;
    std::optional<PanelAction> action{}; ///< a slider's: its value
    bool isEnabled = true;
    bool mustHold = false; ///< acts when it has been pressed for holdSeconds

    bool isSlider() const { return std::holds_alternative<SliderLook>(look); }
    bool answers() const { return action && isEnabled; }
};

/// What is where on a panel, for painting and pointing both.
struct PanelLayout
{
    PanelKind kind = PanelKind::Notice;
    QSizeF size;                  ///< dmm
    double distance = 0.6;        ///< metres from which it is to be read
    std::vector<PanelPart> parts; ///< what comes later lies above

    /// Width and height in the room.
    Eigen::Vector2d metres() const;
    /// `point`: metres from the panel's middle, x to the right, y up.
    QPointF toPanel(const Eigen::Vector2d& point) const;
    bool contains(const Eigen::Vector2d& point) const;

    /// Null: nothing there that would answer.
    const PanelPart* partAt(const Eigen::Vector2d& point) const;
    const PanelPart* partFor(const PanelAction& action) const;
    /// What a press there wants.
    std::optional<PanelAction> hit(const Eigen::Vector2d& point) const;
};

/// Where the middle of a slider's knob can be, from its least value to its most.
QLineF sliderTrack(const QRectF& area);
double sliderShare(const SliderLook& look, double value);
/// Of a part that answers; of a slider by the point's x, whose value stays in its range.
PanelAction actionAt(const PanelPart& part, const QPointF& point);
} // namespace vr
