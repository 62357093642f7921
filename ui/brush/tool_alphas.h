#pragma once

#include "ui/brush/brush_files.h"
#include "ui/settings/settings.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <array>

namespace ui
{
/// Stores each tool's alpha in the settings and reads the alpha files when the program starts. Thread: gui.
class ToolAlphas : public QObject
{
    Q_OBJECT

public:
    /// Precondition: `tools` and `settings` outlive this object.
    ToolAlphas(ToolMemory* tools, Settings* settings, QObject* parent = nullptr);

    /// Gives each tool its stored alpha, or `otherwise` if none is stored. Files are read on a background thread.
    void restore(const StoredToolAlpha& otherwise);
    /// Stores the present alphas of all tools. A tool whose stored file is still being read keeps its stored choice,
    /// unless the tool got another alpha meanwhile.
    void save();
    /// Returns the stored choice of the tool.
    const StoredToolAlpha& stored(core::Tool tool) const { return m_stored[static_cast<std::size_t>(tool)]; }
    /// Drops the file that is being read for the tool, because the user chose no alpha or another one.
    void forget(core::Tool tool) { m_awaited[static_cast<std::size_t>(tool)].clear(); }

Q_SIGNALS:
    /// A stored file was read.
    void fileRead(const QString& path, const std::shared_ptr<const core::Alpha>& alpha);
    /// A stored file is missing or damaged; the tools that use it have no alpha. `problem`: one sentence.
    void fileRefused(const QString& problem);

private:
    void take(const QString& path, const BrushFile<core::Alpha>& file);

    template <class T> using ForEachTool = std::array<T, core::toolNames().size()>;

    ToolMemory* m_tools;
    Settings* m_settings;
    ForEachTool<StoredToolAlpha> m_stored;
    ForEachTool<bool> m_isStored{}; ///< the choice in m_stored has been written to the settings
    ForEachTool<QString> m_awaited; ///< path of the file that is being read for the tool; empty: none
    BackgroundThread m_background;  ///< last member: destroyed first, because its jobs use the other members
};
} // namespace ui
