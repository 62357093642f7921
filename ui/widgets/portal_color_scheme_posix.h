#pragma once

#include "ui/widgets/color_scheme_watch.h"

class QDBusVariant;
class QDBusPendingCallWatcher;

namespace ui
{
/// The colour scheme that the desktop's portal reports (org.freedesktop.portal.Settings, color-scheme). Queried
/// asynchronously once, then updated by signals. Never reports without a session bus or portal. Thread: gui.
class PortalColorScheme : public QObject
{
    Q_OBJECT

public:
    using Report = std::function<void(SystemColorScheme::Scheme)>;

    explicit PortalColorScheme(Report report);

private Q_SLOTS:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void answered(QDBusPendingCallWatcher* call);
    void set(const QVariant& value);

    Report m_report;
};
} // namespace ui
