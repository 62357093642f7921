#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

namespace ui
{
enum class RepairUse { Opening, Insertion };

/// A repair that lost parts of the model: the losses, and pictures before and after. A value type.
struct RepairDoubt
{
    RepairUse use = RepairUse::Opening;
    QString problem;    ///< why the model needs a repair, one sentence
    QStringList losses; ///< amounts lost, one line each
    QImage before, after;
};
} // namespace ui
