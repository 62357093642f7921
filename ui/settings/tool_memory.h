#pragma once

#include "core/stroke/stroke.h"

#include <QObject>

#include <array>
#include <memory>
#include <optional>

namespace ui
{
/// The spacing of a new user's brush, in radii: dense enough for an even furrow, wide enough that a slow hand does not
/// dig a hole.
inline constexpr double defaultSpacing = 0.25;

/// The values that each tool has of its own, in the ranges of stroke files.
struct ToolValues
{
    double strength = core::info(core::Parameter::Strength).defaultValue;
    int falloff = static_cast<int>(core::info(core::Parameter::Falloff).defaultValue);
    double spacing = defaultSpacing;
    double airbrush = core::defaultAirbrush; ///< dabs a second where the hand rests, if the tool can; 0: none
    std::shared_ptr<const core::Alpha> alpha;
    bool alphaFollows = false;
    bool anchored = false; ///< StrokeSettings::anchored
    /// The radius as a share of the model's longest side; nothing: the tool never had a radius of its own.
    std::optional<double> radiusShare;

    bool operator==(const ToolValues&) const = default;
};

/// Puts strength, falloff, spacing, alpha and the anchor into a stroke.
void putInto(core::StrokeSettings& stroke, const ToolValues& values);
/// Takes them from a stroke.
void takeFrom(const core::StrokeSettings& stroke, ToolValues& values);

/// Remembers the values of every tool while another one is in the hand. Thread: gui.
class ToolMemory : public QObject
{
    Q_OBJECT

public:
    explicit ToolMemory(QObject* parent = nullptr) : QObject(parent) {}

    const ToolValues& of(core::Tool tool) const { return m_values[static_cast<std::size_t>(tool)]; }
    void set(core::Tool tool, const ToolValues& values);
    /// Forgets everything: each tool has the values of a new user's.
    void reset();

    /// Whether strokes of the tool go on where the hand rests. At first those of each tool that can.
    bool isAirbrush(core::Tool tool) const { return airbrush(tool) > 0; }
    void setAirbrush(core::Tool tool, bool on);
    /// Returns the dabs a second where the hand rests; 0: none, or the tool cannot.
    double airbrush(core::Tool tool) const { return core::canAirbrush(tool) ? of(tool).airbrush : 0; }

    /// Whether a change of tool leaves the radius as it is. At first it does.
    bool sharesRadius() const { return m_sharesRadius; }
    void setSharesRadius(bool shares);

Q_SIGNALS:
    /// set() gave a tool other values.
    void changed(core::Tool tool);
    /// The values that changed() tells of include the airbrush.
    void airbrushChanged();
    void sharesRadiusChanged(bool shares);

private:
    std::array<ToolValues, core::toolNames().size()> m_values;
    bool m_sharesRadius = true;
};
} // namespace ui
