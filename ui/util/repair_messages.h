#pragma once

#include "core/repair/repair.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace ui
{
/// Describes the repair of a model in plain text, for the window and the command line. Thread: any.
class RepairMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::RepairMessages)

public:
    /// Returns what was found and repaired, step by step, with counts. Steps that found nothing are omitted.
    static QStringList steps(const core::RepairReport& report);
    /// Returns the current step of the repair of `file`.
    static QString progress(const QString& file, core::RepairStep step);
    /// Returns how much of the model is left and how far the surface moved, one line each.
    static QStringList losses(const core::RepairReport& report);
    /// Returns why a repaired model may not be the same model any more, or how much surface inside it is gone; empty if
    /// neither is so.
    static QString doubt(const QString& file, const core::RepairReport& report);
    /// Returns why there is no repaired model.
    static QString refusal(const QString& file, const core::RepairResult& result);
};
} // namespace ui
