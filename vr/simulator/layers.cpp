#include "vr/simulator/layers.h"

#include "vr/simulator/spaces.h"
#include "vr/simulator/system.h"
#include "vr/simulator/xr_pose.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <utility>

namespace simulator
{
namespace
{
using nlohmann::json;

json listOf(const XrPosef& pose)
{
    return {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.x,
            pose.orientation.y, pose.orientation.z, pose.orientation.w};
}

json listOf(const XrFovf& fov)
{
    return {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown};
}

TexturePart checkedPart(Call& call, const XrSwapchainSubImage& image)
{
    const auto& swapchain = call.get<Swapchain>(image.swapchain);
    const XrOffset2Di& offset = image.imageRect.offset;
    const XrExtent2Di& extent = image.imageRect.extent;
    const TextureForm& form = swapchain.form();
    require(swapchain.shown().has_value(), XR_ERROR_LAYER_INVALID, "no image of the swapchain was released");
    const bool isInside = offset.x >= 0 && offset.y >= 0 && extent.width > 0 && extent.height > 0 &&
                          extent.width <= form.width - offset.x && extent.height <= form.height - offset.y;
    require(isInside, XR_ERROR_SWAPCHAIN_RECT_INVALID, "the rectangle is empty or leaves the image");
    require(image.imageArrayIndex < static_cast<std::uint32_t>(form.layers), XR_ERROR_VALIDATION_FAILURE,
            "no such array layer");
    return {swapchain.texture(*swapchain.shown()),  form, offset.x, offset.y, extent.width, extent.height,
            static_cast<int>(image.imageArrayIndex)};
}

void checkFov(const XrFovf& fov)
{
    const auto isAngle = [](float angle) { return std::abs(angle) < std::numbers::pi_v<float> / 2; };
    require(isAngle(fov.angleLeft) && isAngle(fov.angleRight) && isAngle(fov.angleUp) && isAngle(fov.angleDown),
            XR_ERROR_VALIDATION_FAILURE, "an angle of view is out of range");
}

/// Warns if a view was drawn from another pose than xrLocateViews reports: the picture would swim before the eyes.
void compareWithView(Call& call, const Session& session, const XrCompositionLayerProjection& layer, std::uint32_t eye)
{
    constexpr double allowed = 1e-3; // metres for positions, deviation of the dot product from 1 for quaternions
    const auto& space = call.get<Space>(layer.space);
    const auto located = locateView(call.runtime.world, {space, session.views(), eye, session.begun->displayTime});
    const vr::Pose drawn = fromXr(layer.views[eye].pose);
    const bool isThere = (!located.hasPosition() || (drawn.position - located.pose.position).norm() < allowed) &&
                         std::abs(drawn.rotation.dot(located.pose.rotation)) > 1 - allowed;
    if (located.isValid() && !isThere)
        call.warn("a view is not where xrLocateViews says it is at the frame's display time");
}

/// Returns the depth information in a view's next chain; null if there is none.
const XrCompositionLayerDepthInfoKHR* depthOf(const XrCompositionLayerProjectionView& view)
{
    for (auto* it = static_cast<const XrBaseInStructure*>(view.next); it; it = it->next)
        if (it->type == XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR)
            return reinterpret_cast<const XrCompositionLayerDepthInfoKHR*>(it);
    return nullptr;
}

TexturePart checkedDepth(Call& call, const Session& session, const XrCompositionLayerDepthInfoKHR& depth)
{
    require(session.instance().extensions.contains(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME),
            XR_ERROR_VALIDATION_FAILURE, "depth of which the extension is not enabled");
    const TexturePart part = checkedPart(call, depth.subImage);
    require(ShareContext::isDepth(part.form.format), XR_ERROR_LAYER_INVALID, "depth in an image that is none");
    require(depth.minDepth >= 0 && depth.minDepth < depth.maxDepth && depth.maxDepth <= 1, XR_ERROR_VALIDATION_FAILURE,
            "a range of depth that is none");
    require(depth.nearZ >= 0 && depth.farZ >= 0 && depth.nearZ != depth.farZ, XR_ERROR_VALIDATION_FAILURE,
            "planes at no distance from each other");
    return part;
}

bool hasAlpha(XrCompositionLayerFlags flags)
{
    return (flags & XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT) != 0;
}

json projection(Call& call, const Session& session, const XrCompositionLayerProjection& layer, Layers& layers)
{
    constexpr const char* eyes[] = {"left", "right"};
    call.get<Space>(layer.space);
    require(layer.viewCount == viewCount(session.views()), XR_ERROR_VALIDATION_FAILURE,
            "not as many views as the session has");
    json views = json::array();
    const bool isFirst =
        std::all_of(layers.shown.begin(), layers.shown.end(), [](const auto& it) { return it.isQuad; });
    for (std::uint32_t eye = 0; eye < layer.viewCount; ++eye) {
        const XrCompositionLayerProjectionView& view = (&validated(layer.views))[eye];
        validated(&view, XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
        fromXr(view.pose);
        checkFov(view.fov);
        const TexturePart part = checkedPart(call, view.subImage);
        compareWithView(call, session, layer, eye);
        if (isFirst)
            layers.shown.push_back(
                {layer.viewCount == 1 ? "mono" : eyes[eye], part, false, !hasAlpha(layer.layerFlags)});
        views.push_back({{"pose", listOf(view.pose)},
                         {"fov", listOf(view.fov)},
                         {"rect", {part.x, part.y, part.width, part.height}},
                         {"layer", part.layer}});
        if (const XrCompositionLayerDepthInfoKHR* depth = depthOf(view)) {
            const TexturePart depthPart = checkedDepth(call, session, *depth);
            if (isFirst)
                layers.shown.push_back({layers.shown.back().name + "_depth", depthPart});
            views.back()["depth"] = {depth->minDepth, depth->maxDepth, depth->nearZ, depth->farZ};
        }
    }
    return {{"type", "projection"},
            {"alpha", hasAlpha(layer.layerFlags)},
            {"space", nameOf(call.get<Space>(layer.space))},
            {"views", views}};
}

json quad(Call& call, const XrCompositionLayerQuad& layer, Layers& layers)
{
    const auto& space = call.get<Space>(layer.space);
    fromXr(layer.pose);
    const bool isEyes = layer.eyeVisibility >= XR_EYE_VISIBILITY_BOTH && layer.eyeVisibility <= XR_EYE_VISIBILITY_RIGHT;
    require(isEyes, XR_ERROR_VALIDATION_FAILURE, "no such eye");
    const TexturePart part = checkedPart(call, layer.subImage);
    const auto number =
        std::count_if(layers.shown.begin(), layers.shown.end(), [](const auto& it) { return it.isQuad; });
    layers.shown.push_back({"quad" + std::to_string(number), part, true, !hasAlpha(layer.layerFlags)});
    return {{"type", "quad"},
            {"space", nameOf(space)},
            {"pose", listOf(layer.pose)},
            {"size", {layer.size.width, layer.size.height}},
            {"rect", {part.x, part.y, part.width, part.height}}};
}

json checkedLayer(Call& call, const Session& session, const XrCompositionLayerBaseHeader* header, Layers& layers)
{
    require(header, XR_ERROR_LAYER_INVALID, "a layer is null");
    switch (header->type) {
    case XR_TYPE_COMPOSITION_LAYER_PROJECTION:
        return projection(call, session, reinterpret_cast<const XrCompositionLayerProjection&>(*header), layers);
    case XR_TYPE_COMPOSITION_LAYER_QUAD:
        return quad(call, reinterpret_cast<const XrCompositionLayerQuad&>(*header), layers);
    default:
        throw CallFailure{XR_ERROR_LAYER_INVALID, "a layer of a kind that is not offered"};
    }
}

double linear(int encoded)
{
    const double value = encoded / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// Adds the light of the real room, which is a plain wall, to a picture of eight bits in sRGB whose colours are
/// multiplied by their alpha. `byAlpha`: opaque pixels hide the wall.
void addRoom(Picture& picture, bool byAlpha)
{
    constexpr std::array<int, 3> wall{176, 170, 160};
    for (std::size_t pixel = 0; pixel < picture.rgba.size(); pixel += 4) {
        const double seen = byAlpha ? 1 - picture.rgba[pixel + 3] / 255.0 : 1;
        for (std::size_t i = 0; seen > 0 && i < wall.size(); ++i) {
            std::uint8_t& value = picture.rgba[pixel + i];
            if (value == 0 && seen == 1) {
                value = static_cast<std::uint8_t>(wall[i]);
                continue;
            }
            const double light = std::min(linear(value) + seen * linear(wall[i]), 1.0);
            const double encoded = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
            value = static_cast<std::uint8_t>(std::lround(255 * encoded));
        }
    }
}

bool isWanted(SimulatedWorld& world, std::int64_t frame)
{
    const bool isListed = world.keptFrames.erase(frame) > 0;
    return isListed || (world.keepEvery > 0 && frame % world.keepEvery == 0);
}
} // namespace

Layers checkedLayers(Call& call, const Session& session, const XrFrameEndInfo& info)
{
    require(info.displayTime > 0, XR_ERROR_TIME_INVALID, "the display time is not positive");
    const auto& modes = call.runtime.world.blendModes;
    require(std::find(modes.begin(), modes.end(), info.environmentBlendMode) != modes.end(),
            XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "the blend mode is not offered");
    require(info.layerCount <= maxLayers, XR_ERROR_LAYER_LIMIT_EXCEEDED, "too many layers");
    Layers layers;
    layers.blendMode = info.environmentBlendMode;
    for (std::uint32_t i = 0; i < info.layerCount; ++i)
        layers.description.push_back(checkedLayer(call, session, (&validated(info.layers))[i], layers));
    return layers;
}

void showPicture(Runtime& runtime, const Session& session, const Layers& layers)
{
    const auto eye = std::find_if(layers.shown.begin(), layers.shown.end(), [](const auto& it) { return !it.isQuad; });
    if (eye == layers.shown.end() || !std::exchange(runtime.isPictureWanted, false))
        return;
    runtime.picture = session.gl()->read(eye->part);
    if (layers.blendMode == XR_ENVIRONMENT_BLEND_MODE_ADDITIVE)
        addRoom(*runtime.picture, false);
    else if (layers.blendMode == XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND && !eye->isOpaque)
        addRoom(*runtime.picture, true);
    runtime.changed.notify_all();
}

void keepPictures(Runtime& runtime, const Session& session, const Frame& frame, const Layers& layers)
{
    if (runtime.pictureFolder.empty() || !isWanted(runtime.world, frame.number))
        return;
    for (const Layers::Shown& shown : layers.shown) {
        Picture picture = session.gl()->read(shown.part);
        for (std::size_t alpha = 3; shown.isOpaque && alpha < picture.rgba.size(); alpha += 4)
            picture.rgba[alpha] = 255;
        std::ostringstream path;
        path << runtime.pictureFolder << "/session" << session.index << "_frame" << std::setw(4) << std::setfill('0')
             << frame.number << '_' << shown.name << ".png";
        writePng(picture, path.str());
    }
}
} // namespace simulator
