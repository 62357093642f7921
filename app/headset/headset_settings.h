#pragma once

#include "vr/input/headset_settings.h"

#include <QSettings>

namespace app
{
/// What a person has chosen about the headset, stored beside the window's preferences (ui::Settings). What is missing
/// or makes no sense is as it is at first. Gui thread.
class HeadsetSettings
{
public:
    vr::HeadsetSettings choice() const;
    void setChoice(const vr::HeadsetSettings& choice);

private:
    QSettings m_settings;
};
} // namespace app
