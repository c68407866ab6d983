// The page: the line that is typed, what kurbel answers, and the files.
import { completing } from "./completion.js";
import { EXAMPLES } from "./examples.js";
import { Files } from "./files.js";
import { Kurbel, Stopped } from "./kurbel.js";
import { begun, columnsOf, painted } from "./screen.js";
import { isPage, show } from "./view.js";

const at = id => document.getElementById(id);
const line = at("line"), status = at("status"), screen = at("screen");
const earlier = [];
let place = 0, printed = new Uint8Array();

const kurbel = new Kurbel(what => say(`${what} is being loaded, once …`));
const files = new Files(kurbel, at("own"), at("given"), (path, content) => show(at("view"), path, content));

function say(text) {
    status.textContent = text;
}

async function run(text) {
    if (!text.trim() || at("run").disabled) return;
    remember(text);
    busy(true);
    say(kurbel.isReady ? "Running …" : "Python is being loaded …");
    try {
        await kurbel.ready;
        say("Running …");
        const start = performance.now();
        const { code, out, err, ...changes } = await kurbel.ask("run", text, columnsOf(screen));
        print(out, err);
        say(`${code ? `Failed, exit code ${code}` : "Done"}, ${((performance.now() - start) / 1000).toFixed(2)} s`);
        const last = files.changed(changes).at(-1);
        if (last) files.show(last);
        else if (isPage(out)) show(at("view"), "output.html", out);
        else at("view").hidden = true;
    } catch (error) {
        print(new Uint8Array(), error instanceof Stopped ? "" : `${error.message}\n`);
        say(error instanceof Stopped ? "Stopped" : "This did not work");
        // After an error that is not kurbel's own Python may be in any state.
        if (kurbel.isReady) kurbel.stop(files.own);
    }
    busy(false);
}

function remember(text) {
    if (earlier.at(-1) !== text) earlier.push(text);
    place = earlier.length;
    history.replaceState(null, "", `#${encodeURIComponent(text)}`);
    completion.hide();
}

function busy(now) {
    at("run").disabled = now;
    at("stop").hidden = !now;
}

function print(out, err) {
    printed = out;
    screen.replaceChildren(...painted(begun(new TextDecoder().decode(out))));
    if (err) screen.append(Object.assign(document.createElement("span"), { className: "error", textContent: err }));
    screen.scrollTo(0, 0);
    at("tools").hidden = !out.length;
}

const completion = completing(line, at("candidates"), text => kurbel.isReady ? kurbel.ask("complete", text) : [], say);

line.addEventListener("keydown", event => {
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
    event.preventDefault();
    place = Math.min(Math.max(place + (event.key === "ArrowUp" ? -1 : 1), 0), earlier.length);
    line.value = earlier[place] ?? "";
});
at("form").addEventListener("submit", event => {
    event.preventDefault();
    run(line.value);
});
at("stop").addEventListener("click", () => {
    kurbel.stop(files.own);
    line.focus();
});
at("copy").addEventListener("click", async () => {
    await navigator.clipboard.writeText(new TextDecoder().decode(printed));
    say("Copied");
});
at("save").addEventListener("click", () => files.save("output.txt", printed));
at("upload").addEventListener("change", async event => {
    const opened = await Promise.all(
        [...event.target.files].map(async one => [one.name, new Uint8Array(await one.arrayBuffer())]),
    );
    await kurbel.ready;
    files.opened(await kurbel.ask("put", opened));
    say(`${opened.map(([name]) => name).join(", ")}: opened`);
});
at("examples").append(...EXAMPLES.map(([text, about]) => {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.textContent = text;
    button.addEventListener("click", () => {
        line.value = text;
        run(text);
    });
    item.append(button, Object.assign(document.createElement("span"), { className: "muted", textContent: about }));
    return item;
}));

function linked() {
    try {
        return decodeURIComponent(location.hash.slice(1));
    } catch {
        return "";
    }
}
// The browser asks its reader whether to leave what was not downloaded.
addEventListener("beforeunload", event => {
    if (files.unsaved.size) event.preventDefault();
});
addEventListener("hashchange", () => {
    line.value = linked() || line.value;
    line.focus();
});

kurbel.listed.then(changes => files.changed(changes));
// A command of a link is filled in, and runs when its reader says so.
if (linked()) {
    line.value = linked();
    kurbel.ready.then(() => say("Ready"), error => say(error.message));
} else {
    run(line.value);
}
// Once loaded, the page works without a network.
kurbel.ready.then(() => navigator.serviceWorker?.register("service.js"), () => {});
