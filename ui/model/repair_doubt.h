#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

namespace ui
{
enum class RepairUse { Opening, Insertion };

/// A repair that did not keep the model: what it lost, and how it looks. A value.
struct RepairDoubt
{
    RepairUse use = RepairUse::Opening;
    QString problem;    ///< one sentence
    QStringList losses; ///< in numbers, a line each
    QImage before, after;
};
} // namespace ui
