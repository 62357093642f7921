#pragma once

#include "core/analysis/mesh_check.h"

#include <QHash>
#include <QWidget>

class QFormLayout;
class QLabel;

namespace ui
{
class SideColumn;

/// What the model measures, and whether it is sound: as it was when that was last found out. Knows no mesh: it shows
/// what it is given. Thread: gui.
class ModelPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ModelPanel(QWidget* parent = nullptr);

    void setReport(const core::MeshReport& report);
    /// The model is another one now; the figures are of before, and are said to be.
    void setStale();

Q_SIGNALS:
    /// It can be seen now, or not any more.
    void watched(bool isWatched);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    enum class Health { Unknown, Sound, Unsound };

    void addRow(const char* id, const QString& name, const QString& tip);
    void showHealth(Health health, const QString& word, const QString& tip);
    void showColors();

    QFormLayout* m_form;
    QLabel *m_icon, *m_word;
    Health m_health = Health::Unknown;
    QHash<QString, QLabel*> m_values;
};

/// Adds the panel to the column.
ModelPanel* addModelPanel(SideColumn* column);
} // namespace ui
