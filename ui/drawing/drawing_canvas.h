#pragma once

#include "ui/drawing/drawing_painter.h"
#include "ui/util/background_thread.h"

#include <QImage>
#include <QWidget>

#include <memory>

namespace ui
{
using SharedDrawing = std::shared_ptr<const core::LineDrawing>;

/// A view of a drawing, fitted to the widget or zoomed and moved by wheel, drag and keys (+, -, arrows). 0 or a double
/// click fits it again. A background thread renders the picture; the gui thread only shows it, so its cost does not
/// depend on the number of lines.
class DrawingCanvas : public QWidget
{
    Q_OBJECT

public:
    explicit DrawingCanvas(QWidget* parent = nullptr);

    void setDrawing(SharedDrawing drawing);
    void setOptions(const DrawingSettings& options);
    void fit();

    double zoom() const { return m_zoom; }
    const QImage& picture() const { return m_picture; }
    QSize sizeHint() const override { return {360, 240}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

Q_SIGNALS:
    void painted(); ///< the picture shows the latest drawing, options and zoom

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void zoomBy(double factor, const QPointF& at);
    void moveBy(const QPointF& step);
    void render();
    void setPicture(const QImage& picture);

    SharedDrawing m_drawing;
    DrawingSettings m_options;
    double m_zoom = 1;
    QPointF m_shift; ///< from the canvas's centre to the drawing's centre, pixels
    QPointF m_draggedFrom;
    QImage m_picture;
    bool m_isRendering = false, m_isOutdated = false;
    BackgroundThread m_background; ///< last member: destroyed first, before the members that its callbacks use
};
} // namespace ui
