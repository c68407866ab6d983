// The files of the page: what commands wrote and what was opened, to be shown, downloaded and deleted.
const EXAMPLES = "examples/";
// What a build keeps for itself, as in `.kurbel/`, is no file that one shows.
const isHidden = path => path.split("/").some(part => part.startsWith("."));

export class Files {
    // What the worker lost if it were ended.
    own = new Map();
    // What its reader would lose with the page: written here, and not downloaded since.
    unsaved = new Set();
    #kurbel;
    #lists;
    #shown;

    constructor(kurbel, own, given, shown) {
        this.#kurbel = kurbel;
        this.#lists = { own, given };
        this.#shown = shown;
    }

    // Take over what changed, and return the paths of what was written.
    changed({ written, gone, files }) {
        for (const [path, content] of written) this.own.set(path, content);
        for (const path of gone) this.own.delete(path);
        for (const path of gone) this.unsaved.delete(path);
        const seen = files.filter(path => !isHidden(path)), paths = written.map(([path]) => path);
        const given = seen.filter(path => path.startsWith(EXAMPLES) && !this.own.has(path));
        this.#lists.own.replaceChildren(...seen.filter(path => !given.includes(path)).map(path => this.#item(path)));
        this.#lists.given.replaceChildren(...given.map(path => this.#item(path)));
        const found = paths.filter(path => !isHidden(path));
        for (const path of found) this.unsaved.add(path);
        return found;
    }

    // Take over what was opened, which its reader has.
    opened(changes) {
        for (const path of this.changed(changes)) this.unsaved.delete(path);
    }

    async show(path) {
        this.#shown(path, await this.#content(path));
    }

    save(name, content) {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(new Blob([content]));
        link.download = name.split("/").at(-1);
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    }

    async #content(path) {
        return this.own.get(path) ?? await this.#kurbel.ask("read", path);
    }

    #item(path) {
        const item = document.createElement("li"), name = document.createElement("span");
        name.textContent = path;
        item.append(
            name,
            this.#button("Show", path, () => this.show(path)),
            this.#button("Download", path, async () => {
                this.save(path, await this.#content(path));
                this.unsaved.delete(path);
            }),
            this.#button("Delete", path, () => this.#remove(path)),
        );
        return item;
    }

    async #remove(path) {
        if (this.unsaved.has(path) && !confirm(`${path} was not downloaded. Delete it?`)) return;
        this.changed(await this.#kurbel.ask("remove", path));
    }

    #button(text, path, click) {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = text;
        button.setAttribute("aria-label", `${text} ${path}`);
        button.addEventListener("click", click);
        return button;
    }
}
