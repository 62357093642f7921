#pragma once

#include <QList>
#include <QWidget>

namespace ui
{
/// A field to draw in: the line is as wide as the pressure that counts, and words say what draws and how hard.
/// Thread: gui.
class PressureTest : public QWidget
{
    Q_OBJECT

public:
    explicit PressureTest(QWidget* parent = nullptr);

    /// Of the curve that turns the pen's pressure into what counts (penPressure); what is drawn later goes by it.
    void setExponent(double exponent) { m_exponent = exponent; }
    /// What is seen now: "Pen: 0.42", or what to do here.
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
        double pressure = 0; ///< that counts
        bool begins = false; ///< a line
    };

    void draw(const QPointF& at, double pressure, bool begins);
    void showMessage(const QString& words);

    double m_exponent = 1;
    QList<Dot> m_dots;
    QString m_words;
};
} // namespace ui
