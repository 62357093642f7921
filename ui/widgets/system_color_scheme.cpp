#include "ui/widgets/system_color_scheme.h"

#include "ui/widgets/color_scheme_watch.h"

#include <utility>

namespace ui
{
SystemColorScheme::SystemColorScheme(QObject* parent)
    : QObject(parent)
    , m_watch(watchColorScheme([this](Scheme scheme) { set(scheme); }))
{}

SystemColorScheme::~SystemColorScheme() = default;

void SystemColorScheme::set(Scheme scheme)
{
    if (std::exchange(m_scheme, scheme) != scheme)
        Q_EMIT changed();
}
} // namespace ui
