#pragma once

#include "core/repair/repair.h"

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
enum class MendFor { Opening, Insertion };

/// Says why a model cannot be sculpted, and asks whether and how it is to be mended. Returns at once; the answer is
/// called when the person agreed, and never else.
void askToMend(QWidget* parent, MendFor use, const QString& problem,
               const std::function<void(const core::RepairOptions& options)>& answer);

/// What was done to the model that is open now, or that was inserted. Returns at once.
void showMended(QWidget* parent, MendFor use, const QString& name, const QStringList& steps);
} // namespace ui
