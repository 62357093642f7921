// Entry points. The loader gets getInstanceProcAddr() from xrNegotiateLoaderRuntimeInterface(), and all other functions
// from getInstanceProcAddr(). Each function of OpenXR is an Entry. It takes the mutex, waits while it is frozen, gets
// its answer from a scripted result or from the function of calls.h, and logs the call.
#include "vr/simulator/calls.h"
#include "vr/simulator/enum_names.h"
#include "vr/simulator/loader_interface.h"

#include <iostream>
#include <new>

namespace simulator
{
namespace
{
template <std::size_t N> struct Name
{
    consteval Name(const char (&given)[N]) { std::copy_n(given, N, text); }
    char text[N]{}; // NOLINT(readability-identifier-naming): a template's argument has no private members
};

bool isClientsFault(XrResult result)
{
    switch (result) {
    case XR_ERROR_RUNTIME_FAILURE:
    case XR_ERROR_OUT_OF_MEMORY:
    case XR_ERROR_INITIALIZATION_FAILED:
    case XR_ERROR_FUNCTION_UNSUPPORTED:
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
    case XR_ERROR_RUNTIME_UNAVAILABLE:
    case XR_ERROR_INSTANCE_LOST:
    case XR_ERROR_SESSION_LOST:
        return false;
    default:
        return XR_FAILED(result);
    }
}

std::optional<XrResult> takeScriptedResult(Call& call)
{
    auto& scriptedResults = call.runtime.world.scriptedResults;
    const auto found = scriptedResults.find(call.name);
    if (found == scriptedResults.end() || found->second.times == 0)
        return {};
    if (found->second.after > 0) {
        --found->second.after;
        return {};
    }
    --found->second.times;
    call.line["scripted"] = true;
    return found->second.result;
}

template <class Implementation> XrResult answered(Call& call, Implementation implementation)
{
    if (const auto result = takeScriptedResult(call))
        return *result;
    try {
        const XrResult result = implementation();
        return result == XR_SUCCESS && call.isLossPending() ? XR_SESSION_LOSS_PENDING : result;
    } catch (const CallFailure& failure) {
        call.line["reason"] = failure.reason;
        if (isClientsFault(failure.result))
            call.error(nameOf(failure.result) + ", " + failure.reason);
        return failure.result;
    } catch (const std::bad_alloc&) {
        return XR_ERROR_OUT_OF_MEMORY;
    } catch (const std::exception& exception) {
        call.line["reason"] = exception.what();
        return XR_ERROR_RUNTIME_FAILURE;
    }
}

void waitWhileFrozen(Call& call)
{
    Runtime& runtime = call.runtime;
    if (runtime.world.frozen != call.name)
        return;
    runtime.isClientFrozen = true;
    runtime.changed.wait(call.lock, [&] { return runtime.world.frozen != call.name; });
    runtime.isClientFrozen = false;
}

template <Name FunctionName, auto Implementation> struct Entry;

template <Name FunctionName, class... Arguments, XrResult (*Implementation)(Call&, Arguments...)>
struct Entry<FunctionName, Implementation>
{
    static XrResult XRAPI_CALL call(Arguments... arguments)
    {
        Runtime& runtime = Runtime::get();
        std::unique_lock lock(runtime.mutex);
        Call call(FunctionName.text, runtime, lock);
        waitWhileFrozen(call);
        const XrResult result = answered(call, [&] { return Implementation(call, arguments...); });
        call.line["result"] = nameOf(result);
        call.line.update(call.where());
        runtime.log.call(FunctionName.text, std::move(call.line));
        return result;
    }
};

template <class Function, Name FunctionName, auto Implementation>
std::pair<std::string_view, PFN_xrVoidFunction> entry()
{
    // Makes the compiler check that the arguments are those of OpenXR's function type.
    constexpr Function function = &Entry<FunctionName, Implementation>::call;
    return {FunctionName.text, reinterpret_cast<PFN_xrVoidFunction>(function)};
}

#define FETTLE_ENTRY(FUNCTION, IMPLEMENTATION) entry<PFN_##FUNCTION, #FUNCTION, IMPLEMENTATION>()

const std::map<std::string_view, PFN_xrVoidFunction>& globalEntries()
{
    static const std::map<std::string_view, PFN_xrVoidFunction> entries{
        FETTLE_ENTRY(xrEnumerateInstanceExtensionProperties, enumerateInstanceExtensionProperties),
        FETTLE_ENTRY(xrCreateInstance, createInstance),
    };
    return entries;
}

const std::map<std::string_view, PFN_xrVoidFunction>& instanceEntries()
{
    static const std::map<std::string_view, PFN_xrVoidFunction> entries{
        FETTLE_ENTRY(xrDestroyInstance, destroyInstance),
        FETTLE_ENTRY(xrGetInstanceProperties, getInstanceProperties),
        FETTLE_ENTRY(xrPollEvent, pollEvent),
        FETTLE_ENTRY(xrResultToString, resultToString),
        FETTLE_ENTRY(xrStructureTypeToString, structureTypeToString),
        FETTLE_ENTRY(xrStringToPath, stringToPath),
        FETTLE_ENTRY(xrPathToString, pathToString),
        FETTLE_ENTRY(xrGetSystem, getSystem),
        FETTLE_ENTRY(xrGetSystemProperties, getSystemProperties),
        FETTLE_ENTRY(xrEnumerateEnvironmentBlendModes, enumerateEnvironmentBlendModes),
        FETTLE_ENTRY(xrEnumerateViewConfigurations, enumerateViewConfigurations),
        FETTLE_ENTRY(xrGetViewConfigurationProperties, getViewConfigurationProperties),
        FETTLE_ENTRY(xrEnumerateViewConfigurationViews, enumerateViewConfigurationViews),
        FETTLE_ENTRY(xrCreateSession, createSession),
        FETTLE_ENTRY(xrDestroySession, destroySession),
        FETTLE_ENTRY(xrBeginSession, beginSession),
        FETTLE_ENTRY(xrEndSession, endSession),
        FETTLE_ENTRY(xrRequestExitSession, requestExitSession),
        FETTLE_ENTRY(xrWaitFrame, waitFrame),
        FETTLE_ENTRY(xrBeginFrame, beginFrame),
        FETTLE_ENTRY(xrEndFrame, endFrame),
        FETTLE_ENTRY(xrEnumerateSwapchainFormats, enumerateSwapchainFormats),
        FETTLE_ENTRY(xrCreateSwapchain, createSwapchain),
        FETTLE_ENTRY(xrDestroySwapchain, destroySwapchain),
        FETTLE_ENTRY(xrEnumerateSwapchainImages, enumerateSwapchainImages),
        FETTLE_ENTRY(xrAcquireSwapchainImage, acquireSwapchainImage),
        FETTLE_ENTRY(xrWaitSwapchainImage, waitSwapchainImage),
        FETTLE_ENTRY(xrReleaseSwapchainImage, releaseSwapchainImage),
        FETTLE_ENTRY(xrEnumerateReferenceSpaces, enumerateReferenceSpaces),
        FETTLE_ENTRY(xrCreateReferenceSpace, createReferenceSpace),
        FETTLE_ENTRY(xrGetReferenceSpaceBoundsRect, getReferenceSpaceBoundsRect),
        FETTLE_ENTRY(xrCreateActionSpace, createActionSpace),
        FETTLE_ENTRY(xrLocateSpace, locateSpace),
        FETTLE_ENTRY(xrDestroySpace, destroySpace),
        FETTLE_ENTRY(xrLocateViews, locateViews),
        FETTLE_ENTRY(xrCreateActionSet, createActionSet),
        FETTLE_ENTRY(xrDestroyActionSet, destroyActionSet),
        FETTLE_ENTRY(xrCreateAction, createAction),
        FETTLE_ENTRY(xrDestroyAction, destroyAction),
        FETTLE_ENTRY(xrSuggestInteractionProfileBindings, suggestInteractionProfileBindings),
        FETTLE_ENTRY(xrAttachSessionActionSets, attachSessionActionSets),
        FETTLE_ENTRY(xrGetCurrentInteractionProfile, getCurrentInteractionProfile),
        FETTLE_ENTRY(xrSyncActions, syncActions),
        FETTLE_ENTRY(xrGetActionStateBoolean, getActionStateBoolean),
        FETTLE_ENTRY(xrGetActionStateFloat, getActionStateFloat),
        FETTLE_ENTRY(xrGetActionStateVector2f, getActionStateVector2f),
        FETTLE_ENTRY(xrGetActionStatePose, getActionStatePose),
        FETTLE_ENTRY(xrEnumerateBoundSourcesForAction, enumerateBoundSourcesForAction),
        FETTLE_ENTRY(xrGetInputSourceLocalizedName, getInputSourceLocalizedName),
        FETTLE_ENTRY(xrApplyHapticFeedback, applyHapticFeedback),
        FETTLE_ENTRY(xrStopHapticFeedback, stopHapticFeedback),
    };
    return entries;
}

/// Entry points of an extension's functions.
struct ExtensionEntries
{
    const char* extension;
    std::map<std::string_view, PFN_xrVoidFunction> entries;
};

const std::vector<ExtensionEntries>& extensionEntries()
{
    static const std::vector<ExtensionEntries> all{
        {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME,
         {FETTLE_ENTRY(xrGetOpenGLGraphicsRequirementsKHR, getOpenGlRequirements)}},
        {XR_KHR_VISIBILITY_MASK_EXTENSION_NAME, {FETTLE_ENTRY(xrGetVisibilityMaskKHR, getVisibilityMask)}},
        {XR_EXT_HAND_TRACKING_EXTENSION_NAME,
         {FETTLE_ENTRY(xrCreateHandTrackerEXT, createHandTracker),
          FETTLE_ENTRY(xrDestroyHandTrackerEXT, destroyHandTracker),
          FETTLE_ENTRY(xrLocateHandJointsEXT, locateHandJoints)}},
        {XR_FB_DISPLAY_REFRESH_RATE_EXTENSION_NAME,
         {FETTLE_ENTRY(xrEnumerateDisplayRefreshRatesFB, enumerateDisplayRefreshRates),
          FETTLE_ENTRY(xrGetDisplayRefreshRateFB, getDisplayRefreshRate),
          FETTLE_ENTRY(xrRequestDisplayRefreshRateFB, requestDisplayRefreshRate)}},
    };
    return all;
}

bool isEnabled(XrInstance handle, const char* extension)
{
    Runtime& runtime = Runtime::get();
    const std::lock_guard lock(runtime.mutex);
    return runtime.handles.find<Instance>(handle)->extensions.contains(extension);
}

PFN_xrVoidFunction find(const std::map<std::string_view, PFN_xrVoidFunction>& entries, std::string_view name)
{
    const auto found = entries.find(name);
    return found == entries.end() ? nullptr : found->second;
}

XrResult XRAPI_CALL getInstanceProcAddr(XrInstance instance, const char* name, PFN_xrVoidFunction* function);

PFN_xrVoidFunction functionFor(XrInstance instance, std::string_view name)
{
    if (name == "xrGetInstanceProcAddr")
        return reinterpret_cast<PFN_xrVoidFunction>(&getInstanceProcAddr);
    if (const auto global = find(globalEntries(), name))
        return global;
    require(instance != XR_NULL_HANDLE, XR_ERROR_HANDLE_INVALID, "without an instance there is none of that name");
    for (const ExtensionEntries& one : extensionEntries())
        if (const auto function = find(one.entries, name); function && isEnabled(instance, one.extension))
            return function;
    return find(instanceEntries(), name);
}

XrResult XRAPI_CALL getInstanceProcAddr(XrInstance instance, const char* name, PFN_xrVoidFunction* function)
{
    try {
        validated(function) = nullptr;
        *function = functionFor(instance, &validated(name));
        return *function ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
    } catch (const CallFailure& failure) {
        return failure.result;
    }
}

bool isCompatible(const LoaderInfo* loader, const RuntimeRequest* request)
{
    return loader && request && loader->type == LoaderStructure::LoaderInfo &&
           request->type == LoaderStructure::RuntimeRequest && loader->size == sizeof(LoaderInfo) &&
           request->size == sizeof(RuntimeRequest) && loader->minInterfaceVersion <= loaderInterfaceVersion &&
           loader->maxInterfaceVersion >= loaderInterfaceVersion && loader->minApiVersion <= implementedVersion &&
           loader->maxApiVersion >= XR_MAKE_VERSION(1, 0, 0);
}
} // namespace
} // namespace simulator

extern "C" __attribute__((visibility("default"))) XrResult
xrNegotiateLoaderRuntimeInterface(const simulator::LoaderInfo* loader, simulator::RuntimeRequest* request)
{
    using namespace simulator;
    if (!isCompatible(loader, request))
        return XR_ERROR_INITIALIZATION_FAILED;
    try {
        Runtime& runtime = Runtime::get();
        const std::lock_guard lock(runtime.mutex);
        runtime.loadOnce();
    } catch (const std::exception& exception) {
        std::cerr << "Fettle's VR simulator does not understand its script: " << exception.what() << '\n';
        return XR_ERROR_INITIALIZATION_FAILED;
    }
    request->interfaceVersion = loaderInterfaceVersion;
    request->apiVersion = implementedVersion;
    request->getInstanceProcAddr = &getInstanceProcAddr;
    return XR_SUCCESS;
}
