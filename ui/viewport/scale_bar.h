#pragma once

#include <QWidget>

namespace ui
{
class OrbitCamera;

/// A bar with its length in mm, at the scale of the model: in orthographic views everywhere, in perspective at the
/// depth of the pivot. In the lower left corner of its parent; transparent for the mouse.
class ScaleBar : public QWidget
{
    Q_OBJECT

public:
    explicit ScaleBar(QWidget* parent);

    void showFor(const OrbitCamera& camera);
    /// Chooses light colours, for a dark background.
    void setLight(bool light);

    double millimetres() const { return m_millimetres; } ///< length of the bar, mm: 1, 2 or 5 times a power of ten
    double pixels() const { return m_pixels; }           ///< length of the bar, logical pixels

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    double m_millimetres = 0, m_pixels = 0;
    bool m_light = false;
};
} // namespace ui
