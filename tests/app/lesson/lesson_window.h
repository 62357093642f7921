#pragma once

#include "tests/support/program.h"

#include <QAbstractButton>
#include <QTest>

/// Access to the parts of the lesson window by name.
namespace app
{
template <class Widget> Widget* part(Program& program, const char* name)
{
    return program.window.findChild<Widget*>(QLatin1StringView(name));
}

inline void press(Program& program, const char* button)
{
    auto* found = part<QAbstractButton>(program, button);
    QVERIFY2(found && found->isEnabled(), button);
    found->click();
}
} // namespace app
