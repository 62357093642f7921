#pragma once

#include <QObject>

class QDBusVariant;
class QDBusPendingCallWatcher;

namespace ui
{
/// Whether the desktop is light or dark, as its portal says (org.freedesktop.portal.Settings, color-scheme). Asked once
/// without waiting, then told. Where there is no session bus or no portal nothing is ever known. Thread: gui.
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
