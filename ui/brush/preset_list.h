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

/// The brush presets as pictures. A click applies a preset. Presets of tools that are not offered are hidden. Files are
/// read and pictures drawn when the list is first shown. Thread: gui.
class PresetList : public QWidget
{
    Q_OBJECT

public:
    /// Precondition: `brush` and `shapes` outlive the list.
    PresetList(BrushSettings* brush, BrushShapes* shapes, QWidget* parent = nullptr);

    /// Shows the presets in another view too; a click there applies a preset. Precondition: the list outlives the
    /// view.
    void showIn(QListView* view);

Q_SIGNALS:
    /// There is a message for the user.
    void noticed(const QString& sentence);
    /// A preset was applied; the window should return the keyboard focus to the view.
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
    QHash<QString, QPixmap> m_pictures; ///< pictures by the path of their preset
    QString m_toEdit;                   ///< path of a new preset whose name is edited once the presets have been read
    bool m_isLoaded = false;
    PresetLibrary m_library; ///< last member: destroyed first, which ends its threads
};

struct PresetListContext
{
    SideColumn* column;
    const Actions* actions;
    std::function<void()> taken;
    std::function<void(const QString&)> notice;
};

/// Adds a list to the column and returns it.
PresetList* addPresetList(const PresetListContext& context, BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
