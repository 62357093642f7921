#pragma once

#include "ui/widgets/spacing.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace ui
{
// What panels have in common. Gui thread.

/// All that stands in it, one below the other.
inline QVBoxLayout* panelLayout(QWidget* page)
{
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(gap, gap, gap, gap);
    rows->setSpacing(gap);
    return rows;
}

/// To be scrolled up and down where there is little room.
inline QScrollArea* scrollablePanel(QWidget* page)
{
    auto* area = new QScrollArea;
    area->setWidget(page);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}
} // namespace ui
