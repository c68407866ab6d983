"use strict";
// Interactive tables: every figure shown was computed and set beforehand; here it is only chosen.
(() => {
  const SVG = "http://www.w3.org/2000/svg";
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  function element(parent, name, attributes = {}) {
    const made = document.createElementNS(SVG, name);
    put(made, attributes);
    parent.append(made);
    return made;
  }

  function put(one, attributes) {
    for (const [name, value] of Object.entries(attributes)) one.setAttribute(name, value);
  }

  // A figure as it is printed, as a number to draw by; NaN where there is none.
  const number = text => parseFloat(text.replace("\u2212", "-").replace(",", "."));
  const path = points => "M" + points.map(point => point.map(one => one.toFixed(2)).join(" ")).join("L");

  /* The drawing. Lengths are in pixels, R in as many as there is room for. */

  class Drawing {
    constructor(svg, note, data) {
      Object.assign(this, {svg, note, data, scene: undefined, width: 0});
      const boxes = data.scenes.map(scene => scene.box.map(one => one / 1000));
      const end = (side, of) => of(...boxes.map(box => box[side]));
      this.box = [end(0, Math.min), end(1, Math.min), end(2, Math.max), end(3, Math.max)];
    }

    // Draw a scene with its crank at an angle in degrees.
    show(number, angle) {
      const scene = number === null ? null : this.data.scenes[number];
      this.svg.toggleAttribute("hidden", !scene);
      this.note.hidden = Boolean(scene);
      if (!scene) return;
      const room = this.svg.parentElement.clientWidth;
      if (scene !== this.scene || room !== this.width) this.build(scene, room);
      this.move(angle);
    }

    build(scene, room) {
      const [left, low, right, high] = this.box;
      Object.assign(this, {scene, width: room});
      this.unit = Math.min(room / (right - left), 110);
      const size = [(right - left) * this.unit, (high - low) * this.unit];
      put(this.svg, {viewBox: `0 0 ${size[0].toFixed(1)} ${size[1].toFixed(1)}`, width: size[0], height: size[1]});
      // What follows stays where it is when a step has no drawing.
      this.svg.parentElement.style.minHeight = `${size[1]}px`;
      this.svg.replaceChildren();
      Object.assign(this, {shafts: [], stands: []});
      for (const [kind, ...flat] of scene.fixed) {
        const points = [];
        for (let at = 0; at < flat.length; at += 2) points.push(this.place(flat[at] / 1000, flat[at + 1] / 1000));
        this[kind](points);
      }
      const made = (name, kind) => element(this.svg, name, {class: `live-${kind}`});
      const bar = kind => made("line", kind === "crank" ? "crank" : "bar");
      this.heads = scene.heads.map(() => made("rect", "head"));
      this.links = scene.links.map(([kind]) => bar(kind));
      this.pins = scene.pins.map(() => made("circle", "pin"));
      this.shafts.forEach(one => this.svg.append(one));
      this.arc = made("path", "thin");
      this.tip = made("path", "tip");
      this.reach = made("path", "thin");
      this.ends = [made("path", "tip"), made("path", "tip")];
      this.letters = scene.links.map(link => this.letter(link[3]));
      this.phi = this.letter("φ");
      this.x = this.letter("x");
    }

    letter(text) {
      const made = element(this.svg, "text", {class: "live-letter"});
      made.textContent = text;
      return made;
    }

    place(x, y) {
      return [(x - this.box[0]) * this.unit, (this.box[3] - y) * this.unit];
    }

    // Where a joint is at an angle, on the way between two places that are known.
    joint(number, angle) {
      const flat = this.data.joints[number], count = flat.length / 2;
      const at = (((angle % 360) + 360) % 360) / 360 * count, first = Math.floor(at) % count;
      const next = (first + 1) % count, share = at - Math.floor(at);
      const along = axis => (flat[2 * first + axis] * (1 - share) + flat[2 * next + axis] * share) / 1000;
      return [along(0), along(1)];
    }

    move(angle) {
      const scene = this.scene, at = number => this.place(...this.joint(number, angle));
      scene.links.forEach(([kind, start, end], place) => {
        const [[x1, y1], [x2, y2]] = [at(start), at(end)], length = Math.hypot(x2 - x1, y2 - y1) || 1;
        put(this.links[place], {x1, y1, x2, y2});
        // Of a crank on the side away from φ, of other bars above: below is the way of the crosshead.
        const isCrank = kind === "crank", share = isCrank ? 0.6 : 0.42;
        const side = (isCrank ? y2 <= y1 : x2 >= x1) ? 1 : -1;
        put(this.letters[place], {
          x: x1 + (x2 - x1) * share + side * 12 * (y2 - y1) / length,
          y: y1 + (y2 - y1) * share - side * 12 * (x2 - x1) / length + 5,
        });
      });
      scene.pins.forEach((pin, place) => {
        const [cx, cy] = at(pin);
        put(this.pins[place], {cx, cy, r: 4});
      });
      scene.heads.forEach((head, place) => {
        const [x, y] = at(head), [width, height] = [0.34 * this.unit, 0.3 * this.unit];
        put(this.heads[place], {x: x - width / 2, y: y - height / 2, width, height});
      });
      // A crank that hangs down would hide the bearing.
      const hangs = Math.sin(angle * Math.PI / 180) < -0.3;
      for (const [stand, x, y] of this.stands) put(stand, {transform: hangs ? `rotate(180 ${x} ${y})` : ""});
      this.turned(angle);
      if (scene.path) this.reached(this.joint(scene.heads[0], angle));
      else this.x.setAttribute("visibility", "hidden");
    }

    // The crank angle, counter-clockwise from the slide.
    turned(angle) {
      const turn = ((angle % 360) + 360) % 360, radius = 0.46, seen = turn > 6 ? "visible" : "hidden";
      for (const one of [this.arc, this.tip, this.phi]) one.setAttribute("visibility", seen);
      const at = (degrees, by = radius) => {
        const radians = degrees * Math.PI / 180;
        return this.place(by * Math.cos(radians), by * Math.sin(radians));
      };
      const points = [];
      for (let step = 0; step <= 60; step++) points.push(at(turn * step / 60));
      put(this.arc, {d: path(points)});
      const lean = Math.min(turn, 8 / (radius * this.unit) * 180 / Math.PI);
      this.head(this.tip, at(turn - lean), at(turn));
      // Above the middle of a longer arc the rod passes.
      const [x, y] = at(Math.min(turn / 2, 25), radius + 13 / this.unit);
      put(this.phi, {x, y: y + 5});
    }

    // The path of the crosshead, from its inner dead centre.
    reached([x, y]) {
      const [start, level] = this.scene.path.map(one => one / 1000);
      const [[right, height], [left]] = [this.place(start, level), this.place(x, level)];
      const from = this.place(x, y)[1], seen = right - left > 20 ? "visible" : "hidden";
      for (const one of [this.reach, this.x, ...this.ends]) one.setAttribute("visibility", seen);
      const end = height + 4, top = from + 0.15 * this.unit;
      put(this.reach, {d: `M${left} ${top}V${end}M${right} ${top}V${end}M${left} ${height}H${right}`});
      this.head(this.ends[0], [right, height], [left, height]);
      this.head(this.ends[1], [left, height], [right, height]);
      put(this.x, {x: (left + right) / 2, y: height - 5});
    }

    // An arrowhead of 15°, as in ISO 129-1.
    head(one, [x1, y1], [x2, y2]) {
      const length = Math.hypot(x2 - x1, y2 - y1) || 1, [x, y] = [9 * (x2 - x1) / length, 9 * (y2 - y1) / length];
      const side = sign => [x2 - x + sign * 0.132 * y, y2 - y - sign * 0.132 * x];
      put(one, {d: path([[x2, y2], side(1), side(-1)]) + "Z"});
    }

    centre(points) {
      element(this.svg, "path", {class: "live-chain", d: path(points)});
    }

    circle([[cx, cy]]) {
      element(this.svg, "circle", {class: "live-chain", cx, cy, r: this.unit});
    }

    dead([[cx, cy]]) {
      element(this.svg, "circle", {class: "live-dot", cx, cy, r: 2.5});
    }

    left(points) {
      this.ground(...points, -1);
    }

    right(points) {
      this.ground(...points, 1);
    }

    // An edge of the frame from left to right, hatched above (-1) or below.
    ground([x1, y], [x2], side, parent = this.svg) {
      element(parent, "path", {class: "live-edge", d: path([[x1, y], [x2, y]])});
      const marks = [];
      for (let x = x1 + 4; x < x2; x += 6) marks.push(side > 0 ? `M${x - 3} ${y + 5}l5-5` : `M${x - 2} ${y}l5-5`);
      element(parent, "path", {class: "live-thin", d: marks.join("")});
    }

    bearing(points) {
      this.stands.push([this.stand(points), ...points[0]]);
    }

    below(points) {
      this.stand(points);
    }

    hung(points) {
      put(this.stand(points), {transform: `rotate(180 ${points[0].join(" ")})`});
    }

    beside(points) {
      put(this.stand(points), {transform: `rotate(90 ${points[0].join(" ")})`});
    }

    // A bearing on its ground, and the end of the shaft, which is drawn over all links.
    stand([[x, y]]) {
      const foot = y + 22, stand = element(this.svg, "g");
      element(stand, "path", {class: "live-edge", d: `M${x - 3} ${y}L${x - 11} ${foot}M${x + 3} ${y}L${x + 11} ${foot}`});
      this.ground([x - 16, foot], [x + 16], 1, stand);
      const shaft = element(this.svg, "g");
      element(shaft, "circle", {class: "live-pin", cx: x, cy: y, r: 7});
      element(shaft, "circle", {class: "live-dot", cx: x, cy: y, r: 2});
      this.shafts.push(shaft);
      return stand;
    }
  }

  // Of curves, in pixels.
  const [TOP, BOTTOM, HEIGHT, SIDE] = [20, 76, 108, 6];

  /* A curve through the figures of one quantity. */

  class Curve {
    constructor(svg, at, names, ticks, tracks) {
      const known = tracks.flat().filter(Number.isFinite);
      const [low, high] = extremes(known);
      Object.assign(this, {svg, at, names, ticks, low, high});
      if (this.low > 0 && this.low < 0.5 * this.high) this.low = 0;
      if (this.high < 0 && this.high > 0.5 * this.low) this.high = 0;
    }

    show(values, texts, place) {
      const width = Math.max(this.svg.clientWidth, 80);
      if (values !== this.values || width !== this.width) this.build(values, texts, width);
      const [x, y] = [this.across(this.at[place]), this.up(values[place])];
      put(this.line, {x1: x, x2: x, y1: TOP - 6, y2: BOTTOM + 6});
      put(this.dot, {cx: x, cy: Number.isFinite(y) ? y : -9});
    }

    across(value) {
      const [first, last] = [Math.min(...this.at), Math.max(...this.at)];
      return SIDE + (value - first) / (last - first || 1) * (this.width - 2 * SIDE);
    }

    up(value) {
      return this.high === this.low ? (TOP + BOTTOM) / 2 : BOTTOM - (value - this.low) / (this.high - this.low) * (BOTTOM - TOP);
    }

    build(values, texts, width) {
      Object.assign(this, {values, width});
      put(this.svg, {viewBox: `0 0 ${width} ${HEIGHT}`});
      this.svg.replaceChildren();
      for (const [at, text] of this.ticks) {
        const x = this.across(at);
        element(this.svg, "line", {class: "live-grid", x1: x, x2: x, y1: TOP - 6, y2: BOTTOM + 6});
        this.text(x, HEIGHT - 2, text, "tick");
      }
      if (this.low <= 0 && this.high >= 0)
        element(this.svg, "line", {class: "live-zero", x1: 0, x2: width, y1: this.up(0), y2: this.up(0)});
      element(this.svg, "path", {class: "live-graph", d: this.smooth(values)});
      this.line = element(this.svg, "line", {class: "live-at"});
      this.dot = element(this.svg, "circle", {class: "live-point", r: 3.5});
      const [low, high] = extremes(values.filter(Number.isFinite));
      // A figure is that of its step: the curve itself may go further between two of them.
      for (const [value, lift] of low < high ? [[low, 15], [high, -6]] : [[high, -6]]) {
        const place = values.indexOf(value), step = low < high ? ` (${this.names[place]})` : "";
        if (place >= 0) this.text(this.across(this.at[place]), this.up(value) + lift, texts[place] + step, "extreme");
      }
    }

    // A text about a place, within the drawing.
    text(x, y, text, kind) {
      const made = element(this.svg, "text", {class: `live-${kind}`, y});
      made.textContent = text;
      const half = made.getComputedTextLength() / 2;
      made.setAttribute("x", Math.min(Math.max(x, half), this.width - half));
    }

    // Through all points, and nowhere beyond two neighbours (Fritsch and Carlson).
    smooth(values) {
      const points = values.map((value, place) => [this.across(this.at[place]), this.up(value)]);
      const slopes = points.slice(1).map(([x, y], place) => (y - points[place][1]) / (x - points[place][0]));
      const tangent = place => {
        const [before, after] = [slopes[place - 1], slopes[place]];
        if (before === undefined || after === undefined) return before ?? after ?? 0;
        return before * after > 0 ? 2 * before * after / (before + after) : 0;
      };
      let drawn = "", open = false;
      points.forEach(([x, y], place) => {
        if (!Number.isFinite(y)) return void (open = false);
        if (!open) drawn += `M${x.toFixed(2)} ${y.toFixed(2)}`;
        else {
          const [before, third] = [points[place - 1], (x - points[place - 1][0]) / 3];
          const near = [before[0] + third, before[1] + third * tangent(place - 1)], far = [x - third, y - third * tangent(place)];
          drawn += `C${[...near, ...far, x, y].map(one => one.toFixed(2)).join(" ")}`;
        }
        open = true;
      });
      return drawn;
    }
  }

  function extremes(values) {
    return values.reduce(([low, high], one) => [Math.min(low, one), Math.max(high, one)], [Infinity, -Infinity]);
  }

  /* A table with its sliders. */

  class Live {
    constructor(root, alone) {
      const one = name => root.querySelector(`.live-${name}`);
      const data = this.data = JSON.parse(one("data").textContent);
      Object.assign(this, {root, alone, page: one("page"), stage: one("stage"), along: one("along"), play: one("play")});
      this.inputs = [...root.querySelectorAll("input[type=range]:not(.live-along)")];
      this.shown = data.start;
      this.turning = null;
      this.angle = 60;
      this.stage.hidden = false;
      const svg = one("drawing");
      this.drawing = svg && new Drawing(svg, one("undrawn"), data);
      this.figures = data.tracks.map(text => text.split(data.by));
      this.values = this.figures.map(texts => texts.map(number));
      this.outputs = [...root.querySelectorAll(".live-value")];
      this.units = [...root.querySelectorAll(".live-unit")];
      this.curves = [...root.querySelectorAll(".live-curve")].map(
        (curve, place) => new Curve(curve, data.cursor.at, this.names(), this.ticks(), [...new Set(data.of.map(own => own[place]))].map(track => this.values[track])));
      this.listen();
      this.read();
      this.update();
    }

    names() {
      const {texts, unit} = this.data.cursor;
      return texts.map(text => text + unit);
    }

    // Where the axis of curves is marked: at quarters of the turn, else at up to nine places.
    ticks() {
      const {turn, at} = this.data.cursor, names = this.names(), every = Math.ceil(at.length / 9);
      return at.map((value, place) => [value, names[place]]).filter(
        ([value], place) => turn ? value % (turn / 4) === 0 : place % every === 0);
    }

    listen() {
      for (const input of this.inputs) input.addEventListener("input", () => this.update());
      this.along?.addEventListener("input", () => {
        if (this.turns()) this.halt();
        this.update();
      });
      for (const input of [...this.inputs, this.along]) input?.addEventListener("change", () => this.write());
      this.play?.addEventListener("click", () => this.turning === null ? this.start() : this.halt());
      still.addEventListener("change", () => this.calm());
      this.calm();
      if (this.alone) addEventListener("hashchange", () => { this.read(); this.update(); });
      new ResizeObserver(() => this.update()).observe(this.stage);
    }

    // Nothing moves by itself for those who ask for that.
    calm() {
      if (!this.play) return;
      this.play.hidden = still.matches;
      if (still.matches) this.halt();
    }

    start() {
      // Without the crank angle among its sliders a page has nothing that goes along with the mechanism.
      const {at, turn} = this.turns() ? this.data.cursor : {at: null, turn: 360};
      let before = null, angle = at ? at[this.along.value] : this.angle;
      this.label(true);
      const frame = time => {
        if (before !== null) angle = (angle + (time - before) * 0.045) % turn;
        before = time;
        if (at) this.along.value = nearest(at, angle);
        this.angle = angle;
        this.update(angle);
        this.turning = requestAnimationFrame(frame);
      };
      this.turning = requestAnimationFrame(frame);
    }

    turns() {
      return Boolean(this.data.cursor?.turn);
    }

    halt() {
      if (this.turning === null) return;
      cancelAnimationFrame(this.turning);
      this.turning = null;
      this.label(false);
      this.update();
      this.write();
    }

    label(turning) {
      const words = this.play.textContent;
      if ((this.play.dataset.turning === "yes") === turning) return;
      this.play.textContent = this.play.dataset.stop;
      this.play.dataset.stop = words;
      this.play.dataset.turning = turning ? "yes" : "no";
    }

    // Show what the sliders say, the mechanism at an angle between two places while it turns.
    update(angle) {
      const {data} = this, step = this.inputs.reduce((step, input, place) => step * data.sizes[place] + Number(input.value), 0);
      this.inputs.forEach((input, place) => say(input, data.texts[place][input.value]));
      if (step !== this.shown) this.turn(step);
      if (data.measured[step] !== this.measured) {
        this.measured = data.measured[step];
        this.units.forEach((unit, column) => { unit.innerHTML = data.units[this.measured][column]; });
      }
      const place = this.along ? Number(this.along.value) : 0;
      if (data.cursor) {
        say(this.along, data.cursor.texts[place] + data.cursor.unit);
        this.outputs.forEach((output, column) => {
          const track = data.of[step][column], text = this.figures[track][place] || "–";
          if (output.textContent !== text) output.textContent = text;
          this.curves[column].show(this.values[track], this.figures[track], place);
        });
        this.mark(data.cursor.rows[place], data.cursor.columns[place]);
      }
      const turned = this.turns() ? (angle ?? data.cursor.at[place]) + data.cursor.zero : this.angle;
      this.drawing?.show(data.moves[step], turned);
      this.root.classList.toggle("live-beside", this.page.offsetTop < this.stage.offsetTop + this.stage.offsetHeight / 2);
    }

    // Show the table of another step, and leave what was scrolled where it was.
    turn(step) {
      const scrolled = [...this.page.querySelectorAll(".scroll")].map(one => [one.scrollLeft, one.scrollTop]);
      this.page.innerHTML = unpacked(this.data.pages, step);
      const title = unpacked(this.data.titles, step), heading = document.querySelector("h1.unseen");
      if (this.alone && heading && title) document.title = heading.textContent = title;
      [...this.page.querySelectorAll(".scroll")].forEach((one, place) => {
        if (scrolled[place]) [one.scrollLeft, one.scrollTop] = scrolled[place];
      });
      this.shown = step;
    }

    // Mark the row, or in a table that is whole the column, of a place.
    mark(row, column) {
      for (const table of this.page.querySelectorAll("table")) {
        const rows = [...table.querySelectorAll("tbody > tr:not(.group)")], whole = !table.closest(".narrow");
        const cells = whole && column !== null ? rows.map(one => one.querySelectorAll("td")[column]) : [];
        const marked = [rows[row], ...cells].filter(Boolean);
        for (const one of table.querySelectorAll("[aria-current]"))
          if (!marked.includes(one)) one.removeAttribute("aria-current");
        for (const one of marked) if (!one.hasAttribute("aria-current")) one.setAttribute("aria-current", "true");
      }
    }

    // What is chosen, in the address: #ratio=1:4,5&phi=60.
    write() {
      if (!this.alone) return;
      const {data} = this, parts = this.inputs.map((input, place) => [data.keys[place], data.texts[place][input.value]]);
      if (this.along) parts.push([data.cursor.key, data.cursor.texts[this.along.value]]);
      const text = parts.map(pair => pair.map(encodeURIComponent).join("=")).join("&");
      history.replaceState(null, "", `#${text.replaceAll("%3A", ":").replaceAll("%2C", ",")}`);
    }

    read() {
      if (!this.alone) return;
      const same = text => text.replaceAll(",", ".").replaceAll("\u2212", "-");
      for (const part of location.hash.slice(1).split("&")) {
        const [key, value] = part.split("=").map(unescaped), {data} = this;
        const slider = data.keys.indexOf(key), along = data.cursor?.key === key;
        const texts = along ? data.cursor.texts : data.texts[slider];
        const place = texts && value !== undefined ? texts.findIndex(text => same(text) === same(value)) : -1;
        if (place >= 0) (along ? this.along : this.inputs[slider]).value = place;
      }
    }
  }

  function unpacked({by, shapes, kinds, texts}, step) {
    const own = texts[step].split(by);
    return shapes[kinds[step]].map(piece => typeof piece === "number" ? own[piece] : piece).join("");
  }

  function nearest(values, wanted) {
    return values.reduce((best, one, place) => Math.abs(one - wanted) < Math.abs(values[best] - wanted) ? place : best, 0);
  }

  function unescaped(text) {
    try {
      return decodeURIComponent(text);
    } catch {
      return text;
    }
  }

  function say(input, text) {
    if (input.getAttribute("aria-valuetext") === text && input.dataset.said) return;
    input.dataset.said = "yes";
    input.setAttribute("aria-valuetext", text);
    input.parentElement.querySelector(".live-chosen").textContent = text;
  }

  const blocks = document.querySelectorAll(".live");
  for (const root of blocks) new Live(root, blocks.length === 1);
})();
