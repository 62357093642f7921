# shellcheck shell=bash
# Completion of fettle's command line for bash, which finds it as share/bash-completion/completions/fettle. Where it has
# no words bash completes file names. TestReferenceCommands compares its words with the program's.
_fettle()
{
    local word=$2 previous=$3 words=
    local formats='stl obj ply off glb 3mf' read_formats='stl obj ply off glb 3mf gltf amf'
    local model='--unit --from --help -h' lessons='first-clay mug creature toy-car'
    if [ "$previous" = = ]; then # --unit=mm is three words
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    elif [ "$word" = = ]; then
        previous=${COMP_WORDS[COMP_CWORD - 1]} word=
    fi
    if [ "$COMP_CWORD" = 1 ]; then
        words='new check convert boolean replay report sheet lesson brush help
               --vr --vr-simulator --classroom --help --version'
    else
        case ${COMP_WORDS[1]}:$previous in
        *:--unit) words='mm cm m in' ;;
        *:--from) words=$read_formats ;;
        report:--to) words='html pdf' ;;
        *:--to) words=$formats ;;
        convert:--up | boolean:--up) words='y z' ;;
        convert:--large-holes) words='fill refuse' ;;
        convert:--inner-parts) words='fill hollow' ;;
        convert:--overlaps) words='unite keep' ;;
        replay:--verify) words='local full none' ;;
        lesson:--language) words='en de zh_CN' ;;
        help:*) words='new check convert boolean replay report sheet lesson brush' ;;
        boolean:boolean) words='union subtract intersect' ;;
        new:new) words='ball cube torus slab vase head tablet box cylinder cone capsule lathe tube' ;;
        lesson:lesson) words=$lessons ;;
        brush:brush)
            words='clay-buildup raked-clay carve swell panel fine-line ridge polish plane-off big-move horn pores scales
                   cracks weave rough-stone' ;;
        esac
    fi
    if [[ $word == -* && $COMP_CWORD -gt 1 ]]; then
        case ${COMP_WORDS[1]} in
        new)
            words='--size --width --height --depth --radius --top-radius --tube-radius --profile --path --edge-length
                   --to --no-clobber --help -h' ;;
        check) words="$model --json --csv --print --nozzle --overhang --bed" ;;
        convert)
            words="$model --to --no-clobber --size --up --recentre --recenter --triangles --repair --legalise --legalize
                   --wrap --large-holes --inner-parts --parts --overlaps" ;;
        boolean) words="$model --out --output -o --to --no-clobber --up" ;;
        replay)
            words='--strokes --in --parts --out -o --stats --frames --every --verify --from --to --no-clobber
                   --help -h' ;;
        report) words='--out --output -o --unit --to --no-clobber --help -h' ;;
        sheet) words="$model --out --output -o --shaded --no-clobber" ;;
        lesson)
            words='--language --model --step --pack --unpack --pictures --out -o --pdf --texts --json --csv --from
                   --no-clobber --help -h' ;;
        brush) words='--picture --no-clobber --help -h' ;;
        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _fettle fettle
