#pragma once

#include <QObject>

class QDBusVariant;
class QDBusPendingCallWatcher;

namespace ui
{
/// The desktop's colour scheme, as reported by its portal (org.freedesktop.portal.Settings, color-scheme). Queried
/// asynchronously once, then updated by signals. Stays Unknown without a session bus or portal. Thread: gui.
class SystemColorScheme : public QObject
{
    Q_OBJECT

public:
    enum class Scheme { Unknown, Light, Dark };

    explicit SystemColorScheme(QObject* parent = nullptr);

    Scheme scheme() const { return m_scheme; }

Q_SIGNALS:
    void changed();

private Q_SLOTS:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void answered(QDBusPendingCallWatcher* call);
    void set(const QVariant& value);

    Scheme m_scheme = Scheme::Unknown;
};
} // namespace ui
