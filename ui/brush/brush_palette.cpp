#include "ui/brush/brush_palette.h"

#include "ui/actions/actions.h"
#include "ui/brush/brush_bar.h"
#include "ui/brush/preset_list.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"

#include <QAction>
#include <QFormLayout>
#include <QGridLayout>
#include <QListView>
#include <QScreen>
#include <QToolButton>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int columns = 6;
constexpr QSize iconSize{24, 24}, presetSize{48, 48};
constexpr int presetRows = 2;
} // namespace

BrushPalette::BrushPalette(BrushSettings* brush, PresetList* presets, const QList<QAction*>& tools,
                           const QList<QAction*>& commands, QWidget* parent)
    : QFrame(parent, Qt::Popup)
{
    setObjectName(QStringLiteral("brushPalette"));
    setAccessibleName(tr("Palette"));
    setFrameShape(QFrame::StyledPanel);
    auto* form = new QFormLayout;
    form->setSpacing(gap);
    for (const core::Parameter parameter : {core::Parameter::Radius, core::Parameter::Strength}) {
        auto* control = new ParameterControl(brush, parameter, ParameterControl::Label::Without);
        connect(control, &ParameterControl::entered, this, &QWidget::close);
        form->addRow(ErrorMessages::name(parameter), control);
    }
    QVBoxLayout* rows = panelLayout(this);
    rows->addWidget(makeButtons(tools));
    rows->addLayout(form);
    rows->addWidget(makeButtons(commands));
    rows->addWidget(makePresets(presets));
    for (QAction* tool : tools)
        connect(tool, &QAction::triggered, this, &QWidget::close);
}

QWidget* BrushPalette::makeButtons(const QList<QAction*>& actions)
{
    auto* cells = new QWidget;
    auto* grid = new QGridLayout(cells);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    int place = 0;
    for (QAction* action : actions) {
        if (!action->isVisible())
            continue;
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setIconSize(iconSize);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        grid->addWidget(button, place / columns, place % columns, Qt::AlignLeft);
        ++place;
    }
    grid->setColumnStretch(columns, 1);
    return cells;
}

QWidget* BrushPalette::makePresets(PresetList* presets)
{
    auto* view = named(new QListView, "brushPalette.presets", {}, tr("Brush presets"));
    view->setViewMode(QListView::IconMode);
    view->setMovement(QListView::Static);
    view->setResizeMode(QListView::Adjust);
    view->setIconSize(presetSize);
    const int cell = presetSize.height() + view->fontMetrics().lineSpacing() + gap;
    view->setGridSize({presetSize.width() + 3 * gap, cell});
    view->setFixedHeight(presetRows * cell + 2 * view->frameWidth());
    view->setMinimumWidth(columns * (iconSize.width() + gap));
    view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->setTextElideMode(Qt::ElideRight);
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    presets->showIn(view);
    connect(presets, &PresetList::taken, this, &QWidget::close);
    return view;
}

void BrushPalette::openAt(const QPoint& place)
{
    adjustSize();
    const QRect available = parentWidget()->screen()->availableGeometry();
    const QPoint wanted = place - rect().center();
    move(std::clamp(wanted.x(), available.left(), std::max(available.left(), available.right() - width())),
         std::clamp(wanted.y(), available.top(), std::max(available.top(), available.bottom() - height())));
    show();
}

void connectBrushPalette(QWidget* window, Viewport* viewport, BrushSettings* brush, PresetList* presets,
                         const Actions& actions)
{
    const auto open = [=, &actions] {
        QList<QAction*> tools, commands;
        for (const QList<QAction*>& group : actions.groups(Bar::Tools))
            tools += group;
        for (const char* id :
             {"edit.undo", "edit.redo", "symmetry.on", "symmetry.radial", "brush.invert", "brush.presets"})
            commands << actions.get(QLatin1StringView(id));
        auto* palette = new BrushPalette(brush, presets, tools, commands, window);
        palette->setAttribute(Qt::WA_DeleteOnClose);
        const QRect view(viewport->mapToGlobal(QPoint()), viewport->size());
        palette->openAt(view.contains(QCursor::pos()) ? QCursor::pos() : view.center());
    };
    QObject::connect(actions.get(QStringLiteral("brush.palette")), &QAction::triggered, window, open);
    QObject::connect(viewport->input(), &PointerInput::paletteRequested, window, open);
}
} // namespace ui
