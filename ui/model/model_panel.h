#pragma once

#include "core/analysis/mesh_check.h"

#include <QHash>
#include <QWidget>

class QFormLayout;
class QLabel;

namespace ui
{
class SideColumn;

/// A panel with the model's size and soundness at the last check. Knows no mesh: setReport() provides the values.
/// Thread: gui.
class ModelPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ModelPanel(QWidget* parent = nullptr);

    /// `part`: name of the part that the report is of; empty: the whole model.
    void setReport(const core::MeshReport& report, const QString& part = {});
    /// Marks the values as outdated, because the model has changed.
    void setStale();

Q_SIGNALS:
    /// The panel has become visible or hidden.
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

/// Adds the panel to the column and returns it.
ModelPanel* addModelPanel(SideColumn* column);
} // namespace ui
