#pragma once

#include "ui/drawing/drawing_painter.h"
#include "ui/util/background_thread.h"

#include <QImage>
#include <QWidget>

#include <memory>

namespace ui
{
using SharedDrawing = std::shared_ptr<const core::LineDrawing>;

/// Shows a drawing: fitted, or as far as it is zoomed and moved by wheel, drag and keys (+, -, arrows; 0 or a double
/// click fits it again). However many lines it has, the gui thread only shows the picture that another thread made of
/// it.
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
    void painted(); ///< the picture is up to date

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
    QPointF m_shift; ///< of the drawing's middle from the canvas's, pixels
    QPointF m_draggedFrom;
    QImage m_picture;
    bool m_isRendering = false, m_isOutdated = false;
    BackgroundThread m_background; ///< last
};
} // namespace ui
