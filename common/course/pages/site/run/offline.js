"use strict";

// From a server, the site stays readable without a network. A page from a file needs nothing.
if (location.protocol.startsWith("http") && navigator.serviceWorker)
  addEventListener("load", () => navigator.serviceWorker.register(new URL("worker.js", document.currentScript?.src ?? document.querySelector("script[src$='offline.js']").src)));
