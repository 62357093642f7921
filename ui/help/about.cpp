#include "ui/help/about.h"

#include <QCoreApplication>
#include <QIcon>
#include <QMessageBox>

namespace ui
{
namespace
{
struct About
{
    Q_DECLARE_TR_FUNCTIONS(ui::About)
};
} // namespace

void showAbout(QWidget* parent)
{
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, About::tr("About Fettle"),
        About::tr("Fettle %1\n\nSculpt a model with mouse, pen or VR controllers, and export it ready to print.")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Ok, parent);
    box->setIconPixmap(QIcon(QStringLiteral(":/icons/fettle.svg")).pixmap(QSize(64, 64), parent->devicePixelRatioF()));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}
} // namespace ui
