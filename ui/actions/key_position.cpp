#include "ui/actions/key_position.h"

#include <QGuiApplication>
#include <QKeyEvent>

#include <string_view>

namespace ui
{
namespace
{
struct KeyRow
{
    quint32 first; ///< scan code of the row's first key on PC keyboards
    std::string_view keys;
};
constexpr KeyRow digits{2, "1234567890"};
constexpr KeyRow letters[] = {{16, "QWERTYUIOP"}, {30, "ASDFGHJKL"}, {44, "ZXCVBNM"}};

Qt::Key keyIn(const KeyRow& row, quint32 code)
{
    return code >= row.first && code < row.first + row.keys.size() ? static_cast<Qt::Key>(row.keys[code - row.first])
                                                                   : Qt::Key(0);
}
} // namespace

Qt::Key keyByPosition(const QKeyEvent& event)
{
    constexpr quint32 ofX11 = 8; // offset that X11 and Wayland add to PC scan codes
    constexpr int lastOfLatin = 0x24f, firstOfOthers = 0x01000000;
    const quint32 native = event.nativeScanCode();
    const bool isPlain = QGuiApplication::platformName() == QLatin1StringView("windows");
    const quint32 code = isPlain ? native : native < ofX11 ? 0 : native - ofX11;
    const bool isDigit = event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9;
    if (const Qt::Key digit = keyIn(digits, code))
        return isDigit ? Qt::Key(0) : digit;
    if (event.key() <= lastOfLatin || event.key() >= firstOfOthers)
        return Qt::Key(0);
    for (const KeyRow& row : letters)
        if (const Qt::Key letter = keyIn(row, code))
            return letter;
    return Qt::Key(0);
}
} // namespace ui
