#pragma once

#include "ui/settings/printer_presets.h"

#include "core/print/print_check.h"

#include <QList>
#include <QString>

#include <optional>

namespace ui
{
enum class PrintVerdict { Good, Warning, Bad };

/// A finding of the print check: a sentence, and its places in the model, if any.
struct PrintFinding
{
    PrintVerdict verdict = PrintVerdict::Good;
    QString text, tip;
    std::vector<core::PrintPlace> places = {};
    QStringList placeTexts = {};                    ///< a text for each place
    std::optional<core::PrintPicture> picture = {}; ///< colouring of the model that shows the places
};

/// The surface that was checked, of a model whose parts overlap.
enum class PrintedParts {
    Apart,    ///< the parts, which do not overlap
    United,   ///< the union of the parts
    EachAlone ///< the parts, because no union was found
};

QList<PrintFinding> printFindings(const core::MeshReport& mesh, const core::PrintReport& print,
                                  const core::PrintLimits& limits, const QString& printer,
                                  PrintedParts parts = PrintedParts::Apart);
} // namespace ui
