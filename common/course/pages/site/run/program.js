"use strict";

// A program of docs/minimal below its listing: drawn as it stands, turned with the mouse, changed by sliders and in an editor.
class Program {
  static scenes = {}; // of scenes.js
  static all = [];
  static SIZE = [640, 360];

  // `listing`: the block of code, behind which the program stands. `text`: what it draws; the listing's own by default.
  constructor(name, listing, text = listing.querySelector("code").textContent) {
    Object.assign(this, {name, listing, scene: Program.scenes[name], first: text, text, mine: new Set()});
    Program.all.push(this);
    this.values = structuredClone(this.scene.values ?? {});
    if (this.scene.lights) this.values.lights = structuredClone(this.scene.lights);
    this.canvas = make("canvas", {width: Program.SIZE[0], height: Program.SIZE[1], tabIndex: 0, className: "run-canvas"});
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `What the program above draws${this.turns ? "; arrow keys turn it" : ""}`);
    this.said = make("p", {className: "run-said"});
    this.said.setAttribute("role", "status");
    this.sliders = make("div", {className: "run-sliders"});
    const button = (words, act) => make("button", {type: "button", textContent: words, onclick: act});
    this.buttons = make("div", {className: "run-buttons"}, button("Edit", () => this.edit()), button("Reset", () => this.reset()));
    if (this.scene.clock) this.buttons.append(this.play = button("Play", () => this.toggle_clock()));
    this.element = make("figure", {className: "run", id: `run-${name}`}, this.canvas, this.buttons, this.said, this.sliders);
    listing.after(this.element);
    this.offer_mine();
    this.listen();
    new IntersectionObserver((entries, seen) => {
      if (!entries.some(one => one.isIntersecting)) return;
      seen.disconnect();
      this.start();
    }, {rootMargin: "200px"}).observe(this.canvas);
  }

  get turns() {
    return this.scene.camera && !this.scene.camera.still;
  }

  start() {
    if (this.drawing) return;
    try {
      this.drawing = new Drawing(this.canvas, this.scene);
    } catch (error) {
      this.say(`${error.message}: this picture stays still.`);
      this.canvas.remove();
      return;
    }
    this.canvas.addEventListener("webglcontextlost", event => { event.preventDefault(); this.drawing = null; this.say("The graphics device gave up: does a loop of this program end? Reset begins again."); });
    this.canvas.addEventListener("webglcontextrestored", () => this.start());
    this.make_sliders();
    this.compile();
  }

  say(words) {
    this.said.textContent = words;
  }

  // The text with those of the reader's answers that are switched on, in the place of what does the same.
  shown(text, answers) {
    for (const [number, [id, answer]] of answers.entries()) {
      const [old, call, before] = this.scene.mine[id];
      if (!text.includes(old)) throw new Error(`the program no longer has the place that ${id} takes`);
      const at = before ? text.indexOf(before) : text.search(/^\w+ \w+\(.*\{/m);
      const line = text.slice(0, at).split("\n").length;
      text = `${text.slice(0, at)}\n#line 1 ${3 + number}\n${answer}\n#line ${line} 1\n${text.slice(at).replace(old, call)}`;
    }
    return text;
  }

  compile() {
    if (!this.drawing) return;
    this.errors = [];
    const answers = [...this.mine].map(id => [id, Answers.text(id).replace(/^[ \t]*#[ \t]*include.*$/gm, "")]);
    const attempt = text => { this.drawing.compile(this.shown(text, answers)); return text; };
    try {
      for (const [number, one] of answers.entries()) {
        const given = one[1];
        try {
          Gl.forgiving(given, tried => { one[1] = tried; return attempt(this.text); }, 3 + number);
        } catch { one[1] = given; }
      }
      Gl.forgiving(this.text, attempt);
      this.say("");
    } catch (error) {
      const foreign = error.lines?.find(one => one.part > 2);
      this.errors = error.lines?.filter(one => one.part === 1) ?? [];
      this.say(foreign ? `your answer, line ${foreign.line}: ${foreign.words}` : error.words ?? error.message);
    }
    this.mark();
    this.draw();
  }

  draw() {
    cancelAnimationFrame(this.waiting);
    this.waiting = requestAnimationFrame(() => this.drawing?.draw(this.numbers()));
  }

  // The uniforms' values; a direction is told by two angles.
  numbers() {
    const r = Math.PI / 180;
    return Object.fromEntries(Object.entries(this.values).map(([name, value]) => [name, value.azimuth === undefined ? value :
      [Math.cos(value.elevation * r) * Math.sin(value.azimuth * r), Math.sin(value.elevation * r), Math.cos(value.elevation * r) * Math.cos(value.azimuth * r), 0]]));
  }

  listen() {
    if (!this.turns) return;
    const turn = (across, along) => {
      const {camera} = this.drawing ?? {};
      if (!camera) return;
      camera.yaw -= across;
      camera.pitch = Math.min(Math.max(camera.pitch + along, -85), 85);
      this.draw();
    };
    this.canvas.classList.add("turns");
    this.canvas.onpointerdown = event => this.canvas.setPointerCapture(event.pointerId);
    this.canvas.onpointermove = event => { if (event.buttons & 1) turn(0.4 * event.movementX, 0.4 * event.movementY); };
    this.canvas.onkeydown = event => {
      const way = {ArrowLeft: [5, 0], ArrowRight: [-5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5]}[event.key];
      if (!way) return;
      event.preventDefault();
      turn(...way);
    };
  }

  make_sliders() {
    const sliders = [];
    for (const [name, value] of Object.entries(this.values))
      if (value.azimuth !== undefined)
        for (const [angle, least, most] of [["azimuth", -180, 180], ["elevation", -10, 90]])
          sliders.push(this.slider(`${name.replace("to_", "")}: ${angle}`, least, most, value[angle], at => { value[angle] = at; this.draw(); }));
    for (const [path, [label, least, most]] of Object.entries(this.scene.sliders ?? {})) {
      const [name, ...rest] = path.split("."), steps = rest.map(part => "xyzw".includes(part) ? "xyzw".indexOf(part) : Number(part));
      const last = steps.pop() ?? 0, list = steps.reduce((at, i) => at[i], this.values[name]);
      sliders.push(this.slider(label, least, most, list[last], at => { list[last] = name === "steps" ? Math.round(at) : at; this.draw(); }));
    }
    for (const {name, value} of this.constants())
      sliders.push(this.slider(name, Math.min(0, 2 * value), Math.max(0, 2 * value), value, at => this.set_constant(name, at)));
    this.sliders.replaceChildren(...sliders);
  }

  slider(label, least, most, value, act) {
    const number = make("output", {textContent: Program.short(value)});
    const range = make("input", {type: "range", min: least, max: most, step: (most - least) / 500 || 1, value});
    range.oninput = () => { number.textContent = Program.short(Number(range.value)); act(Number(range.value)); };
    return make("label", {}, make("span", {textContent: label}), range, number);
  }

  static short(value) {
    return String(Number(value.toPrecision(3)));
  }

  // Global constants that are one float: `const float a = 1.0, b = 2.0;`.
  constants() {
    return [...this.text.matchAll(/^const float ([^;]*);/gm)].flatMap(([, list]) =>
      [...list.matchAll(/(\w+) = (-?[\d.]+(?:e-?\d+)?)(?=,|$)/g)].map(([, name, value]) => ({name, value: Number(value)}))).filter(one => one.name !== "pi");
  }

  set_constant(name, value) {
    const written = Number.isInteger(Number(value.toPrecision(5))) ? `${Number(value.toPrecision(5))}.0` : String(Number(value.toPrecision(5)));
    this.take(this.text.replace(new RegExp(`(^const float [^;]*\\b${name} = )-?[\\d.]+(?:e-?\\d+)?`, "m"), `$1${written}`));
  }

  // A new text, from a slider or the editor.
  take(text) {
    this.text = text;
    if (this.editor && this.editor.getValue() !== text) this.editor.setValue(text);
    clearTimeout(this.typing);
    this.typing = setTimeout(() => this.compile(), 120);
  }

  async edit() {
    if (this.editor) return this.editor.focus();
    const place = make("div", {className: "run-editor"});
    this.buttons.after(place);
    this.editor = await Editor.on(place, this.text, {changed: text => { if (text !== this.text) this.take(text); }});
    this.mark();
    this.editor.focus();
  }

  mark() {
    if (this.editor) Editor.mark(this.editor, this.errors ?? []);
  }

  reset() {
    this.values = structuredClone(this.scene.values ?? {});
    if (this.scene.lights) this.values.lights = structuredClone(this.scene.lights);
    if (this.drawing) this.drawing.camera = {...this.scene.camera};
    this.take(this.first);
    this.make_sliders();
  }

  toggle_clock() {
    const begin = performance.now() - 1000 * this.values[this.scene.clock][0], running = this.play.textContent === "Pause";
    this.play.textContent = running ? "Play" : "Pause";
    const turn = () => {
      if (this.play.textContent !== "Pause") return;
      this.values[this.scene.clock] = [(performance.now() - begin) / 1000];
      this.drawing?.draw(this.numbers());
      requestAnimationFrame(turn);
    };
    turn();
  }

  // A switch for each exercise whose function this program has.
  offer_mine() {
    for (const id of Object.keys(this.scene.mine ?? {})) {
      const box = make("input", {type: "checkbox"});
      box.onchange = () => this.show_mine(id, box.checked);
      this.buttons.append(make("label", {className: "run-mine"}, box, ` mine: ${id}`));
    }
  }

  async show_mine(id, on) {
    await Answers.load(id);
    this.mine[on ? "add" : "delete"](id);
    this.compile();
  }

  // An answer has changed.
  static refresh(id) {
    for (const program of Program.all) if (program.mine.has(id)) program.compile();
  }
}
