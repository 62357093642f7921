#pragma once

#include "ui/settings/printer_presets.h"

#include "core/analysis/print_check.h"

#include <QList>
#include <QString>

#include <optional>

namespace ui
{
enum class PrintVerdict { Good, Warning, Bad };

/// One thing that was looked at, in a sentence, and where in the model it is, if that is a place.
struct PrintFinding
{
    PrintVerdict verdict = PrintVerdict::Good;
    QString text, tip;
    std::vector<core::PrintPlace> places = {};
    QStringList placeTexts = {};                    ///< of each place
    std::optional<core::PrintPicture> picture = {}; ///< shows the places
};

QList<PrintFinding> printFindings(const core::MeshReport& mesh, const core::PrintReport& print,
                                  const core::PrintLimits& limits, const QString& printer);
} // namespace ui
