#pragma once

#include "ui/scene/reference_image.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLayout;
class QSlider;
class QSpinBox;

namespace ui
{
class Actions;
class ReferenceImages;
class Viewport;

/// A panel for the reference image of the side that the camera is nearest to: its file, placement and opacity. Thread:
/// gui.
class ReferencePanel : public QWidget
{
    Q_OBJECT

public:
    /// Nothing is owned. Precondition: the arguments outlive the panel.
    ReferencePanel(ReferenceImages* images, Viewport* viewport, const Actions& actions, QWidget* parent = nullptr);

private:
    QLayout* buildHead(const Actions& actions);
    QLayout* buildOpacity();
    QDoubleSpinBox* lengthBox(const QString& id, const QString& name, const QString& tip, double min, double max);
    void followView();
    void showImage();
    void showSides();
    void showFile();
    void place();

    ReferenceImages* m_images;
    Viewport* m_viewport;
    OrbitCamera::Side m_side;
    SharedReferencePicture m_thumbnailOf;
    QComboBox* m_sides;
    QLabel *m_thumbnail, *m_name;
    QDoubleSpinBox *m_width, *m_x, *m_y;
    QSlider* m_opacity;
    QSpinBox* m_percent;
    QCheckBox* m_inFront;
};
} // namespace ui
