#include "vr/simulator/calls.h"
#include "vr/simulator/spaces.h"
#include "vr/simulator/system.h"

#include <array>
#include <cmath>

namespace simulator
{
namespace
{
struct Triangles
{
    std::vector<XrVector2f> points;
    std::vector<std::uint32_t> indices;
};

/// Returns the corners of an eye's picture at a distance of 1: right-angled triangles whose legs are `share` of its
/// sides.
Triangles cornersOf(const XrFovf& fov, double share)
{
    Triangles corners;
    if (share <= 0)
        return corners;
    const std::array across{std::tan(fov.angleLeft), std::tan(fov.angleRight)};
    const std::array along{std::tan(fov.angleDown), std::tan(fov.angleUp)};
    const auto towards = [&](float from, float to) { return from + static_cast<float>(share) * (to - from); };
    for (const std::size_t i : {0, 1})
        for (const std::size_t j : {0, 1}) {
            corners.points.insert(corners.points.end(), {{across[i], along[j]},
                                                         {towards(across[i], across[1 - i]), along[j]},
                                                         {across[i], towards(along[j], along[1 - j])}});
            for (int k = 0; k < 3; ++k)
                corners.indices.push_back(static_cast<std::uint32_t>(corners.indices.size()));
        }
    return corners;
}
} // namespace

XrResult getVisibilityMask(Call& call, XrSession handle, XrViewConfigurationType views, std::uint32_t view,
                           XrVisibilityMaskTypeKHR type, XrVisibilityMaskKHR* mask)
{
    call.get<Session>(handle);
    validated(mask, XR_TYPE_VISIBILITY_MASK_KHR);
    const SimulatedWorld& world = call.runtime.world;
    requireViews(world, views);
    require(view < viewCount(views), XR_ERROR_VALIDATION_FAILURE, "no such view");
    require(type >= XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR && type <= XR_VISIBILITY_MASK_TYPE_LINE_LOOP_KHR,
            XR_ERROR_VALIDATION_FAILURE, "no such kind of mask");
    const bool isTold = type == XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR;
    const Triangles told =
        isTold ? cornersOf(fovOf(world.headset, views, view), world.headset.hiddenShare) : Triangles();
    writeItems(OutputArray<XrVector2f>{mask->vertexCapacityInput, &mask->vertexCountOutput, mask->vertices},
               told.points);
    writeItems(OutputArray<std::uint32_t>{mask->indexCapacityInput, &mask->indexCountOutput, mask->indices},
               told.indices);
    return XR_SUCCESS;
}

XrResult enumerateDisplayRefreshRates(Call& call, XrSession handle, std::uint32_t capacity, std::uint32_t* count,
                                      float* rates)
{
    call.get<Session>(handle);
    writeItems(OutputArray<float>{capacity, count, rates}, call.runtime.world.headset.rates());
    return XR_SUCCESS;
}

XrResult getDisplayRefreshRate(Call& call, XrSession handle, float* rate)
{
    call.get<Session>(handle);
    validated(rate) = static_cast<float>(call.runtime.world.headset.hertz);
    return XR_SUCCESS;
}

XrResult requestDisplayRefreshRate(Call& call, XrSession handle, float rate)
{
    call.get<Session>(handle);
    Headset& headset = call.runtime.world.headset;
    const std::vector<float> rates = headset.rates();
    const bool isOffered = rate == 0 || std::find(rates.begin(), rates.end(), rate) != rates.end();
    require(isOffered, XR_ERROR_DISPLAY_REFRESH_RATE_UNSUPPORTED_FB, "the display has no such rate");
    call.line["rate"] = rate;
    if (rate > 0)
        headset.hertz = rate;
    return XR_SUCCESS;
}
} // namespace simulator
