#include "ui/drawing/preview_panel.h"

#include "ui/actions/actions.h"
#include "ui/drawing/drawing_sheet.h"
#include "ui/settings/settings.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_button.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QToolButton>

#include <utility>

namespace ui
{
namespace
{

/// The content of the panel: controls above the canvas, or beside it if the panel is low.
class Content : public QWidget
{
public:
    Content(QBoxLayout* controls, QWidget* canvas)
        : m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this))
        , m_controls(controls)
    {
        m_layout->setContentsMargins(gap, gap, gap, gap);
        m_layout->setSpacing(gap);
        m_controls->setSpacing(gap);
        m_layout->addLayout(controls);
        m_layout->addWidget(canvas, 1);
    }

protected:
    void resizeEvent(QResizeEvent*) override
    {
        const bool isWide = width() > 2 * height();
        m_layout->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        m_controls->setDirection(isWide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    }

private:
    QBoxLayout *m_layout, *m_controls;
};
} // namespace

PreviewPanel::PreviewPanel(Settings* settings, QAction* exporting, QWidget* parent)
    : QDockWidget(tr("2D Preview"), parent)
    , m_settings(settings)
    , m_options(settings->get<DrawingSettings>())
{
    setObjectName(QStringLiteral("previewPanel"));
    setWidget(content(exporting));
    m_canvas->setOptions(m_options);
    settings->onReset([this] { show(m_settings->get<DrawingSettings>()); });
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool isSeen) {
        m_isSeen = isSeen;
        Q_EMIT drawingRequested(isSeen, m_options.shaded);
        if (!isSeen)
            setDrawing({});
    });
}

QWidget* PreviewPanel::content(QAction* exporting)
{
    m_canvas = named(new DrawingCanvas, "preview.canvas", {}, tr("Drawing of the model"));
    m_note = named(new QLabel, "preview.note");
    m_note->setWordWrap(true);
    m_note->hide();
    auto* over = new QVBoxLayout(m_canvas);
    over->setContentsMargins(gap, gap, gap, gap);
    over->addWidget(m_note, 0, Qt::AlignBottom);
    return new Content(controls(exporting), m_canvas);
}

QBoxLayout* PreviewPanel::controls(QAction* exporting)
{
    m_sides =
        choiceBox(QStringLiteral("preview.sides"), tr("Sides"), tr("Shows all three drawings, or one of them larger."),
                  {tr("All sides"), tr("Front"), tr("Right"), tr("Top")}, static_cast<int>(m_options.sides));
    m_style =
        choiceBox(QStringLiteral("preview.style"), tr("Drawn as"), tr("Shows the lines only, or colours under them."),
                  {tr("Lines"), tr("Shaded")}, m_options.shaded ? 1 : 0);
    m_dimensions = panelButton(QStringLiteral("preview.dimensions"), QStringLiteral("dimensions"), tr("Dimensions"),
                               tr("Shows the model's dimensions beside it."));
    m_dimensions->setCheckable(true);
    m_dimensions->setChecked(m_options.dimensions);
    connect(m_dimensions, &QToolButton::toggled, this, &PreviewPanel::choose);
    auto* fit = panelButton(QStringLiteral("preview.fit"), QStringLiteral("frame"), tr("Fit (0)"),
                            tr("Shows the whole drawing; the wheel zooms, a drag moves it."));
    connect(fit, &QToolButton::clicked, m_canvas, &DrawingCanvas::fit);
    auto* write =
        panelButton(QStringLiteral("preview.export"), {}, Actions::plain(exporting->text()), exporting->statusTip());
    write->setIcon(exporting->icon());
    const auto showTip = [write, exporting] { write->setToolTip(exporting->toolTip()); };
    showTip();
    connect(exporting, &QAction::changed, write, showTip);
    connect(write, &QToolButton::clicked, exporting, &QAction::trigger);

    auto* buttons = new QHBoxLayout;
    for (QToolButton* each : {m_dimensions, fit, write})
        buttons->addWidget(each);
    auto* row = new QBoxLayout(QBoxLayout::LeftToRight);
    row->addWidget(m_sides);
    row->addWidget(m_style);
    row->addLayout(buttons);
    row->addStretch();
    return row;
}

QComboBox* PreviewPanel::choiceBox(const QString& name, const QString& text, const QString& tip,
                                   const QStringList& words, int index)
{
    auto* box = named(new QComboBox, name, QStringLiteral("%1\n%2").arg(text, tip), text);
    box->addItems(words);
    box->setCurrentIndex(index);
    connect(box, &QComboBox::currentIndexChanged, this, &PreviewPanel::choose);
    return box;
}

/// Sets the controls, whose signals then update the options.
void PreviewPanel::show(const DrawingSettings& options)
{
    m_sides->setCurrentIndex(static_cast<int>(options.sides));
    m_style->setCurrentIndex(options.shaded ? 1 : 0);
    m_dimensions->setChecked(options.dimensions);
}

void PreviewPanel::choose()
{
    const bool wasShaded = m_options.shaded;
    m_options = {static_cast<DrawnSides>(m_sides->currentIndex()), m_style->currentIndex() == 1,
                 m_dimensions->isChecked()};
    m_settings->set(m_options);
    m_canvas->setOptions(m_options);
    if (m_options.shaded != wasShaded)
        Q_EMIT drawingRequested(m_isSeen, m_options.shaded);
}

void PreviewPanel::setDrawing(SharedDrawing drawing)
{
    const bool isShort = drawing && !drawing->hasCreases;
    m_note->setVisible(isShort);
    if (isShort)
        m_note->setText(drawing->isInterim ? tr("Coarser while you sculpt; the fine drawing follows.")
                                           : tr("Creases are left out: the surface has too many."));
    m_canvas->setDrawing(std::move(drawing));
}

void PreviewPanel::exportAs(const QString& modelName)
{
    askForDrawing(window(), m_settings->lastFolder(), modelName, drawingEndings(),
                  [this, modelName](const QString& path) {
                      m_settings->set(&Setting::lastFolder, QFileInfo(path).absolutePath());
                      Q_EMIT exportRequested(path, modelName, m_options.shaded);
                  });
}

void addPreview(QMainWindow* window, Settings* settings, QAction* exporting, const std::function<QString()>& modelName,
                QMenu* toggles)
{
    auto* panel = new PreviewPanel(settings, exporting);
    // Gives the corner to the right dock area, whose panels need the height
    window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window->addDockWidget(Qt::BottomDockWidgetArea, panel);
    panel->hide();
    toggles->addAction(panel->toggleViewAction());
    QObject::connect(exporting, &QAction::triggered, panel, [panel, modelName] { panel->exportAs(modelName()); });
}
} // namespace ui
