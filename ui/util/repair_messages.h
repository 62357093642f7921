#pragma once

#include "core/repair/repair.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace ui
{
/// Describes the repair of a model: plain text, for the window and for the command line alike. Any thread.
class RepairMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::RepairMessages)

public:
    /// Returns what was found and repaired, step by step, with counts; steps that found nothing are left out.
    static QStringList steps(const core::RepairReport& report);
    /// Describes the present step of the repair of `file`.
    static QString progress(const QString& file, core::RepairStep step);
    /// Returns what is left of the model and how far the surface moved, a line each.
    static QStringList losses(const core::RepairReport& report);
    /// Says why a repaired model may not be the model any more; empty if it is.
    static QString doubt(const QString& file, const core::RepairReport& report);
    /// Says why there is no repaired model.
    static QString refusal(const QString& file, const core::RepairResult& result);
};
} // namespace ui
