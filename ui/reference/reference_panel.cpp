#include "ui/reference/reference_panel.h"

#include "ui/actions/actions.h"
#include "ui/reference/reference_images.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr int thumbnailSize = 56, iconSize = 32;
constexpr int minWidth = 104;
constexpr int maxNameLength = 128; ///< pixels; longer names are elided

int percentOf(double opacity)
{
    return static_cast<int>(std::lround(100 * opacity));
}

/// Scales the first mip level that is less than twice as large as the thumbnail.
QPixmap thumbnailOf(const ReferencePicture& picture, double ratio)
{
    const int wanted = static_cast<int>(std::lround(thumbnailSize * ratio));
    const auto small = std::ranges::find_if(
        picture.levels, [&](const QImage& level) { return std::max(level.width(), level.height()) < 2 * wanted; });
    QPixmap pixmap = QPixmap::fromImage(small->scaled(wanted, wanted, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}
} // namespace

ReferencePanel::ReferencePanel(ReferenceImages* images, Viewport* viewport, const Actions& actions, QWidget* parent)
    : QWidget(parent)
    , m_images(images)
    , m_viewport(viewport)
    , m_side(nearestSide(viewport->camera()))
    , m_sides(new QComboBox)
    , m_inFront(new QCheckBox(tr("In front of the model")))
{
    named(m_sides, "reference.side", tr("The side that shows the image. Choosing another side turns the view to it."),
          tr("Side"));
    m_sides->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_sides->setMinimumWidth(minWidth);
    connect(m_sides, &QComboBox::activated, this,
            [this](int index) { m_viewport->navigation()->turnTo(static_cast<OrbitCamera::Side>(index)); });
    m_width = lengthBox(QStringLiteral("reference.width"), tr("Width"),
                        tr("How wide the image is, measured beside the model."), minReferenceWidth, maxReferenceWidth);
    m_width->setStepType(QDoubleSpinBox::AdaptiveDecimalStepType);
    m_x = lengthBox(QStringLiteral("reference.x"), tr("To the right"),
                    tr("How far the image's middle is to the right of the origin."), -maxReferenceOffset,
                    maxReferenceOffset);
    m_y = lengthBox(QStringLiteral("reference.y"), tr("Upwards"),
                    tr("How far the image's middle is above the origin in this view."), -maxReferenceOffset,
                    maxReferenceOffset);
    named(m_inFront, "reference.inFront",
          tr("Draws the image over the model instead of behind it, so that both can be compared."));
    connect(m_inFront, &QCheckBox::toggled, this, &ReferencePanel::place);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(gap, gap, gap, gap);
    form->setSpacing(gap);
    form->addRow(tr("Side"), m_sides);
    form->addRow(buildHead(actions));
    form->addRow(tr("Width"), m_width);
    form->addRow(tr("To the right"), m_x);
    form->addRow(tr("Upwards"), m_y);
    form->addRow(tr("Opacity"), buildOpacity());
    form->addRow(m_inFront);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

    connect(images, &ReferenceImages::changed, this, &ReferencePanel::showImage);
    connect(viewport->input(), &PointerInput::viewChanged, this, &ReferencePanel::followView);
    showImage();
}

/// Builds the row with thumbnail, name and buttons.
QLayout* ReferencePanel::buildHead(const Actions& actions)
{
    m_thumbnail = named(new QLabel, "reference.thumbnail");
    m_thumbnail->setFixedSize(thumbnailSize, thumbnailSize);
    m_thumbnail->setAlignment(Qt::AlignCenter);
    m_name = named(new QLabel, "reference.name");
    m_name->setTextFormat(Qt::PlainText);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(gap / 2);
    for (const char* id : {"reference.choose", "reference.show", "reference.remove"}) {
        auto* button = new QToolButton;
        button->setDefaultAction(actions.get(QLatin1StringView(id)));
        button->setIconSize(QSize(20, 20));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* column = new QVBoxLayout;
    column->setSpacing(gap / 2);
    column->addWidget(m_name);
    column->addLayout(buttons);
    auto* row = new QHBoxLayout;
    row->addWidget(m_thumbnail);
    row->addLayout(column, 1);
    return row;
}

QLayout* ReferencePanel::buildOpacity()
{
    m_opacity = new QSlider(Qt::Horizontal);
    m_percent = named(new QSpinBox, "reference.opacity");
    m_percent->setKeyboardTracking(false);
    m_percent->setSuffix(tr(" %"));
    m_opacity->setRange(percentOf(minReferenceOpacity), 100);
    m_percent->setRange(percentOf(minReferenceOpacity), 100);
    for (QWidget* control : {static_cast<QWidget*>(m_opacity), static_cast<QWidget*>(m_percent)}) {
        control->setAccessibleName(tr("Opacity"));
        control->setToolTip(tr("Opacity of the image."));
    }
    connect(m_opacity, &QSlider::valueChanged, m_percent, &QSpinBox::setValue);
    connect(m_percent, &QSpinBox::valueChanged, this, &ReferencePanel::place);
    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    row->addWidget(m_opacity, 1);
    row->addWidget(m_percent);
    return row;
}

QDoubleSpinBox* ReferencePanel::lengthBox(const QString& id, const QString& name, const QString& tip, double min,
                                          double max)
{
    auto* box = named(new NumberField, id, tip, name);
    box->setDecimals(2);
    box->setRange(min, max);
    box->setSuffix(tr(" mm"));
    box->setKeyboardTracking(false);
    // A box wide enough for the largest number would widen the dock
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    box->setMinimumWidth(minWidth);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ReferencePanel::place);
    return box;
}

void ReferencePanel::followView()
{
    const OrbitCamera::Side side = nearestSide(m_viewport->camera());
    if (side == m_side)
        return;
    m_side = side;
    showImage();
}

void ReferencePanel::showImage()
{
    showSides();
    showFile();
    const bool isThere = !m_images->path(m_side).isEmpty();
    for (QWidget* control : std::initializer_list<QWidget*>{m_width, m_x, m_y, m_opacity, m_percent, m_inFront})
        control->setEnabled(isThere);
    const QSignalBlocker quiet[] = {QSignalBlocker(m_width),   QSignalBlocker(m_x),       QSignalBlocker(m_y),
                                    QSignalBlocker(m_opacity), QSignalBlocker(m_percent), QSignalBlocker(m_inFront)};
    const ReferencePlacement& placement = m_images->reference(m_side).placement;
    m_width->setValue(placement.width);
    m_x->setValue(placement.x);
    m_y->setValue(placement.y);
    m_opacity->setValue(percentOf(placement.opacity));
    m_percent->setValue(percentOf(placement.opacity));
    m_inFront->setChecked(placement.inFront);
}

/// Lists the sides and says which have an image.
void ReferencePanel::showSides()
{
    const QString names[] = {tr("Front"), tr("Back"), tr("Right"), tr("Left"), tr("Top"), tr("Bottom")};
    for (const auto& side : viewSides) {
        const auto index = static_cast<int>(side.value);
        const QString words =
            m_images->reference(side.value).picture ? tr("%1, with an image").arg(names[index]) : names[index];
        if (index == m_sides->count())
            m_sides->addItem(words);
        else
            m_sides->setItemText(index, words);
    }
    m_sides->setCurrentIndex(static_cast<int>(m_side));
}

void ReferencePanel::showFile()
{
    const QString path = m_images->path(m_side);
    const QString name = path.isEmpty() ? tr("No image") : QFileInfo(path).fileName();
    m_name->setText(m_name->fontMetrics().elidedText(name, Qt::ElideMiddle, maxNameLength));
    m_name->setToolTip(path.isEmpty() ? tr("Choose an image, or drop its file on the window.")
                                      : QDir::toNativeSeparators(path));
    const SharedReferencePicture& picture = m_images->reference(m_side).picture;
    if (picture && picture != m_thumbnailOf)
        m_thumbnail->setPixmap(thumbnailOf(*picture, devicePixelRatioF()));
    else if (!picture)
        m_thumbnail->setPixmap(themedIcon(path.isEmpty() ? QStringLiteral("reference") : QStringLiteral("unreadable"))
                                   .pixmap(iconSize, iconSize));
    m_thumbnailOf = picture;
}

void ReferencePanel::place()
{
    m_images->place(m_side,
                    {m_width->value(), m_x->value(), m_y->value(), m_percent->value() / 100.0, m_inFront->isChecked()});
}
} // namespace ui
