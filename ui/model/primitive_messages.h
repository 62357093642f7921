#pragma once

#include "core/primitives/primitives.h"

#include <QCoreApplication>
#include <QString>

namespace ui
{
/// Names of primitives and of their measures, and sentences about measures that are not possible. Thread: any.
class PrimitiveMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::PrimitiveMessages)

public:
    static QString kind(core::Primitive::Kind kind);
    static QString measure(core::Primitive::Measure measure);
    /// Returns why the primitive cannot be made, one sentence; empty if it can.
    static QString problem(const core::PrimitiveResult& result);
};
} // namespace ui
