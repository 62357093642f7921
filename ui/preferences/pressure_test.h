#pragma once

#include <QList>
#include <QWidget>

namespace ui
{
/// A field for trying the pen: the line's width is the effective pressure, and a text shows the device and its
/// pressure. Thread: gui.
class PressureTest : public QWidget
{
    Q_OBJECT

public:
    explicit PressureTest(QWidget* parent = nullptr);

    /// Sets the exponent that maps the pen's pressure to the effective pressure (penPressure) of later dots.
    void setExponent(double exponent) { m_exponent = exponent; }
    /// Returns the displayed text: a pressure such as "Pen: 0.42", or a hint.
    const QString& words() const { return m_words; }

    QSize sizeHint() const override { return {200, 96}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;

private:
    struct Dot
    {
        QPointF at;
        double pressure = 0; ///< effective pressure, 0 to 1
        bool begins = false; ///< the dot begins a line
    };

    void draw(const QPointF& at, double pressure, bool begins);
    void showMessage(const QString& words);

    double m_exponent = 1;
    QList<Dot> m_dots;
    QString m_words;
};
} // namespace ui
