#pragma once

#include "core/stroke/stroke.h"

#include <QObject>

#include <array>
#include <memory>
#include <optional>

namespace ui
{
/// Default spacing of dabs, in radii: dense enough for an even furrow, wide enough that slow strokes do not dig a hole.
inline constexpr double defaultSpacing = 0.25;

/// Values that each tool has of its own. Each is in the range that stroke files allow.
struct ToolValues
{
    double strength = core::info(core::Parameter::Strength).defaultValue;
    int falloff = static_cast<int>(core::info(core::Parameter::Falloff).defaultValue);
    double spacing = defaultSpacing;
    /// dabs per second while the pointer rests, if the tool can airbrush; 0: none
    double airbrush = core::defaultAirbrush;
    std::shared_ptr<const core::Alpha> alpha;
    bool alphaFollows = false;
    bool anchored = false; ///< see StrokeSettings::anchored
    /// radius as a fraction of the model's longest side; nullopt: the tool never had a radius of its own
    std::optional<double> radiusShare;

    bool operator==(const ToolValues&) const = default;
};

/// Copies strength, falloff, spacing, alpha and anchoring into a stroke.
void putInto(core::StrokeSettings& stroke, const ToolValues& values);
/// Copies strength, falloff, spacing, alpha and anchoring from a stroke.
void takeFrom(const core::StrokeSettings& stroke, ToolValues& values);

/// The values of every tool, kept while another tool is in use. Thread: gui.
class ToolMemory : public QObject
{
    Q_OBJECT

public:
    explicit ToolMemory(QObject* parent = nullptr) : QObject(parent) {}

    const ToolValues& of(core::Tool tool) const { return m_values[static_cast<std::size_t>(tool)]; }
    void set(core::Tool tool, const ToolValues& values);
    /// Resets the values of all tools to those of a new user.
    void reset();

    /// Returns true if the tool's strokes continue while the pointer rests. Initially true for every tool that can
    /// airbrush.
    bool isAirbrush(core::Tool tool) const { return airbrush(tool) > 0; }
    void setAirbrush(core::Tool tool, bool on);
    /// Returns the dabs per second while the pointer rests; 0: airbrush off, or the tool cannot.
    double airbrush(core::Tool tool) const { return core::canAirbrush(tool) ? of(tool).airbrush : 0; }

    /// Returns true if changing the tool keeps the radius. Initially true.
    bool sharesRadius() const { return m_sharesRadius; }
    void setSharesRadius(bool shares);

Q_SIGNALS:
    /// set() changed a tool's values.
    void changed(core::Tool tool);
    /// The airbrush of a tool changed. Emitted after changed().
    void airbrushChanged();
    void sharesRadiusChanged(bool shares);

private:
    std::array<ToolValues, core::toolNames().size()> m_values;
    bool m_sharesRadius = true;
};
} // namespace ui
