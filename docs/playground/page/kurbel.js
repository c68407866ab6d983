// kurbel in its worker: asked by messages, stopped by ending the worker, which begins anew with the files.
export class Stopped extends Error {}

export class Kurbel {
    #worker;
    #asked = new Map();
    #number = 0;
    #loading;

    constructor(loading) {
        this.#loading = loading;
        this.listed = this.#begin([]);
    }

    // Begin the worker; the promise is of the files that it has.
    #begin(files) {
        this.isReady = false;
        // Of a worker's own address the page's rules would not hold; of one that the page wrote they do.
        const address = JSON.stringify(new URL("worker.js", import.meta.url).href);
        const source = URL.createObjectURL(new Blob([`import ${address};`], { type: "text/javascript" }));
        this.#worker = new Worker(source, { type: "module" });
        const begun = new Promise((resolve, reject) => {
            this.#worker.onmessage = ({ data }) => {
                if (data.kind === "ready") resolve();
                else if (data.kind === "broken") reject(new Error(`Python does not start here: ${data.reason}`));
                else if (data.kind === "loading") this.#loading(data.what);
                else this.#answered(data);
            };
            this.#worker.onerror = event =>
                reject(new Error(`Python does not start here: ${event.message ?? "its files cannot be loaded"}`));
        });
        const listed = begun.then(() => this.ask("put", files));
        this.ready = listed.then(() => { this.isReady = true; });
        // Who waits for it is told; nobody has to.
        this.ready.catch(() => {});
        listed.catch(() => {});
        return listed;
    }

    ask(action, ...words) {
        const number = ++this.#number;
        this.#worker.postMessage({ number, action, words });
        return new Promise((resolve, reject) => this.#asked.set(number, { resolve, reject }));
    }

    #answered({ number, kind, answer, reason }) {
        const { resolve, reject } = this.#asked.get(number);
        this.#asked.delete(number);
        if (kind === "answer") resolve(answer);
        else reject(new Error(reason));
    }

    // End what runs; `files` is what the next worker is to have beside the examples.
    stop(files) {
        this.#worker.terminate();
        for (const { reject } of this.#asked.values()) reject(new Stopped());
        this.#asked.clear();
        this.#begin([...files]);
    }
}
