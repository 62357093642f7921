#include "ui/settings/printer_presets.h"

namespace ui
{
namespace
{
constexpr QLatin1Char divider('\t');
} // namespace

QList<PrinterPreset> defaultPrinters()
{
    return {
        {QStringLiteral("Prusa MK4"), {250, 210, 220}},         {QStringLiteral("Prusa MINI"), {180, 180, 180}},
        {QStringLiteral("Prusa XL"), {360, 360, 360}},          {QStringLiteral("Bambu Lab A1"), {256, 256, 256}},
        {QStringLiteral("Bambu Lab A1 mini"), {180, 180, 180}}, {QStringLiteral("Creality Ender-3"), {220, 220, 250}},
        {QStringLiteral("UltiMaker S5"), {330, 240, 300}},      {QStringLiteral("Formlabs Form 4"), {200, 125, 210}}};
}

QStringList toLines(const QList<PrinterPreset>& printers)
{
    QStringList lines;
    for (const PrinterPreset& printer : printers) {
        QStringList fields{printer.name};
        for (const double side : {printer.bed.x, printer.bed.y, printer.bed.z})
            fields << QString::number(side, 'g', 12);
        lines << fields.join(divider);
    }
    return lines;
}

QList<PrinterPreset> printersOf(const QStringList& lines)
{
    QList<PrinterPreset> printers;
    for (const QString& line : lines) {
        const QStringList fields = line.split(divider);
        if (fields.size() != 4 || fields[0].trimmed().isEmpty())
            continue;
        double sides[3];
        bool areSides = true;
        for (int i = 0; i < 3; ++i) {
            bool ok = false;
            sides[i] = fields[i + 1].toDouble(&ok);
            areSides = areSides && ok && sides[i] >= minBed && sides[i] <= maxBed;
        }
        if (areSides)
            printers << PrinterPreset{fields[0], {sides[0], sides[1], sides[2]}};
    }
    return printers;
}
} // namespace ui
