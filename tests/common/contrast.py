"""Texts of a page that are hard to read: their contrast with the background is below 4.5 (WCAG 2.1, 1.4.3).

Texts over pictures are not judged."""

CONTRAST = """(() => {
  const rgb = text => (text.match(/[\\d.]+/g) ?? [0, 0, 0, 0]).map(Number);
  const light = c => { const [r, g, b] = c.slice(0, 3).map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const over = (top, below) => { const a = top[3] ?? 1; return [0, 1, 2].map(i => top[i] * a + below[i] * (1 - a)); };
  const ground = e => { const layers = []; for (let at = e; at; at = at.parentElement) layers.push(rgb(getComputedStyle(at).backgroundColor));
    return layers.reverse().reduce((below, top) => over(top, below), [255, 255, 255]); };
  const found = {};
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const e = walker.currentNode.parentElement, style = getComputedStyle(e);
    if (!walker.currentNode.textContent.trim() || !e.checkVisibility?.({checkOpacity: true, checkVisibilityCSS: true})) continue;
    if (e.closest("script, style, svg, .katex-mathml, .live-frame, .slide, .md-search, dialog, .md-skip, .headerlink, [aria-hidden=true], .md-top, .CodeMirror-measure")) continue;
    const box = e.getBoundingClientRect();
    if (!box.width || !box.height) continue;
    const below = ground(e), color = over(rgb(style.color), below);
    const [a, b] = [light(color), light(below)].sort((x, y) => y - x), ratio = (a + 0.05) / (b + 0.05);
    if (ratio < 4.5) found[`${e.tagName}.${e.className} in ${e.parentElement.tagName}.${e.parentElement.className}`] =
      [ratio.toFixed(2), style.color, below.map(Math.round).join(","), walker.currentNode.textContent.trim().slice(0, 30)];
  }
  return found;
})()"""

# Colours change at once.
AT_ONCE = "document.head.append(Object.assign(document.createElement('style'), {textContent: '* { transition: none !important; }'}))"


def hard_to_read(browser) -> dict:
    """{scheme: {element: [contrast, colour, background, words]}} of the page that is open, in dark and in light by a reader's button."""
    browser.evaluate(AT_ONCE)
    found = {}
    for scheme in ("slate", "default"):
        browser.evaluate(f"document.querySelector('.md-option[data-md-color-scheme={scheme}]').click()")
        browser.wait(f"document.body.dataset.mdColorScheme === '{scheme}'")
        if texts := browser.evaluate(CONTRAST):
            found[scheme] = texts
    return found
