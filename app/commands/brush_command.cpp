// brush: describes a preset file, or reports in one sentence why it is invalid. Optionally draws a picture of one
// stroke.
#include "app/commands/command_line.h"
#include "app/commands/command_options.h"

#include "ui/brush/preset_file.h"

#include <QFile>
#include <QImage>
#include <QLocale>

#include <algorithm>

namespace app
{
namespace
{
constexpr int pictureSide = 256; ///< width and height of the picture, pixels

class BrushCommandMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::BrushCommand)
};

/// Returns the name of a bundled preset on the command line, which is the base name of its file.
QString wordFor(const QString& path)
{
    return path.section(QLatin1Char('/'), -1).section(QLatin1Char('.'), 0, 0);
}

QString pathOf(const QString& nameOrPath)
{
    const QStringList bundled = ui::bundledPresets();
    const auto found = std::ranges::find_if(bundled, [&](const QString& path) { return wordFor(path) == nameOrPath; });
    return found == bundled.end() || QFile::exists(nameOrPath) ? nameOrPath : *found;
}

ui::PresetFile read(const QString& path)
{
    ui::PresetFile file = ui::readPreset(path);
    if (!file.preset)
        CommandLine::fail(file.problem);
    return file;
}

QString lineOf(const ui::PresetFile& file)
{
    const core::StrokeSettings& stroke = file.preset->stroke;
    const QString alpha =
        stroke.alpha ? QString::fromStdString(stroke.alpha->source()) : QString::fromStdString(file.preset->alpha.file);
    QString line = BrushCommandMessages::tr("%1: tool %2, strength %3, falloff %4, spacing %5")
                       .arg(QString::fromStdString(file.preset->name), QString::fromUtf8(core::name(stroke.tool)))
                       .arg(stroke.strength)
                       .arg(stroke.falloff)
                       .arg(stroke.spacing);
    if (!alpha.isEmpty())
        line += BrushCommandMessages::tr(", alpha %1").arg(alpha);
    return line + QLatin1Char('\n');
}

void draw(const ui::PresetFile& file, const QString& path)
{
    if (!file.preset->alpha.file.empty())
        if (const auto alpha = ui::alphaOf(file); !alpha.what)
            CommandLine::fail(alpha.problem);
    if (!ui::presetImage(file, pictureSide, {}).save(path, "PNG"))
        CommandLine::fail(BrushCommandMessages::tr("%1: this picture cannot be written.").arg(path));
}
} // namespace

ExitStatus brushCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        BrushCommandMessages::tr("Shows what a brush preset contains, or why it is invalid (status 2). Without a "
                                 "preset: lists the program's presets."));
    parser.addPositionalArgument(QStringLiteral("PRESET"),
                                 BrushCommandMessages::tr("A preset file, or the name of a preset of the program."),
                                 QStringLiteral("[PRESET]"));
    parser.addOption({QStringLiteral("picture"),
                      BrushCommandMessages::tr("File for a picture of one stroke of the brush, PNG."),
                      QStringLiteral("OUT.png")});
    CommandOptions::addNoClobber(parser);
    const CommandOptions options(parser, QStringLiteral("brush"), arguments);
    if (options.isAnswered())
        return Done;
    const QStringList presets = options.files();
    const QString picture = options.text(QStringLiteral("picture"));
    if (presets.size() > 1)
        CommandLine::fail(
            BrushCommandMessages::tr("brush: one preset at a time can be read, not %1 as well.").arg(presets.at(1)));
    if (presets.isEmpty() && !picture.isEmpty())
        CommandLine::fail(BrushCommandMessages::tr("brush: no preset was given."));
    options.requireFree(picture);
    if (presets.isEmpty()) {
        for (const QString& path : ui::bundledPresets())
            CommandLine::print(QStringLiteral("%1  %2").arg(wordFor(path), -14).arg(lineOf(read(path))));
        return Done;
    }
    const ui::PresetFile file = read(pathOf(presets.first()));
    CommandLine::print(lineOf(file));
    if (!picture.isEmpty())
        draw(file, picture);
    return Done;
}
} // namespace app
