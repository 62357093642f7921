// Source: Microsoft Learn, "Support Dark and Light themes in Win32 apps", "RegNotifyChangeKeyValue function".
#include "ui/widgets/color_scheme_watch.h"

#include <QWinEventNotifier>

#include <utility>
#include <windows.h>

namespace ui
{
namespace
{
constexpr const wchar_t* themeKey = LR"(Software\Microsoft\Windows\CurrentVersion\Themes\Personalize)";

/// Watches where Windows keeps the user's choice of dark or light programs.
class RegistryWatch : public QObject
{
public:
    explicit RegistryWatch(std::function<void(SystemColorScheme::Scheme)> report)
        : m_report(std::move(report))
        , m_changed(CreateEventW(nullptr, FALSE, FALSE, nullptr))
    {
        RegOpenKeyExW(HKEY_CURRENT_USER, themeKey, 0, KEY_NOTIFY | KEY_QUERY_VALUE, &m_key);
        m_notifier.setHandle(m_changed);
        connect(&m_notifier, &QWinEventNotifier::activated, this, &RegistryWatch::read);
        m_notifier.setEnabled(m_key != nullptr);
        read();
    }
    ~RegistryWatch() override
    {
        m_notifier.setEnabled(false);
        if (m_key)
            RegCloseKey(m_key);
        CloseHandle(m_changed);
    }

private:
    /// Asks to be told of the next change before it reads, so that none is missed.
    void read()
    {
        RegNotifyChangeKeyValue(m_key, FALSE, REG_NOTIFY_CHANGE_LAST_SET, m_changed, TRUE);
        DWORD isLight = 0, size = sizeof isLight;
        const bool isKnown = m_key && RegGetValueW(m_key, nullptr, L"AppsUseLightTheme", RRF_RT_REG_DWORD, nullptr,
                                                   &isLight, &size) == ERROR_SUCCESS;
        m_report(!isKnown  ? SystemColorScheme::Scheme::Unknown
                 : isLight ? SystemColorScheme::Scheme::Light
                           : SystemColorScheme::Scheme::Dark);
    }

    std::function<void(SystemColorScheme::Scheme)> m_report;
    HANDLE m_changed;
    HKEY m_key = nullptr;
    QWinEventNotifier m_notifier;
};
} // namespace

std::unique_ptr<QObject> watchColorScheme(std::function<void(SystemColorScheme::Scheme)> report)
{
    return std::make_unique<RegistryWatch>(std::move(report));
}
} // namespace ui
