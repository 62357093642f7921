#pragma once

#include "core/io/stroke/stroke_file.h"

namespace core
{
/// Spacing of a preset whose file has no "spacing", in radii.
inline constexpr double presetSpacing = 0.25;
inline constexpr std::size_t maxPresetName = 80; ///< bytes
/// The range of BrushPreset::radiusShare.
inline constexpr double minPresetRadius = 0.002, maxPresetRadius = 0.5;

/// A named set of settings for one tool.
struct BrushPreset
{
    /// Flags for settings that a preset may leave out; a setting left out keeps the value of the current brush.
    struct Choices
    {
        bool reach = false, topology = false, detail = false, color = false;

        bool operator==(const Choices&) const = default;
    };

    std::string name; ///< shown to users; one line of UTF-8, 1 to maxPresetName bytes
    /// The preset's tool, strength, falloff, spacing, airbrush, inverted, alphaFollows, anchored and any built-in
    /// alpha. Its brush, topology, detail and color count only if `chosen` has them.
    StrokeSettings stroke;
    Choices chosen;
    std::optional<double> radiusShare; ///< radius as a fraction of the model's longest side
    StrokeNeed alpha;                  ///< the alpha if it is an image file and not yet loaded into `stroke`
    std::string alphaImage;            ///< content of that image file, in base64; may be empty
};

/// Parses a preset file: one brush with a name, as JSON. The keys of "stroke" are those of the stroke file
/// (stroke_file.h).
///
///     {"format":"fettle-brush","version":1,"name":"Pores","radius_share":0.1,
///      "stroke":{"tool":"clay","brush":"ray","strength":0.4,"falloff":4,"detail":1,"topology":"refine","spacing":2,
///                "airbrush":0,"invert":true,"alpha":"pores","alpha_follows":true,"anchored":true,
///                "color":[200,120,80]},
///      "alpha_image":"…"}
///
/// Required keys: format, version, name and stroke; in stroke: tool. If "brush", "detail", "topology" or "color" is
/// missing, the brush keeps its current value. "radius_share" (0.002 to 0.5) is optional, too, and is used only if the
/// user lets each tool have its own radius. The other defaults are those of a new brush: "spacing" 0.25, "airbrush" 10.
/// "alpha_image" is the base64 image of an alpha that is not in builtInAlphas().
///
/// Throws StrokeFileError. Kind::NewerVersion takes precedence over all other errors in the file.
BrushPreset parseBrush(std::string_view text);
BrushPreset readBrush(const std::filesystem::path& path);

/// Writes the preset with enough digits that reading returns bit-identical numbers.
std::string toJson(const BrushPreset& preset);
} // namespace core
