#pragma once

#include <QObject>

#include <memory>

namespace ui
{
/// The desktop's colour scheme. Queried once, then updated by signals. Stays Unknown where the desktop does not tell.
/// Thread: gui.
class SystemColorScheme : public QObject
{
    Q_OBJECT

public:
    enum class Scheme { Unknown, Light, Dark };

    explicit SystemColorScheme(QObject* parent = nullptr);
    ~SystemColorScheme() override;

    Scheme scheme() const { return m_scheme; }

Q_SIGNALS:
    void changed();

private:
    void set(Scheme scheme);

    Scheme m_scheme = Scheme::Unknown;
    std::unique_ptr<QObject> m_watch; ///< calls set()
};
} // namespace ui
