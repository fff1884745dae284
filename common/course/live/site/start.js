"use strict";

// What of a page becomes live.
const Lesson = {
  chapter: null,
  knobs: [],
  named: [],
  current: null,

  async start() {
    Live.course = await Live.get("course");
    Lesson.show_progress(Live.course.progress);
    const page = decodeURIComponent(location.pathname.split("/").pop()).replace(/\.html$/, "");
    const chapters = Object.keys(Live.course.chapters), part = page.match(/^(\d\d)[a-z]_/)?.[1];  // 15a_terrain
    Lesson.chapter = chapters.find(name => name === page || part && name.startsWith(`${part}_`)) ?? null;
    Live.connect();
    Live.on("chosen", picture => Lesson.choose(picture));
    Live.on("clicked", picture => Lesson.enlarge(picture));
    Live.on("lost", () => document.body.classList.add("live-lost"));
    Live.on("connected", () => document.body.classList.remove("live-lost"));
    Live.on("checked", event => Lesson.show_progress(event.progress));
    Lesson.find_pictures();
    if (!Lesson.chapter) return;
    for (const one of document.querySelectorAll("a.exercise")) Exercise.offer(one, FileExercise);
    Chart.start?.();
    try {
      Lesson.knobs = await Knobs.of(Lesson.chapter);
    } catch (error) {
      Lesson.complain(error.message);
      return;
    }
    Lesson.named = Knobs.link_text(document.querySelector("article"), Lesson.knobs, Lesson.turn);
    Lesson.link_commands();
    document.body.classList.add("live-ready");
  },

  complain(words) {
    document.querySelector("article h1")?.after(make("p", {className: "live-complaint", textContent: words}));
  },

  // What an image shows: the golden of a shot, tree/tests/NN_name/golden/SHOT.png, or one of the lesson's other pictures,
  // images/NAME.png. Null for a diagram or a chart.
  source(image) {
    const path = decodeURIComponent(new URL(image.src).pathname);
    const golden = path.match(/\/tree\/tests\/(\d\d_\w+)\/golden\/(\w+)\.png$/), name = path.match(/\/images\/(\w+)\.(?:png|jpg)$/)?.[1];
    if (Live.course.chapters[golden?.[1]]?.shots[golden[2]]) return {chapter: golden[1], shot: golden[2]};
    const made = Live.course.pictures[name];
    return made ? {chapter: made.cells[0].chapter, cell: [name, 0], made} : null;
  },

  find_pictures() {
    for (const image of document.querySelectorAll("article img")) {
      const source = image.closest("a, .hero") ? null : Lesson.source(image);
      if (!source) continue;
      const slide = image.closest(".slide");
      if (slide) Lesson.liven_pair(slide);
      else if (source.made?.cells.length > 1) Lesson.liven_cells(image, source);
      else Lesson.liven(image, source);
    }
  },

  liven(image, source) {
    const frame = make("span");
    image.replaceWith(frame);
    frame.append(image);
    Lesson.place(new Picture(frame, source.chapter, [{image, ...source}]), frame);
  },

  place(picture, element) {
    for (const side of picture.sides) side.image.classList.remove("zooms");
    element.closest("table")?.classList.add("live-table");
    picture.block = element.closest(".md-typeset__scrollwrap, p, figure") ?? element.closest("table") ?? element;
  },

  // Two pictures under a slider: each is drawn from what it shows, and both are turned together.
  liven_pair(slide) {
    const images = [...slide.querySelectorAll("img")], sources = images.map(Lesson.source);
    if (slide.picture || images.length !== 2 || sources.some(one => !one || one.chapter !== sources[0].chapter || one.made?.cells.length > 1)) return;
    images[1].classList.add("live-second");
    Lesson.place(new Picture(slide, sources[0].chapter, sources.map((source, i) => ({image: images[i], ...source}))), slide);
  },

  // A picture of several cells becomes a grid of live ones, which show their part of it until they are drawn.
  async liven_cells(image, {chapter, cell: [name], made}) {
    await image.decode().catch(() => {});
    const {columns, cells} = made, rows = Math.ceil(cells.length / columns), gap = 4;
    const wide = image.naturalWidth / columns, high = image.naturalHeight / rows;
    const grid = make("span", {className: "live-grid"});
    grid.style.gridTemplateColumns = `repeat(${columns}, 1fr)`;
    image.replaceWith(grid);
    cells.forEach((_, i) => {
      const own = make("img", {alt: `${image.alt}, ${i + 1} of ${cells.length}`}), frame = make("span", {}, own);
      grid.append(frame);
      Picture.part(image, [i % columns * wide + gap / 2, Math.floor(i / columns) * high + gap / 2, wide - gap, high - gap])
        .then(part => { own.src ||= URL.createObjectURL(part); });
      Lesson.place(new Picture(frame, chapter, [{image: own, cell: [name, i]}]), grid);
    });
  },

  async choose(picture) {
    if (Lesson.current === picture && picture.panel?.element.isConnected) return;
    Lesson.current?.frame.classList.remove("live-chosen");
    Lesson.current = picture;
    picture.frame.classList.add("live-chosen");
    if (picture.fixed) return;
    await Lesson.open(picture);
  },

  // One of a row of pictures moves into its panel, where it is as wide as the page; a still one keeps its place.
  async enlarge(picture) {
    if (picture.fixed || picture.dock || picture.still) return;
    await Lesson.open(picture);
    picture.still = picture.sides[0].image.cloneNode();
    if (picture.frame.offsetWidth < 0.7 * picture.block.offsetWidth) {
      picture.frame.replaceWith(picture.still);
      picture.panel.element.prepend(picture.frame);
      picture.draw(true);
    }
  },

  close(panel) {
    const {picture} = panel;
    if (picture.still?.isConnected) picture.still.replaceWith(picture.frame);
    picture.still = null;
    panel.element.remove();
  },

  // The panel below the picture's table or paragraph.
  async open(picture) {
    const knobs = await Knobs.of(picture.chapter);
    if (!picture.panel) {
      const first = [Knobs.find(knobs, "method"), ...Object.keys(picture.given).map(name => Knobs.find(knobs, name)),
                     ...(picture.chapter === Lesson.chapter ? Lesson.named : [])].filter(Boolean);
      new Panel(picture, knobs, [...new Set(first)]);
    }
    if (picture.dock) return;
    for (const other of document.querySelectorAll("article .live-panel"))
      if (other.panel && !other.panel.picture.fixed && !other.panel.picture.dock && other.panel !== picture.panel) Lesson.close(other.panel);
    if (!picture.panel.element.isConnected) picture.block.after(picture.panel.element);
  },

  // The picture that a link turns: the one chosen last, else the one above the link, else the page's first.
  near(element) {
    const own = Picture.all.filter(one => one.sides[0].shot && one.chapter === Lesson.chapter && one.frame.isConnected && one.frame.offsetParent);
    if (Lesson.current && own.includes(Lesson.current)) return Lesson.current;
    return own.filter(one => one.frame.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING).pop() ?? own[0];
  },

  async turn(knob, value, link) {
    let picture = Lesson.near(link);
    if (!picture || !Lesson.in_view(picture.frame)) picture = Lesson.dock(picture?.sides[0].shot, picture?.state);
    await Lesson.choose(picture);
    await Lesson.open(picture);
    picture.panel.turn(knob, value)?.scrollIntoView({block: "nearest"});
  },

  in_view(element) {
    const box = element.getBoundingClientRect();
    return box.bottom > 80 && box.top < innerHeight - 80;
  },

  // A picture in the corner of the window, for text far from its picture.
  dock(shot, state, use) {
    shot ??= Object.keys(Live.course.chapters[Lesson.chapter].shots)[0];
    let picture = Lesson.docked;
    if (picture?.sides[0].shot !== shot) {
      picture?.holder.remove();
      const image = make("img", {alt: shot}), frame = make("span", {}, image);
      image.src = new URL(`golden/${Lesson.chapter}/${shot}`, Live.base);
      const close = make("button", {type: "button", className: "live-close", textContent: "×", title: "close"});
      const holder = make("aside", {className: "live-dock"}, close, frame);
      document.body.append(holder);
      picture = Lesson.docked = new Picture(frame, Lesson.chapter, [{image, shot}]);
      Object.assign(picture, {dock: true, holder});
      close.onclick = () => { holder.hidden = true; };
      Lesson.open(picture).then(() => holder.append(picture.panel.element));
    }
    picture.holder.hidden = false;
    if (state || use) picture.change({...structuredClone(state ?? Picture.fresh()), ...(use ? {use} : {})});
    return picture;
  },

  // A command in the text that draws a shot of this chapter: a click draws it here.
  link_commands() {
    for (const code of document.querySelectorAll("article :is(p, li) code")) {
      const words = code.textContent.trim().split(/\s+/), after = word => words[words.indexOf(word) + 1];
      if (words[0] !== "./course" || words[1] !== "run" || words[2] !== Lesson.chapter.slice(0, 2) || !words.includes("--shot")) continue;
      const shot = after("--shot");
      if (!Live.course.chapters[Lesson.chapter].shots[shot]) continue;
      const set = {};
      words.forEach((word, i) => {
        const found = word.match(/^--([\w.]+)$/), given = word === "--set" ? words[i + 1]?.split("=") : found && !["shot", "use", "set", "size", "look"].includes(found[1]) ? [found[1], words[i + 1]] : null;
        const knob = given && Knobs.find(Lesson.knobs, given[0]);
        if (knob && given[1]) set[knob.name] = given[1];
      });
      code.classList.add("live-link");
      code.tabIndex = 0;
      code.title = "draw it here";
      code.onclick = () => {
        const picture = Lesson.dock(shot, {...Picture.fresh(), set, look: words.includes("--look") ? after("--look") : "",
          use: words.includes("--use") ? after("--use") : "solution"});
        Lesson.choose(picture);
      };
    }
  },

  show_progress(progress) {
    Live.progress = progress;
    const all = Object.values(progress), solved = all.reduce((sum, one) => sum + one.solved.length, 0);
    const total = all.reduce((sum, one) => sum + one.exercises, 0);
    let place = document.querySelector(".live-progress");
    if (!place) {
      place = make("span", {className: "live-progress"});
      document.querySelector(".md-header__inner")?.append(place);
    }
    place.textContent = `${solved} of ${total} exercises solved`;
    place.title = Object.entries(progress).map(([name, one]) => `${name}: ${one.solved.length} of ${one.exercises}`).join("\n");
    for (const mark of document.querySelectorAll("a.exercise")) {
      const [heading] = Exercise.section(mark);
      heading?.classList.toggle("run-solved", all.some(one => one.solved.includes(mark.id)));
      heading?.classList.toggle("run-untouched", all.some(one => one.untouched.includes(mark.id)));
    }
  },
};
Lesson.start().catch(error => Lesson.complain(error.message));
