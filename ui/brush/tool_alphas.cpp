#include "ui/brush/tool_alphas.h"

#include "ui/settings/stored_brush.h"

namespace ui
{
ToolAlphas::ToolAlphas(ToolMemory* tools, Settings* settings, QObject* parent)
    : QObject(parent)
    , m_tools(tools)
    , m_settings(settings)
{}

void ToolAlphas::restore(const StoredToolAlpha& otherwise)
{
    QStringList files;
    m_isStored.fill(false);
    for (std::size_t i = 0; i < m_stored.size(); ++i) {
        const auto tool = static_cast<core::Tool>(i);
        m_stored[i] = m_settings->get<StoredToolAlpha>(groupOf(tool), otherwise);
        const QString& source = m_stored[i].alpha;
        ToolValues values = m_tools->of(tool);
        values.alphaFollows = m_stored[i].alphaFollows;
        values.alpha = core::builtInAlpha(source.toStdString());
        m_awaited[i] = values.alpha ? QString() : source;
        m_tools->set(tool, values);
        if (!m_awaited[i].isEmpty() && !files.contains(source))
            files << source;
    }
    for (const QString& path : files)
        m_background.run([path] { return readAlpha(path); },
                         [this, path](const BrushFile<core::Alpha>& file) { take(path, file); });
}

void ToolAlphas::take(const QString& path, const BrushFile<core::Alpha>& file)
{
    bool isAwaited = false;
    for (std::size_t i = 0; i < m_awaited.size(); ++i) {
        if (m_awaited[i] != path)
            continue;
        isAwaited = true;
        m_awaited[i].clear();
        ToolValues values = m_tools->of(static_cast<core::Tool>(i));
        values.alpha = values.alpha ? values.alpha : file.what;
        m_tools->set(static_cast<core::Tool>(i), values);
    }
    if (!isAwaited)
        return;
    if (file.what)
        Q_EMIT fileRead(path, file.what);
    else
        Q_EMIT fileRefused(file.problem);
}

void ToolAlphas::save()
{
    for (std::size_t i = 0; i < m_stored.size(); ++i) {
        const auto tool = static_cast<core::Tool>(i);
        const ToolValues& values = m_tools->of(tool);
        if (values.alpha)
            m_awaited[i].clear();
        StoredToolAlpha now{values.alpha ? QString::fromStdString(values.alpha->source()) : m_awaited[i],
                            values.alphaFollows};
        if (now == m_stored[i] && m_isStored[i])
            continue;
        m_stored[i] = now;
        m_isStored[i] = true;
        m_settings->set(now, groupOf(tool));
    }
}
} // namespace ui
