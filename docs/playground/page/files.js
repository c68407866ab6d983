// The files of the page: what commands wrote and what was opened, to be shown, downloaded and deleted.
const EXAMPLES = "examples/";

export class Files {
    // What the worker lost if it were ended.
    own = new Map();
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
        const given = files.filter(path => path.startsWith(EXAMPLES) && !this.own.has(path));
        this.#lists.own.replaceChildren(...files.filter(path => !given.includes(path)).map(path => this.#item(path)));
        this.#lists.given.replaceChildren(...given.map(path => this.#item(path)));
        return written.map(([path]) => path);
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
            this.#button("Download", path, async () => this.save(path, await this.#content(path))),
            this.#button("Delete", path, async () => this.changed(await this.#kurbel.ask("remove", path))),
        );
        return item;
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
