#pragma once

#include "ui/scene/orbit_camera.h"

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace ui
{
/// A cube that stands as the model does, in the upper right corner of its parent: a click on a face looks from there,
/// a drag turns the view. Thread: gui.
class NavigationCube : public QWidget
{
    Q_OBJECT

public:
    explicit NavigationCube(QWidget* parent);

    void showFor(const OrbitCamera& camera);
    /// Light on a dark background.
    void setLight(bool light);

Q_SIGNALS:
    void entered();
    void sideChosen(ui::OrbitCamera::Side side);
    /// Asks to turn the view by degrees, to the right and down.
    void turned(double right, double down);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A face that is seen.
    struct Face
    {
        OrbitCamera::Side side;
        QPolygonF corners; ///< upper left of its word first, clockwise
        double slant = 0;  ///< 1 if it faces the eye, 0 if it is seen from its edge
    };

    std::optional<OrbitCamera::Side> sideAt(const QPointF& point) const;
    void setHovered(const std::optional<OrbitCamera::Side>& side);
    void paint(const Face& face, QPainter& painter) const;
    void place();

    std::vector<Face> m_faces;
    core::Vec3 m_right = core::Vec3::Zero(), m_up = core::Vec3::Zero(); ///< of the camera
    std::optional<OrbitCamera::Side> m_hovered;
    QPointF m_pressed, m_last;
    bool m_isDragged = false;
    bool m_light = false;
};
} // namespace ui
