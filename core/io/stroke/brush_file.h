#pragma once

#include "core/io/stroke/stroke_file.h"

namespace core
{
/// The spacing of a preset that names none, in radii.
inline constexpr double presetSpacing = 0.25;
inline constexpr std::size_t maxPresetName = 80; ///< bytes
/// The range of BrushPreset::radiusShare.
inline constexpr double minPresetRadius = 0.002, maxPresetRadius = 0.5;

/// A tool with its values, under a name.
struct BrushPreset
{
    /// Names the values that a preset may leave to the brush that is there.
    struct Choices
    {
        bool reach = false, topology = false, detail = false, color = false;

        bool operator==(const Choices&) const = default;
    };

    std::string name; ///< for people; one line of UTF-8, 1 to maxPresetName bytes
    /// Tool, strength, falloff, spacing, airbrush, inverted, alphaFollows, anchored, and an alpha of ours; brush,
    /// topology, detail and color as far as they are chosen.
    StrokeSettings stroke;
    Choices chosen;
    std::optional<double> radiusShare; ///< the radius as a share of the model's longest side
    StrokeNeed alpha;                  ///< an alpha that is a file, while the settings have none
    std::string alphaImage;            ///< that file, in base64; may be empty
};

/// The preset file: a brush under a name. JSON; the keys of "stroke" are those of the stroke file (stroke_file.h).
///
///     {"format":"fettle-brush","version":1,"name":"Pores","radius_share":0.1,
///      "stroke":{"tool":"clay","brush":"ray","strength":0.4,"falloff":4,"detail":1,"topology":"refine","spacing":2,
///                "airbrush":0,"invert":true,"alpha":"pores","alpha_follows":true,"anchored":true,
///                "color":[200,120,80]},
///      "alpha_image":"…"}
///
/// Required: format, version, name, stroke, and in it tool. "brush", "detail", "topology" and "color" change nothing
/// where they are missing; so does "radius_share" (0.002 to 0.5), which only counts where each tool has a radius of its
/// own. The other defaults are those of a new brush: "spacing" 0.25, "airbrush" 10. "alpha_image": the image of an
/// alpha that is none of builtInAlphas(), in base64.
///
/// Throws StrokeFileError; NewerVersion wins over all that such a file may have besides.
BrushPreset parseBrush(std::string_view text);
BrushPreset readBrush(const std::string& path);

/// Writes what the preset says, with enough digits to come back bit-identical.
std::string toJson(const BrushPreset& preset);
} // namespace core
