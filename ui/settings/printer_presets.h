#pragma once

#include "core/analysis/print_check.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace ui
{
struct Printer
{
    QString name; ///< not empty
    core::PrintBed bed;
};

inline constexpr double leastBed = 10, mostBed = 10'000; ///< mm, a side

/// Those that many have, by what their makers say of them.
QList<Printer> usualPrinters();

/// As settings keep them: a line each. Lines that are none are left out.
QStringList toLines(const QList<Printer>& printers);
QList<Printer> printersOf(const QStringList& lines);
} // namespace ui
