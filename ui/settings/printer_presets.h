#pragma once

#include "core/print/print_check.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace ui
{
struct PrinterPreset
{
    QString name; ///< must not be empty
    core::PrintBed bed;
};

inline constexpr double minBed = 10, maxBed = 10'000; ///< smallest and largest side of a printer's bed, mm

/// Returns common printers with the bed sizes published by their makers.
QList<PrinterPreset> defaultPrinters();

/// Converts printers to the lines stored in the settings and back, one line each. Invalid lines are skipped.
QStringList toLines(const QList<PrinterPreset>& printers);
QList<PrinterPreset> printersOf(const QStringList& lines);
} // namespace ui
