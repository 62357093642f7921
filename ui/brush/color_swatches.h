#pragma once

#include "core/geometry/geometry.h"

#include <QWidget>

class QGridLayout;

namespace ui
{
/// Colours at hand: a click or Space takes one, the context menu or Delete removes it, a button at the end keeps the
/// present colour. Thread: gui.
class ColorSwatches : public QWidget
{
    Q_OBJECT

public:
    static constexpr int maxSwatches = 17; ///< with the button two rows

    explicit ColorSwatches(QWidget* parent = nullptr);

    const QList<core::Rgb>& colors() const { return m_colors; }
    /// Those past the most are left out.
    void setColors(QList<core::Rgb> colors);
    /// At the end; if there is no room, the first goes. One that is there already is not added again.
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
