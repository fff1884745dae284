"use strict";

// The panel below a picture: knobs, two sides, time, passes.
class Panel {
  // shown: knobs in view, the first ones; the rest is folded.
  constructor(picture, knobs, shown) {
    Object.assign(this, {picture, knobs, rows: new Map()});
    this.element = make("div", {className: "live-panel"});
    this.element.panel = this;
    picture.panel = this;
    const first = shown.slice(0, 8), rest = knobs.filter(knob => !first.includes(knob));
    this.element.append(this.head(), make("div", {className: "live-knobs"}, ...first.map(knob => this.row(knob))));
    if (rest.length) this.element.append(this.fold(`all ${knobs.length} knobs`, () => {
      const filter = make("input", {type: "search", placeholder: "filter", className: "live-filter"});
      const all = make("div", {className: "live-knobs"}, ...rest.map(knob => this.row(knob)));
      filter.oninput = () => { for (const row of all.children) row.hidden = !row.dataset.knob.includes(filter.value); };
      return [filter, all];
    }));
    this.times = make("div", {className: "live-times"});
    this.element.append(this.fold("passes and their times", () => [this.look_choice(), this.times]));
    this.follow = change => this.update(change);
    picture.listeners.push(this.follow);
    picture.warm();
  }

  head() {
    const {picture} = this;
    const reset = make("button", {type: "button", textContent: "reset", title: "camera and knobs as the lesson has them"});
    reset.onclick = () => {
      picture.change({...Picture.fresh(), use: picture.state.use});
      for (const [knob, row] of this.rows) row.set(this.value(knob));
    };
    this.time = make("input", {type: "range", min: 0, max: 20, step: 0.01, value: 0, className: "live-time"});
    this.time.setAttribute("aria-label", "time in seconds");
    this.time.oninput = () => picture.change({time_s: +this.time.value}, false);
    this.play = make("button", {type: "button", textContent: "▶", title: "let time run"});
    this.play.onclick = () => this.run_time();
    this.moving = make("span", {className: "live-moves", hidden: true}, this.play, this.time);
    this.said = make("span", {className: "live-said"});
    return make("div", {className: "live-head"}, make("b", {textContent: picture.title}), reset, this.split_choice(), this.moving, this.said);
  }

  // Two values of a choice under one slider: the chapter's methods first.
  split_choice() {
    const select = make("select", {className: "live-split", title: "two values side by side"}, make("option", {value: "", textContent: "compare with …"}));
    select.setAttribute("aria-label", "compare with");
    const own = knob => [knob.name.split(".").pop() === "method" ? 0 : 1, knob.name.split(".").length];
    const choices = this.knobs.filter(knob => knob.type === "choice").sort((a, b) => own(a)[0] - own(b)[0] || own(a)[1] - own(b)[1]);
    for (const knob of choices) {
      const group = make("optgroup", {label: knob.name});
      for (const option of knob.options) group.append(make("option", {value: `${knob.name}=${option}`, textContent: option}));
      select.append(group);
    }
    select.onchange = () => {
      const [name, value] = select.value.split("=");
      this.split_knob = this.knobs.find(knob => knob.name === name);
      this.picture.split(name ? {set: {[name]: value}} : null, name ? [this.value(this.split_knob), value] : []);
    };
    return select;
  }

  fold(title, make_inside) {
    const details = make("details", {className: "live-fold"}, make("summary", {textContent: title}));
    details.addEventListener("toggle", () => {
      if (details.open && details.children.length === 1) {
        details.append(...make_inside());
        if (this.answer) this.show_passes(this.answer);
      }
    });
    return details;
  }

  look_choice() {
    this.look = make("select", {className: "live-look"}, make("option", {value: "", textContent: "the picture"}));
    this.look.setAttribute("aria-label", "look at a pass");
    this.look.onchange = () => this.picture.change({look: this.look.value});
    return make("label", {textContent: "look at "}, this.look);
  }

  // What a knob is now: turned here, set by the shot, or its default.
  value(knob) {
    const set = Object.entries(this.picture.given).find(([name]) => Knobs.find(this.knobs, name) === knob);
    return this.picture.state.set[knob.name] ?? (set ? String(set[1] === true ? "on" : set[1] === false ? "off" : set[1]) : Knobs.default_text(knob));
  }

  row(knob) {
    const row = Knobs.control(knob, this.value(knob), (text, still) => this.picture.knob(knob.name, text, still));
    this.rows.set(knob, row);
    return row;
  }

  turn(knob, value) {
    if (value === null) { // a name alone: the next of its choices, or its control to turn
      const options = Knobs.options(knob);
      if (options.length) value = options[(options.indexOf(this.value(knob)) + 1) % options.length];
    }
    if (value !== null) this.picture.knob(knob.name, value);
    let row = this.rows.get(knob);
    if (!row) {
      row = this.row(knob);
      this.element.querySelector(".live-knobs").append(row);
    }
    row.set(this.value(knob));
    row.classList.remove("live-flash");
    void row.offsetWidth; // the animation starts again
    row.classList.add("live-flash");
    return row;
  }

  update({answer, i}) {
    if (!answer || i) return;
    this.answer = answer;
    this.moving.hidden = !answer.moves;
    if (answer.error) this.said.textContent = "";
    else {
      const gpu_ms = (answer.passes ?? []).reduce((sum, [, , ms]) => sum + ms, 0);
      this.said.textContent = `${gpu_ms.toFixed(1)} ms on ${answer.device ?? "?"}`;
      this.said.title = `${(answer.status ?? []).join("\n")}`;
    }
    this.show_passes(answer);
  }

  show_passes(answer) {
    if (!answer.passes || !this.look) return;
    const rows = answer.passes.map(([name, stage, ms]) => make("tr", {}, make("td", {textContent: name}),
      make("td", {textContent: stage}), make("td", {textContent: `${ms.toFixed(2)} ms`})));
    this.times.replaceChildren(make("table", {}, ...rows), ...(answer.status ?? []).map(line => make("p", {textContent: line})));
    const names = (answer.looks ?? []).join("\n");
    if (names !== this.looks) {
      this.looks = names;
      const chosen = this.look.value;
      this.look.replaceChildren(make("option", {value: "", textContent: "the picture"}),
        ...(answer.looks ?? []).map(name => make("option", {value: name, textContent: name})));
      this.look.value = chosen;
    }
  }

  run_time() {
    this.runs = !this.runs;
    this.play.textContent = this.runs ? "❚❚" : "▶";
    let before = performance.now();
    const step = now => {
      if (!this.runs || !this.element.isConnected) return;
      const waits = [...Live.asked.keys()].some(place => place.startsWith(`${this.picture.place}.`));
      if (!waits && !document.hidden) { // the next one when this one has come: time does not run ahead
        const time_s = (this.picture.state.time_s + Math.min((now - before) / 1000, 0.5)) % 20;
        before = now;
        this.time.value = time_s;
        this.picture.state.time_s = time_s;
        this.picture.ask(false);
      }
      requestAnimationFrame(step);
    };
    if (this.runs) requestAnimationFrame(step);
    else this.picture.draw(true);
  }
}
