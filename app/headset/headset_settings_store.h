#pragma once

#include "vr/input/headset_settings.h"

#include <QSettings>

namespace app
{
/// Stores the settings of the headset beside the window's preferences (ui::Settings). Missing or invalid values are
/// replaced by the defaults. Thread: gui.
class HeadsetSettingsStore
{
public:
    vr::HeadsetSettings load() const;
    void save(const vr::HeadsetSettings& settings);

private:
    QSettings m_settings;
};
} // namespace app
