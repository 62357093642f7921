#pragma once

#include "ui/brush/preset_library.h"

#include <QWidget>

#include <functional>

class QListView;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace ui
{
class Actions;
class BrushSettings;
class BrushShapes;
class SideColumn;

/// The brush presets as pictures. A click takes a preset's tool and values; the presets of tools that are not offered
/// are not shown. Reads and draws only from the first time on that it can be seen. Thread: gui.
class PresetShelf : public QWidget
{
    Q_OBJECT

public:
    /// Keeps both pointers: they must outlive the shelf.
    PresetShelf(BrushSettings* brush, BrushShapes* shapes, QWidget* parent = nullptr);

    /// Shows the presets in another view as well, where a click takes one, too. The shelf must outlive the view.
    void showIn(QListView* view);

Q_SIGNALS:
    /// One sentence.
    void noticed(const QString& sentence);
    /// A preset was taken; the keys belong to the model again.
    void taken();

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    QToolButton* button(const QString& name, const QString& icon, const QString& text, const QString& tip,
                        const std::function<void()>& what);
    void layCells();
    void fill();
    void setPicture(const QString& path, const QImage& picture);
    void take(const QListWidgetItem* item);
    void update();
    void makeNew();
    void exportChosen();
    const PresetLibrary::Entry* entryOf(const QListWidgetItem* item) const;

    BrushSettings* m_brush;
    BrushShapes* m_shapes;
    QListWidget* m_list;
    QToolButton *m_new = nullptr, *m_import = nullptr, *m_export = nullptr, *m_rename = nullptr, *m_delete = nullptr;
    QHash<QString, QPixmap> m_pictures; ///< by path
    QString m_toEdit;                   ///< the path of a new preset, whose name is edited when it is there
    bool m_isLoaded = false;
    PresetLibrary m_library; ///< last
};

struct PresetShelfContext
{
    SideColumn* column;
    const Actions* actions;
    std::function<void()> taken;
    std::function<void(const QString&)> notice;
};

/// Adds a shelf to the column.
PresetShelf* addPresetShelf(const PresetShelfContext& context, BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
