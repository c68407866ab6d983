// Drawings that move by their own style sheets: here their clock is stopped, started and set.
(() => {
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  class Film {
    constructor(root, alone) {
      const one = name => root.querySelector(`.film-${name}`);
      const data = this.data = JSON.parse(one("data").textContent);
      Object.assign(this, {slider: one("slider"), play: one("play"), shown: one("angle")});
      this.outputs = [...root.querySelectorAll(".film-value")];
      this.parts = root.querySelector("svg").getAnimations({subtree: true});
      this.span = data.last - data.first;
      this.begun = (data.start - data.first) / this.span;
      one("choice").hidden = false;
      for (const one of root.querySelectorAll(".film-values")) one.hidden = false;
      this.slider.addEventListener("input", () => { this.halt(); this.turn(Number(this.slider.value)); });
      this.play.addEventListener("click", () => this.turning ? this.rest() : this.start());
      still.addEventListener("change", () => this.calm());
      this.halt();
      this.turn(data.start);
      if (alone) this.start();
      this.calm();
    }

    // Nothing moves by itself for those who ask for that.
    calm() {
      this.play.hidden = still.matches;
      if (still.matches) this.rest();
    }

    // The last angle is that at which the next run begins, and is shown before it does. Before its time 0 an
    // animation does nothing, so what comes before the start is shown as in the next run.
    turn(angle) {
      const share = Math.min((angle - this.data.first) / this.span, 1 - 1e-6) - this.begun;
      for (const one of this.parts) one.currentTime = (share < 0 ? share + 1 : share) * this.data.seconds * 1000;
      this.say(angle);
    }

    angle() {
      const time = this.parts[0].currentTime / this.data.seconds / 1000 + this.begun;
      return this.data.first + (time - Math.floor(time)) * this.span;
    }

    start() {
      for (const one of this.parts) one.play();
      this.label(true);
      const frame = () => {
        if (!this.turning) return;
        this.say(Math.round(this.angle()));
        requestAnimationFrame(frame);
      };
      requestAnimationFrame(frame);
    }

    halt() {
      for (const one of this.parts) one.pause();
      this.label(false);
    }

    // Stop at a whole degree, for which there are printed numbers.
    rest() {
      const angle = Math.round(this.angle());
      this.halt();
      this.turn(angle);
    }

    label(turning) {
      this.turning = turning;
      this.play.textContent = turning ? this.play.dataset.stop : this.play.dataset.play;
    }

    say(angle) {
      const text = `${angle}°`, place = Math.round(angle - this.data.first);
      if (this.shown.textContent === text && this.slider.value === String(angle)) return;
      this.slider.value = angle;
      this.slider.setAttribute("aria-valuetext", text);
      this.shown.textContent = text;
      this.outputs.forEach((output, column) => { output.textContent = this.data.values[column][place]; });
    }
  }

  const blocks = document.querySelectorAll(".film");
  for (const root of blocks) new Film(root, blocks.length === 1 && document.querySelector("main > .film"));
})();
