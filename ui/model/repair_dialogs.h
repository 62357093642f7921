#pragma once

#include "core/repair/repair.h"
#include "ui/model/repair_doubt.h"

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
/// Says why a model cannot be sculpted, and asks whether and how to repair it. Returns at once; the callback is called
/// when the person agreed, and never else.
void askToRepair(QWidget* parent, RepairUse use, const QString& problem,
                 const std::function<void(const core::RepairOptions& options)>& callback);

/// Shows a model before and after a repair that did not keep it, and asks whether it is wanted. Returns at once; the
/// callback is called when the person agreed, and never else.
void askToAccept(QWidget* parent, const RepairDoubt& doubt, const std::function<void()>& callback);

/// What was done to the model that is open now, or that was inserted. Returns at once.
void showRepaired(QWidget* parent, RepairUse use, const QString& name, const QStringList& steps);
} // namespace ui
