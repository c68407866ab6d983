// Tab in the line: what click completes for a shell, it completes here.
const MOST = 200;

export function completing(line, list, candidates, say) {
    let leaving = false;
    const hide = () => {
        list.hidden = true;
        list.replaceChildren();
    };
    line.addEventListener("keydown", event => {
        if (event.key === "Tab" && !event.shiftKey && !leaving && line.value.trim()) {
            event.preventDefault();
            complete();
        }
        // The keyboard has a way out of the line.
        leaving = event.key === "Escape" || (leaving && event.key === "Shift");
        if (event.key === "Escape") hide();
    });
    line.addEventListener("input", hide);

    async function complete() {
        const end = line.selectionEnd, typed = line.value.slice(0, end);
        const found = await candidates(typed);
        if (line.value.slice(0, end) !== typed) return;
        const common = found.length ? shared(found.map(([value]) => value)) : "";
        const word = typed.match(/\S*$/)[0];
        if (common.length > word.length || found.length === 1) put(end, word, common, found.length === 1);
        hide();
        if (found.length > 1) offer(found, end);
        say(found.length === 1 ? `${common}` : found.length ? `${found.length} possibilities` : "Nothing completes this");
    }

    function put(end, word, value, isWhole) {
        const rest = line.value.slice(end);
        const begun = line.value.slice(0, end - word.length) + value + (isWhole && !/[/=]$/.test(value) ? " " : "");
        line.value = begun + rest;
        line.setSelectionRange(begun.length, begun.length);
    }

    function offer(found) {
        list.append(...found.slice(0, MOST).map(([value, help]) => {
            const item = document.createElement("li"), button = document.createElement("button");
            button.type = "button";
            button.textContent = value;
            button.title = help;
            button.addEventListener("click", () => {
                const end = line.selectionEnd;
                put(end, line.value.slice(0, end).match(/\S*$/)[0], value, true);
                hide();
                line.focus();
            });
            item.append(button);
            return item;
        }));
        list.hidden = false;
    }

    return { hide };
}

function shared(values) {
    let common = values[0];
    for (const value of values) while (!value.startsWith(common)) common = common.slice(0, -1);
    return common;
}
