"use strict";

// The connection to the server: pictures asked for by place, checks, and what the server tells.
const Live = {
  base: new URL(".", document.currentScript.src),
  listeners: {},
  asked: new Map(), // place: {request, done} of the newest question
  number: 0,
  waiting: [],
  wait_ms: 500,
  pictures: 0, // received, for tests

  on(event, listener) {
    (Live.listeners[event] ??= []).push(listener);
  },

  emit(event, value) {
    for (const listener of Live.listeners[event] ?? []) listener(value);
  },

  async get(path) {
    const answer = await fetch(new URL(path, Live.base));
    if (!answer.ok) throw new Error(Live.words(await answer.text()));
    return answer.json();
  },

  // The words of a refusal, which is JSON; other errors are text.
  words(text) {
    try {
      return JSON.parse(text).error ?? text;
    } catch {
      return text.trim();
    }
  },

  async put(path, value) {
    const answer = await fetch(new URL(path, Live.base), {method: "PUT", body: JSON.stringify(value)});
    return {status: answer.status, ...await answer.json()};
  },

  connect() {
    const address = new URL("socket", Live.base);
    address.protocol = address.protocol.replace("http", "ws");
    const socket = Live.socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      Live.wait_ms = 500;
      Live.emit("connected");
      for (const message of Live.waiting.splice(0)) socket.send(message);
      for (const [place, {request}] of Live.asked) if (request.do === "draw") socket.send(JSON.stringify({...request, place}));
    };
    socket.onmessage = message => {
      if (typeof message.data === "string") {
        const event = JSON.parse(message.data);
        Live.emit(event.event, event);
      } else {
        Live.receive(message.data);
      }
    };
    socket.onclose = () => {
      Live.emit("lost");
      setTimeout(Live.connect, Live.wait_ms);
      Live.wait_ms = Math.min(2 * Live.wait_ms, 10000);
    };
  },

  send(message) {
    if (Live.socket?.readyState === WebSocket.OPEN) Live.socket.send(JSON.stringify(message));
    else if (message.do !== "draw") Live.waiting.push(JSON.stringify(message)); // pictures are asked for again
  },

  // A picture for a place; the newest question of a place is the one that counts.
  draw(place, request, done) {
    request = {...request, do: "draw", number: ++Live.number};
    Live.asked.set(place, {request, done});
    Live.send({...request, place});
  },

  // Four bytes say how long the answer is, behind which the picture follows.
  receive(data) {
    const length = new DataView(data).getUint32(0, true);
    const answer = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
    const asked = Live.asked.get(answer.place);
    if (!asked) return;
    const last = asked.request.number === answer.number;
    if (last) Live.asked.delete(answer.place);
    const picture = data.byteLength > 4 + length ? new Blob([new Uint8Array(data, 4 + length)], {type: `image/${answer.format}`}) : null;
    if (picture) ++Live.pictures;
    asked.done(answer, picture, last);
  },
};
Live.on("refused", event => {
  const asked = Live.asked.get(event.place);
  Live.asked.delete(event.place);
  asked?.done({code: 2, error: event.error}, null, true);
});
