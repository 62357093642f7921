#include "ui/model/model_actions.h"

#include "ui/actions/actions.h"
#include "ui/model/model_dialogs.h"
#include "ui/model/primitive_dialog.h"
#include "ui/settings/brush_settings.h"

#include <QAction>
#include <QWidget>

#include <utility>

namespace ui
{
namespace
{
using How = core::MaskOperation::Kind;

constexpr std::pair<const char*, How> maskActions[] = {{"mask.invert", How::Invert}, {"mask.clear", How::Clear},
                                                       {"mask.blur", How::Blur},     {"mask.sharpen", How::Sharpen},
                                                       {"mask.grow", How::Grow},     {"mask.shrink", How::Shrink},
                                                       {"mask.cavity", How::Cavity}, {"mask.part", How::Part}};
} // namespace

void connectModel(const Actions& actions, QWidget* window, const std::function<const ModelInfo&()>& modelInfo,
                  const BrushSettings* brush, const std::function<void(const core::ModelCommand&)>& request)
{
    const auto on = [&](const char* id, const auto& what) {
        QObject::connect(actions.get(QLatin1StringView(id)), &QAction::triggered, window, what);
    };
    on("model.scale", [=] { askForScale(window, modelInfo(), request); });
    on("model.mirror", [=] { askForMirror(window, request); });
    on("model.symmetrize", [=] { askForSymmetry(window, request); });
    on("model.recentre", [=] { request(core::Recentre{}); });
    on("model.placeOnBed", [=] { request(core::PlaceOnBed{}); });
    on("model.flattenBase", [=] { askForBase(window, modelInfo(), request); });
    on("model.reset", [=] { request(core::Reset{}); });
    on("model.fill", [=] { request(core::Fill{brush->stroke().color}); });
    on("mask.color", [=] { request(core::MaskOperation{How::Color, brush->stroke().color}); });
    for (const auto& [id, how] : maskActions)
        on(id, [=, how = how] { request(core::MaskOperation{how}); });
    on("mask.hideMasked", [=] { request(core::Hide{core::Hide::What::Masked}); });
    on("mask.hideUnmasked", [=] { request(core::Hide{core::Hide::What::Unmasked}); });
    on("mask.showHidden", [=] { request(core::Hide{core::Hide::What::Nothing}); });
    on("model.insertPrimitive",
       [=, memory = std::make_shared<PrimitiveMemory>()] { askForPrimitive(window, modelInfo(), memory, request); });
    on("model.remesh", [=] { askForRemesh(window, modelInfo(), request); });
}
} // namespace ui
