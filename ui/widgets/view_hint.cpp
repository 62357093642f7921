#include "ui/widgets/view_hint.h"

#include <algorithm>

namespace ui
{
namespace
{
constexpr int topMargin = 12; ///< pixels from the view's top
} // namespace

ViewHint::ViewHint(const char* name, QWidget* view) : QLabel(view)
{
    setObjectName(QLatin1StringView(name));
    setAlignment(Qt::AlignCenter);
    setStyleSheet(
        QStringLiteral("background: rgba(28, 30, 33, 225); color: white; border-radius: 4px; padding: 4px 8px;"));
}

void ViewHint::showText(const QString& text, int viewWidth)
{
    setText(text);
    setWordWrap(false);
    QSize size = sizeHint();
    if (const int most = std::max(viewWidth - 2 * corner, viewWidth / 2); size.width() > most) {
        setWordWrap(true);
        size = {most, heightForWidth(most)};
    }
    setGeometry((viewWidth - size.width()) / 2, topMargin, size.width(), size.height());
}
} // namespace ui
