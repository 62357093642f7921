#include "vr/panels/panel_content.h"

namespace vr
{
PanelKind kindOf(const PanelContent& content)
{
    static_assert(std::variant_size_v<PanelContent> == panelKindCount);
    return static_cast<PanelKind>(content.index());
}

PanelLayout layoutOf(const PanelContent& content)
{
    return std::visit([](const auto& panel) { return panel.layout(); }, content);
}
} // namespace vr
