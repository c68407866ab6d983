#!/usr/bin/env bash
# The checks of action.yml: handbooks in FOLDERS, documents in FILES, one a line. Neither reads files
# outside of its folder unless ALLOW_OUTSIDE is true.
# What is stale goes to the log and to the job's summary, what is wrong to annotations. Runs in bash 3.2.
set -euo pipefail

failed=0

# Print the lines of a list without blanks around them, and without empty ones.
lines_of() {
    printf '%s\n' "$1" | tr -d '\r' | sed -e 's/^[[:blank:]]*//' -e 's/[[:blank:]]*$//' -e '/^$/d'
}

# Run a command of kurbel and report how it ended.
checked() {
    local log said token code=0
    log=$(mktemp)
    said=$(mktemp)
    python -m kurbel "$@" >"$log" 2>"$said" || code=$?
    # Until the token stands there again, GitHub takes nothing of the output for a command to itself.
    token=$(od -An -N16 -tx1 /dev/urandom | tr -d ' \n')
    echo "::stop-commands::$token"
    echo "kurbel $*"
    cat "$log" "$said"
    echo "::$token::"
    if [ "$code" -ne 0 ]; then
        failed=1
        annotations <"$said"
        summary "$log" "$said" >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
    fi
    rm -f "$log" "$said"
}

# Turn sentences of kurbel into annotations, at a file and its line where they name them.
annotations() {
    sed -e 's/%/%25/g' -e 's/^kurbel: //' | sed \
        -e 's/^\([^:,]*\), line \([0-9][0-9]*\)\(, [^:]*\)*: /::error file=\1,line=\2::/' -e t \
        -e 's/^\([^:,]*\):\([0-9][0-9]*\): /::error file=\1,line=\2::/' -e t \
        -e 's/^/::error title=kurbel::/'
}

# Print a section in Markdown: indented lines are code, which nothing in them can end.
summary() {
    printf '### kurbel\n\n'
    # Not head, at whose end cat and with it the whole script would be ended.
    cat "$2" "$1" | sed -n '1,300s/^/    /p'
    printf '\n'
}

folders=$(lines_of "${FOLDERS:-}")
patterns=$(lines_of "${FILES:-}")
if [ -z "$folders$patterns" ]; then
    echo "::error title=kurbel::name a handbook with folder, or documents with files"
    exit 2
fi

handbooks=()
while IFS= read -r folder; do
    [ -z "$folder" ] || handbooks+=("$folder")
done <<<"$folders"
outside=()
[ "${ALLOW_OUTSIDE:-false}" != true ] || outside=(--allow-outside)
# An empty list is an error in bash 3.2 unless it is asked for so.
[ "${#handbooks[@]}" -eq 0 ] || checked handbook check ${outside[@]+"${outside[@]}"} -- "${handbooks[@]}" </dev/null

documents=()
while IFS= read -r pattern; do
    if [ -e "$pattern" ] || [ -z "$pattern" ]; then
        [ -z "$pattern" ] || documents+=("$pattern")
    elif ! compgen -G "$pattern" >/dev/null; then
        # kurbel says what is amiss with a file that is not there.
        documents+=("$pattern")
    else
        while IFS= read -r document; do documents+=("$document"); done < <(compgen -G "$pattern")
    fi
done <<<"$patterns"
[ "${#documents[@]}" -eq 0 ] || checked inject --check ${outside[@]+"${outside[@]}"} -- "${documents[@]}" </dev/null

exit "$failed"
