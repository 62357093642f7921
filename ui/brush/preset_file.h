#pragma once

#include "ui/brush/brush_files.h"

#include "core/io/stroke/brush_file.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <memory>
#include <stop_token>

namespace ui
{
/// A preset with its file, or one sentence with file, place and reason why there is none.
struct PresetFile
{
    QString path;                                    ///< ":/brushes/…" of those that come with the program
    std::shared_ptr<const core::BrushPreset> preset; ///< null: refused
    QString problem;
};

/// The presets that come with the program (resources/brushes), in the order of the shelf.
QStringList bundledPresets();

/// Any thread, like all that follows; none throws.
PresetFile readPreset(const QString& path);
/// Returns where the alpha is of a preset whose alpha is a file: an image in the preset is there after layAlphaDown().
QString alphaPath(const PresetFile& file);
/// Returns that alpha.
BrushFile<core::Alpha> alphaOf(const PresetFile& file);
/// Writes the image in the preset to alphaPath(), so that strokes and settings can name it. Returns one sentence if
/// that cannot be done.
QString layAlphaDown(const PresetFile& file);
/// Puts the image of the preset's alpha file into it, so that it needs no other file. `from`: the file that the preset
/// is from, or is made for. Returns one sentence if the image cannot be read.
QString embedAlpha(core::BrushPreset& preset, const QString& from);
/// Writes the preset, whole or not at all. Returns one sentence if that cannot be done.
QString writePreset(const core::BrushPreset& preset, const QString& path);

/// Returns a square picture of what the brush does; null if it was stopped. An alpha that cannot be read is left out.
QImage presetImage(const PresetFile& file, int pixels, const std::stop_token& stop);
} // namespace ui
