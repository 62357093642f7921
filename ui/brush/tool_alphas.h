#pragma once

#include "ui/brush/brush_files.h"
#include "ui/settings/settings.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <array>

namespace ui
{
/// Keeps the alpha of each tool in the settings, and reads their files at the start. Thread: gui.
class ToolAlphas : public QObject
{
    Q_OBJECT

public:
    /// Keeps both: they must outlive this.
    ToolAlphas(ToolMemory* tools, Settings* settings, QObject* parent = nullptr);

    /// Gives each tool the alpha that is stored for it, or `otherwise` if none is. Files are read on a thread.
    void restore(const StoredToolAlpha& otherwise);
    /// Stores what the tools have now. While a stored file is being read, it stays stored; whoever gives the tool an
    /// alpha meanwhile has chosen later.
    void save();
    /// Returns what is stored for the tool.
    const StoredToolAlpha& stored(core::Tool tool) const { return m_stored[static_cast<std::size_t>(tool)]; }
    /// The tool has no alpha by choice: a file that is being read for it is too late.
    void forget(core::Tool tool) { m_awaited[static_cast<std::size_t>(tool)].clear(); }

Q_SIGNALS:
    /// A stored file was read.
    void fileRead(const QString& path, const std::shared_ptr<const core::Alpha>& alpha);
    /// A stored file is gone or broken; the tools that had it have none. `problem`: one sentence.
    void fileRefused(const QString& problem);

private:
    void take(const QString& path, const BrushFile<core::Alpha>& file);

    template <class T> using ForEachTool = std::array<T, core::toolNames().size()>;

    ToolMemory* m_tools;
    Settings* m_settings;
    ForEachTool<StoredToolAlpha> m_stored;
    ForEachTool<bool> m_isStored{}; ///< else the settings may say something else, or nothing
    ForEachTool<QString> m_awaited; ///< the path that is being read for the tool; empty: none
    BackgroundThread m_background;  ///< last
};
} // namespace ui
