#pragma once

#include "core/geometry/geometry.h"

#include <QWidget>

class QGridLayout;

namespace ui
{
/// A grid of stored colours. A click or Space chooses a colour, Delete or the context menu removes it. A button at the
/// end adds the present colour. Thread: gui.
class ColorSwatches : public QWidget
{
    Q_OBJECT

public:
    static constexpr int maxSwatches = 17; ///< fills two rows together with the button that adds a colour

    explicit ColorSwatches(QWidget* parent = nullptr);

    const QList<core::Rgb>& colors() const { return m_colors; }
    /// Replaces the colours; those beyond maxSwatches are dropped.
    void setColors(QList<core::Rgb> colors);
    /// Appends a colour unless it is present; if the grid is full, the first colour is removed.
    void add(const core::Rgb& color);
    void remove(const core::Rgb& color);

Q_SIGNALS:
    void chosen(const core::Rgb& color);
    void addRequested();
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* button(const core::Rgb& color);

    QList<core::Rgb> m_colors;
    QGridLayout* m_grid;
};
} // namespace ui
