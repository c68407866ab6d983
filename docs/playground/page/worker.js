// Runs kurbel in a thread of its own, so that the page stays alive and a command can be stopped.
import { loadPyodide } from "./pyodide/pyodide.mjs";

const WORK = "/work", PACKAGES = "/packages";
const FOLDER = new URL("pyodide/", import.meta.url).href;
// The libraries come from this folder; of what Pyodide could load from elsewhere nothing is listed.
const NONE = {
    info: { abi_version: "2026_0", arch: "wasm32", platform: "emscripten_5_0_3", python: "3.14.2" },
    packages: {},
};

let python, session, known;
try {
    const options = {
        indexURL: FOLDER, packageBaseUrl: FOLDER, lockFileContents: NONE,
        env: { HOME: WORK, PYTHONPATH: PACKAGES, PYTHONDONTWRITEBYTECODE: "1" },
    };
    const [packages, loaded] = await Promise.all([archive("kurbel.tar.gz"), loadPyodide(options)]);
    python = loaded;
    unpack(packages);
    python.FS.chdir(WORK);
    session = python.pyimport("console");
    session.start();
    known = new Map(listed());
    postMessage({ kind: "ready" });
} catch (error) {
    postMessage({ kind: "broken", reason: error.message });
}

onmessage = async ({ data: { number, action, words } }) => {
    try {
        postMessage({ kind: "answer", number, answer: await ACTIONS[action](...words) });
    } catch (error) {
        postMessage({ kind: "failed", number, reason: error.message });
    }
};

const ACTIONS = {
    async run(line, columns) {
        let ran = await called(line, columns);
        if (ran.later) {
            postMessage({ kind: "loading", what: ran.later });
            unpack(await archive(`${ran.later}.tar.gz`));
            ran = await called(line, columns);
        }
        return { ...ran, ...changes() };
    },
    complete: line => session.complete(line).toJs(),
    read: path => python.FS.readFile(`${WORK}/${path}`),
    put(files) {
        for (const [path, content] of files) write(`${WORK}/${path}`, content);
        return changes();
    },
    remove(path) {
        python.FS.unlink(`${WORK}/${path}`);
        return changes();
    },
};

// Where the browser can, on a stack of its own: that of a worker is half as deep.
async function called(line, columns) {
    const proxy = await session.run.callPromising(line, columns);
    const [code, out, err, later] = proxy.toJs();
    proxy.destroy();
    return { code, out, err, later };
}

function listed() {
    return session.files(WORK).toJs().map(([path, size, time]) => [path.slice(WORK.length + 1), `${size} ${time}`]);
}

// The files that were written since the last time, with what they contain, and those that are gone.
function changes() {
    const now = new Map(listed());
    const written = [...now].filter(([path, stamp]) => known.get(path) !== stamp)
        .map(([path]) => [path, python.FS.readFile(`${WORK}/${path}`)]);
    const gone = [...known.keys()].filter(path => !now.has(path));
    known = now;
    return { written, gone, files: [...now.keys()] };
}

async function archive(name) {
    const answer = await fetch(new URL(name, import.meta.url)).catch(() => ({ status: "no network" }));
    if (!answer.ok) throw new Error(`${name} is loaded when it is first needed, and cannot be now: ${answer.status}`);
    const plain = answer.body.pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(plain).arrayBuffer());
}

// A tar of the oldest format: for each file a head of 512 bytes, and what it contains in pieces of 512.
function unpack(bytes) {
    const text = (from, to) => new TextDecoder().decode(bytes.subarray(from, to)).replace(/\0.*$/s, "");
    for (let at = 0; bytes[at]; ) {
        const size = parseInt(text(at + 124, at + 136), 8), prefix = text(at + 345, at + 500);
        const name = (prefix && prefix + "/") + text(at, at + 100), start = at + 512;
        write("/" + name, bytes.subarray(start, start + size));
        at = start + 512 * Math.ceil(size / 512);
    }
    python.runPython("import importlib; importlib.invalidate_caches()");
}

function write(path, content) {
    const { FS } = python;
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, content, { canOwn: true });
}
