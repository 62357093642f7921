#pragma once

#include <QWidget>

namespace ui
{
class OrbitCamera;

/// A length in mm as long as the model's own: in orthographic views everywhere, in perspective at the depth of the
/// point that the view turns about. Stands in the lower left corner of its parent; the mouse goes through it.
class ScaleBar : public QWidget
{
    Q_OBJECT

public:
    explicit ScaleBar(QWidget* parent);

    void showFor(const OrbitCamera& camera);
    /// Light on a dark background.
    void setLight(bool light);

    double millimetres() const { return m_millimetres; } ///< 1, 2 or 5 times a power of ten
    double pixels() const { return m_pixels; }           ///< logical

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    double m_millimetres = 0, m_pixels = 0;
    bool m_light = false;
};
} // namespace ui
