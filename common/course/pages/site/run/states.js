"use strict";

// A picture that shows other values of the knobs that its lesson names, each drawn ahead (pages/states.py): by controls below it
// and by the names in the text.
class States {
  static all = [];

  // `host`: the element for the controls; without it they follow the picture's block.
  constructor(image, host = null) {
    Object.assign(this, {image, told: JSON.parse(image.dataset.states), first: image.getAttribute("src"), rows: new Map(), knob: null, value: null});
    this.said = make("output", {className: "states-said"});
    this.beside = make("input", {type: "checkbox"});
    this.beside.onchange = () => this.show();
    const compare = make("label", {className: "states-beside"}, this.beside, " side by side");
    this.controls = make("div", {className: "states"}, ...this.told.knobs.map(one => this.row(one)), compare, this.said);
    if (host) host.append(this.controls);
    else (image.closest("figure, p") ?? image).after(this.controls);
  }

  // A control of one knob: its options, or a slider over its numbers.
  row(one) {
    const values = [...new Set([one.base, ...Object.keys(one.files)])];
    if (one.number) values.sort((a, b) => a - b);
    const name = make("span", {textContent: one.knob.split(".").pop(), title: `${one.knob}: ${one.help}`});
    const number = make("output", {textContent: one.base});
    const control = one.number ? make("input", {type: "range", min: 0, max: values.length - 1, value: values.indexOf(one.base)})
      : make("select", {}, ...values.map(value => make("option", {value, textContent: value === one.base ? `${value} (as shown)` : value})));
    if (!one.number) control.value = one.base;
    control.setAttribute("aria-label", one.knob);
    control.oninput = () => this.set(one.knob, one.number ? values[control.value] : control.value);
    this.rows.set(one.knob, value => {
      control.value = one.number ? values.indexOf(value) : value;
      number.textContent = `${value}${one.unit ? ` ${one.unit}` : ""}`;
      if (one.number) control.setAttribute("aria-valuetext", number.textContent);
    });
    this.rows.get(one.knob)(one.base);
    return make("label", {}, name, control, ...one.number ? [number] : []);
  }

  find(knob) {
    return this.told.knobs.find(one => one.knob === knob);
  }

  has(knob, value) {
    const one = this.find(knob);
    return Boolean(one) && (value === null || value in one.files || States.same(value, one.base));
  }

  static same(a, b) {
    return a === b || a !== "" && b !== "" && Number(a) === Number(b);
  }

  // The value after the one that is shown, for a name that stands without one.
  next(knob) {
    const one = this.find(knob), values = [one.base, ...Object.keys(one.files)];
    return values[(values.indexOf(this.knob === knob ? this.value : one.base) + 1) % values.length];
  }

  // One knob differs from the picture as the lesson has it; the others go back.
  set(knob, value) {
    const one = this.find(knob), file = one.files[value];
    Object.assign(this, file ? {knob, value, file} : {knob: null, value: null, file: null});
    for (const other of this.told.knobs) this.rows.get(other.knob)(other.knob === this.knob ? value : other.base);
    this.show();
  }

  show() {
    const {image, told} = this;
    if (image.naturalWidth) { // a drawn state has fewer pixels
      image.style.aspectRatio ||= `${image.naturalWidth} / ${image.naturalHeight}`;
      image.style.width ||= `${image.width}px`;
    }
    const pair = this.beside.checked && this.file;
    this.image.src = pair ? told.base : this.file ?? this.first;
    this.said.textContent = this.file ? `${this.knob} = ${this.value}${pair ? ", right of the divider" : ""}` : "";
    this.split(pair ? this.file : null);
  }

  // The picture without the change left of a divider, with it on the right.
  split(file) {
    this.frame?.replaceWith(this.image);
    this.frame = null;
    if (!file) return;
    const range = make("input", {type: "range", min: 0, max: 100, step: 0.5, value: 50});
    range.setAttribute("aria-label", `as the lesson shows it, and ${this.knob} = ${this.value}`);
    const other = make("img", {src: file, alt: ""});
    this.frame = make("span", {className: "slide states-frame"});
    this.frame.style.width = this.image.style.width;
    this.image.replaceWith(this.frame);
    this.frame.append(this.image, other, range);
    range.oninput = () => this.frame.style.setProperty("--at", `${range.value}%`);
  }

  in_view() {
    const box = this.image.getBoundingClientRect();
    return box.width > 300 && box.bottom > 120 && box.top < innerHeight - 120;
  }

  // Shows elements in the corner of the window, instead of the last ones.
  static open(children) {
    States.docked?.remove();
    const close = make("button", {type: "button", className: "states-close", textContent: "×", title: "close"});
    close.setAttribute("aria-label", "close the picture");
    const holder = States.docked = make("aside", {className: "states-dock"}, close, ...children);
    close.onclick = () => holder.remove();
    holder.onkeydown = event => { if (event.key === "Escape") holder.remove(); };
    document.body.append(holder);
    return holder;
  }

  // A copy of a picture in the corner, for text far from it.
  static dock(one) {
    if (States.docked?.isConnected && States.docked.copy?.from === one) return States.docked.copy;
    const image = make("img", {src: one.first, alt: one.image.alt});
    image.dataset.states = one.image.dataset.states;
    const holder = States.open([image]);
    return holder.copy = Object.assign(new States(image, holder), {from: one});
  }

  static turn(one, knob, value) {
    const shown = one.in_view() ? one : States.dock(one);
    shown.set(knob, value ?? shown.next(knob));
  }

  // A knob's name in the text turns it in the picture above, or in the nearest that has it.
  static link(code) {
    const {knob} = code.dataset, value = code.dataset.value ?? null, able = States.all.filter(one => one.has(knob, value));
    const one = able.filter(other => other.image.compareDocumentPosition(code) & Node.DOCUMENT_POSITION_FOLLOWING).pop() ?? able[0];
    if (!one) return;
    const {help} = one.find(knob), act = () => States.turn(one, knob, value);
    Object.assign(code, {tabIndex: 0, role: "button", title: value === null ? `${knob}: ${help}. Each click shows another value` : `show ${knob} = ${value}`, onclick: act});
    code.classList.add("states-link");
    code.onkeydown = event => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      act();
    };
  }
}

// A picture as large as the window has its controls with it (lesson.js).
addEventListener("enlarged", ({target, detail: copy}) => {
  const one = States.all.find(other => other.image === target);
  if (!one) return;
  copy.src = one.first;
  copy.removeAttribute("style");
  new States(copy, copy.parentElement);
});

addEventListener("DOMContentLoaded", () => {
  for (const image of document.querySelectorAll("article img[data-states]")) {
    const small = image.closest("td, .slide, a"), one = new States(image, small ? make("div") : null);
    States.all.push(one);
  }
  for (const code of document.querySelectorAll("article code[data-knob]")) States.link(code);
  for (const image of document.querySelectorAll("article img[data-points]")) new ChartPoints(image);
});

// A chart with a button at each drawn point; its picture opens in the corner.
class ChartPoints {
  constructor(image) {
    const frame = make("span", {className: "states-chart"});
    image.replaceWith(frame);
    frame.append(image);
    for (const point of JSON.parse(image.dataset.points)) {
      const button = make("button", {type: "button", title: point.words});
      button.setAttribute("aria-label", `show the picture of ${point.words}`);
      Object.assign(button.style, {left: `${100 * point.x}%`, top: `${100 * point.y}%`});
      button.onclick = event => { event.stopPropagation(); ChartPoints.show(point); };
      frame.append(button);
    }
  }

  static show(point) {
    States.open([make("img", {src: point.file, alt: point.words}), make("p", {className: "states-words", textContent: point.words})]);
  }
}
