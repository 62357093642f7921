#pragma once

#include "ui/scene/orbit_camera.h"

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace ui
{
/// A cube in the upper right corner of its parent that is oriented like the model. Clicking a face chooses a view from
/// that side; dragging turns the view. Thread: gui.
class NavigationCube : public QWidget
{
    Q_OBJECT

public:
    explicit NavigationCube(QWidget* parent);

    void showFor(const OrbitCamera& camera);
    /// Chooses light colours, for a dark background.
    void setLight(bool light);

Q_SIGNALS:
    void entered();
    void sideChosen(ui::OrbitCamera::Side side);
    /// The user asked to turn the view by these angles in degrees, to the right and down.
    void turned(double right, double down);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A visible face of the cube.
    struct Face
    {
        OrbitCamera::Side side;
        QPolygonF corners; ///< corners in the widget, pixels, clockwise from the upper left of the face's label
        double slant = 0;  ///< 1 if the face is turned towards the eye, 0 if it is seen edge-on
    };

    std::optional<OrbitCamera::Side> sideAt(const QPointF& point) const;
    void setHovered(const std::optional<OrbitCamera::Side>& side);
    void paint(const Face& face, QPainter& painter) const;
    void place();

    std::vector<Face> m_faces;
    core::Vec3 m_right = core::Vec3::Zero(), m_up = core::Vec3::Zero(); ///< directions of the camera
    std::optional<OrbitCamera::Side> m_hovered;
    QPointF m_pressed, m_last;
    bool m_isDragged = false;
    bool m_light = false;
};
} // namespace ui
