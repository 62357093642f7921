#pragma once

#include "core/analysis/print_check.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace ui
{
struct PrinterPreset
{
    QString name; ///< not empty
    core::PrintBed bed;
};

inline constexpr double minBed = 10, maxBed = 10'000; ///< mm, a side

/// Common printers, with their makers' figures.
QList<PrinterPreset> defaultPrinters();

/// As settings keep them: a line each. Lines that are none are left out.
QStringList toLines(const QList<PrinterPreset>& printers);
QList<PrinterPreset> printersOf(const QStringList& lines);
} // namespace ui
