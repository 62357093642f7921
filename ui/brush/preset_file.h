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
/// A preset and its file, or the reason why the file was refused.
struct PresetFile
{
    QString path;                                    ///< ":/brushes/…" if the preset is part of the program
    std::shared_ptr<const core::BrushPreset> preset; ///< null: the file was refused
    QString problem;
};

/// Returns the presets that are part of the program (resources/brushes), in the order of the list.
QStringList bundledPresets();

/// Reads a preset. Thread: any, as for all functions below; none of them throws.
PresetFile readPreset(const QString& path);
/// Returns the path of the preset's alpha file. Precondition: the preset has one. An image embedded in the preset is at
/// this path after layAlphaDown().
QString alphaPath(const PresetFile& file);
/// Returns the preset's alpha, from the embedded image or else from the file at alphaPath().
BrushFile<core::Alpha> alphaOf(const PresetFile& file);
/// Writes the image embedded in the preset to alphaPath(), so that strokes and settings can name a file. Returns a
/// message if writing fails; else empty.
QString layAlphaDown(const PresetFile& file);
/// Embeds the image of the preset's alpha, so that the preset needs no other file. Does nothing if the alpha is built
/// in or already embedded, or if there is none. `from`: file that the preset was read from or will be written to.
/// Returns a message if the image cannot be read; else empty.
QString embedAlpha(core::BrushPreset& preset, const QString& from);
/// Writes the preset atomically. Returns a message if writing fails; else empty.
QString writePreset(const core::BrushPreset& preset, const QString& path);

/// Returns a square picture of a stroke with this brush; null if stopped. An unreadable alpha is left out.
QImage presetImage(const PresetFile& file, int pixels, const std::stop_token& stop);
} // namespace ui
