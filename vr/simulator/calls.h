#pragma once

#include "vr/simulator/call.h"

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

/// Implementations of the functions of OpenXR. They may throw CallFailure.
namespace simulator
{
// instance_calls.cpp
XrResult enumerateInstanceExtensionProperties(Call&, const char* layer, std::uint32_t capacity, std::uint32_t* count,
                                              XrExtensionProperties* properties);
XrResult createInstance(Call&, const XrInstanceCreateInfo* info, XrInstance* instance);
XrResult destroyInstance(Call&, XrInstance);
XrResult getInstanceProperties(Call&, XrInstance, XrInstanceProperties*);
XrResult pollEvent(Call&, XrInstance, XrEventDataBuffer*);
XrResult resultToString(Call&, XrInstance, XrResult, char* buffer);
XrResult structureTypeToString(Call&, XrInstance, XrStructureType, char* buffer);
XrResult stringToPath(Call&, XrInstance, const char* text, XrPath*);
XrResult pathToString(Call&, XrInstance, XrPath, std::uint32_t capacity, std::uint32_t* count, char* buffer);

// system_calls.cpp
XrResult getSystem(Call&, XrInstance, const XrSystemGetInfo*, XrSystemId*);
XrResult getSystemProperties(Call&, XrInstance, XrSystemId, XrSystemProperties*);
XrResult enumerateEnvironmentBlendModes(Call&, XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                                        std::uint32_t* count, XrEnvironmentBlendMode*);
XrResult enumerateViewConfigurations(Call&, XrInstance, XrSystemId, std::uint32_t capacity, std::uint32_t* count,
                                     XrViewConfigurationType*);
XrResult getViewConfigurationProperties(Call&, XrInstance, XrSystemId, XrViewConfigurationType,
                                        XrViewConfigurationProperties*);
XrResult enumerateViewConfigurationViews(Call&, XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                                         std::uint32_t* count, XrViewConfigurationView*);
XrResult getOpenGlRequirements(Call&, XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR*);

// session_calls.cpp
XrResult createSession(Call&, XrInstance, const XrSessionCreateInfo*, XrSession*);
XrResult destroySession(Call&, XrSession);
XrResult beginSession(Call&, XrSession, const XrSessionBeginInfo*);
XrResult endSession(Call&, XrSession);
XrResult requestExitSession(Call&, XrSession);

// frame_calls.cpp
XrResult waitFrame(Call&, XrSession, const XrFrameWaitInfo*, XrFrameState*);
XrResult beginFrame(Call&, XrSession, const XrFrameBeginInfo*);
XrResult endFrame(Call&, XrSession, const XrFrameEndInfo*);

// swapchain_calls.cpp
XrResult enumerateSwapchainFormats(Call&, XrSession, std::uint32_t capacity, std::uint32_t* count,
                                   std::int64_t* formats);
XrResult createSwapchain(Call&, XrSession, const XrSwapchainCreateInfo*, XrSwapchain*);
XrResult destroySwapchain(Call&, XrSwapchain);
XrResult enumerateSwapchainImages(Call&, XrSwapchain, std::uint32_t capacity, std::uint32_t* count,
                                  XrSwapchainImageBaseHeader*);
XrResult acquireSwapchainImage(Call&, XrSwapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t* index);
XrResult waitSwapchainImage(Call&, XrSwapchain, const XrSwapchainImageWaitInfo*);
XrResult releaseSwapchainImage(Call&, XrSwapchain, const XrSwapchainImageReleaseInfo*);

// space_calls.cpp
XrResult enumerateReferenceSpaces(Call&, XrSession, std::uint32_t capacity, std::uint32_t* count,
                                  XrReferenceSpaceType*);
XrResult createReferenceSpace(Call&, XrSession, const XrReferenceSpaceCreateInfo*, XrSpace*);
XrResult getReferenceSpaceBoundsRect(Call&, XrSession, XrReferenceSpaceType, XrExtent2Df*);
XrResult createActionSpace(Call&, XrSession, const XrActionSpaceCreateInfo*, XrSpace*);
XrResult locateSpace(Call&, XrSpace, XrSpace base, XrTime, XrSpaceLocation*);
XrResult destroySpace(Call&, XrSpace);
XrResult locateViews(Call&, XrSession, const XrViewLocateInfo*, XrViewState*, std::uint32_t capacity,
                     std::uint32_t* count, XrView*);

// action_calls.cpp
XrResult createActionSet(Call&, XrInstance, const XrActionSetCreateInfo*, XrActionSet*);
XrResult destroyActionSet(Call&, XrActionSet);
XrResult createAction(Call&, XrActionSet, const XrActionCreateInfo*, XrAction*);
XrResult destroyAction(Call&, XrAction);
XrResult suggestInteractionProfileBindings(Call&, XrInstance, const XrInteractionProfileSuggestedBinding*);

// input_calls.cpp
XrResult attachSessionActionSets(Call&, XrSession, const XrSessionActionSetsAttachInfo*);
XrResult getCurrentInteractionProfile(Call&, XrSession, XrPath userPath, XrInteractionProfileState*);
XrResult syncActions(Call&, XrSession, const XrActionsSyncInfo*);
XrResult getActionStateBoolean(Call&, XrSession, const XrActionStateGetInfo*, XrActionStateBoolean*);
XrResult getActionStateFloat(Call&, XrSession, const XrActionStateGetInfo*, XrActionStateFloat*);
XrResult getActionStateVector2f(Call&, XrSession, const XrActionStateGetInfo*, XrActionStateVector2f*);
XrResult getActionStatePose(Call&, XrSession, const XrActionStateGetInfo*, XrActionStatePose*);
XrResult enumerateBoundSourcesForAction(Call&, XrSession, const XrBoundSourcesForActionEnumerateInfo*,
                                        std::uint32_t capacity, std::uint32_t* count, XrPath* sources);
XrResult getInputSourceLocalizedName(Call&, XrSession, const XrInputSourceLocalizedNameGetInfo*, std::uint32_t capacity,
                                     std::uint32_t* count, char* buffer);

// extension_calls.cpp
XrResult getVisibilityMask(Call&, XrSession, XrViewConfigurationType, std::uint32_t view, XrVisibilityMaskTypeKHR,
                           XrVisibilityMaskKHR*);
XrResult enumerateDisplayRefreshRates(Call&, XrSession, std::uint32_t capacity, std::uint32_t* count, float* rates);
XrResult getDisplayRefreshRate(Call&, XrSession, float* rate);
XrResult requestDisplayRefreshRate(Call&, XrSession, float rate);

// hand_tracking_calls.cpp
XrResult createHandTracker(Call&, XrSession, const XrHandTrackerCreateInfoEXT*, XrHandTrackerEXT*);
XrResult destroyHandTracker(Call&, XrHandTrackerEXT);
XrResult locateHandJoints(Call&, XrHandTrackerEXT, const XrHandJointsLocateInfoEXT*, XrHandJointLocationsEXT*);

// haptic_calls.cpp
XrResult applyHapticFeedback(Call&, XrSession, const XrHapticActionInfo*, const XrHapticBaseHeader*);
XrResult stopHapticFeedback(Call&, XrSession, const XrHapticActionInfo*);
} // namespace simulator
