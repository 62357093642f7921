#include "ui/util/part_name.h"

#include <QCoreApplication>

namespace ui
{
QString partName(const core::Part& part)
{
    if (!part.name.empty())
        return QString::fromStdString(part.name);
    return QCoreApplication::translate("ui::PartName", "Part %1").arg(part.id + 1);
}
} // namespace ui
