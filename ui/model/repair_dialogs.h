#pragma once

#include "core/repair/repair.h"
#include "ui/model/repair_doubt.h"

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
/// Explains why a model cannot be sculpted, and asks whether and how to repair it. Returns at once; `callback` is
/// called only if the user accepts.
void askToRepair(QWidget* parent, RepairUse use, const QString& problem,
                 const std::function<void(const core::RepairOptions& options)>& callback);

/// Shows a model before and after a repair that lost parts of it, and asks whether to accept the result. Returns at
/// once; `callback` is called only if the user accepts.
void askToAccept(QWidget* parent, const RepairDoubt& doubt, const std::function<void()>& callback);

/// Shows what a repair changed in the opened or inserted model. Returns at once.
void showRepaired(QWidget* parent, RepairUse use, const QString& name, const QStringList& steps);
} // namespace ui
