"use strict";

// Charts that answer: a point's figures under the pointer; a click draws its picture, the truth and the error.
const Chart = {
  start() {
    for (const image of document.querySelectorAll("article img")) {
      const found = decodeURIComponent(new URL(image.src).pathname).match(/\/studies\/([\w.]+)\.(?:svg|png)$/);
      if (!found) continue;
      const frame = make("span", {className: "live-chart"}), dot = make("span", {className: "live-dot", hidden: true}), words = make("span", {className: "live-words", hidden: true});
      image.replaceWith(frame);
      frame.append(image, dot, words);
      let chart = null;
      frame.addEventListener("pointerenter", async () => {
        chart ??= await Live.get(`chart/${found[1]}`).catch(error => ({points: [], error: error.message}));
        frame.dataset.points = chart.points.length;
      });
      frame.addEventListener("pointermove", event => Chart.point_at(frame, chart, dot, words, event));
      frame.addEventListener("pointerleave", () => { dot.hidden = words.hidden = true; });
      frame.addEventListener("click", event => {
        if (dot.hidden || !chart?.draws) return;
        event.stopPropagation();
        event.preventDefault();
        Chart.show(frame, found[1], frame.nearest);
      }, true);
    }
  },

  // The nearest point within a finger's width.
  point_at(frame, chart, dot, words, event) {
    const box = frame.querySelector("img").getBoundingClientRect(), home = frame.getBoundingClientRect();
    const away = point => Math.hypot(box.left + point.x * box.width - event.clientX, box.top + point.y * box.height - event.clientY);
    const nearest = chart?.points.reduce((best, one) => !best || away(one) < away(best) ? one : best, null);
    const hits = Boolean(nearest) && away(nearest) < 16;
    dot.hidden = words.hidden = !hits;
    frame.style.cursor = hits && chart.draws ? "pointer" : "";
    if (chart?.error) { // said where the pointer is
      words.hidden = false;
      words.textContent = chart.error;
      Object.assign(words.style, {left: "12px", top: "12px"});
    }
    if (!hits) return;
    frame.nearest = nearest;
    const x = box.left - home.left + nearest.x * box.width, y = box.top - home.top + nearest.y * box.height;
    Object.assign(dot.style, {left: `${x}px`, top: `${y}px`});
    words.textContent = nearest.words + (chart.draws ? "\nclick: its picture, the truth and the error" : "");
    Object.assign(words.style, {left: `${Math.min(x + 12, Math.max(home.width - 300, 0))}px`, top: `${y + 14}px`});
  },

  show(frame, name, point) {
    const cells = ["its picture", "the truth", "the error"].map(title => {
      const image = make("img", {alt: title}), caption = make("figcaption", {textContent: `${title} …`});
      return {image, caption, title, figure: make("figure", {}, image, caption)};
    });
    const row = make("div", {className: "live-errors"}, make("p", {textContent: point.words.replaceAll("\n", "; ")}), ...cells.map(cell => cell.figure));
    const block = frame.closest("p, figure") ?? frame;
    if (block.nextElementSibling?.matches(".live-errors")) block.nextElementSibling.remove();
    block.after(row);
    cells.forEach((cell, i) => {
      Live.asked.set(`chart.${i}`, {request: {number: point.point, do: "point"}, done: (answer, picture) => {
        if (answer.number !== point.point) return;
        cell.caption.textContent = answer.error || cell.title + (typeof answer.flip_mean === "number" ? `: FLIP ${answer.flip_mean.toPrecision(3)} at this size` : "");
        if (picture) cell.image.src = URL.createObjectURL(picture);
      }});
    });
    Live.send({do: "point", chart: name, number: point.point});
  },
};
