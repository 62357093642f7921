#include "ui/settings/stored_brush.h"

#include "ui/settings/settings.h"

#include <cmath>

namespace ui
{
namespace
{
template <class Visit> void forEachTool(const Visit& visit)
{
    for (std::size_t i = 0; i < core::toolNames().size(); ++i)
        visit(static_cast<core::Tool>(i));
}

QString nameOf(core::Tool tool)
{
    const std::string_view name = core::name(tool);
    return QLatin1StringView(name.data(), static_cast<qsizetype>(name.size()));
}

/// Returns the tool's airbrush, dabs per second, in settings from before each tool stored its own.
double firstAirbrush(core::Tool tool, const QStringList& without)
{
    return without.contains(nameOf(tool)) ? 0 : core::defaultAirbrush;
}
} // namespace

QString groupOf(core::Tool tool)
{
    return QStringLiteral("tool/") + nameOf(tool) + u'/';
}

void restoreBrush(const Settings& settings, BrushSettings* brush)
{
    const StoredTool ofAll{settings.value(core::Parameter::Strength), settings.value(core::Parameter::Falloff),
                           settings.value(core::Parameter::Spacing), 0, 0};
    const QStringList withoutAirbrush = settings.get(&Setting::withoutAirbrush);
    // must be set first, or the radii below would be ignored
    brush->tools()->setSharesRadius(settings.get(&Setting::sharesRadius));
    forEachTool([&](core::Tool tool) {
        const auto stored = settings.get<StoredTool>(groupOf(tool), ofAll);
        ToolValues values = brush->tools()->of(tool);
        values.strength = stored.strength;
        if (const int falloff = static_cast<int>(std::lround(stored.falloff)); core::isFalloff(falloff))
            values.falloff = falloff;
        values.spacing = stored.spacing;
        values.airbrush = firstAirbrush(tool, withoutAirbrush);
        if (values.airbrush > 0 && stored.airbrush >= core::minAirbrush)
            values.airbrush = stored.airbrush;
        values.radiusShare.reset();
        if (stored.radiusShare > 0)
            values.radiusShare = stored.radiusShare;
        values.anchored = stored.anchored;
        brush->tools()->set(tool, values);
    });
    brush->setValue(core::Parameter::Detail, settings.value(core::Parameter::Detail));
}

void storeBrush(const BrushSettings& brush, Settings* settings)
{
    forEachTool([&](core::Tool tool) {
        const ToolValues& values = brush.tools()->of(tool);
        settings->set(StoredTool{values.strength, double(values.falloff), values.spacing, values.airbrush,
                                 values.radiusShare.value_or(0), values.anchored},
                      groupOf(tool));
    });
    settings->set(&Setting::sharesRadius, brush.tools()->sharesRadius());
    const ToolValues& ofFirst = brush.tools()->of(core::Tool::Pull);
    settings->setValue(core::Parameter::Strength, ofFirst.strength);
    settings->setValue(core::Parameter::Falloff, ofFirst.falloff);
    settings->setValue(core::Parameter::Spacing, ofFirst.spacing);
    settings->setValue(core::Parameter::Detail, brush.value(core::Parameter::Detail));
}
} // namespace ui
