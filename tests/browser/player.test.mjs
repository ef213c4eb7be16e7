// Plays pages of `islet run --html` in a real browser, from files and without a network.
// Environment: ISLET, the program; CHROMIUM, the browser.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { drawPicture, phone, pictureOf, pixels, settle, temporaryFolder, useBrowser, visit } from "./browser.mjs";

const folder = temporaryFolder("player");
const desktop = { viewport: { width: 1280, height: 760 } };

useBrowser();

function makePage(scene, ...options) {
    const file = join(folder, `${basename(scene)}${options.join("")}.html`);
    execFileSync(process.env.ISLET, ["run", scene, "--html", file, ...options]);
    return file;
}

/// Opens a page of the scene; from the network it may have nothing.
const withPage = (scene, options, use, ...arguments_) => visit(pathToFileURL(makePage(scene, ...arguments_)).href, {
    options: { reducedMotion: "reduce", ...options }, // or it would play at once
    mayAsk: (url) => /^(file|data):/.test(url),
    prepare: async (page, context) => {
        await context.setOffline(true);
        await page.addInitScript(drawPicture);
    },
}, async (page) => {
    await page.waitForFunction(() => document.documentElement.dataset.frame !== undefined);
    await use(page);
});

const frameOf = (page) => page.evaluate(() => Number(document.documentElement.dataset.frame));
const textOf = (page, id) => page.locator(`#${id}`).textContent();

/// Those of awake bodies.
const awakePixels = (page) => pixels(page, ["awake-1", "awake-2", "awake-3", "awake-4", "awake-5", "awake-6"]);

async function changes(page, action) {
    const old = await pictureOf(page);
    await action();
    await settle(page);
    return (await pictureOf(page)) !== old;
}

test("shows the bodies, and they fall", async () => {
    await withPage("hello", desktop, async (page) => {
        const start = await awakePixels(page);
        assert.ok(start.count > 500, `${start.count} pixels of the falling box`);
        for (let i = 0; i < 30; ++i) await page.keyboard.press("ArrowRight");
        await settle(page);
        const later = await awakePixels(page);
        assert.ok(later.y > start.y + 20, `from ${start.y} to ${later.y}`);
        assert.ok(Math.abs(later.x - start.x) < 5);
        assert.equal(await textOf(page, "step"), "30");
        assert.equal(await textOf(page, "time"), "0.50");
    });
});

test("plays at its speed, pauses, and starts over at the end", async () => {
    await withPage("card_house", desktop, async (page) => {
        const before_ = await pictureOf(page);
        const started = Date.now();
        await page.click("#play");
        await page.waitForFunction(() => Number(document.documentElement.dataset.frame) >= 60);
        const seconds = (Date.now() - started) / 1000;
        assert.ok(seconds > 0.9, `a second of the run took ${seconds} s`);
        assert.notEqual(await pictureOf(page), before_);
        await page.keyboard.press(" ");
        await settle(page);
        const paused = await frameOf(page);
        await page.waitForTimeout(200);
        assert.equal(await frameOf(page), paused);

        await page.keyboard.press("End");
        await settle(page);
        assert.equal(await frameOf(page), 3600);
        await page.click("#play");
        await page.waitForFunction(() => Number(document.documentElement.dataset.frame) < 100);
    });
});

test("opens playing, unless the visitor wants no motion", async () => {
    await withPage("card_house", { ...desktop, reducedMotion: "no-preference" }, async (page) => {
        await page.waitForFunction(() => Number(document.documentElement.dataset.frame) >= 30);
    });
    await withPage("card_house", desktop, async (page) => {
        await page.waitForTimeout(200);
        assert.equal(await frameOf(page), 0);
    });
});

test("frame 0 shows the contacts that the bodies have there", async () => {
    await withPage("pyramid", desktop, async (page) => {
        const touching = async () => Number(await page.locator("[data-column=touching] output").textContent());
        const first = await touching();
        assert.ok((await pixels(page, ["contact"])).count > 50);
        await page.keyboard.press("ArrowRight");
        await settle(page);
        assert.equal(await touching(), first);
    });
});

test("paths show what was, not what will be", async () => {
    await withPage("bounce", desktop, async (page) => {
        const paths = () => pixels(page, ["trail"]);
        assert.equal((await paths()).count, 0);
        await page.keyboard.press("End");
        await settle(page);
        assert.ok((await paths()).count > 20);
    });
});

test("the camera goes after what leaves the view, unless told not to", async () => {
    const thrown = join(folder, "thrown.json");
    const ball = { type: "dynamic", position: [0, 1], linear_velocity: [8, 4], shapes: [{ circle: { radius: 0.5 } }] };
    writeFileSync(thrown, JSON.stringify({ name: "thrown", steps: 120, view: [-5, -1, 5, 5], world: { gravity: [0, 0] }, bodies: [ball] }));
    await withPage(thrown, desktop, async (page) => {
        const start = await awakePixels(page);
        await page.keyboard.press("End");
        await settle(page);
        const end = await awakePixels(page);
        assert.ok(end.count > 0.7 * start.count && end.x < desktop.viewport.width, JSON.stringify({ start, end }));
        await page.keyboard.press("f");
        await settle(page);
        assert.equal((await awakePixels(page)).count, 0);
    });
});

test("steps forward and back, and comes back to the same picture", async () => {
    await withPage("pyramid", desktop, async (page) => {
        const pictures = [];
        for (let i = 0; i < 60; ++i) {
            if (i % 20 === 0) pictures.push(await pictureOf(page));
            await page.click("[data-command=forward]");
            await settle(page);
        }
        assert.equal(await frameOf(page), 60);
        for (let i = 60; i > 0; --i) {
            await page.click("[data-command=back]");
            await settle(page);
            if ((i - 1) % 20 === 0) assert.equal(await pictureOf(page), pictures.pop());
        }
        assert.equal(await frameOf(page), 0);
        await page.click("[data-command=back]");
        await settle(page);
        assert.equal(await frameOf(page), 0);
    });
});

test("the scrubber leads anywhere", async () => {
    await withPage("bounce", desktop, async (page) => {
        const box = await page.locator("#scrubber").boundingBox();
        await page.mouse.click(box.x + 0.5 * box.width, box.y + box.height / 2);
        await settle(page);
        assert.ok(Math.abs((await frameOf(page)) - 75) <= 2);
        await page.mouse.click(box.x + 0.25 * box.width, box.y + box.height / 2);
        await settle(page);
        assert.ok(Math.abs((await frameOf(page)) - 37) <= 3);
    });
});

test("speeds go from an eighth to four times", async () => {
    await withPage("hello", desktop, async (page) => {
        for (const wanted of ["2×", "4×", "4×"]) {
            await page.keyboard.press("ArrowUp");
            await settle(page);
            assert.equal(await textOf(page, "speed"), wanted);
        }
        for (const wanted of ["2×", "1×", "½×", "¼×", "⅛×", "⅛×"]) {
            await page.click("[data-command=slower]");
            await settle(page);
            assert.equal(await textOf(page, "speed"), wanted);
        }
    });
});

test("contacts can be hidden, and there is no switch for joints that do not exist", async () => {
    await withPage("pyramid", desktop, async (page) => {
        const with_ = await pictureOf(page);
        assert.ok(await changes(page, () => page.click("#contacts")));
        assert.equal(await page.getAttribute("#contacts", "aria-pressed"), "false");
        await page.keyboard.press("c");
        await settle(page);
        assert.equal(await pictureOf(page), with_);
        assert.equal(await page.locator("#joints").isVisible(), (await page.locator("[data-column=joints]").isVisible()));
    });
});

test("joints can be hidden", async () => {
    await withPage("tumbler", desktop, async (page) => {
        assert.ok(await changes(page, () => page.click("#joints")));
        assert.ok(await changes(page, () => page.keyboard.press("j")));
    }, "--steps", "5");
});

test("what is drawn of joints goes with their bodies, and bullets have a colour of their own", async () => {
    await withPage("pinball", desktop, async (page) => {
        const legend = () => page.locator("#legend li:visible").allTextContents();
        assert.deepEqual(await legend(), ["awake", "static", "bullet"]);
        const start = await pixels(page, ["bullet"]);
        assert.ok(start.count > 50, `${start.count} pixels of the ball`);
        // Seen from near, the plunger's dot goes down with it, and up again; those of the hinges stay.
        await page.mouse.move(start.x, start.y);
        await page.mouse.wheel(0, -600);
        const dots = [];
        for (const step of [0, 65, 95]) {
            await page.evaluate((value) => Object.assign(document.getElementById("scrubber"), { value }).dispatchEvent(new Event("input")), step);
            await settle(page);
            dots.push(await pixels(page, ["joint"]));
        }
        assert.ok(dots.every(({ count }) => count > 20), JSON.stringify(dots));
        assert.ok(dots[1].y > dots[0].y + 2 && Math.abs(dots[2].y - dots[0].y) < 1, JSON.stringify(dots));
        await page.keyboard.press("0");
        await settle(page);
        const shot = await pixels(page, ["bullet"]);
        assert.ok(shot.y < start.y - 50, "the ball is on its way up");
    });
});

test("the wheel zooms about the pointer, dragging pans, a double click shows all again", async () => {
    await withPage("hello", desktop, async (page) => {
        const start = await awakePixels(page);
        const whole = await pictureOf(page);
        await page.mouse.move(start.x, start.y);
        await page.mouse.wheel(0, -300);
        await settle(page);
        const near = await awakePixels(page);
        assert.ok(near.count > 2 * start.count, `from ${start.count} to ${near.count} pixels`);
        assert.ok(Math.hypot(near.x - start.x, near.y - start.y) < 3, "what is under the pointer stays there");

        await page.mouse.down();
        await page.mouse.move(start.x - 120, start.y + 40, { steps: 4 });
        await page.mouse.up();
        await settle(page);
        const moved = await awakePixels(page);
        assert.ok(Math.abs(moved.x - near.x + 120) < 3 && Math.abs(moved.y - near.y - 40) < 3, JSON.stringify({ near, moved }));

        await page.mouse.dblclick(start.x - 200, start.y + 100);
        await settle(page);
        assert.equal(await pictureOf(page), whole);
    });
});

test("a picked number becomes the curve", async () => {
    await withPage("bounce", desktop, async (page) => {
        const curve = () => page.evaluate(() => document.getElementById("curve").toDataURL());
        const energy = await curve();
        await page.click("[data-column=contacts]");
        await settle(page);
        assert.notEqual(await curve(), energy);
        assert.equal(await page.locator("[data-column=contacts] output").textContent(), "0");
    });
});

test("fits a phone, lying or standing, and fingers work", async () => {
    for (const viewport of [phone.viewport, { width: 844, height: 390 }, { width: 320, height: 568 }]) {
        await withPage("pyramid", { ...phone, viewport }, async (page) => {
            assert.ok((await awakePixels(page)).count > 300);
            assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width);
            for (const button of await page.locator("#dock button:visible").all()) {
                const box = await button.boundingBox();
                assert.ok(box.x >= 0 && box.x + box.width <= viewport.width && box.y + box.height <= viewport.height, JSON.stringify(box));
                assert.ok(box.width >= 32 && box.height >= 32, "large enough for a finger");
            }
            assert.ok(await page.evaluate(() => document.getElementById("controls").scrollWidth <= document.getElementById("controls").clientWidth));
            await page.tap("#play");
            await page.waitForFunction(() => Number(document.documentElement.dataset.frame) > 10);
            await page.tap("#play");
            await page.tap("[data-command=forward]");
        });
    }
});

test("is dark where the system is", async () => {
    for (const colorScheme of ["light", "dark"]) {
        await withPage("hello", { ...desktop, colorScheme }, async (page) => {
            const paper = await page.evaluate(() => [...document.getElementById("world").getContext("2d").getImageData(3, 3, 1, 1).data]);
            assert.ok(colorScheme === "dark" ? paper[0] < 60 : paper[0] > 200, String(paper));
        });
    }
});

test("says what was left out of a large run, and plays it", async () => {
    await withPage("compounds", desktop, async (page) => {
        assert.match(await textOf(page, "thinned"), /one step of every 2/);
        await page.keyboard.press("End");
        await settle(page);
        assert.equal(await textOf(page, "step"), "500");
        assert.ok((await awakePixels(page)).count > 5000);
    });
});

test("any frame can be read first, and holds what the run counted", async () => {
    // The decoder as it stands in the project, outside a browser.
    const source = readFileSync(new URL("../../tools/islet/player/movie.js", import.meta.url), "utf8");
    const { Movie, looks } = await import(`data:text/javascript,${encodeURIComponent(source)}`);
    const page = readFileSync(makePage("dominoes"), "utf8");
    const element = (id) => page.match(new RegExp(`id="${id}">([^<]*)<`))[1];
    const run = JSON.parse(element("run"));
    const bytes = Buffer.from(element("movie"), "base64");
    const numbers = new Float32Array(new Uint8Array(Buffer.from(element("numbers"), "base64")).buffer);
    const column = (name) => numbers.subarray(run.columns.indexOf(name) * run.frames, (run.columns.indexOf(name) + 1) * run.frames);

    const summary = ({ bodies, contacts, looks: worn }) => {
        const rows = (t) => Array.from({ length: t.size }, (_, i) => (t.live[i] ? [t.x[i], t.y[i], t.angle[i]] : null));
        return { bodies: rows(bodies), contacts: rows(contacts), awake: worn.filter((look) => looks[look] === "awake").length };
    };
    const inOrder = new Movie(bytes, run), jumping = new Movie(bytes, run);
    const frames = Array.from({ length: run.frames }, (_, i) => summary(inOrder.at(i)));
    assert.equal(inOrder.state.position, bytes.length);
    for (const [i, frame] of frames.entries()) {
        assert.equal(frame.bodies.filter(Boolean).length, column("bodies")[i]);
        assert.equal(frame.awake, column("awakeBodies")[i]);
    }
    for (const i of [600, 599, 0, 49, 50, 48, 300, 251, 250, 249, 99, 100, 600]) {
        assert.deepEqual(withoutEnd(summary(jumping.at(i))), withoutEnd(frames[i]), `frame ${i}`);
    }
});

/// A table read from further on may have room for ids that come later.
function withoutEnd({ bodies, contacts, awake }) {
    const trimmed = (rows) => rows.slice(0, rows.findLastIndex(Boolean) + 1);
    return { bodies: trimmed(bodies), contacts: trimmed(contacts), awake };
}
