#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/settings/model_info.h"

#include <QWidget>

class QLabel;

namespace ui
{
/// The right end of the status bar: the model's name, vertices and size, and the brush's radius.
class InfoBar : public QWidget
{
    Q_OBJECT

public:
    explicit InfoBar(const BrushSettings* brush, QWidget* parent = nullptr);

    void setModelInfo(const ModelInfo& modelInfo);

private:
    void showRadius();

    const BrushSettings* m_brush;
    QLabel *m_name, *m_vertices, *m_size, *m_radius;
};
} // namespace ui
