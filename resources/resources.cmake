# fettle_add_resources(TARGET): what the program reads at run time as ":/<path below resources>": icons, shaders.
# On executables only: in a static library resources can be lost when it is linked.
set(FETTLE_RESOURCE_FILES
    icons/about.svg
    icons/color.svg
    icons/export.svg
    icons/fettle.svg
    icons/fill.svg
    icons/flatten.svg
    icons/frame.svg
    icons/fusion.svg
    icons/headset.svg
    icons/insert.svg
    icons/keys.svg
    icons/larger.svg
    icons/mirror.svg
    icons/move.svg
    icons/open.svg
    icons/orthographic.svg
    icons/paint.svg
    icons/pull.svg
    icons/push.svg
    icons/quit.svg
    icons/ray.svg
    icons/recentre.svg
    icons/redo.svg
    icons/remesh.svg
    icons/rotate.svg
    icons/scale.svg
    icons/smaller.svg
    icons/smooth.svg
    icons/stop.svg
    icons/symmetrize.svg
    icons/undo.svg
    icons/uniform.svg
    icons/view-back.svg
    icons/view-bottom.svg
    icons/view-front.svg
    icons/view-left.svg
    icons/view-right.svg
    icons/view-top.svg
    shaders/background.frag
    shaders/background.vert
    shaders/clay.frag
    shaders/clay.vert
    shaders/cursor.frag
    shaders/cursor.vert
    shaders/ground.frag
    shaders/ground.vert
    shaders/layer.frag
    shaders/plane.frag
    shaders/plane.vert)

function(fettle_add_resources TARGET)
    list(TRANSFORM FETTLE_RESOURCE_FILES PREPEND ${PROJECT_SOURCE_DIR}/resources/ OUTPUT_VARIABLE FILES)
    qt_add_resources(${TARGET} "resources" PREFIX "/" BASE ${PROJECT_SOURCE_DIR}/resources FILES ${FILES})
endfunction()
