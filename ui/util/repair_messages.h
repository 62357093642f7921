#pragma once

#include "core/repair/repair.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace ui
{
/// What legalising a model came to, in words: plain text, for the window and for the command line alike. Any thread.
class MendingWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::MendingWords)

public:
    /// What was found and mended, step by step, with counts; steps that found nothing are left out.
    static QStringList steps(const core::RepairReport& report);
    /// What goes on while `file` is legalised.
    static QString doing(const QString& file, core::RepairStep step);
    /// How far the surface moved.
    static QString distance(const core::RepairReport& report);
    /// Why there is no mended model.
    static QString refusal(const QString& file, const core::RepairResult& legalised);
};
} // namespace ui
