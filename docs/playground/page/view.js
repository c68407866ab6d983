// A file as it looks: pages in a frame that is shut off from this page, pictures, PDF, and text.
import { begun } from "./screen.js";

const PICTURES = { svg: "image/svg+xml", png: "image/png" };
let address = "";

// Whether what was printed is a page or a drawing.
export function isPage(bytes) {
    return bytes[0] === "<".charCodeAt(0);
}

export function show(section, path, content) {
    const kind = path.split(".").at(-1).toLowerCase();
    section.querySelector("h2").textContent = path;
    section.querySelector("div").replaceChildren(shown(path, kind, content));
    section.hidden = false;
}

function shown(path, kind, content) {
    if (kind === "html") return page(path, text(content) ?? "");
    if (kind === "pdf" && navigator.pdfViewerEnabled) return frame(path, linked(content, "application/pdf"));
    if (kind in PICTURES) return Object.assign(new Image(), { alt: path, src: linked(content, PICTURES[kind]) });
    const plain = text(content);
    if (plain === null) return note("This file is no text; download it to open it.");
    const box = document.createElement("pre");
    box.tabIndex = 0;
    box.role = "region";
    box.ariaLabel = path;
    box.textContent = begun(plain);
    return box;
}

function page(path, source) {
    const view = frame(path);
    // Its scripts run, of which interactive pages have some, but reach nothing: neither this page nor a network.
    view.sandbox = "allow-scripts";
    view.srcdoc = source;
    return view;
}

function frame(path, address) {
    const view = document.createElement("iframe");
    view.title = path;
    if (address) view.src = address;
    return view;
}

function linked(content, type) {
    URL.revokeObjectURL(address);
    address = URL.createObjectURL(new Blob([content], { type }));
    return address;
}

function text(content) {
    try {
        return new TextDecoder("utf-8", { fatal: true }).decode(content);
    } catch {
        return null;
    }
}

function note(sentence) {
    return Object.assign(document.createElement("p"), { textContent: sentence });
}
