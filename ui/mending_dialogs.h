#pragma once

#include "core/legalise.h"

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
/// Says why a model cannot be sculpted, and asks whether and how it is to be mended. Returns at once; the answer is called when the person
/// agreed, and never else.
void askToMend(QWidget* parent, const QString& problem, const std::function<void(const core::LegaliseOptions& options)>& answer);

/// What was done to the model that is open now. Returns at once.
void showMended(QWidget* parent, const QString& name, const QStringList& steps);
} // namespace ui
