// One page of a browser. A line of JSON on standard input calls a function of Playwright's page, {"call": "keyboard.press", "with":
// ["Tab"]}; its answer is a line on standard output, {"value"} or {"error"}, with what the page complained of since.
const {createInterface} = require("readline");
const playwright = require("playwright-core");

const {name, launch, page: look, server} = JSON.parse(process.argv[2]);

async function main() {
  const browser = await playwright[name].launch(launch), page = await (await browser.newContext(look)).newPage(), complaints = [];
  page.setDefaultTimeout(110000); // on a busy machine a page that draws by software takes half a minute
  page.on("pageerror", error => complaints.push(error.message));
  page.on("console", said => {
    if (!["error", "warning", "assert"].includes(said.type())) return;
    if (!said.text().includes("GPU stall due to ReadPixels")) complaints.push(said.text()); // of every program that is drawn
  });
  page.on("request", asked => {
    if (!["data:", "file:", "about:", "blob:", server].some(one => one && asked.url().startsWith(one))) complaints.push(`asks the network for ${asked.url()}`);
  });
  for await (const line of createInterface({input: process.stdin})) {
    const {call, with: words} = JSON.parse(line), path = call.split("."), method = path.pop(), on = path.reduce((one, key) => one[key], page);
    let answer;
    try {
      const value = await on[method](...words);
      answer = {value: call === "evaluate" ? value ?? null : null};
    } catch (error) {
      answer = {error: error.message};
    }
    process.stdout.write(`${JSON.stringify({...answer, complaints: complaints.splice(0)})}\n`);
  }
  await browser.close();
}
main();
