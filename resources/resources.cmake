# fettle_add_resources(TARGET): what the program reads at run time as ":/<path below resources>": icons, shaders, the
# user guide. On executables only: in a static library resources can be lost when it is linked.
set(FETTLE_RESOURCE_FILES
    brushes/big-move.json
    brushes/carve.json
    brushes/clay-buildup.json
    brushes/cracks.json
    brushes/fine-line.json
    brushes/horn.json
    brushes/panel.json
    brushes/plane-off.json
    brushes/polish.json
    brushes/pores.json
    brushes/raked-clay.json
    brushes/ridge.json
    brushes/rough-stone.json
    brushes/scales.json
    brushes/swell.json
    brushes/weave.json
    icons/about.svg
    icons/adaptive.svg
    icons/add.svg
    icons/area-box.svg
    icons/area-lasso.svg
    icons/area-line.svg
    icons/area-plane.svg
    icons/area-polygon.svg
    icons/area-split.svg
    icons/area-trim.svg
    icons/background-black.svg
    icons/background-dark.svg
    icons/background-light.svg
    icons/background-sky.svg
    icons/background-theme.svg
    icons/background-white.svg
    icons/brush-model.svg
    icons/caption.svg
    icons/cavity.svg
    icons/classroom.svg
    icons/clay.svg
    icons/clock.svg
    icons/color.svg
    icons/crease.svg
    icons/dimensions.svg
    icons/drawing.svg
    icons/duplicate.svg
    icons/edit-stroke.svg
    icons/export.svg
    icons/export-for.svg
    icons/farther.svg
    icons/fettle.svg
    icons/files.svg
    icons/fill.svg
    icons/flat.svg
    icons/flatten-base.svg
    icons/flatten.svg
    icons/folder.svg
    icons/folder-up.svg
    icons/follow.svg
    icons/frame.svg
    icons/fusion.svg
    icons/grab.svg
    icons/ground.svg
    icons/guide.svg
    icons/hand.svg
    icons/hand-left.svg
    icons/headset.svg
    icons/headset-find.svg
    icons/inflate.svg
    icons/insert.svg
    icons/invert.svg
    icons/keep.svg
    icons/key-hand.svg
    icons/keys.svg
    icons/larger.svg
    icons/layer.svg
    icons/lesson.svg
    icons/level.svg
    icons/mask.svg
    icons/mask-blur.svg
    icons/mask-cavity.svg
    icons/mask-clear.svg
    icons/mask-color.svg
    icons/mask-grow.svg
    icons/mask-invert.svg
    icons/mask-part.svg
    icons/mask-sharpen.svg
    icons/mask-shrink.svg
    icons/material-clay.svg
    icons/material-grey.svg
    icons/material-paint.svg
    icons/material-pearl.svg
    icons/material-porcelain.svg
    icons/material-skin.svg
    icons/material-wax.svg
    icons/mirror.svg
    icons/move.svg
    icons/nearer.svg
    icons/next.svg
    icons/open.svg
    icons/orthographic.svg
    icons/paint.svg
    icons/palette.svg
    icons/panel-close.svg
    icons/panel-float.svg
    icons/panels-left.svg
    icons/part-choose.svg
    icons/part-down.svg
    icons/part-hidden.svg
    icons/part-intersect.svg
    icons/part-isolate.svg
    icons/part-locked.svg
    icons/part-separate.svg
    icons/part-shown.svg
    icons/part-subtract.svg
    icons/part-tag.svg
    icons/part-union.svg
    icons/part-unlocked.svg
    icons/part-up.svg
    icons/pause.svg
    icons/pick.svg
    icons/point.svg
    icons/pinch.svg
    icons/place-on-bed.svg
    icons/place-solid.svg
    icons/play.svg
    icons/plus.svg
    icons/preferences.svg
    icons/presets.svg
    icons/previous.svg
    icons/primitive.svg
    icons/print-check.svg
    icons/pull.svg
    icons/push.svg
    icons/question.svg
    icons/quit.svg
    icons/radial.svg
    icons/radius.svg
    icons/ray.svg
    icons/recentre.svg
    icons/record.svg
    icons/redo.svg
    icons/reference.svg
    icons/reference-choose.svg
    icons/reference-remove.svg
    icons/refine.svg
    icons/remesh.svg
    icons/rename.svg
    icons/report.svg
    icons/reset.svg
    icons/reveal.svg
    icons/revert.svg
    icons/rotate.svg
    icons/save-as.svg
    icons/save-copy.svg
    icons/save.svg
    icons/scale-bar.svg
    icons/scale.svg
    icons/scrape.svg
    icons/smaller.svg
    icons/smooth.svg
    icons/snake.svg
    icons/sort-down.svg
    icons/sort-up.svg
    icons/sphere.svg
    icons/stamp.svg
    icons/start.svg
    icons/steady.svg
    icons/sound.svg
    icons/stop.svg
    icons/strength.svg
    icons/swap.svg
    icons/symmetrize.svg
    icons/symmetry-plane.svg
    icons/take-over.svg
    icons/time-lapse.svg
    icons/tint.svg
    icons/tool-names.svg
    icons/trash.svg
    icons/tube.svg
    icons/turn-down.svg
    icons/turn-left.svg
    icons/turn-right.svg
    icons/turn-up.svg
    icons/turntable.svg
    icons/twist.svg
    icons/undo.svg
    icons/uniform.svg
    icons/unsound.svg
    icons/unreadable.svg
    icons/view-back.svg
    icons/view-bottom.svg
    icons/view-cube.svg
    icons/view-front.svg
    icons/view-left.svg
    icons/view-right.svg
    icons/view-top.svg
    icons/wireframe.svg
    icons/wait.svg
    shaders/background.frag
    shaders/background.vert
    shaders/clay.frag
    shaders/clay.vert
    shaders/cursor.frag
    shaders/cursor.vert
    shaders/dome.frag
    shaders/dome.vert
    shaders/ghost.frag
    shaders/ghost.vert
    shaders/ground.frag
    shaders/ground.vert
    shaders/hidden.frag
    shaders/hidden.vert
    shaders/line.frag
    shaders/line.vert
    shaders/picture.frag
    shaders/plane.frag
    shaders/plane.vert
    shaders/rectangle.vert
    shaders/reference.frag
    shaders/reference.vert
    shaders/ring.frag
    shaders/sectors.frag
    shaders/shell.frag
    shaders/shell.vert
    shaders/wire.frag
    shaders/wire.geom)
foreach(LANGUAGE en de zh_CN)
    foreach(PAGE
            first-steps lesson-vase lesson-head lesson-tablet lessons view tools presets topology symmetry mask colour
            model parts open repair files export print preview time-lapse history recovery keys pen vr controllers
            vr-sculpting simulator classroom class-work record-lesson report problems)
        list(APPEND FETTLE_RESOURCE_FILES help/${LANGUAGE}/${PAGE}.md)
    endforeach()
    foreach(PICTURE
            class cut export handles history lesson palette presets print recovery repair simulator start time-lapse
            tube unit window)
        list(APPEND FETTLE_RESOURCE_FILES help/${LANGUAGE}/pictures/${PICTURE}.png) # made by TestGuidePictures
    endforeach()
endforeach()
foreach(STARTER ball cube torus slab vase head tablet)
    list(APPEND FETTLE_RESOURCE_FILES pictures/starter-${STARTER}.png)
endforeach()
foreach(PICTURE lesson-vase lesson-head lesson-tablet)
    list(APPEND FETTLE_RESOURCE_FILES help/pictures/${PICTURE}.png)
endforeach()
set(LESSON_first-clay pull push smooth stalk)
set(LESSON_mug body hollow grooves handle finish)
set(LESSON_creature legs ears face base)
set(LESSON_toy-car body cabin windscreen wheels join)
foreach(LESSON first-clay mug creature toy-car)
    list(APPEND FETTLE_RESOURCE_FILES lessons/${LESSON}/lesson.json)
    set(NUMBER 0)
    foreach(STEP IN LISTS LESSON_${LESSON})
        math(EXPR NUMBER "${NUMBER} + 1")
        list(APPEND FETTLE_RESOURCE_FILES lessons/${LESSON}/${STEP}.json lessons/${LESSON}/step-${NUMBER}.png)
    endforeach()
endforeach()

function(fettle_add_resources TARGET)
    list(TRANSFORM FETTLE_RESOURCE_FILES PREPEND ${PROJECT_SOURCE_DIR}/resources/ OUTPUT_VARIABLE FILES)
    qt_add_resources(${TARGET} "resources" PREFIX "/" BASE ${PROJECT_SOURCE_DIR}/resources FILES ${FILES})
endfunction()
