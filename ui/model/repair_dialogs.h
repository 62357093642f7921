#pragma once

#include "core/repair/repair.h"

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
enum class RepairUse { Opening, Insertion };

/// Says why a model cannot be sculpted, and asks whether and how to repair it. Returns at once; the callback is called
/// when the person agreed, and never else.
void askToRepair(QWidget* parent, RepairUse use, const QString& problem,
                 const std::function<void(const core::RepairOptions& options)>& callback);

/// What was done to the model that is open now, or that was inserted. Returns at once.
void showRepaired(QWidget* parent, RepairUse use, const QString& name, const QStringList& steps);
} // namespace ui
