#pragma once

#include "ui/widgets/spacing.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace ui
{
/// Sets up a vertical layout for the page and returns it. Thread: gui.
inline QVBoxLayout* panelLayout(QWidget* page)
{
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(gap, gap, gap, gap);
    rows->setSpacing(gap);
    return rows;
}

/// Returns a scroll area around the page, for windows with little room.
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
