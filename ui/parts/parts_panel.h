#pragma once

#include "core/operations/model_command.h"

#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;

namespace ui
{
class Actions;
class SideColumn;

/// The list of the document's parts: a row for each, with its visibility, its lock, its colour and its name. The
/// active part has a bold name; further selected rows are the parts that it is combined with. Knows no document:
/// setParts() provides what is shown, and signals request changes. Thread: gui.
class PartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PartsPanel(const Actions& actions, QWidget* parent = nullptr);

    /// Shows the list. Rows that are still there stay selected.
    void setParts(const core::PartList& parts, core::PartId active);

Q_SIGNALS:
    void activated(core::PartId part);
    /// The user requests a change of a part, or of all.
    void requested(core::PartId part, const core::ModelCommand& command);
    /// The user requests to combine the part with others.
    void combinationRequested(core::PartId part, const core::CombineParts& command);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectActions(const Actions& actions);
    QTreeWidgetItem* rowOf(core::PartId part) const;
    const core::Part* present() const;
    std::vector<core::PartId> others() const;
    void onClicked(QTreeWidgetItem* row, int column);
    void onRenamed(QTreeWidgetItem* row);
    void toggleShown(const core::Part& part);
    void edit(core::Part part, std::optional<std::size_t> position = {});
    void move(int by);
    void chooseTag();
    void combine(core::SetOperation operation);

    QTreeWidget* m_list;
    core::PartList m_parts;
    core::PartId m_active = 0;
    bool m_isFilling = false; ///< the rows are being set, not edited by the user
};

/// Adds the panel to the column and returns it.
PartsPanel* addPartsPanel(SideColumn* column, const Actions& actions);
} // namespace ui
