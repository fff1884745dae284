"use strict";

// A picture of the page that its chapter draws: one side, or two under a slider. What it shows is `state` and no more, so
// that a question says all there is to know.
class Picture {
  static count = 0;
  static all = [];

  // frame: the element that holds the images. sides: {image, shot, over}, where `over` replaces parts of the state; a cell
  // of one of the lesson's pictures has {image, cell: [name, number], over}. `shown` is the answer whose picture is in `image`.
  constructor(frame, chapter, sides) {
    Object.assign(this, {frame, chapter, sides, place: `p${++Picture.count}`, state: Picture.fresh(), answers: []});
    this.listeners = [];
    this.moving_scale = 0.5;
    const {cell, shot} = sides[0];
    this.cell = cell && Live.course.pictures[cell[0]].cells[cell[1]];
    // Knobs as the picture has them, before a hand turns them.
    this.given = this.cell?.set ?? Live.course.chapters[chapter].shots[shot]?.set ?? {};
    this.title = cell ? Object.values(this.given).join(", ") || this.cell.shot || cell[0] : shot;
    if (this.cell) this.aspect = this.cell.size[1] / this.cell.size[0];
    if (this.cell?.use) this.state.use = this.cell.use;
    frame.classList.add("live-frame");
    frame.tabIndex = 0;
    frame.picture = this;
    this.note = make("span", {className: "live-note"});
    frame.append(this.note);
    Picture.all.push(this);
    for (const side of sides) side.image.draggable = false;
    frame.addEventListener("pointerenter", () => this.warm(), {once: true});
    frame.addEventListener("pointerdown", event => this.press(event));
    frame.addEventListener("wheel", event => this.turn_wheel(event), {passive: false});
    frame.addEventListener("dblclick", () => this.change({turn_rad: 0, tilt_rad: 0, notches: 0, pan: [0, 0]}));
    frame.addEventListener("keydown", event => this.press_key(event));
    // The page's own click shows a picture large.
    frame.addEventListener("click", event => { event.stopPropagation(); event.preventDefault(); }, true);
  }

  // How large to draw while something moves, as a share of the whole: half, and less where that takes more than 90 ms. What
  // the last two sizes took says how much of it is for the pixels; what is not, no smaller picture saves.
  static scale_for(scale, ms, before) {
    let per_pixel = Math.max(ms, 1) / scale ** 2, fixed = 0;
    if (before) {
      per_pixel = Math.max((ms - before.ms) / (scale ** 2 - before.scale ** 2), 1);
      fixed = Math.max(ms - per_pixel * scale ** 2, 0);
    }
    const wanted = Math.sqrt(Math.max(90 - fixed, fixed / 2) / per_pixel);
    return Math.min(Math.max(wanted, 0.5 * scale, 0.15), 1.25 * scale, 0.5);
  }

  // What a picture that moves took: the next one may have another size.
  learn(ms) {
    const scale = this.moving_scale, known = this.measured ?? [], before = known.find(one => Math.abs(one.scale - scale) > 0.02);
    this.moving_scale = Picture.scale_for(scale, ms, before);
    this.measured = [{scale, ms}, ...known].slice(0, 3);
  }

  static fresh() {
    return {set: {}, use: "solution", look: "", turn_rad: 0, tilt_rad: 0, notches: 0, pan: [0, 0], time_s: 0};
  }

  // The chapter starts before it is needed.
  warm() {
    if (!this.warmed) this.draw(true);
  }

  change(part, still = true) {
    Object.assign(this.state, part);
    this.draw(still);
    for (const listener of this.listeners) listener(part);
  }

  knob(name, value, still = true) {
    const set = {...this.state.set};
    if (value === null) delete set[name];
    else set[name] = String(value);
    this.change({set}, still);
  }

  // Smaller while something moves, the whole when it rests, and then with more samples.
  draw(still) {
    this.warmed = true;
    this.samples = 1;
    clearTimeout(this.rest);
    clearTimeout(this.refining);
    if (!still) this.rest = setTimeout(() => this.draw(true), 250);
    if (this.drawing_soon) {
      this.drawing_still = still;
      return;
    }
    this.drawing_soon = true;
    this.drawing_still = still;
    requestAnimationFrame(() => {
      this.drawing_soon = false;
      this.ask(this.drawing_still);
    });
  }

  ask(still) {
    const [wide, high] = this.shown_size(still);
    this.sides.forEach((side, i) => {
      const over = side.over ?? {}, {set, ...state} = this.state;
      const source = side.cell ? {picture: side.cell} : {shot: side.shot};
      const knobs = {...(this.samples > 1 ? {samples: String(this.samples)} : {}), ...set, ...over.set}, request = {...state, ...over, chapter: this.chapter, ...source, size: [wide, high], still,
        set: {...Picture.given(this.chapter, side.cell, still, knobs), ...knobs}};
      this.asked_at = performance.now();
      Live.draw(`${this.place}.${i}`, request, (answer, picture, last) => this.show(i, answer, picture, last));
    });
    this.note.textContent ||= "…";
  }

  // The knobs of a cell but those that `turned` replaces, by their names or longer ones ("maps.method" for "method").
  static given(chapter, cell, still, turned) {
    if (!cell) return {};
    const knobs = Knobs.lists[chapter] ?? [];
    const {set, samples} = Live.course.pictures[cell[0]].cells[cell[1]];
    const replaced = name => Object.keys(turned).some(one => one === name || one === Knobs.find(knobs, name)?.name);
    return Object.fromEntries(Object.entries({...set, samples: String(still ? samples ?? 4 : 1)}).filter(([name]) => !replaced(name)));
  }

  // A cell has the size that the lesson's picture was drawn at: what it shows may be a matter of single pixels.
  shown_size(still) {
    const scale = still ? 1 : this.moving_scale;
    if (this.cell) return this.cell.size.map(pixels => Math.max(16, Math.round(pixels * scale)));
    const box = this.frame.getBoundingClientRect(), image = this.sides[0].image;
    const aspect = (this.aspect ??= (image.naturalHeight / image.naturalWidth) || 9 / 16);
    const wide = Math.min(Math.max(box.width || 480, 160) * Math.min(devicePixelRatio, 2), 1280) * scale;
    return [Math.round(wide), Math.max(16, Math.round(wide * aspect))];
  }

  show(i, answer, picture, last) {
    this.ms = performance.now() - this.asked_at;
    if (answer.format === "jpeg" && last) this.learn(answer.ms);
    this.answers[i] = answer;
    if (picture && this.sides[i]) this.put(this.sides[i], answer, picture);
    const wrong = answer.error || answer.errors?.[0] || "";
    this.frame.classList.toggle("live-wrong", Boolean(wrong));
    this.note.textContent = wrong || (last ? "" : this.note.textContent);
    this.note.title = [answer.error, ...answer.errors ?? []].filter(Boolean).join("\n");
    if (answer.code === 3 && last && Date.now() > (this.mended ?? 0) + 10000) { // it ended, and starts again
      this.mended = Date.now();
      setTimeout(() => this.draw(true), 500);
    }
    for (const listener of this.listeners) listener({answer, i});
    if (last && answer.format === "png" && !wrong && !answer.code) this.refine(i, answer.ms ?? this.ms);
  }

  // At rest, four times the samples until there are 16, unless that would keep a hand waiting.
  refine(i, ms) {
    if (this.samples > 1) this.note.textContent = `${this.samples} samples`;
    if (!Live.course.refine_ms || i + 1 < this.sides.length || this.cell || this.state.set.samples || this.samples >= 16 || 4 * ms > Live.course.refine_ms) return;
    clearTimeout(this.refining);
    this.refining = setTimeout(() => { this.samples *= 4; this.ask(true); }, 500);
  }

  async put(side, answer, picture) {
    const number = side.number = (side.number ?? 0) + 1;
    if (this.cell?.crop) picture = await Picture.part(picture, this.cell.crop.map(pixels => pixels * answer.size[0] / this.cell.size[0]));
    if (number !== side.number) return; // a newer one was quicker
    const url = URL.createObjectURL(picture), old = side.url;
    side.url = url;
    side.image.onload = () => old && URL.revokeObjectURL(old);
    side.image.src = url;
    side.shown = answer;
  }

  // A part of an image, [left, top, width, height], as a PNG.
  static async part(source, [left, top, width, height]) {
    const bitmap = source instanceof Blob ? await createImageBitmap(source) : source;
    const canvas = make("canvas", {width: Math.round(width), height: Math.round(height)});
    canvas.getContext("2d").drawImage(bitmap, left, top, width, height, 0, 0, canvas.width, canvas.height);
    return new Promise(done => canvas.toBlob(done));
  }

  get divider() {
    return this.frame.querySelector("input[type=range]");
  }

  near_divider(x) {
    const box = this.frame.getBoundingClientRect();
    return this.divider && Math.abs((x - box.left) / box.width - this.divider.value / 100) < 28 / box.width;
  }

  press(event) {
    if (event.button > 2 || event.target.closest("button, a")) return;
    Live.emit("chosen", this);
    this.frame.focus({preventScroll: true});
    const divides = this.near_divider(event.clientX), pans = event.shiftKey || event.button !== 0;
    let {clientX: x, clientY: y} = event, moved = false;
    event.preventDefault();
    this.frame.setPointerCapture(event.pointerId);
    const move = to => {
      const box = this.frame.getBoundingClientRect(), right = to.clientX - x, down = to.clientY - y;
      [x, y] = [to.clientX, to.clientY];
      moved ||= Boolean(right || down);
      if (divides) {
        this.divider.value = 100 * (x - box.left) / box.width;
        this.divider.dispatchEvent(new Event("input"));
      } else if (pans) {
        const [a, b] = this.state.pan;
        this.change({pan: [a + right / box.height, b + down / box.height]}, false);
      } else if (right || down) {
        this.change({turn_rad: this.state.turn_rad - 3 * right / box.width, tilt_rad: this.state.tilt_rad + 2 * down / box.height}, false);
      }
    };
    const release = () => {
      this.frame.removeEventListener("pointermove", move);
      this.frame.removeEventListener("pointerup", release);
      this.frame.removeEventListener("pointercancel", release);
      if (!moved) Live.emit("clicked", this);
    };
    this.frame.addEventListener("pointermove", move);
    this.frame.addEventListener("pointerup", release);
    this.frame.addEventListener("pointercancel", release);
  }

  // Only a picture that was chosen takes the wheel from the page.
  turn_wheel(event) {
    if (document.activeElement !== this.frame && !event.ctrlKey) return;
    event.preventDefault();
    this.change({notches: this.state.notches - Math.sign(event.deltaY)}, false);
  }

  press_key(event) {
    const turns = {ArrowLeft: ["turn_rad", -0.1], ArrowRight: ["turn_rad", 0.1], ArrowUp: ["tilt_rad", 0.1],
      ArrowDown: ["tilt_rad", -0.1], "+": ["notches", 1], "-": ["notches", -1]}[event.key];
    if (!turns || event.target !== this.frame) return;
    event.preventDefault();
    this.change({[turns[0]]: this.state[turns[0]] + turns[1]}, false);
  }

  // A second side with another knob or another version of an exercise; null takes it away.
  split(over, names) {
    this.frame.querySelectorAll(".live-second, input[type=range], .live-name").forEach(one => one.remove());
    this.sides.length = 1;
    this.frame.classList.toggle("slide", Boolean(over));
    if (over) {
      const first = this.sides[0], image = first.image.cloneNode();
      image.className = "live-second";
      const range = make("input", {type: "range", min: 0, max: 100, step: 0.5, value: 50});
      range.setAttribute("aria-label", `${names[0]} left of the divider, ${names[1]} right of it`);
      range.addEventListener("input", () => this.frame.style.setProperty("--at", `${range.value}%`));
      first.image.after(image, range);
      this.frame.style.setProperty("--at", "50%");
      this.frame.append(make("span", {className: "live-name left", textContent: names[0]}),
                        make("span", {className: "live-name right", textContent: names[1]}));
      this.sides.push({image, shot: first.shot, cell: first.cell, over});
    }
    this.draw(true);
  }
}
